//! The page of golden images in a browser: every control used, on reports with a case of every kind.
//!
//! What is done and asked stands in `browser/`, a file a scenario; playwright-core drives Debian's Chromium.

mod cases;
#[path = "../common/mod.rs"]
mod common;
mod synthetic;

use common::tool;
use lobe_backends::translate::web;
use lobe_golden::page::{Written, write};
use serde_json::Value;
use std::path::Path;
use std::process::{Command, Stdio};
use synthetic::Pictures;
use tempfile::TempDir;

/// The page of a report, with the report and the pictures beside it, as `lobe golden report` leaves them.
fn written((report, pictures): &(Value, Pictures)) -> (TempDir, Written) {
    let folder = tempfile::tempdir().expect("a folder");
    let put = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().expect("a folder")).expect("writable");
        std::fs::write(path, bytes).expect("writable");
    };
    put("report.json", report.to_string().as_bytes());
    // Names that mean harm are no files.
    for (name, bytes) in pictures
        .0
        .iter()
        .filter(|(name, _)| name.bytes().all(|b| b.is_ascii_alphanumeric() || b"/-_.".contains(&b)))
    {
        if !name.contains("..") {
            put(name, bytes);
        }
    }
    let written = write(report, pictures, folder.path()).unwrap_or_else(|e| panic!("{e}"));
    (folder, written)
}

/// Goes through a scenario of `browser/` on the page in `folder`; false, said aloud, where a tool is not here.
#[track_caller]
fn drive(scenario: &str, folder: &Path) -> bool {
    let tools = || Some((tool(web::node())?, tool(web::playwright())?, tool(web::browser())?));
    let Some((node, playwright, browser)) = tools() else { return false };
    let scripts = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden_page/browser");
    let output = Command::new(node)
        .arg(scripts.join("drive.mjs"))
        .arg(scenario)
        .args([folder, playwright.modules(), &browser])
        .stdin(Stdio::null())
        .output()
        .expect("node runs");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    print!("{}", text(&output.stdout));
    assert!(output.status.success(), "{scenario}: {}{}", text(&output.stdout), text(&output.stderr));
    true
}

#[track_caller]
fn check(scenario: &str) {
    drive(scenario, written(&cases::every_kind()).0.path());
}

#[test]
fn the_list_is_searched_filtered_sorted_and_in_the_address() {
    check("list");
}

#[test]
fn pictures_and_maps_are_laid_over_one_another() {
    check("pictures");
}

#[test]
fn the_inspector_shows_every_value_and_the_worst_pixels() {
    check("inspector");
}

#[test]
fn lanes_show_numbers_texts_and_what_changed() {
    check("lanes");
}

#[test]
fn what_lacks_evidence_is_never_shown_as_fine() {
    check("evidence");
}

#[test]
fn everybody_can_use_it() {
    check("access");
}

#[test]
fn differences_of_texts_are_exact_and_shortest() {
    check("lines");
}

#[test]
fn decisions_are_kept_and_exported() {
    let (folder, _) = written(&cases::every_kind());
    if !drive("decisions", folder.path()) {
        return;
    }
    let exported = std::fs::read_to_string(folder.path().join("decisions.json")).expect("exported");
    let schema = include_str!("../../schema/golden-decisions-1.json");
    let schema: Value = serde_json::from_str(schema).expect("JSON");
    let exported: Value = serde_json::from_str(&exported).expect("JSON");
    jsonschema::draft202012::validate(&schema, &exported).unwrap_or_else(|e| panic!("{e}"));
}

#[test]
fn names_that_mean_harm_do_none() {
    let (folder, _) = written(&cases::hostile());
    // Nothing was written beside the folder either.
    assert!(!folder.path().join("page/data/../../up").exists());
    drive("harm", folder.path());
}

#[test]
fn ten_thousand_cases_are_light() {
    let (folder, written) = written(&cases::many(10_000));
    assert_eq!((written.lacking, written.pictures > 0), (9_900, true));
    drive("many", folder.path());
}

#[test]
fn a_picture_of_the_largest_size_is_shown() {
    drive("large", written(&cases::large()).0.path());
}

#[test]
fn what_is_lacking_is_counted() {
    let (_folder, written) = written(&cases::every_kind());
    // A picture that is not there, one that is another, and a golden and a picture that the report does not name.
    assert_eq!(written.lacking, 3);
}
