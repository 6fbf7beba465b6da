//! What the binary writes as JSON follows the schemas in `tests/schema`. Those of reports of kernels are held by
//! `tests/tests/report.rs` too, with failures of all kinds.

mod common;

use common::{lobe, text};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

fn at(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

fn schema(name: &str) -> jsonschema::Validator {
    let path = at("tests/schema").join(format!("{name}-1.json"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    jsonschema::validator_for(&serde_json::from_str(&text).expect("JSON")).expect("a schema")
}

#[track_caller]
fn assert_follows(schema: &jsonschema::Validator, value: &Value) {
    let errors: Vec<String> =
        schema.iter_errors(value).map(|error| format!("{}: {error}", error.instance_path())).collect();
    assert!(errors.is_empty(), "{}\nin {value}", errors.join("\n"));
}

/// The one document that a command writes, which follows its schema.
#[track_caller]
fn document(name: &str, args: &[&str]) -> Value {
    let output = lobe(&[args, &["--format", "json"]].concat());
    let value = serde_json::from_slice(&output.stdout).unwrap_or_else(|e| {
        panic!("{e} in {}{}", text(&output.stdout), text(&output.stderr));
    });
    assert_follows(&schema(name), &value);
    value
}

/// The lines that a command writes, each of which follows its schema.
#[track_caller]
fn lines(name: &str, args: &[&str]) -> Vec<Value> {
    let output = lobe(&[args, &["--format", "json"]].concat());
    let (schema, said) = (schema(name), text(&output.stdout));
    let lines: Vec<Value> = said.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    lines.iter().for_each(|line| assert_follows(&schema, line));
    assert!(!lines.is_empty(), "nothing is written: {}", text(&output.stderr));
    lines
}

#[test]
fn reports_of_kernels() {
    document("report", &["check", "erf", "expm1_over_x_higham", "--inputs", "200", "--model", "wgsl"]);
    document("report", &["oracle", &at("tests/cases/oracle").display().to_string(), "--route", "interp"]);
}

#[test]
fn listings() {
    document("list", &["list"]);
    document("list", &["list", "--operations"]);
    document("doctor", &["doctor"]);
}

#[test]
fn descriptions_of_what_was_emitted() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().display().to_string();
    for (form, entries) in [("library", 0), ("entry", 1)] {
        lobe(&["emit", "sg_product", "--target", "wgsl", "--form", form, "--out", &out]);
        let text = std::fs::read_to_string(folder.path().join("sg_product.json")).expect("the description");
        let value: Value = serde_json::from_str(&text).expect("JSON");
        assert_follows(&schema("reflection"), &value);
        assert_eq!(value["entries"].as_array().map(Vec::len), Some(entries));
    }
}

#[test]
fn explanations() {
    for (kernel, row) in
        [("expm1_over_x_higham", "{\"x\": 0.0012}"), ("erf", "{\"x\": 1e-40}"), ("erf", "{\"x\": \"nan\"}")]
    {
        document("explain", &["explain", kernel, "--input", row, "--route", "interp"]);
    }
}

#[test]
fn faults_and_throughput() {
    document("mutate", &["mutate", "erf", "--equivalence", "0", "--inputs", "300"]);
    lines(
        "bench",
        &["bench", "triad", "--items", "1000", "--rounds", "3", "--route", "native", "--route", "interp"],
    );
}

#[test]
fn methods_against_each_other() {
    let scene = at("tests/cases/scenes/plates_a010.json").display().to_string();
    let small = ["--size", "8x8", "--truth", "64", "--rounds", "1", "--route", "interp"];
    lines("race", &[&["bench", "--render", &scene], &small[..]].concat());
}

#[test]
fn virtual_lights_over_their_number_and_in_time() {
    let scene = at("tests/cases/scenes/plates_a010.json").display().to_string();
    let costs = lines(
        "lights",
        &["bench", "--lights", &scene, "--size", "4x4", "--rounds", "1", "--route", "interp"],
    );
    assert_eq!(costs.iter().filter(|line| line["fixed"].is_number()).count(), 4);
    let few = ["--size", "8x8", "--pictures", "4", "--lights", "64"];
    let methods = lines("flicker", &[&["flicker", &scene], &few[..]].concat());
    assert_eq!(methods.len(), 3);
}

#[test]
fn proxies_of_scenes() {
    for (scene, count) in [("room.gltf", 5), ("plates.gltf", 3), ("cornell_L0.json", 6)] {
        let path = at("tests/cases/scenes").join(scene).display().to_string();
        let value = document("proxies", &["proxies", &path]);
        assert!(value["count"].as_u64() >= Some(count), "{value}");
    }
}

#[test]
fn proxies_are_written_and_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let (scene, out) =
        (at("tests/cases/scenes/room.gltf").display().to_string(), folder.path().join("p.json"));
    let output = lobe(&["proxies", &scene, "--count", "3", "-o", &out.display().to_string()]);
    assert!(text(&output.stdout).starts_with("3 rectangles for 50 triangles"), "{}", text(&output.stdout));
    assert!(text(&output.stderr).contains("room.gltf: a roughness below 0.141"), "{}", text(&output.stderr));
    let written: Value = serde_json::from_slice(&std::fs::read(&out).expect("written")).expect("JSON");
    assert_follows(&schema("proxies"), &written);
    for (args, message) in [
        (vec!["--count", "1"], "1 proxies are too few: 3 are left"),
        (vec!["--angle", "0"], "the angle in degrees is 0: it must be above 0"),
    ] {
        let output = lobe(&[&["proxies", &scene][..], &args].concat());
        assert_eq!(output.status.code(), Some(2));
        assert!(text(&output.stderr).contains(message), "{}", text(&output.stderr));
    }
}

/// A picture of a scene, in a folder.
fn rendered(folder: &Path, method: &str, size: &str, name: &str) -> String {
    let (scene, out) = (at("tests/cases/scenes/plates_a040.json").display().to_string(), folder.join(name));
    let out = out.display().to_string();
    let output = lobe(&["render", &scene, "--method", method, "--size", size, "--layers", "-o", &out]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    out
}

#[test]
fn pictures_are_compared_and_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let [one, other, small] =
        [("rect", "16x12", "a.exr"), ("rect-laplace", "16x12", "b.exr"), ("direct", "8x8", "c.exr")]
            .map(|(method, size, name)| rendered(folder.path(), method, size, name));
    let [shown, shown_too] = [("rect", "a.png"), ("rect-laplace", "b.png")]
        .map(|(method, name)| rendered(folder.path(), method, "16x12", name));
    let map = folder.path().join("map.png").display().to_string();
    let layer = "indirect_specular_fromspec_novis";
    let high = document("compare", &["compare", &one, &other, "--layer", layer, "--map", &map]);
    assert_eq!(
        (&high["size"], &high["shown"]["tone_map"], &high["layer"]),
        (&json!([16, 12]), &json!("aces"), &json!(layer))
    );
    assert!(high["flip"]["mean"].as_f64() > Some(0.0) && high["mean_ratio"].as_f64() > Some(0.1), "{high}");
    assert_eq!(&std::fs::read(&map).expect("written")[1..4], b"PNG");
    let low = document("compare", &["compare", &shown, &shown_too]);
    assert_eq!((&low["shown"], &low["layer"]), (&Value::Null, &Value::Null));
    let same =
        document("compare", &["compare", &one, &one, "--tone-map", "hable", "--pixels-per-degree", "30"]);
    assert_eq!((same["flip"]["max"].as_f64(), same["mean_ratio"].as_f64()), (Some(0.0), Some(1.0)));
    let said = text(&lobe(&["compare", &one, &other]).stdout);
    for part in ["mean ratio", "relative RMSE", "HDR-FLIP", "worst pixel    column "] {
        assert!(said.contains(part), "no {part} in {said}");
    }
    for (args, message) in [
        (vec![&*one, &small], "the picture has 16 x 12 pixels, the truth 8 x 8"),
        (vec![&one, &shown], "compare two EXR or two PNG files"),
        (vec![&one, &other, "--layer", "nothing"], "there is no layer `nothing`; there are: without a name"),
        (vec![&one, &other, "--layer", "nothing"], "`direct_vis`"),
        (vec![&shown, &shown_too, "--layer", "direct_vis"], "a PNG file has no layers"),
        (vec![&one, "gone.exr"], "gone.exr: cannot be read"),
        (vec![&one, "picture.jpg"], "picture.jpg: pictures are read from .exr and .png"),
        (vec![&one, &other, "--pixels-per-degree", "0"], "`0` is no number of pixels"),
    ] {
        let output = lobe(&[&["compare"][..], &args].concat());
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(text(&output.stderr).contains(message), "{message} // {}", text(&output.stderr));
    }
}

/// Files that are cut off or changed are refused by name, whatever is in them.
#[test]
fn spoilt_pictures_are_refused_or_compared() {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["whole.exr", "whole.png"] {
        let whole = rendered(folder.path(), "direct", "6x4", name);
        let bytes = std::fs::read(&whole).expect("written");
        let spoilt = folder.path().join(format!("spoilt_{name}"));
        for at in (0..bytes.len()).step_by(bytes.len() / 40) {
            let mut changed = bytes.clone();
            changed[at] ^= 0x55;
            for bytes in [&bytes[..at], &changed] {
                std::fs::write(&spoilt, bytes).expect("writable");
                let output = lobe(&["compare", &spoilt.display().to_string(), &whole]);
                let said = text(&output.stderr);
                assert!(matches!(output.status.code(), Some(0 | 2)), "{name}, byte {at}: {said}");
                assert!(output.status.success() || said.contains("spoilt_"), "{name}, byte {at}: {said}");
            }
        }
    }
}

#[test]
fn proxies_are_drawn() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = at("tests/cases/scenes/room.gltf").display().to_string();
    let [png, svg, jpg] =
        ["p.png", "p.svg", "p.jpg"].map(|name| folder.path().join(name).display().to_string());
    let output = lobe(&["proxies", &scene, "--picture", &png, "--picture", &svg, "--size", "40x30"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let reader = png::Decoder::new(std::io::BufReader::new(std::fs::File::open(&png).expect("written")));
    let info = reader.read_info().expect("a PNG file").info().size();
    assert_eq!(info, (40, 30));
    assert!(std::fs::read_to_string(&svg).expect("written").contains("data:image/png;base64,"));
    for (args, message) in [
        (vec!["--picture", &jpg], "p.jpg: proxies are drawn as .png or .svg"),
        (vec!["--picture", &png, "--size", "9999x9999"], "9999 x 9999 are too many pixels"),
        (vec!["--picture", &png, "--camera", "none"], "none"),
        (vec!["--partition", "25"], "25"),
    ] {
        let output = lobe(&[&["proxies", &scene][..], &args].concat());
        assert_eq!(output.status.code(), Some(2));
        assert!(text(&output.stderr).contains(message), "{}", text(&output.stderr));
    }
}

#[test]
fn runs_of_shaders() {
    let corpus = at("tests/cases/corpus").display().to_string();
    let found = lines("run", &["run", "--batch", &corpus]);
    let has = |part: &str| found.iter().any(|line| line.to_string().contains(part));
    for part in ["\"summary\"", "\"first\"", "\"status\":\"refused\"", "\"status\":\"ok\""] {
        assert!(has(part), "the corpus shows no {part}");
    }
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("bad.wgsl").display().to_string();
    std::fs::write(&path, "@compute @workgroup_size(1) fn main() { nonsense }").expect("writable");
    assert_eq!(lines("run", &["run", &path])[0]["status"], "invalid");
    let race = "@group(0) @binding(0) var<storage, read_write> out: array<u32, 4>;
        @compute @workgroup_size(4) fn main(@builtin(local_invocation_index) i: u32) { out[i + 4u] = 1u / (i - i); }";
    std::fs::write(&path, race).expect("writable");
    let found = &lines("run", &["run", &path, "--sanitize", "--route", "interp"])[0];
    assert!(found["findings"].as_array().is_some_and(|all| !all.is_empty()), "{found}");
}
