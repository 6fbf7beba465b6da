//! Reports of parts become the report of the whole, byte for byte: of a check in shares, and of tests that nextest split.

mod common;

use common::{assert_fails, assert_holds, lobe, skip, text};
use std::path::Path;
use std::process::{Command, Output};

const KERNELS: [&str; 4] = ["sg_eval", "erf", "asg_eval", "sg_integral"];

fn check(kernels: &[&str], options: &[&str]) -> String {
    let common = ["--inputs", "200", "--route", "native", "--route", "interp", "--format", "json"];
    assert_holds(&lobe(&[&["check"], kernels, &common, options].concat()))
}

#[test]
fn shares_of_a_check_are_merged_to_the_check() {
    let folder = tempfile::tempdir().expect("a folder");
    let kernels = &KERNELS;
    for share in ["1/3", "2/3", "3/3"] {
        let part = check(kernels, &["--partition", share]);
        std::fs::write(folder.path().join(format!("{}.json", &share[..1])), part).expect("writable");
    }
    let merge = |paths: &[&str], format| lobe(&[&["merge"], paths, &["--format", format]].concat());
    let path = folder.path().display().to_string();
    assert_eq!(assert_holds(&merge(&[&path], "json")), check(kernels, &[]));
    let [one, two] = [1, 2].map(|n| folder.path().join(format!("{n}.json")).display().to_string());
    let lacking = merge(&[&two, &one], "human");
    assert_eq!(lacking.status.code(), Some(1));
    assert!(text(&lacking.stdout).contains("missing    3/3 of lobe check"), "{}", text(&lacking.stdout));
    let xml = merge(&[&two, &one], "junit");
    assert!(text(&xml.stdout).contains("no report of it is there"), "{}", text(&xml.stdout));

    let other = folder.path().join("4.json");
    std::fs::write(&other, check(kernels, &["--partition", "1/3", "--seed", "8"])).expect("writable");
    assert_fails(&merge(&[&path], "json"), 2, &["has seed 7", "4.json has 8", "not parts of one run"]);
    std::fs::write(&other, "{}").expect("writable");
    assert_fails(&merge(&[&path], "json"), 2, &["4.json: is no report", "missing field"]);
    let empty = tempfile::tempdir().expect("a folder");
    assert_fails(&merge(&[&empty.path().display().to_string()], "json"), 2, &["no report (*.json) is there"]);
    assert_fails(
        &lobe(&["check", "erf", "--partition", "4/3"]),
        2,
        &["write 2/3 for the second of three parts"],
    );
}

/// Runs the tests of `tests/own-kernels`, or a part of them, as a user does.
fn nextest(reports: &Path, options: &[&str]) -> Output {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
    let profile: &[&str] = if cfg!(debug_assertions) { &[] } else { &["--release"] };
    let mut command = Command::new(env!("CARGO"));
    command
        .current_dir(root)
        .args(["nextest", "run", "--offline", "--workspace", "--test", "kernels"])
        .args(profile)
        .args(options);
    command.env("LOBE_REPORT_DIR", reports).env_remove("LOBE_REQUIRE_TOOLS").output().expect("cargo runs")
}

#[test]
fn tests_that_nextest_splits_are_merged_to_those_of_one_run() {
    let has_nextest = Command::new(env!("CARGO")).args(["nextest", "--version"]).output();
    if !has_nextest.is_ok_and(|output| output.status.success()) {
        skip("cargo-nextest", "cargo install --locked cargo-nextest");
        return;
    }
    let merged = |folders: &[&Path], code| {
        let paths: Vec<String> = folders.iter().map(|folder| folder.display().to_string()).collect();
        let paths: Vec<&str> = paths.iter().map(String::as_str).collect();
        let output = lobe(&[&["merge", "--format", "json"], &paths[..]].concat());
        assert_eq!(output.status.code(), Some(code), "{}", text(&output.stderr));
        text(&output.stdout)
    };
    let [whole, first, second] = [(); 3].map(|()| tempfile::tempdir().expect("a folder"));
    for (folder, options) in
        [(&whole, &[][..]), (&first, &["--partition", "count:1/2"]), (&second, &["--partition", "count:2/2"])]
    {
        let output = nextest(folder.path(), options);
        assert!(output.status.success(), "{}", text(&output.stderr));
    }
    let [whole, first, second] = [&whole, &first, &second].map(|folder| folder.path());
    let report = merged(&[whole], 0);
    assert_eq!(merged(&[first, second], 0), report);
    assert_eq!(merged(&[second, first], 0), report);
    assert!(report.contains("\"falloff\"") && report.contains("native = interp"), "{report}");
    assert!(merged(&[second], 1).contains("of own-kernels kernels::check"), "half of it is missing");
}
