//! Shadows of the rectangle method: none where nothing is in the way, whole where something is, and nearer to the truth.

use super::{picture, picture_by, scene};
use lobe_tests::render::{Method, Picture, Settings};
use lobe_tests::scene::{Light, Scene};

/// Methods that have shadows, and how much of what a shadow takes they may err by.
const METHODS: [(Method, f64); 2] = [(Method::RectLaplace, 0.5), (Method::RectQuadrature, 0.1)];

fn shadowed(scene: &Scene, method: Method) -> Picture {
    picture_by(scene, &Settings { method, shadows: true, ..Settings::default() })
}

fn layer(picture: &Picture, name: &str) -> Vec<[f32; 3]> {
    let pixels = picture.layer(name).unwrap_or_else(|| panic!("no layer {name}"));
    pixels.iter().map(|p| p.to_array()).collect()
}

fn mean(picture: &Picture, name: &str) -> f64 {
    let values = layer(picture, name);
    values.iter().flatten().map(|v| f64::from(*v)).sum::<f64>() / (3 * values.len()) as f64
}

/// The components of a picture with shadows, without their suffix.
fn parts(picture: &Picture) -> Vec<String> {
    let names = picture.layers.iter().filter(|layer| layer.name.starts_with("indirect"));
    names.filter_map(|layer| Some(layer.name.strip_suffix("_vis")?.to_owned())).collect()
}

#[test]
fn nothing_in_the_way_is_no_shadow() {
    let mut scene = scene("plates_a010.json");
    scene.camera.size = [48; 2];
    for (method, _) in METHODS {
        let (with, without) = (shadowed(&scene, method), picture(&scene, method, 0));
        assert!(parts(&with).len() >= 3, "{method}: {:?}", parts(&with));
        for part in parts(&with) {
            let lit = |of: &Picture, kind: &str| layer(of, &format!("{part}_{kind}"));
            assert_eq!(lit(&with, "vis"), lit(&without, "novis"), "{method}, {part}");
            assert!(mean(&with, &format!("{part}_vis")) > 0.0, "{method}, {part}");
        }
    }
}

#[test]
fn pixels_that_take_turns_are_those_of_one_turn() {
    let mut scene = screened(0.5);
    let whole = shadowed(&scene, Method::RectQuadrature);
    // The light in 40 parts, whose rays are too many for one turn of all pixels.
    let Light::Directional { to_light, irradiance } = scene.lights[0] else { panic!("another light") };
    scene.lights = vec![Light::Directional { to_light, irradiance: irradiance / 40.0 }; 40];
    let bands = shadowed(&scene, Method::RectQuadrature);
    let late = &layer(&whole, "indirect_total_vis")[whole.radiance.len() / 2..];
    assert!(late.iter().flatten().any(|v| *v > 0.0), "no light of one bounce in a later turn");
    for (one, other) in whole.radiance.iter().zip(&bands.radiance) {
        assert!((*one - *other).abs().max_element() <= 1e-5 * one.max_element(), "{one} and {other}");
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
    for (method, _) in METHODS {
        let (open, closed) = (shadowed(&screened(0.001), method), shadowed(&screened(3.0), method));
        for part in parts(&open) {
            let part = format!("{part}_vis");
            assert!(mean(&open, &part) > 1e-4, "{method}, {part}: {}", mean(&open, &part));
            assert_eq!(mean(&closed, &part), 0.0, "{method}, {part}");
        }
        let unshadowed = picture(&screened(3.0), method, 0);
        assert!(mean(&unshadowed, "indirect_diffuse_novis") > 1e-3, "{method} itself knows of no screen");
    }
}

#[test]
fn half_a_screen_is_nearer_to_the_truth_than_none() {
    let scene = screened(0.5);
    let truth = picture(&scene, Method::Reference, 256);
    for (method, share) in METHODS {
        let (with, without) = (shadowed(&scene, method), picture(&scene, method, 0));
        for part in parts(&with) {
            let (vis, novis) = (format!("{part}_vis"), format!("{part}_novis"));
            let (truth, with, without) = (mean(&truth, &vis), mean(&with, &vis), mean(&without, &novis));
            let is_nearer = (with - truth).abs() < share * (without - truth).abs();
            println!("{method}, {part}: {with}, {without}, in truth {truth}");
            assert!(is_nearer, "{method}, {part}: {with}, {without}, in truth {truth}");
        }
    }
}
