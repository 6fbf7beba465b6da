//! Virtual lights against the reference, and in scenes that leave little of them.

use lobe_codegen::glam::Vec3;
use lobe_tests::metrics::{Image, Pair, radiometry};
use lobe_tests::render::{Density, Method, Picture, Reading, Settings, VirtualLights, Visibility};
use lobe_tests::scene::{Light, Scene};

const SIZE: u32 = 32;

fn scene(name: &str) -> Scene {
    let mut scene = crate::scene(name);
    scene.camera.size = [SIZE, SIZE];
    scene
}

fn settings(method: Method, virtual_lights: VirtualLights) -> Settings {
    Settings { method, virtual_lights, ..Settings::default() }
}

fn truth(scene: &Scene, samples: u32) -> Picture {
    crate::picture_by(scene, &Settings { method: Method::Reference, samples, ..Settings::default() })
}

/// Mean ratio and relative RMSE of a layer.
fn compared(picture: &Picture, truth: &Picture, layer: &str) -> (f64, f64) {
    let image = |picture: &Picture| {
        let pixels = picture.layer(layer).unwrap_or_else(|| panic!("no layer {layer}"));
        Image { size: picture.size, pixels: pixels.to_vec() }
    };
    let (picture, truth) = (image(picture), image(truth));
    let found = radiometry(&Pair::new(&picture, &truth).unwrap_or_else(|e| panic!("{e}")));
    (found.mean_ratio.unwrap_or(f64::NAN), found.relative_rmse.unwrap_or(f64::NAN))
}

#[test]
fn point_lights_are_the_light_of_one_bounce() {
    let scene = scene("plates_a010.json");
    let truth = truth(&scene, 2048);
    for density in Density::ALL {
        let lights = VirtualLights { count: 8192, density, ..VirtualLights::default() };
        let found = crate::picture_by(&scene, &settings(Method::Vpl, lights));
        for layer in ["indirect_total_la", "indirect_diffuse_la", "indirect_specular_fromspec_la"] {
            let (mean_ratio, _) = compared(&found, &truth, layer);
            assert!((mean_ratio - 1.0).abs() < 0.04, "{density}, {layer}: {mean_ratio}");
        }
    }
}

#[test]
fn shadows_of_point_lights_are_those_of_the_reference() {
    let scene = scene("cornell_L1.json");
    let truth = truth(&scene, 1024);
    let lights = VirtualLights { count: 4096, visibility: Visibility::Exact, ..VirtualLights::default() };
    let found = crate::picture_by(&scene, &settings(Method::Vpl, lights));
    let (mean_ratio, _) = compared(&found, &truth, "indirect_diffuse_vis");
    assert!((mean_ratio - 1.0).abs() < 0.06, "{mean_ratio}");
}

#[test]
fn wide_lights_are_less_noisy_than_points_and_converge() {
    for (name, share) in [("plates_a005.json", 0.75), ("caustic_a010.json", 0.85)] {
        let scene = scene(name);
        let truth = truth(&scene, 4096);
        let of = |method, count| {
            let lights = VirtualLights { count, smoothing: 1.0, ..VirtualLights::default() };
            compared(&crate::picture_by(&scene, &settings(method, lights)), &truth, "indirect_total_la")
        };
        let (points, wide, many) =
            (of(Method::Vpl, 1024), of(Method::VslWide, 1024), of(Method::VslWide, 16384));
        assert!(wide.1 < share * points.1, "{name}: {wide:?}, {points:?}");
        assert!(many.1 < 0.8 * wide.1, "{name}: {many:?}, {wide:?}");
        assert!((many.0 - 1.0).abs() < (wide.0 - 1.0).abs(), "{name}: {many:?}, {wide:?}");
    }
}

/// The box, with all lengths multiplied.
fn scaled(factor: f64) -> Scene {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/cases/scenes/cornell_L0.json");
    let text = std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{path}: {e}"));
    let mut json: serde_json::Value = serde_json::from_str(&text).unwrap_or_else(|e| panic!("{path}: {e}"));
    json["camera"]["width"] = 8.into();
    json["camera"]["height"] = 8.into();
    let numbers = |value: &mut serde_json::Value| {
        for number in value.as_array_mut().into_iter().flatten() {
            *number = (factor * number.as_f64().unwrap_or(0.0)).into();
        }
    };
    for key in ["position", "look_at"] {
        numbers(&mut json["camera"][key]);
    }
    for rect in json["rects"].as_array_mut().into_iter().flatten() {
        ["center", "half_u", "half_v"].iter().for_each(|key| numbers(&mut rect[*key]));
    }
    Scene::from_json(&json.to_string()).unwrap_or_else(|e| panic!("{e}"))
}

/// What is left of a scene, and by what it is lit.
fn spoilt() -> Vec<(&'static str, Scene)> {
    let with = |change: &dyn Fn(&mut Scene)| {
        let mut scene = scene("cornell_L0.json");
        scene.camera.size = [8, 8];
        change(&mut scene);
        scene
    };
    let spot = |position: Vec3| Light::Spot {
        position,
        axis: Vec3::NEG_Y,
        inner: 0.1,
        outer: 1.5,
        intensity: Vec3::splat(10.0),
    };
    let floor = |scene: &Scene| scene.rectangles[0].center;
    vec![
        ("a light in a wall", with(&|scene| scene.lights = vec![spot(floor(scene))])),
        ("a light that nothing is before", with(&|scene| scene.lights = vec![spot(Vec3::splat(-1e3))])),
        (
            "no light",
            with(&|scene| {
                let dark = Light::Directional { to_light: Vec3::Y, irradiance: Vec3::ZERO };
                scene.lights = vec![dark];
            }),
        ),
        ("a small scene", scaled(1e-3)),
        ("a large scene", scaled(1e4)),
    ]
}

/// Lights with shadows of both kinds, by few points and by many.
fn shadowed(lights: VirtualLights) -> Vec<VirtualLights> {
    let imperfect = |shadow_points, shadow_map, shadow_floor| VirtualLights {
        visibility: Visibility::Imperfect,
        shadow_points,
        shadow_map,
        shadow_floor,
        ..lights
    };
    let exact = VirtualLights { visibility: Visibility::Exact, ..lights };
    vec![exact, imperfect(1, 1, 0.0), imperfect(3, 16, 1.0), imperfect(30, 8, 0.25)]
}

#[test]
fn whatever_is_left_gives_a_picture() {
    let methods =
        [Method::Vpl, Method::Vsl, Method::VslWide, Method::Vsgl, Method::Vsgl2, Method::Vsgl2Paper];
    for (what, scene) in spoilt() {
        for method in methods {
            for (count, map, smoothing) in [(1, 1, 4.0), (7, 5, 0.01), (64, 16, 100.0), (64, 33, 0.0)] {
                let lights = VirtualLights { count, map, smoothing, ..VirtualLights::default() };
                for lights in shadowed(lights) {
                    let picture = crate::picture_by(&scene, &settings(method, lights));
                    assert!(picture.is_sound(), "{what}, {method}, {lights:?}");
                }
            }
        }
    }
}

#[test]
fn many_pictures_are_closer_than_one() {
    let scene = scene("caustic_a005.json");
    let truth = truth(&scene, 2048);
    let of = |frames| {
        let reading = Some(Reading::Square);
        let lights = VirtualLights { count: 256, frames, shrink: 0.9, reading, ..VirtualLights::default() };
        compared(&crate::picture_by(&scene, &settings(Method::VslWide, lights)), &truth, "indirect_total_la")
            .1
    };
    let (one, many) = (of(1), of(24));
    assert!(many < 0.8 * one, "{many} after {one}");
}
