//! What rays meet, by the pass and by trying every triangle.

use lobe_backends::pipeline::{Dispatcher, Interpreted, Memory, Pipeline};
use lobe_codegen::glam::Vec3;
use lobe_kernels::registry::PASSES;
use lobe_kernels::scene::bvh::{BVH_DEPTH, NEAREST};
use lobe_kernels::scene::triangle::{sheared_ray, triangle_distance};
use lobe_kernels::scene::{BvhNode, Hit, NOWHERE, SceneRay, Triangle};
use lobe_tests::domain::Rng;
use lobe_tests::render::bvh::Bvh;

/// What each ray meets first, and whether it reaches its end, by the passes.
fn traced(triangles: &[Triangle], rays: &[SceneRay]) -> (Vec<Hit>, Vec<u32>) {
    let pipeline = Pipeline::new(PASSES).unwrap_or_else(|e| panic!("{e}"));
    let bvh = Bvh::new(triangles, 1e-4);
    let mut memory = Memory::default();
    let mut put = |name: &str, bytes: Result<Vec<u8>, _>| {
        memory.put(name, bytes.unwrap_or_else(|e: lobe_backends::executor::ExecError| panic!("{e}")));
    };
    put("nodes", pipeline.pack("nodes", &bvh.nodes));
    put("triangles", pipeline.pack("triangles", &bvh.triangles));
    put("rays", pipeline.pack("rays", rays));
    put("shadow_rays", pipeline.pack("shadow_rays", rays));
    put("hits", pipeline.zeros("hits", rays.len()));
    put("visible", pipeline.zeros("visible", rays.len()));
    let mut interp = Interpreted::default();
    for name in ["nearest_pass", "shadow_pass"] {
        let pass = pipeline.pass(name).unwrap_or_else(|e| panic!("{e}"));
        interp.dispatch(pass, rays.len() as u32, &mut memory).unwrap_or_else(|e| panic!("{e}"));
    }
    let hits = pipeline.unpack("hits", memory.bytes("hits")).unwrap_or_else(|e| panic!("{e}"));
    (hits, pipeline.unpack("visible", memory.bytes("visible")).unwrap_or_else(|e| panic!("{e}")))
}

/// The nearest distance, by trying every triangle.
fn nearest(triangles: &[Triangle], ray: &SceneRay) -> Option<f32> {
    let sheared = sheared_ray(ray.origin, ray.dir);
    let others = triangles.iter().filter(|t| t.surface != ray.leaving && t.surface != ray.reaching);
    let distances = others.map(|t| triangle_distance(sheared, t.a, t.b, t.c));
    distances.filter(|d| *d > NEAREST && *d < ray.reach).min_by(f32::total_cmp)
}

fn place(rng: &mut Rng, size: f32) -> Vec3 {
    let mut number = || (2.0 * rng.unit() - 1.0) as f32 * size;
    Vec3::new(number(), number(), number())
}

/// Triangles of all sizes, some without extent, some in one plane or one place.
fn soup(rng: &mut Rng, count: u32) -> Vec<Triangle> {
    let triangle = |surface: u32| {
        let a = place(rng, 10.0);
        let size = if surface.is_multiple_of(7) { 5.0 } else { 0.5 };
        let (b, c) = (a + place(rng, size), a + place(rng, size));
        match surface % 11 {
            0 => Triangle { a: a.with_y(1.0), surface, b: b.with_y(1.0), c: c.with_y(1.0) },
            1 => Triangle { a, surface, b: a, c },
            2 => Triangle { a: Vec3::ONE, surface, b: Vec3::X, c: Vec3::Y },
            _ => Triangle { a, surface, b, c },
        }
    };
    (0..count).map(triangle).collect()
}

/// Rays every way, some along the axes, some short, some that leave a surface out.
fn rays(rng: &mut Rng, count: u32) -> Vec<SceneRay> {
    let ray = |at: u32| {
        let axis = [Vec3::X, Vec3::NEG_Y, Vec3::Z][at as usize % 3];
        let dir = if at.is_multiple_of(5) { axis } else { place(rng, 1.0).normalize_or(Vec3::X) };
        let reach = if at.is_multiple_of(4) { 4.0 } else { 1e30 };
        let leaving = if at.is_multiple_of(3) { at % 100 } else { NOWHERE };
        SceneRay { origin: place(rng, 12.0), reach, dir, leaving, reaching: NOWHERE }
    };
    (0..count).map(ray).collect()
}

#[test]
fn the_tree_finds_what_trying_every_triangle_finds() {
    for (seed, count) in [(1, 1), (2, 3), (3, 50), (4, 2000)] {
        let mut rng = Rng::new(seed, "bvh");
        let triangles = soup(&mut rng, count);
        let rays = rays(&mut rng, 2000);
        let (hits, visible) = traced(&triangles, &rays);
        for (at, ray) in rays.iter().enumerate() {
            let expected = nearest(&triangles, ray);
            let (hit, free) = (hits[at], visible[at]);
            let found = (hit.surface != NOWHERE).then_some(hit.dist);
            assert_eq!(found, expected, "seed {seed}, {count} triangles, ray {at}: {ray:?}");
            assert_eq!(free == 1, expected.is_none(), "seed {seed}, {count} triangles, shadow ray {at}");
        }
    }
}

/// A box of 12 triangles, each side cut in two: from inside every ray meets it, those through edges and corners too.
#[test]
fn a_closed_box_has_no_gaps() {
    let corner = |i: usize| Vec3::from_array([0, 1, 2].map(|k| if i >> k & 1 == 1 { 1.0 } else { -0.7 }));
    let sides = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    let triangle =
        |surface: u32, [a, b, c]: [usize; 3]| Triangle { a: corner(a), surface, b: corner(b), c: corner(c) };
    let halves = |(at, [a, b, c, d]): (u32, [usize; 4])| [triangle(at, [a, b, c]), triangle(at, [a, c, d])];
    let triangles: Vec<Triangle> = (0..).zip(sides).flat_map(halves).collect();
    let mut rng = Rng::new(5, "box");
    let aimed = |at: usize| {
        let (a, b) = (corner(at % 8), corner((at / 8) % 8));
        let target = a + (b - a) * [0.0, 0.5, rng.unit() as f32][at % 3];
        let origin = place(&mut rng, 0.3);
        let dir = (target - origin).normalize();
        SceneRay { origin, reach: 1e30, dir, leaving: NOWHERE, reaching: NOWHERE }
    };
    let rays: Vec<SceneRay> = (0..20_000).map(aimed).collect();
    let (hits, _) = traced(&triangles, &rays);
    let escaped: Vec<usize> = (0..rays.len()).filter(|at| hits[*at].surface == NOWHERE).collect();
    assert!(escaped.is_empty(), "{} rays escape, the first is {:?}", escaped.len(), rays[escaped[0]]);
}

/// Depth of the tree below a node.
fn depth(nodes: &[BvhNode], at: usize) -> u32 {
    let node = nodes[at];
    if node.count > 0 {
        return 0;
    }
    1 + depth(nodes, node.first as usize).max(depth(nodes, node.first as usize + 1))
}

/// The worst for a tree: each triangle a thousandth of the size of the one before it.
#[test]
fn no_tree_is_deeper_than_the_stack() {
    let nested = |surface: u32| {
        let size = 0.9_f32.powi(surface as i32 % 800);
        Triangle { a: Vec3::X * size, surface, b: Vec3::Y * size, c: Vec3::Z * size }
    };
    let mut rng = Rng::new(6, "deep");
    for triangles in [(0..5000).map(nested).collect::<Vec<_>>(), soup(&mut rng, 30_000)] {
        let bvh = Bvh::new(&triangles, 0.0);
        let deepest = depth(&bvh.nodes, 0);
        assert!(deepest < BVH_DEPTH, "{deepest}");
        assert_eq!(bvh.triangles.len(), triangles.len());
    }
}
