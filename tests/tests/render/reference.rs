//! The reference against pictures of an independent renderer (`tests/cases/reference`), and methods against it.

use crate::picture;
use lobe_codegen::glam::Vec3;
use lobe_kernels::reference::running_mean::luminance;
use lobe_tests::render::{Method, Picture};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// What is kept of an independent picture.
#[derive(serde::Deserialize)]
struct Kept {
    layers: BTreeMap<String, Layer>,
}

/// Means of a layer.
#[derive(serde::Deserialize)]
struct Layer {
    /// Of the whole picture, linear RGB.
    mean: [f64; 3],
    /// Of the luminance in 8 by 8 blocks, row by row.
    blocks: Vec<f64>,
    /// Standard error of the whole picture's luminance.
    error: Option<f64>,
}

/// Pixels along a side of a picture, and blocks.
const SIDE: usize = 128;
const BLOCKS: usize = 8;
const BLOCK: usize = SIDE / BLOCKS;

fn kept(name: &str) -> Kept {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("cases/reference/{name}.json"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    serde_json::from_str(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn mean(pixels: &[Vec3]) -> f64 {
    pixels.iter().map(|p| f64::from(luminance(*p))).sum::<f64>() / pixels.len() as f64
}

fn luminance_of(rgb: [f64; 3]) -> f64 {
    0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]
}

/// Mean luminance and its standard error in a block.
fn block(pixels: &[Vec3], errors: Option<&[Vec3]>, at: usize) -> (f64, f64) {
    let places = (0..BLOCK * BLOCK)
        .map(|i| (at / BLOCKS * BLOCK + i / BLOCK) * SIDE + at % BLOCKS * BLOCK + i % BLOCK);
    let count = (BLOCK * BLOCK) as f64;
    let sum: f64 = places.clone().map(|i| f64::from(luminance(pixels[i]))).sum();
    let variance: f64 = places.map(|i| errors.map_or(0.0, |e| f64::from(e[i].x).powi(2))).sum();
    (sum / count, variance.sqrt() / count)
}

/// Whole pictures within 0.5 % and 4 standard errors of both, and blocks within 2 % of the picture and 5 of ours.
fn check(name: &str, samples: u32) {
    let found = picture(&crate::scene(&format!("{name}.json")), Method::Reference, samples);
    for (layer, kept) in &kept(name).layers {
        let pixels = found.layer(layer).unwrap_or_else(|| panic!("{name}: there is no {layer}"));
        let errors = found.layer(&format!("se_{layer}"));
        let wanted = luminance_of(kept.mean);
        if let Some(errors) = errors {
            let own: f64 =
                errors.iter().map(|e| f64::from(e.x).powi(2)).sum::<f64>().sqrt() / errors.len() as f64;
            let permitted = 0.005 * wanted + 4.0 * own.hypot(kept.error.unwrap_or(0.0));
            let gap = mean(pixels) - wanted;
            assert!(
                gap.abs() <= permitted,
                "{name}, {layer}: {gap:e} of {wanted:e} off, {permitted:e} permitted"
            );
        }
        if layer.contains("fromspec") {
            continue;
        }
        for (at, wanted_here) in kept.blocks.iter().enumerate() {
            let (here, own) = block(pixels, errors, at);
            let permitted = 0.02 * wanted + 0.02 * wanted_here + 5.0 * own;
            assert!(
                (here - wanted_here).abs() <= permitted,
                "{name}, {layer}, block {at}: {here:e} for {wanted_here:e}"
            );
        }
    }
}

#[test]
fn cornell_boxes() {
    for name in ["cornell_L0", "cornell_L1", "cornell_L2", "cornell_L3"] {
        check(name, 128);
    }
}

#[test]
fn plates() {
    for name in ["plates_a005", "plates_a010", "plates_a020", "plates_a040"] {
        check(name, 128);
    }
}

#[test]
fn caustics() {
    for name in ["caustic_a002", "caustic_a005", "caustic_a010"] {
        check(name, 128);
    }
}

/// Mean of a layer of a method over the independent picture's.
fn ratio(found: &Picture, name: &str, layer: &str) -> f64 {
    let pixels = found.layer(layer).unwrap_or_else(|| panic!("{name}: there is no {layer}"));
    mean(pixels) / luminance_of(kept(name).layers[layer].mean)
}

/// Means that were measured (`tests/SCENES.md`), held within 0.02.
#[test]
fn methods_are_as_far_from_the_reference_as_documented() {
    for (name, corrected, single, split, quadrature) in MEASURED {
        for (method, wanted) in [
            (Method::Rect, corrected),
            (Method::RectLaplaceSingle, single),
            (Method::RectLaplace, split),
            (Method::RectQuadrature, quadrature),
        ] {
            let picture = picture(&crate::scene(&format!("{name}.json")), method, 1);
            let found = ratio(&picture, name, "indirect_specular_fromspec_novis");
            assert!((found - wanted).abs() < 0.02, "{name}, {method}: {found:.3} instead of {wanted}");
        }
    }
}

/// Scene; `rect`, `rect-laplace-single`, `rect-laplace`, `rect-quadrature`.
const MEASURED: [(&str, f64, f64, f64, f64); 8] = [
    ("cornell_L0", 1.053, 0.851, 0.947, 0.979),
    ("cornell_L1", 0.261, 0.547, 0.963, 1.001),
    ("cornell_L2", 1.143, 0.757, 0.904, 0.997),
    ("cornell_L3", 0.164, 0.609, 0.846, 0.993),
    ("plates_a005", 0.736, 0.933, 0.999, 1.027),
    ("plates_a010", 1.016, 0.843, 1.012, 0.993),
    ("plates_a020", 1.121, 0.794, 0.873, 1.008),
    ("plates_a040", 1.075, 0.820, 0.930, 1.010),
];

/// All light of one bounce, which [`Method::RectQuadrature`] has: held within 0.01.
#[test]
fn the_quadrature_has_all_light_of_one_bounce() {
    for (name, wanted) in WHOLE {
        let picture = picture(&crate::scene(&format!("{name}.json")), Method::RectQuadrature, 1);
        let layers = ["indirect_specular_novis", "indirect_diffuse_novis", "indirect_total_novis"];
        for (layer, wanted) in layers.into_iter().zip(wanted) {
            let found = ratio(&picture, name, layer);
            assert!((found - wanted).abs() < 0.01, "{name}, {layer}: {found:.3} instead of {wanted}");
        }
    }
}

/// Scene; the pixel's glossy lobe, its diffuse one, both.
const WHOLE: [(&str, [f64; 3]); 8] = [
    ("cornell_L0", [0.979, 0.994, 0.983]),
    ("cornell_L1", [0.992, 0.998, 0.996]),
    ("cornell_L2", [0.993, 0.995, 0.994]),
    ("cornell_L3", [0.988, 0.993, 0.990]),
    ("plates_a005", [1.026, 1.011, 1.024]),
    ("plates_a010", [0.995, 1.004, 0.996]),
    ("plates_a020", [1.010, 0.998, 1.008]),
    ("plates_a040", [1.012, 0.999, 1.010]),
];
