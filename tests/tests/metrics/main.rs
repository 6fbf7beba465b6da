//! Metrics of pictures: FLIP against the program of its authors, and what every metric must have.

mod pictures;

use lobe_codegen::glam::Vec3;
use lobe_tests::domain::Rng;
use lobe_tests::metrics::flip::{Exposures, ToneMap, exposures, hdr, ldr};
use lobe_tests::metrics::{Image, Map, Pair, PairError, Range, Viewing, compare, radiometry};
use pictures::picture;

/// What the authors' program says of two pictures.
#[derive(serde::Deserialize)]
struct Expected {
    picture: String,
    truth: String,
    pixels_per_degree: f32,
    tone_map: Option<String>,
    exposures: Option<[f32; 2]>,
    count: Option<u32>,
    mean: f64,
    max: f32,
    /// Column, row, value.
    pixels: Vec<(usize, usize, f32)>,
}

fn tone_map(name: &str) -> ToneMap {
    match name {
        "aces" => ToneMap::Aces,
        "hable" => ToneMap::Hable,
        "reinhard" => ToneMap::Reinhard,
        name => panic!("there is no curve `{name}`"),
    }
}

fn expected() -> Vec<Expected> {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/metrics/flip.json");
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    serde_json::from_str(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// Our map, whose exposures are the expected ones.
fn map(row: &Expected, pair: &Pair<'_>) -> Map {
    let Some(name) = &row.tone_map else { return ldr(pair, row.pixels_per_degree) };
    let found = exposures(pair.truth(), tone_map(name));
    let [start, stop] = row.exposures.expect("they are used");
    let is_close = |a: f32, b: f32| (a - b).abs() < 1e-5 * a.abs().max(1.0);
    assert!(is_close(found.start, start) && is_close(found.stop, stop), "{found:?} for {start} to {stop}");
    assert_eq!(Some(found.count), row.count);
    hdr(pair, row.pixels_per_degree, tone_map(name), &found)
}

#[test]
fn flip_is_that_of_its_authors() {
    let rows = expected();
    assert_eq!(rows.len(), 25);
    let mut worst = (0.0_f64, 0.0_f32);
    for row in rows {
        let (found, truth) = (picture(&row.picture), picture(&row.truth));
        let map = map(&row, &Pair::new(&found, &truth).expect("they may be compared"));
        let what = format!("{} for {}, {:?}", row.picture, row.truth, row.tone_map);
        let pooled = map.pooled();
        let off = (pooled.mean - row.mean).abs();
        assert!(off < 1e-4, "{what}: {} instead of {}", pooled.mean, row.mean);
        worst.0 = worst.0.max(off);
        let pixels = row.pixels.iter().map(|&(x, y, wanted)| (map.values[y * 64 + x], wanted));
        for (value, wanted) in pixels.chain([(pooled.max, row.max)]) {
            assert!((value - wanted).abs() < 1e-3, "{what}: {value} instead of {wanted}");
            worst.1 = worst.1.max((value - wanted).abs());
        }
    }
    println!("worst mean {:e}, worst pixel {:e}", worst.0, worst.1);
}

fn with<T>(picture: &Image, truth: &Image, f: impl Fn(&Pair<'_>) -> T) -> T {
    f(&Pair::new(picture, truth).expect("they may be compared"))
}

/// 0 of equal pictures, within 0 ..= 1 and as much the other way round of others; a flat patch may be of any size.
#[test]
fn flip_is_a_difference() {
    for name in ["gradient", "noise 1", "checkers"] {
        let truth = picture(name);
        let [found, back] = {
            let other = picture("noise 2");
            [with(&other, &truth, |p| ldr(p, 40.0)), with(&truth, &other, |p| ldr(p, 40.0))]
        };
        assert!(with(&truth, &truth, |p| ldr(p, 40.0)).values.iter().all(|v| *v == 0.0), "{name}");
        assert!(found.values.iter().all(|v| (0.0..=1.0).contains(v)), "{name}");
        let apart = found.values.iter().zip(&back.values).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(apart < 1e-5, "{name}: {apart}");
    }
    let flat = |size: [u32; 2], value| Image { size, pixels: vec![value; (size[0] * size[1]) as usize] };
    let one = |size| with(&flat(size, Vec3::splat(0.4)), &flat(size, Vec3::splat(0.6)), |p| ldr(p, 67.0));
    let (small, large) = (one([1, 1]).values[0], one([30, 20]).values[299]);
    assert!((small - large).abs() < 1e-5 && small > 0.1, "{small} {large}");
}

/// No finite picture makes a number that is none, however bright, dark or negative.
#[test]
fn flip_is_a_number_for_every_finite_picture() {
    let mut rng = Rng::new(11, "wild pictures");
    for round in 0..60 {
        let scale = 10f64.powf(rng.range(-45.0, 38.0));
        let mut image = || {
            let mut number = || match rng.below(8) {
                0 => 0.0,
                1 => -rng.unit() * scale,
                2 => rng.unit() * 3e38,
                _ => rng.unit() * scale,
            };
            let mut pixel = || Vec3::new(number() as f32, number() as f32, number() as f32);
            Image { size: [5, 4], pixels: (0..20).map(|_| pixel()).collect() }
        };
        let (found, truth) = (image(), image());
        for curve in [ToneMap::Aces, ToneMap::Hable, ToneMap::Reinhard] {
            let viewing = Viewing { tone_map: curve, pixels_per_degree: 10.0 };
            let compared = with(&found, &truth, |p| compare(p, Range::High, &viewing));
            let is_sound = compared.map.values.iter().all(|v| (0.0..=1.0).contains(v));
            assert!(is_sound, "round {round}, {curve:?}: {:?} of {found:?} for {truth:?}", compared.shown);
        }
    }
}

/// A black truth is looked at as it is, and has no ratio.
#[test]
fn black_pictures_are_pictures() {
    let black = Image { size: [4, 4], pixels: vec![Vec3::ZERO; 16] };
    let grey = Image { size: [4, 4], pixels: vec![Vec3::splat(0.5); 16] };
    let found = with(&grey, &black, |p| compare(p, Range::High, &Viewing::default()));
    assert_eq!((found.radiometry.mean_ratio, found.radiometry.relative_rmse), (None, None));
    let shown = found.shown.expect("it is of high range");
    assert_eq!(shown.exposures, Exposures { start: 0.0, stop: 0.0, count: 2 });
    assert!(found.flip.mean > 0.1, "{found}");
    let same = with(&black, &black, |p| compare(p, Range::High, &Viewing::default()));
    assert_eq!(same.flip.max, 0.0);
}

#[test]
fn differences_of_light_are_those_of_the_numbers() {
    let truth = Image { size: [2, 2], pixels: [1.0, 2.0, 3.0, 2.0].map(Vec3::splat).to_vec() };
    let mut found = truth.clone();
    found.pixels[3] = Vec3::new(2.0, 2.0, 6.0);
    let radiometry = with(&found, &truth, radiometry);
    assert_eq!((radiometry.worst.x, radiometry.worst.y), (1, 1));
    assert_eq!((radiometry.worst.picture, radiometry.worst.truth), ([2.0, 2.0, 6.0], [2.0; 3]));
    let close = |value: Option<f64>, wanted: f64| (value.expect("a number") - wanted).abs() < 1e-6;
    assert!(close(radiometry.mean_ratio, 1.0 + 0.0722 * 4.0 / 8.0), "{radiometry:?}");
    assert!(close(radiometry.relative_rmse, 0.0722 * 4.0 / 4.0), "{radiometry:?}");
}

#[test]
fn what_cannot_be_compared_is_named() {
    let flat = |size: [u32; 2]| Image { size, pixels: vec![Vec3::ONE; (size[0] * size[1]) as usize] };
    let said = |a: &Image, b: &Image| Pair::new(a, b).expect_err("it is refused");
    let sizes = said(&flat([3, 2]), &flat([2, 3]));
    assert_eq!(sizes, PairError::Sizes { picture: [3, 2], truth: [2, 3] });
    assert!(matches!(
        said(&flat([0, 2]), &flat([0, 2])),
        PairError::Pixels { which: "picture", count: 0, .. }
    ));
    let mut broken = flat([3, 2]);
    broken.pixels[4].y = f32::NAN;
    assert!(matches!(said(&flat([3, 2]), &broken), PairError::NotFinite { which: "truth", x: 1, y: 1, .. }));
}

/// A few bytes that claim to be a large picture are refused before room is made for it.
#[test]
fn a_claim_of_a_few_bytes_is_not_believed() {
    let folder = tempfile::tempdir().expect("a folder");
    let check = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).expect("written");
        lobe_tests::metrics::open(&path, None).expect_err("it is none").to_string()
    };
    let chunk = |kind: &[u8], data: &[u8]| {
        let mut crc = 0xffff_ffff_u32;
        for byte in kind.iter().chain(data) {
            crc ^= u32::from(*byte);
            for _ in 0..8 {
                crc = if crc & 1 == 1 { crc >> 1 ^ 0xedb8_8320 } else { crc >> 1 };
            }
        }
        let length = (data.len() as u32).to_be_bytes();
        [&length[..], kind, data, &(!crc).to_be_bytes()].concat()
    };
    let side = 16_000_u32.to_be_bytes();
    let header = [&side[..], &side, &[16, 6, 0, 0, 0]].concat();
    let png =
        [b"\x89PNG\r\n\x1a\n".as_slice(), &chunk(b"IHDR", &header), &chunk(b"IDAT", &[0x78, 0x9c])].concat();
    let message = check("bomb.png", &png);
    assert!(message.contains("imit"), "{message}");

    let small = picture("noise 1");
    let layer = lobe_tests::render::Picture { size: small.size, radiance: small.pixels, layers: vec![] };
    let mut exr = lobe_tests::render::exr(&layer, false).expect("a file");
    for name in [b"dataWindow\0".as_slice(), b"displayWindow\0"] {
        let at = exr.windows(name.len()).position(|w| w == name).expect("an attribute") + name.len() + 10;
        for place in [at + 8, at + 12] {
            exr[place..place + 4].copy_from_slice(&99_999_i32.to_le_bytes());
        }
    }
    let message = check("bomb.exr", &exr);
    assert!(message.contains("bytes of pixels"), "{message}");
}
