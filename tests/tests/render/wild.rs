//! Scenes that a careful author would not write: each a picture of light, with every method.

use crate::{picture, picture_by};
use lobe_codegen::glam::{Quat, Vec3};
use lobe_tests::domain::Rng;
use lobe_tests::render::{Method, Settings};
use lobe_tests::scene::{Light, Scene};

/// What is done to a scene.
type Change = fn(&mut Scene, &mut Rng);

const CHANGES: [(&str, Change); 8] = [
    ("tiny", |scene, _| scale(scene, 1e-3)),
    ("huge", |scene, _| scale(scene, 1e3)),
    ("light from below", |scene, _| scene.lights[0] = directional(Vec3::NEG_Y)),
    ("light along a surface", |scene, _| scene.lights[0] = directional(Vec3::X)),
    ("a light in a wall", |scene, _| {
        let position = scene.rectangles[0].center;
        let (inner, outer) = (0.5, 1.0);
        scene.lights[0] = Light::Spot { position, axis: Vec3::Y, inner, outer, intensity: Vec3::splat(1e3) };
    }),
    ("mirrors", |scene, _| scene.materials.iter_mut().for_each(|(_, m)| m.alpha = 0.02)),
    ("turned surfaces", |scene, rng| {
        for surface in &mut scene.rectangles {
            let turn = Quat::from_rotation_arc(Vec3::Y, direction(rng));
            surface.half_u = turn * surface.half_u;
            surface.half_v = turn * surface.half_v;
            surface.normal = turn * surface.normal;
        }
    }),
    ("slivers", |scene, rng| {
        for surface in &mut scene.rectangles {
            surface.half_u *= 10f32.powf(-4.0 * rng.unit() as f32);
        }
    }),
];

fn directional(to_light: Vec3) -> Light {
    Light::Directional { to_light, irradiance: Vec3::splat(1e3) }
}

fn direction(rng: &mut Rng) -> Vec3 {
    let mut number = || (2.0 * rng.unit() - 1.0) as f32;
    Vec3::new(number(), number(), number()).normalize_or(Vec3::Y)
}

fn scale(scene: &mut Scene, factor: f32) {
    for surface in &mut scene.rectangles {
        surface.center *= factor;
        surface.half_u *= factor;
        surface.half_v *= factor;
    }
    scene.camera = scene.camera.scaled(factor);
    for light in &mut scene.lights {
        if let Light::Spot { position, intensity, .. } = light {
            *position *= factor;
            *intensity *= factor * factor;
        }
    }
}

#[test]
fn wild_scenes_are_pictures_of_light() {
    let seed = std::env::var("LOBE_SEED").ok().and_then(|s| s.parse().ok()).unwrap_or(7);
    for name in ["cornell_L0.json", "caustic_a002.json", "plates_a040.json"] {
        for (what, change) in CHANGES {
            let mut rng = Rng::new(seed, what);
            let mut scene = crate::scene(name);
            change(&mut scene, &mut rng);
            scene.camera.size = [24, 24];
            for method in Method::ALL {
                let picture = picture(&scene, method, 8);
                assert!(picture.is_sound(), "{name}, {what}, {method}, seed {seed}");
                if method.has_shadows() {
                    let settings = Settings { method, shadows: true, ..Settings::default() };
                    let shadowed = picture_by(&scene, &settings);
                    assert!(shadowed.is_sound(), "{name}, {what}, {method} with shadows, seed {seed}");
                }
            }
        }
    }
}
