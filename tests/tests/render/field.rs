//! The light-field texture: with room for all rectangles the picture is that of all rectangles.

use lobe_backends::pipeline::Interpreted;
use lobe_codegen::glam::Vec3;
use lobe_tests::proxies::{self, Options};
use lobe_tests::render::{LightField, Method, Picture, Renderer, Settings};
use lobe_tests::scene::Scene;

/// A box of which five surfaces are seen, few enough for a list.
fn small() -> Scene {
    let mut scene = crate::scene("cornell_L0.json");
    scene.rectangles.truncate(8);
    scene.camera.size = [48, 48];
    scene
}

const METHODS: [Method; 2] = [Method::RectLaplace, Method::RectQuadrature];

fn by_field(renderer: &Renderer, scene: &Scene, method: Method, field: &mut LightField) -> Picture {
    let proxies = proxies::proxies(scene, &Options::default()).unwrap_or_else(|e| panic!("{e}"));
    let settings = Settings { method, ..Settings::default() };
    let made = renderer.render_by_field(scene, &proxies, &settings, field, &mut Interpreted::default());
    made.unwrap_or_else(|e| panic!("{e}"))
}

/// Root of the mean squared difference over the mean, of all of one bounce.
fn error(found: &Picture, wanted: &Picture) -> f32 {
    let sum = |p: &Picture, i: usize| -> Vec3 {
        ["indirect_specular_fromspec_novis", "indirect_diffuse_novis"]
            .iter()
            .filter_map(|n| Some(p.layer(n)?[i]))
            .sum()
    };
    let count = wanted.radiance.len();
    let squares: f32 = (0..count).map(|i| (sum(found, i) - sum(wanted, i)).length_squared()).sum();
    let mean: f32 = (0..count).map(|i| sum(wanted, i).element_sum()).sum::<f32>() / count as f32;
    (squares / count as f32).sqrt() / mean
}

#[test]
fn with_room_for_all_the_picture_is_that_of_all() {
    let renderer = Renderer::new().unwrap_or_else(|e| panic!("{e}"));
    let scene = small();
    for method in METHODS {
        let wanted = crate::picture(&scene, method, 1);
        let by = |most| error(&by_field(&renderer, &scene, method, &mut LightField::new(16, most)), &wanted);
        let (whole, two, one) = (by(8), by(2), by(1));
        // The sum is in another order.
        assert!(whole < 1e-5 && whole < two && two < one, "{method}: {whole:e} {two:e} {one:e}");
    }
}

/// Of two rectangles that move one is listed: which, changes with the movement.
#[test]
fn what_stands_still_is_kept() {
    let renderer = Renderer::new().unwrap_or_else(|e| panic!("{e}"));
    let mut scene = small();
    // The floor and the back, which are lit.
    for index in [0, 1] {
        let moving = scene.rectangles.remove(index);
        scene.rectangles.push(moving);
    }
    let mut field = LightField::new(8, 1);
    (field.moving, field.moving_surfaces) = (2, 2);
    by_field(&renderer, &scene, Method::RectQuadrature, &mut field);
    let [.., a, b] = scene.rectangles.as_mut_slice() else { panic!("the scene has two surfaces") };
    std::mem::swap(&mut a.center, &mut b.center);
    assert!(a.name == "floor" && b.name == "back");
    let kept = by_field(&renderer, &scene, Method::RectQuadrature, &mut field);
    field.forget();
    let anew = by_field(&renderer, &scene, Method::RectQuadrature, &mut field);
    assert_eq!(kept, anew);
}
