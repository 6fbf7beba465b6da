//! Shadows of the rectangle method: none where nothing is in the way, whole where something is, and nearer to the truth.

use super::{picture, picture_by, scene};
use lobe_tests::render::{Method, Picture, Settings};
use lobe_tests::scene::Scene;

fn shadowed(scene: &Scene) -> Picture {
    picture_by(scene, &Settings { shadows: true, ..Settings::default() })
}

fn layer(picture: &Picture, name: &str) -> Vec<[f32; 3]> {
    let pixels = picture.layer(name).unwrap_or_else(|| panic!("no layer {name}"));
    pixels.iter().map(|p| p.to_array()).collect()
}

fn mean(picture: &Picture, name: &str) -> f64 {
    let values = layer(picture, name);
    values.iter().flatten().map(|v| f64::from(*v)).sum::<f64>() / (3 * values.len()) as f64
}

#[test]
fn nothing_in_the_way_is_no_shadow() {
    let mut scene = scene("plates_a010.json");
    scene.camera.size = [48; 2];
    let (with, without) = (shadowed(&scene), picture(&scene, Method::RectLaplace, 0));
    for part in ["indirect_specular_fromspec", "indirect_diffuse_fromspec", "indirect_diffuse"] {
        let lit = |of: &Picture, kind: &str| layer(of, &format!("{part}_{kind}"));
        assert_eq!(lit(&with, "vis"), lit(&without, "novis"), "{part}");
        assert!(mean(&with, &format!("{part}_vis")) > 0.0, "{part}");
    }
}

/// A glossy wall before a floor, and a screen between: `half` its height over 2 m.
fn screened(height: f32) -> Scene {
    let text = format!(
        r#"{{"format": "glossy-oracle-scene/1", "name": "screened",
        "camera": {{"position": [0, 3, 4], "look_at": [0, 0, 0], "up": [0, 1, 0], "vfov_deg": 40, "width": 32, "height": 32}},
        "lights": [{{"type": "directional", "direction": [0, -0.4, -1], "irradiance": [1, 1, 1]}}],
        "materials": {{"all": {{"diffuse_albedo": [0.5, 0.5, 0.5], "specular_f0": [0.5, 0.5, 0.5], "specular_f90": 1, "ggx_alpha": 0.3}}}},
        "rects": [
            {{"center": [0, 0, 0], "half_u": [0, 0, 1], "half_v": [1, 0, 0], "material": "all"}},
            {{"center": [0, 1, -2], "half_u": [2, 0, 0], "half_v": [0, 1, 0], "material": "all"}},
            {{"center": [0, {height}, -1.5], "half_u": [0, {height}, 0], "half_v": [4, 0, 0], "material": "all"}}]}}"#
    );
    Scene::from_json(&text).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn a_screen_takes_all_light() {
    // The screen's back is dark, its front hides the wall; light comes over the camera.
    let (open, closed) = (shadowed(&screened(0.001)), shadowed(&screened(3.0)));
    for part in ["indirect_specular_fromspec_vis", "indirect_diffuse_fromspec_vis", "indirect_diffuse_vis"] {
        assert!(mean(&open, part) > 1e-4, "{part}: {}", mean(&open, part));
        assert_eq!(mean(&closed, part), 0.0, "{part}");
    }
    let unshadowed = picture(&screened(3.0), Method::RectLaplace, 0);
    assert!(mean(&unshadowed, "indirect_diffuse_novis") > 1e-3, "the method itself knows of no screen");
}

#[test]
fn half_a_screen_is_nearer_to_the_truth_than_none() {
    let scene = screened(0.5);
    let truth = mean(&picture(&scene, Method::Reference, 256), "indirect_diffuse_vis");
    let with = mean(&shadowed(&scene), "indirect_diffuse_vis");
    let without = mean(&picture(&scene, Method::RectLaplace, 0), "indirect_diffuse_novis");
    let is_nearer = (with - truth).abs() < 0.5 * (without - truth).abs();
    assert!(is_nearer && with > 0.25 * truth, "{with}, {without}, in truth {truth}");
}
