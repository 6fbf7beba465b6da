//! `lobe explain` as its users meet it.

mod common;

use common::{assert_fails, assert_holds, lobe};
use serde_json::Value;

const KERNEL: [&str; 2] = ["explain", "expm1_over_x_higham"];

fn explain(rest: &[&str]) -> std::process::Output {
    lobe(&[&KERNEL, rest].concat())
}

#[test]
fn the_operation_is_told_with_its_lines_and_its_rule() {
    let said = assert_holds(&explain(&["--input", r#"{"x": 0.0012}"#, "--route", "interp"]));
    for part in [
        "`log(u)`",
        "special.rs:",
        "WGSL",
        "SPIR-V",
        "HLSL",
        "OpExtInst",
        "absolute 4.76837158203125e-7",
        "0x1.",
    ] {
        assert!(said.contains(part), "no {part} in: {said}");
    }
}

#[test]
fn the_same_comes_as_json() {
    let arguments = ["--input", r#"{"x": 0.0012}"#, "--route", "interp", "--format", "json"];
    let report: Value = serde_json::from_str(&assert_holds(&explain(&arguments))).expect("JSON");
    assert_eq!((&report["schema"], &report["report"]), (&1.into(), &"explain".into()));
    assert_eq!(report["shares"][0]["rust"], "log(u)");
    assert_eq!(report["shares"][0]["lines"].as_array().map(Vec::len), Some(4));
    assert_eq!(report["same_bits"], true);
}

#[test]
fn what_cannot_be_explained_is_refused() {
    let row = ["--input", r#"{"x": 1.0}"#];
    assert_fails(&explain(&[&row[..], &["--route", "native"]].concat()), 2, &["native code tells nothing"]);
    assert_fails(&explain(&["--input", r#"{"y": 1.0}"#]), 2, &["--input", "x"]);
    assert_fails(&explain(&["--input", "no-such-file"]), 2, &["no-such-file"]);
    let missing = explain(&[&row[..], &["--route", "spirv@no_such_driver"]].concat());
    assert_fails(&missing, 3, &["no_such_driver"]);
}
