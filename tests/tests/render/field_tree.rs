//! The tree over rectangles: its lists are those of trying each, and its bounds hold.

use lobe_backends::pipeline::{Dispatcher, Interpreted, Memory, Pipeline};
use lobe_codegen::glam::Vec3;
use lobe_kernels::brdf::Material;
use lobe_kernels::rect::Rectangle;
use lobe_kernels::rect::field::{FIELD_LIST, FIELD_TEXEL, FieldSettings, field_weight};
use lobe_kernels::rect::field_tree::{field_bound, field_view};
use lobe_kernels::rect::pass::{RectProxy, light_share};
use lobe_kernels::registry::PASSES;
use lobe_kernels::scene::light::SceneLight;
use lobe_kernels::scene::{NOWHERE, Surface};
use lobe_tests::domain::Rng;
use lobe_tests::render::FieldTree;

/// What is listed, and where.
struct World {
    surfaces: Vec<Surface>,
    proxies: Vec<RectProxy>,
    materials: Vec<Material>,
    lights: Vec<SceneLight>,
}

fn place(rng: &mut Rng, size: f32) -> Vec3 {
    let mut number = || (2.0 * rng.unit() - 1.0) as f32 * size;
    Vec3::new(number(), number(), number())
}

fn rectangle(rng: &mut Rng, reach: f32, size: f32) -> Rectangle {
    let normal = place(rng, 1.0).normalize_or(Vec3::Y);
    let tangent = normal.cross(place(rng, 1.0)).normalize_or(normal.any_orthonormal_vector());
    let half_x = size * (0.1 + rng.unit() as f32);
    let half_y = half_x * (0.3 + 0.7 * rng.unit() as f32);
    Rectangle { position: place(rng, reach), normal, tangent, half_x, half_y }
}

impl World {
    /// Small rectangles of several materials among six large ones, of which some are seen by others edge on, under a
    /// directional light and a spotlight.
    fn new(seed: u64, count: u32) -> Self {
        let mut rng = Rng::new(seed, "field tree");
        let material = |alpha: f32, share: f32| Material {
            diffuse_albedo: Vec3::splat(0.6 * share),
            f0: Vec3::new(1.0, 0.7, 0.3) * (1.0 - share),
            f90: 1.0,
            alpha,
        };
        let materials =
            vec![material(0.02, 0.1), material(0.15, 0.0), material(0.5, 0.5), material(1.0, 1.0)];
        let light = |is_spot: u32, axis: Vec3, strength: f32| SceneLight {
            axis,
            is_spot,
            position: 3.0 * -axis,
            outer: 1.2,
            strength: Vec3::splat(strength),
            blend: 0.3,
        };
        let lights = vec![
            light(0, place(&mut rng, 1.0).normalize_or(Vec3::Y), 3.0),
            light(1, place(&mut rng, 1.0).normalize_or(Vec3::Y), 20.0),
        ];
        let proxies = (0..count).map(|i| {
            let size = if i % 50 == 0 { 1.0 } else { 0.05 };
            let mut rectangle = rectangle(&mut rng, 2.0, size);
            if i % 4 == 0 {
                // In one plane with others.
                (rectangle.normal, rectangle.tangent, rectangle.position.y) = (Vec3::Y, Vec3::X, -2.0);
            }
            RectProxy { rectangle, material: i % 4, fill: 0.3 + 0.7 * rng.unit() as f32 }
        });
        let proxies = proxies.collect();
        let surface = |at: u32| {
            let rectangle = rectangle(&mut rng, 2.0, 1.5);
            Surface { rectangle, material: 3, shape: at, back: NOWHERE, apex: 2.0 }
        };
        Self { surfaces: (0..6).map(surface).collect(), proxies, materials, lights }
    }

    /// The lists of a pass.
    fn lists(&self, pipeline: &Pipeline, pass: &str, settings: FieldSettings) -> Vec<u32> {
        let range = settings.first..settings.first + settings.count;
        let tree = FieldTree::new(&self.proxies, range, &self.materials, &self.lights);
        let texels = self.surfaces.len() * (settings.side * settings.side) as usize;
        let mut memory = Memory::default();
        let mut put = |name: &str, bytes: Result<Vec<u8>, lobe_backends::executor::ExecError>| {
            memory.put(name, bytes.unwrap_or_else(|e| panic!("{e}")));
        };
        put("field_settings", pipeline.pack("field_settings", &[settings]));
        put("surfaces", pipeline.pack("surfaces", &self.surfaces));
        put("proxies", pipeline.pack("proxies", &self.proxies));
        put("materials", pipeline.pack("materials", &self.materials));
        put("lights", pipeline.pack("lights", &self.lights));
        put("field_nodes", pipeline.pack("field_nodes", &tree.nodes));
        put("field_lobes", pipeline.pack("field_lobes", &tree.lobes));
        put("field", pipeline.zeros("field", texels * FIELD_TEXEL as usize));
        let found = pipeline.pass(pass).unwrap_or_else(|e| panic!("{e}"));
        let mut interp = Interpreted::default();
        interp.dispatch(found, texels as u32, &mut memory).unwrap_or_else(|e| panic!("{e}"));
        pipeline.unpack("field", memory.bytes("field")).unwrap_or_else(|e| panic!("{e}"))
    }
}

#[test]
fn the_lists_are_those_of_trying_each() {
    let pipeline = Pipeline::new(PASSES).unwrap_or_else(|e| panic!("{e}"));
    for (seed, count, most) in [(1, 1, 8), (2, 5, 8), (3, 60, 1), (4, 300, 8), (5, 300, 3), (6, 1000, 8)] {
        let world = World::new(seed, count);
        // The first and the last are not to be listed, where there are more.
        let (first, count) = if count > 2 { (1, count - 2) } else { (0, count) };
        let settings = FieldSettings { side: 8, most, list: 0, first, count, texel: 0 };
        let all = world.lists(&pipeline, "field_pass", settings);
        let by_tree = world.lists(&pipeline, "field_tree_pass", settings);
        for (texel, (a, b)) in
            all.chunks(FIELD_TEXEL as usize).zip(by_tree.chunks(FIELD_TEXEL as usize)).enumerate()
        {
            assert_eq!(a, b, "seed {seed}, {count} rectangles, texel {texel}");
        }
        let listed = all[..FIELD_LIST as usize].iter().filter(|id| **id != NOWHERE).count();
        assert_eq!(listed as u32, most.min(count), "seed {seed}");
    }
}

/// What a rectangle sends is at most the bound of each node that it is in.
#[test]
fn no_rectangle_exceeds_the_bounds_of_its_nodes() {
    for seed in 0..10 {
        let world = World::new(seed, 200);
        let tree = FieldTree::new(&world.proxies, 0..200, &world.materials, &world.lights);
        let lights = world.lights.len();
        let mut rng = Rng::new(seed, "texels");
        for _ in 0..50 {
            let (position, normal) = (place(&mut rng, 2.5), place(&mut rng, 1.0).normalize_or(Vec3::Y));
            let bounds: Vec<f32> = (0..tree.nodes.len())
                .map(|at| {
                    let view = field_view(tree.nodes[at], position, normal);
                    let lobes = &tree.lobes[at * lights..(at + 1) * lights];
                    if view.is_seen == 1 {
                        lobes.iter().map(|lobe| field_bound(*lobe, view)).sum()
                    } else {
                        0.0
                    }
                })
                .collect();
            // From the leaves up, the greatest weight of each node.
            let mut greatest = vec![0.0_f32; tree.nodes.len()];
            for at in (0..tree.nodes.len()).rev() {
                let node = tree.nodes[at];
                greatest[at] = match node.is_leaf {
                    1 => {
                        let proxy = world.proxies[node.first as usize];
                        let material = world.materials[proxy.material as usize];
                        let of = |light: &SceneLight| {
                            field_weight(proxy, material, light_share(*light, proxy), position, normal)
                        };
                        world.lights.iter().map(of).sum()
                    }
                    _ => greatest[node.first as usize].max(greatest[node.first as usize + 1]),
                };
                assert!(
                    greatest[at] <= bounds[at],
                    "seed {seed}, node {at}: {} above {}, {node:?}, {position} {normal}",
                    greatest[at],
                    bounds[at]
                );
            }
        }
    }
}
