//! What proxies must be, on meshes of known shape.

use super::*;
use crate::domain::Rng;
use crate::scene::{Choices, Scene};
use expect::{grid, scene_of, sphere};
use lobe_codegen::glam::{DVec3, Quat};
use proptest::prelude::*;
use std::path::Path;

mod expect {
    use super::{Scene, Triangle, Vec3};
    use lobe_codegen::glam::DVec3;

    /// A scene of these alone, with the camera and light of one that is kept.
    pub(super) fn scene_of(triangles: Vec<Triangle>) -> Scene {
        let mut scene = super::kept("room.gltf");
        scene.triangles = triangles;
        scene
    }

    pub(super) fn triangle(vertices: [Vec3; 3], material: usize) -> Triangle {
        let [a, b, c] = vertices.map(|vertex| vertex.as_dvec3());
        let normal: DVec3 = (b - a).cross(c - a).normalize();
        Triangle { vertices, normal: normal.as_vec3(), material, two_sided: false, detail: None }
    }

    /// A surface over the unit square, of `n` by `n` squares.
    pub(super) fn grid(n: u32, material: usize, at: impl Fn(f32, f32) -> Vec3) -> Vec<Triangle> {
        let corner = |i: u32, j: u32| at(i as f32 / n as f32, j as f32 / n as f32);
        let square = |i: u32, j: u32| {
            let [a, b, c, d] = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| corner(i, j));
            [triangle([a, b, c], material), triangle([a, c, d], material)]
        };
        (0..n).flat_map(|j| (0..n).flat_map(move |i| [(i, j)])).flat_map(|(i, j)| square(i, j)).collect()
    }

    /// A band of a sphere of radius 1.
    pub(super) fn sphere(n: u32) -> Vec<Triangle> {
        grid(n, 0, |s, t| {
            let (phi, height) = (6.0 * s, 1.6 * t - 0.8);
            let ring = (1.0 - height * height).sqrt();
            Vec3::new(ring * phi.cos(), ring * phi.sin(), height)
        })
    }
}

fn kept(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/scenes");
    Scene::open(&folder.join(name), &Choices::default()).unwrap()
}

/// What every proxy must be, of the triangles that `region_of` says.
fn check(scene: &Scene, options: &Options) -> Proxies {
    let found = proxies(scene, options).unwrap();
    let summary = found.summary();
    assert_eq!(summary.triangles, scene.triangles.len());
    assert!(summary.overlap >= summary.covered * (1.0 - 1e-5), "{summary}");
    for proxy in &found.rectangles {
        assert!(proxy.fill > 0.0 && proxy.fill <= 1.0 + 1e-6, "{proxy:?}");
    }
    assert_contained(scene, options, &found);
    assert_eq!(Proxies::from_json(&found.to_json().unwrap()).unwrap().rectangles, found.rectangles);
    found
}

/// Each region's corners lie in its rectangle, as seen along the normal.
fn assert_contained(scene: &Scene, options: &Options, found: &Proxies) {
    let limits = Limits::new(scene, options).unwrap();
    let (_, region_of) = regions_of(scene, options, &limits).unwrap();
    let members: Vec<_> = members(&region_of).into_iter().filter(|members| !members.is_empty()).collect();
    assert_eq!(members.len(), found.rectangles.len());
    for (proxy, members) in found.rectangles.iter().zip(members) {
        let tolerance = 1e-5 * (proxy.half_x + proxy.half_y);
        for vertex in members.iter().flat_map(|&i| scene.triangles[i as usize].vertices) {
            let across = proxy.normal.cross(proxy.tangent);
            let [x, y] = [proxy.tangent, across].map(|axis| (vertex - proxy.position).dot(axis).abs());
            assert!(x <= proxy.half_x + tolerance && y <= proxy.half_y + tolerance, "{vertex} {proxy:?}");
        }
    }
}

#[test]
fn plates_are_their_own_proxies() {
    let found = check(&kept("room.gltf"), &Options::default());
    let told: Vec<_> =
        found.rectangles.iter().map(|p| (p.material_name.as_str(), p.triangles, p.two_sided)).collect();
    let expected = [
        ("white", 8, false),
        ("red", 8, false),
        ("white", 8, false),
        ("white", 18, false),
        ("gold", 8, true),
    ];
    assert_eq!(told, expected);
    let summary = found.summary();
    assert!((summary.overlap - 1.0).abs() < 1e-5 && summary.deviation.max < 1e-6, "{summary}");
}

#[test]
fn rectangles_of_a_scene_pass_through() {
    let scene = kept("cornell_L0.json");
    let found = proxies(&scene, &Options::default()).unwrap();
    assert_eq!(found.rectangles.len(), scene.rectangles.len());
    for (proxy, surface) in found.rectangles.iter().zip(&scene.rectangles) {
        assert_eq!((proxy.position, proxy.normal, proxy.fill), (surface.center, surface.normal, 1.0));
        let across = proxy.normal.cross(proxy.tangent) * proxy.half_y;
        assert!((across - surface.half_v).length() < 1e-6, "{proxy:?} {surface:?}");
    }
    assert!((found.summary().overlap - 1.0).abs() < 1e-6);
}

#[test]
fn a_sphere_is_merged_down() {
    let scene = scene_of(sphere(40));
    let all = check(&scene, &Options::default());
    let mut overlap = all.summary().deviation.rms;
    for count in [40, 12, 6, 1] {
        let found = check(&scene, &Options { count: Some(count), ..Options::default() });
        assert_eq!(found.rectangles.len(), count);
        assert!(found.summary().deviation.rms >= overlap, "{count}: {}", found.summary());
        overlap = found.summary().deviation.rms;
    }
}

#[test]
fn materials_are_kept_apart_unless_told() {
    let mut triangles = grid(4, 0, |s, t| Vec3::new(s, t, 0.0));
    triangles.extend(grid(4, 1, |s, t| Vec3::new(s + 1.0, t, 0.0)));
    triangles.extend(grid(4, 1, |s, t| Vec3::new(s + 1.0, t + 1.0, 0.0)));
    let scene = scene_of(triangles);
    let one = Options { count: Some(1), ..Options::default() };
    assert_eq!(proxies(&scene, &one), Err(ProxiesError::Count { count: 1, least: 2 }));
    let found = check(&scene, &Options { merge_materials: true, ..one });
    assert_eq!((found.rectangles[0].material, found.rectangles[0].fill), (1, 0.75));
    assert_eq!(check(&scene, &Options { count: Some(2), ..one }).summary().overlap, 1.0);
}

/// Leaves in the unit cube, turned every way.
fn foliage(seed: u64, count: u32, size: f32) -> Vec<Triangle> {
    let mut rng = Rng::new(seed, "foliage");
    let mut place = || Vec3::from_array([0; 3].map(|_| rng.unit() as f32));
    let mut leaf = |_| {
        let (at, along) = (place(), (place() - 0.5).normalize_or(Vec3::X));
        let across = along.cross(place() - 0.5).normalize_or(along.any_orthonormal_vector());
        let leaf = grid(1, 0, |s, t| at + size * (s * along + t * across));
        leaf.into_iter().map(|t| Triangle { two_sided: true, ..t }).collect::<Vec<_>>()
    };
    (0..count).flat_map(&mut leaf).collect()
}

#[test]
fn leaves_are_put_together_by_cells_and_directions() {
    let scene = scene_of(foliage(7, 500, 0.03));
    assert_eq!(proxies(&scene, &Options::default()).unwrap().rectangles.len(), 500);
    let mut rms = f32::INFINITY;
    for depth in [0, 3, 6] {
        let found = check(&scene, &Options { partition: Some(depth), ..Options::default() });
        let summary = found.summary();
        assert!(summary.count <= 3 << depth, "{depth}: {summary}");
        assert!(summary.deviation.rms < 0.8 * rms, "{depth}: {summary}");
        // Normals of a class are within 55 degrees of its axis, so that 0.577 of the area is left at least.
        assert!(summary.covered > 0.57 && summary.covered < 1.0, "{depth}: {summary}");
        assert!(found.rectangles.iter().all(|proxy| proxy.two_sided));
        rms = summary.deviation.rms;
    }
}

#[test]
fn opposite_sides_are_not_put_together() {
    let whole = Options { partition: Some(0), ..Options::default() };
    let found = check(&scene_of(sphere(40)), &whole);
    assert_eq!(found.rectangles.len(), 6);
    assert!(found.rectangles.iter().all(|proxy| proxy.deviation.angle_deg < 70.0 && !proxy.two_sided));
}

/// A floor in pieces with a gap, and leaves over it: the floor holds the limits and is not divided, the leaves are.
#[test]
fn what_holds_the_limits_is_not_divided() {
    let half = |x: f32| grid(6, 1, move |s, t| Vec3::new(0.6 * s + x, -0.1, 1.0 - t));
    let scene = scene_of([half(-0.2), half(0.5), foliage(8, 100, 0.03)].concat());
    let found = check(&scene, &Options { partition: Some(5), ..Options::default() });
    let floors: Vec<&Proxy> = found.rectangles.iter().filter(|proxy| proxy.material == 1).collect();
    assert_eq!(floors.iter().map(|floor| floor.triangles).collect::<Vec<_>>(), [144]);
    assert!(floors[0].deviation.max < 1e-6 && (floors[0].fill - 12.0 / 13.0).abs() < 1e-4, "{:?}", floors[0]);
    assert!(found.rectangles.len() < 1 + 3 * 32);
}

/// Two walls of two triangles each, of which either half of space holds one, among leaves of its class.
#[test]
fn what_is_larger_than_its_cell_stays_by_itself() {
    let wall = |x: f32| grid(1, 0, move |s, t| Vec3::new(4.0 * s - 2.0 + x, 4.0 * t - 2.0, -0.1));
    let walls = [wall(-1.0), wall(1.0)].concat().into_iter().map(|t| Triangle { two_sided: true, ..t });
    let scene = scene_of(walls.chain(foliage(9, 200, 0.03)).collect());
    let found = check(&scene, &Options { partition: Some(1), ..Options::default() });
    let large: Vec<&Proxy> = found.rectangles.iter().filter(|proxy| proxy.area() > 10.0).collect();
    assert_eq!(large.iter().map(|wall| (wall.triangles, wall.fill)).collect::<Vec<_>>(), [(2, 1.0); 2]);
}

/// Pieces that touch nowhere are merged too, those in one plane that leave least empty first.
#[test]
fn pieces_apart_are_merged_by_what_they_leave_empty() {
    let tile = |x: f32| grid(2, 0, move |s, t| Vec3::new(s + x, t, 0.0));
    let scene = scene_of([tile(0.0), tile(1.1), tile(5.0)].concat());
    let found = check(&scene, &Options { count: Some(2), ..Options::default() });
    let mut halves: Vec<f32> = found.rectangles.iter().map(|proxy| proxy.half_x).collect();
    halves.sort_by(f32::total_cmp);
    assert!((halves[0] - 0.5).abs() < 1e-6 && (halves[1] - 1.05).abs() < 1e-6, "{halves:?}");
}

#[test]
fn options_out_of_range_are_named() {
    let scene = kept("room.gltf");
    for (options, message) in [
        (Options { angle: 0.0, ..Options::default() }, "the angle in degrees is 0: it must be above 0"),
        (Options { angle: f64::NAN, ..Options::default() }, "the angle in degrees is NaN"),
        (Options { distance: Some(-1.0), ..Options::default() }, "the distance in metres is -1"),
        (
            Options { partition: Some(25), ..Options::default() },
            "the depth of the partition is 25: it must be at most 24",
        ),
        (Options { count: Some(0), ..Options::default() }, "the number of proxies is 0"),
        (Options { count: Some(2), ..Options::default() }, "2 proxies are too few: 3 are left"),
    ] {
        let said = proxies(&scene, &options).unwrap_err().to_string();
        assert!(said.contains(message), "{said} // {message}");
    }
}

#[test]
fn what_is_wrong_in_a_file_is_named() {
    let text = proxies(&kept("room.gltf"), &Options::default()).unwrap().to_json().unwrap();
    for (pointer, value, message) in [
        ("/schema", serde_json::json!(2), "version 2, and this reads \"proxies\" of version 1"),
        ("/area", serde_json::json!(-1), "area: it is negative"),
        ("/proxies", serde_json::json!([]), "proxies: there is none"),
        ("/proxies/1/normal", serde_json::json!([0, 0, 2]), "proxies[1].normal: it is not of length one"),
        ("/proxies/0/half_x", serde_json::json!(0), "proxies[0].half_x: it is not above 0"),
        ("/proxies/0/fill", serde_json::json!(1.5), "proxies[0].fill: it is not above 0"),
        ("/proxies/0/position", serde_json::json!([1e10, 0, 0]), "proxies[0].position: it is not in"),
        ("/proxies/0/triangles", serde_json::json!("ten"), "these are no proxies: invalid type"),
    ] {
        let mut value_of: serde_json::Value = serde_json::from_str(&text).unwrap();
        *value_of.pointer_mut(pointer).unwrap() = value;
        let said = Proxies::from_json(&value_of.to_string()).unwrap_err().to_string();
        assert!(said.contains(message), "{said} // {message}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// However it is turned, moved and cut.
    #[test]
    fn a_rectangle_in_pieces_is_one_proxy(
        axis in prop::array::uniform3(-1.0..1.0f32),
        angle in 0.0..6.0f32,
        [x, y] in prop::array::uniform2(0.05..5.0f32),
        shift in prop::array::uniform3(-5.0..5.0f32),
        n in 1..9u32,
    ) {
        let axis = Vec3::from_array(axis).try_normalize().unwrap_or(Vec3::Y);
        let (turn, shift) = (Quat::from_axis_angle(axis, angle), Vec3::from_array(shift));
        let (u, v) = (turn * Vec3::new(x, 0.0, 0.0), turn * Vec3::new(0.0, y, 0.0));
        let scene = scene_of(grid(n, 0, |s, t| shift + (2.0 * s - 1.0) * u + (2.0 * t - 1.0) * v));
        let found = check(&scene, &Options::default());
        prop_assert_eq!(found.rectangles.len(), 1);
        let proxy = &found.rectangles[0];
        let scale = x + y + 10.0;
        prop_assert!((proxy.position - shift).length() < 1e-5 * scale);
        prop_assert!((proxy.normal - turn * Vec3::Z).length() < 1e-3);
        prop_assert!((proxy.half_x - x.max(y)).abs() < 1e-5 * scale && (proxy.half_y - x.min(y)).abs() < 1e-5 * scale);
        let along = proxy.tangent.cross(if x >= y { u } else { v }.normalize()).length();
        prop_assert!(along < 1e-2 || (x - y).abs() < 1e-3 * scale, "{:?}", proxy);
        prop_assert!(proxy.fill > 0.999, "{:?}", proxy);
    }

    /// Of any surface the rectangles hold their triangles, however few they are to be.
    #[test]
    fn rectangles_hold_their_triangles(
        bumps in prop::array::uniform4(-1.0..1.0f32),
        n in 2..12u32,
        count in prop::option::of(1..20usize),
        partition in prop::option::of(0..8u32),
    ) {
        let [a, b, c, d] = bumps;
        let wave = move |s: f32, t: f32| Vec3::new(2.0 * s, t, a * (7.0 * s + b).sin() + c * (5.0 * t + d).cos());
        check(&scene_of(grid(n, 0, wave)), &Options { count, partition, ..Options::default() });
    }
}

/// The rectangle of least area is no larger than any other around the points.
#[test]
fn no_other_direction_gives_a_smaller_rectangle() {
    let plane = moments::Plane { point: DVec3::ZERO, normal: DVec3::Z };
    let points: Vec<DVec3> = (0..60)
        .map(f64::from)
        .map(|i| DVec3::new(3.0 * (i * 1.7).sin(), (i * 2.3).cos() + 0.3 * i.sin(), 0.0))
        .collect();
    let best = rectangle::around(&points, &plane).area();
    for step in 0..900 {
        let along = DVec3::new((f64::from(step) * 0.001_745).cos(), (f64::from(step) * 0.001_745).sin(), 0.0);
        let extent = |axis: DVec3| {
            let (low, high) = points
                .iter()
                .map(|p| p.dot(axis))
                .fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(x), h.max(x)));
            high - low
        };
        let area = extent(along) * extent(DVec3::Z.cross(along));
        assert!(best <= area * (1.0 + 1e-12), "{step}: {best} {area}");
    }
}
