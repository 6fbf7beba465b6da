//! Scenes: those that are kept are read, and no text makes the reader panic or let through what is not sound.

use crate::support::check;
use lobe_codegen::glam::Vec3;
use lobe_tests::scene::{Light, Ray, Scene};
use proptest::prelude::*;
use std::path::PathBuf;

/// The texts of `tests/cases/scenes`, by name.
fn kept() -> Vec<(String, String)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("cases/scenes");
    let mut found: Vec<_> = std::fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "json"))
        .map(|path| {
            let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
            (name, std::fs::read_to_string(path).expect("text"))
        })
        .collect();
    found.sort();
    found
}

#[test]
fn every_kept_scene_is_read() {
    let kept = kept();
    assert_eq!(kept.len(), 11);
    for (name, text) in kept {
        let scene = Scene::from_json(&text).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!(scene.name, name);
        assert_eq!(scene.camera.size, [128, 128]);
        assert_sound(&scene);
    }
}

/// The middle of the box's front is seen in the middle of the picture.
#[test]
fn a_camera_looks_at_what_it_is_told_to() {
    let (_, text) = kept().into_iter().find(|(name, _)| name == "cornell_L0").expect("it is kept");
    let camera = Scene::from_json(&text).expect("a scene").camera;
    let corners =
        [(63, 63), (64, 63), (63, 64), (64, 64)].map(|(column, row)| camera.ray(column, row).direction);
    let middle = corners.into_iter().sum::<Vec3>().normalize();
    let Ray { origin, .. } = camera.ray(0, 0);
    let wanted = (Vec3::new(0.015, 0.97, 0.0) - origin).normalize();
    assert!((middle - wanted).length() < 1e-6, "{middle} {wanted}");
}

#[track_caller]
pub(crate) fn assert_sound(scene: &Scene) {
    assert!(!scene.lights.is_empty() && scene.rectangles.len() + scene.triangles.len() > 0, "{scene:?}");
    let is_unit = |v: Vec3| (v.length() - 1.0).abs() < 1e-6;
    for light in &scene.lights {
        match *light {
            Light::Directional { to_light, irradiance } => {
                assert!(is_unit(to_light) && irradiance.is_finite(), "{light:?}");
            }
            Light::Spot { position, axis, inner, outer, intensity } => {
                assert!(is_unit(axis) && position.is_finite() && intensity.is_finite(), "{light:?}");
                assert!(inner < outer, "{light:?}");
            }
        }
    }
    for rectangle in &scene.rectangles {
        assert!(is_unit(rectangle.normal) && rectangle.center.is_finite(), "{rectangle:?}");
        assert!(rectangle.half_u.length() > 0.0 && rectangle.half_v.length() > 0.0, "{rectangle:?}");
        assert!(rectangle.material < scene.materials.len(), "{rectangle:?}");
    }
    for triangle in &scene.triangles {
        assert!(is_unit(triangle.normal) && triangle.vertices.iter().all(|v| v.is_finite()), "{triangle:?}");
        assert!(triangle.material < scene.materials.len(), "{triangle:?}");
    }
    assert_details_sound(scene);
    for (name, material) in &scene.materials {
        assert!((0.02..=1.0).contains(&material.alpha), "{name}");
        for share in [material.diffuse_albedo, material.f0, Vec3::splat(material.f90)] {
            assert!(share.min_element() >= 0.0 && share.max_element() <= 1.0, "{name}");
        }
    }
    let [width, height] = scene.camera.size;
    for (column, row) in [(0, 0), (width - 1, height - 1), (width / 2, height / 2)] {
        let Ray { origin, direction } = scene.camera.ray(column, row);
        assert!(origin.is_finite() && is_unit(direction), "{origin} {direction}");
    }
}

/// Every corner, skin and texel that is named is there.
#[track_caller]
fn assert_details_sound(scene: &Scene) {
    let is_unit = |v: Vec3| (v.length() - 1.0).abs() < 1e-5;
    let details = &scene.details;
    for detail in scene.triangles.iter().filter_map(|triangle| triangle.detail) {
        assert!(detail.corners.iter().all(|corner| (*corner as usize) < details.corners.len()), "{detail:?}");
        assert!((detail.skin as usize) < details.skins.len(), "{detail:?}");
    }
    for corner in &details.corners {
        assert!(is_unit(corner.normal) && corner.uvs.iter().all(|uv| uv.is_finite()), "{corner:?}");
        assert!(is_unit(corner.tangent) || corner.tangent == Vec3::ZERO, "{corner:?}");
        assert!(corner.handedness.abs() == 1.0, "{corner:?}");
    }
    for image in details.skins.iter().flat_map(|skin| skin.images) {
        let end = u64::from(image.first) + u64::from(image.width) * u64::from(image.height);
        assert!(end <= details.texels.len() as u64, "{image:?}");
    }
}

/// A change of a text.
#[derive(Debug, Clone)]
pub(crate) enum Change {
    Remove(usize, usize),
    Insert(usize, String),
    Number(usize, String),
}

pub(crate) fn change() -> impl Strategy<Value = Change> {
    let numbers = [
        "0", "-0.0", "1e308", "-1e308", "1e-308", "1e9", "1", "-1", "null", "NaN", "90", "16385", "\"\"",
        "[]",
    ];
    let number = prop::sample::select(numbers.to_vec()).prop_map(str::to_owned);
    prop_oneof![
        (any::<usize>(), 1usize..40).prop_map(|(at, n)| Change::Remove(at, n)),
        (any::<usize>(), "[\\[\\]{}:,\"0-9eE.+-]{1,3}").prop_map(|(at, text)| Change::Insert(at, text)),
        (any::<usize>(), number).prop_map(|(at, text)| Change::Number(at, text)),
    ]
}

pub(crate) fn changed(text: &str, change: &Change) -> String {
    let place =
        |at: usize| (at % (text.len() + 1)..).find(|&at| text.is_char_boundary(at)).unwrap_or(text.len());
    match change {
        Change::Remove(at, n) => {
            let start = place(*at);
            let end =
                (start + n..).find(|&at| at >= text.len() || text.is_char_boundary(at)).unwrap_or(text.len());
            format!("{}{}", &text[..start], &text[end.min(text.len())..])
        }
        Change::Insert(at, inserted) => {
            let at = place(*at);
            format!("{}{inserted}{}", &text[..at], &text[at..])
        }
        Change::Number(at, number) => {
            let digits = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | 'e');
            let places: Vec<_> = text.match_indices(|c: char| c.is_ascii_digit()).map(|(at, _)| at).collect();
            let Some(&inside) = places.get(at % places.len().max(1)) else { return text.to_owned() };
            let start = text[..inside].rfind(|c: char| !digits(c)).map_or(0, |at| at + 1);
            let end = text[inside..].find(|c: char| !digits(c)).map_or(text.len(), |n| inside + n);
            format!("{}{number}{}", &text[..start], &text[end..])
        }
    }
}

#[test]
fn spoilt_texts_are_refused_or_sound() {
    let texts: Vec<String> = kept().into_iter().map(|(_, text)| text).collect();
    let strategy = (prop::sample::select(texts), prop::collection::vec(change(), 1..4));
    check(strategy, |(text, changes)| {
        let text = changes.iter().fold(text, |text, change| changed(&text, change));
        match Scene::from_json(&text) {
            Ok(scene) => assert_sound(&scene),
            Err(error) => prop_assert!(!error.to_string().is_empty()),
        }
        Ok(())
    });
}
