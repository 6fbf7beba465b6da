//! `lobe export` as its users meet it.

mod common;

use common::{assert_fails, assert_holds, lobe, lobe_with_input};
use serde_json::Value;

const ROW: &str = r#"{"a": {"axis": [1, 0, 0], "sharpness": 2.5, "log_amplitude": 0}, "b": {"axis": [0, 1, 0], "sharpness": "0x1.8p3", "log_amplitude": -1}}"#;

#[test]
fn an_exported_shader_runs_by_lobe_run_with_the_same_inputs_and_results() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name).display().to_string();
    let shader = at("case.wgsl");
    assert_holds(&lobe(&["export", "sg_product", "--input", ROW, "--as", "wgsl", "-o", &shader]));
    let output = format!("results={}", at("results.bin"));
    let said = assert_holds(&lobe(&["run", &shader, "--output", &output, "--format", "json"]));
    let report: Value = serde_json::from_str(&said).expect("JSON");
    assert_eq!((&report["status"], &report["entry"]), (&"ok".into(), &"sg_product_entry".into()));
    let bytes = std::fs::read(at("results.bin")).expect("written");
    let floats: Vec<f32> =
        bytes.as_chunks::<4>().0.iter().map(|word| f32::from_bits(u32::from_le_bytes(*word))).collect();
    let eval = assert_holds(&lobe_with_input(&["eval", "sg_product", "--args", "-"], ROW));
    let eval: Value = serde_json::from_str(&eval).expect("JSON");
    let wanted =
        [&eval["axis"][0], &eval["axis"][1], &eval["axis"][2], &eval["sharpness"], &eval["log_amplitude"]];
    let wanted: Vec<f32> = wanted.iter().map(|v| v.as_f64().expect("a number") as f32).collect();
    assert_eq!(floats[..5], wanted);
}

#[test]
fn the_worst_row_of_a_route_is_exported_as_every_form() {
    for (form, begin) in [("wgsl", "// erf,"), ("amber", "#!amber"), ("offload", "#--- source.hlsl")] {
        let args = ["export", "erf", "--worst", "--inputs", "300", "--route", "interp", "--as", form];
        let text = assert_holds(&lobe(&args));
        assert!(text.starts_with(begin), "{text}");
        assert!(text.contains("Found on interp:") && !text.contains("NOT permitted"), "{text}");
        assert_eq!(text, assert_holds(&lobe(&args)), "the same each time");
    }
}

#[test]
fn bounds_are_those_of_the_specification_that_is_asked_for() {
    let export = |model: &str| {
        assert_holds(&lobe(&["export", "sg_product", "--input", ROW, "--as", "wgsl", "--model", model]))
    };
    let (portable, hlsl) = (export("portable"), export("hlsl"));
    assert!(hlsl.contains("// lobe: --model hlsl\n") && !portable.contains("--model"), "{hlsl}");
    let expected = |text: &str| text.lines().find(|line| line.contains(" +- ")).map(str::to_owned);
    assert_ne!(expected(&portable), expected(&hlsl));
}

#[test]
fn what_cannot_be_exported_says_why() {
    let export = |rest: &[&str]| lobe(&[&["export", "erf"], rest].concat());
    assert_fails(&export(&["--as", "wgsl"]), 2, &["--input"]);
    assert_fails(&export(&["--input", "{\"x\": 1}", "--as", "metal"]), 2, &["wgsl", "amber", "offload"]);
    assert_fails(&export(&["--input", "{}", "--as", "wgsl"]), 2, &["--input: line 1", "lack `x`"]);
    assert_fails(&export(&["--input", "{\"x\": \"nan\"}", "--as", "amber"]), 2, &["nothing to expect"]);
    assert_fails(&export(&["--input", "{\"x\": 1}", "--as", "wgsl", "-o", "no/such"]), 2, &["no/such"]);
    let missing = ["--input", "{\"x\": 1}", "--as", "wgsl", "--route", "spirv@nix"];
    assert_fails(&export(&missing), 3, &["no Vulkan driver `nix`"]);
}

#[test]
fn words_that_are_none_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let shader = folder.path().join("case.wgsl").display().to_string();
    assert_holds(&lobe(&["export", "erf", "--input", "{\"x\": 1}", "--as", "wgsl", "-o", &shader]));
    let run = |input: &str| lobe(&["run", &shader, "--route", "interp", "--input", input]);
    assert_holds(&run("x_values=words:0x3f000000"));
    assert_fails(&run("x_values=words:0x3f00000000"), 2, &["no word of 32 bits"]);
    let too_few = run("x_values=words:");
    assert_fails(&too_few, 2, &["`` is no word"]);
}
