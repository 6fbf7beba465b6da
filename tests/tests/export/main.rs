//! Exported cases hold what they say: read back by readers of our own, their shaders assembled, compiled and run on a
//! driver, the results judged by what the file expects. Neither Amber nor LLVM's offload test suite is needed.

mod amber;
#[path = "../common/mod.rs"]
mod common;
mod driver;
mod offload;

use lobe_backends::executor::Native;
use lobe_codegen::accuracy::Model;
use lobe_codegen::data::Columns;
use lobe_codegen::def::FunctionRef;
use lobe_codegen::emit::{Content, Target};
use lobe_codegen::prelude::*;
use lobe_codegen::validate::from_wgsl;
use lobe_kernels::registry::KERNELS;
use lobe_tests::domain::Inputs;
use lobe_tests::export::{Case, ExportError, Form, export};
use lobe_tests::subject::Subject;
use lobe_tests::value::parse_rows;

/// Floats beside integers, with room between.
#[kernel]
struct Mixed {
    /// A weight.
    weight: f32,
    /// An axis.
    axis: Vec3,
    /// Whether it is met: 1, else 0.
    met: u32,
    /// A count, below zero.
    count: i32,
}

/// Returns floats beside integers.
#[kernel]
fn mixed(x: f32, n: u32, flag: bool) -> Mixed {
    let mut met = 0u32;
    if flag && n > 2 {
        met = 1;
    }
    Mixed { weight: x / 3.0, axis: Vec3::new(x, exp(x), 1.0), met, count: n as i32 - 9 }
}

/// Is a truth.
#[kernel]
fn larger(x: f32, n: u32) -> bool {
    x > n as f32
}

/// Whole numbers alone.
#[kernel]
fn counted(n: u32) -> UVec3 {
    UVec3::new(n, n * 3, n + 7)
}

/// Turns.
#[kernel]
fn turned(frame: Mat3, v: Vec3) -> Vec3 {
    frame * v / 7.0
}

/// Has no bound where x is 1, and none for the first part anywhere below 1.
#[kernel]
fn partly_known(x: f32) -> Vec2 {
    Vec2::new(log(x), x * 2.0)
}

/// Kernels with rows that a reader would trip over: several of them, all kinds of scalars, numbers at the edges.
const TRICKY: [(FunctionRef, &str); 5] = {
    let [mixed, counted, turned, partly, larger] =
        lobe_codegen::kernels![mixed, counted, turned, partly_known, larger];
    [
        (mixed, MIXED_ROWS),
        (counted, "{\"n\": 1431655765}\n{\"n\": 5}"),
        (turned, "{\"frame\": [[0.1, 0.2, 0.3], [1, 2, 3], [-4, 5e-5, 6e5]], \"v\": [0.7, -0.8, 0.9]}"),
        (partly, "{\"x\": 2.5}"),
        (larger, "{\"x\": 2.5, \"n\": 2}\n{\"x\": 2.5, \"n\": 3}"),
    ]
};

const MIXED_ROWS: &str = "
    {\"x\": 0.1, \"n\": 3, \"flag\": true}
    {\"x\": -2, \"n\": 0, \"flag\": false}
    {\"x\": \"0x0.000002p-126\", \"n\": 7, \"flag\": true}
";

fn tricky() -> impl Iterator<Item = (Subject, Columns)> {
    TRICKY.into_iter().map(|(kernel, text)| {
        (Subject::new(kernel).expect("a kernel"), parse_rows(kernel(), text).expect("rows"))
    })
}

/// Kernels of the library, each `step`th, with rows of their domains.
fn library(step: usize) -> impl Iterator<Item = (Subject, Columns)> {
    KERNELS.iter().step_by(step).map(|kernel| {
        let subject = Subject::new(*kernel).unwrap_or_else(|e| panic!("{e}"));
        let none = Columns::zeros(subject.program().params().len(), 0);
        let inputs = Inputs::draw(kernel(), 70, 7, &none).unwrap_or_else(|e| panic!("{e}"));
        let rows = inputs.args.slice(inputs.args.rows.saturating_sub(3)..inputs.args.rows);
        (subject, rows)
    })
}

fn exported(subject: &Subject, rows: &Columns, form: Form) -> Result<String, ExportError> {
    export(&Case::new(subject, rows, Model::portable(), Some(&mut Native))?, form)
}

/// What is written, unless the form has no words for it.
fn written(subject: &Subject, rows: &Columns, form: Form) -> Option<String> {
    match exported(subject, rows, form) {
        Ok(text) => Some(text),
        Err(
            ExportError::NothingKnown { .. } | ExportError::PartlyKnown { .. } | ExportError::Mixed { .. },
        ) => None,
        Err(error) => panic!("{error}"),
    }
}

#[test]
fn wgsl_is_valid_and_tells_its_inputs_and_results() {
    for (subject, rows) in library(1).chain(tricky()) {
        let name = subject.def().name;
        let text = written(&subject, &rows, Form::Wgsl).expect("always written");
        let module = from_wgsl(&text).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!(module.module().entry_points[0].name, format!("{name}_entry"));
        for part in
            ["Found on native:", "// lobe: --input row_count=words:", "// Arguments", "rows of arguments"]
        {
            let is_one_of = part.contains("rguments");
            assert!(text.contains(part) || is_one_of, "{name}: no {part}");
        }
        assert!(!text.contains("NOT permitted"), "{name}: native is within its bound\n{text}");
    }
}

#[test]
fn the_assembly_of_amber_scripts_is_the_words_that_checks_run() {
    let Some(assembler) = amber::assembler() else { return };
    let mut n = 0;
    for (subject, rows) in library(1).chain(tricky()) {
        let Some(text) = written(&subject, &rows, Form::Amber) else { continue };
        let Content::Words(mut wanted) = subject.program().artifact(Target::Spirv).expect("emitted").content
        else {
            panic!("SPIR-V is words")
        };
        let mut found = amber::read(&text).assemble(&assembler);
        // The third word names the maker.
        (wanted[2], found[2]) = (0, 0);
        assert!(wanted == found, "{}: another module", subject.def().name);
        n += 1;
    }
    assert!(n > 150, "only {n} were written");
}

#[test]
fn a_driver_gives_what_amber_scripts_expect_and_no_other_results_pass() {
    let (Some(assembler), Some(mut driver)) = (amber::assembler(), driver::open()) else { return };
    for (subject, rows) in library(6).chain(tricky()) {
        let Some(text) = written(&subject, &rows, Form::Amber) else { continue };
        let script = amber::read(&text);
        let results = script.run(&assembler, &mut driver);
        let name = subject.def().name;
        assert_eq!(script.failures(&results), Vec::<String>::new(), "{name}\n{text}");
        let spoilt = script.spoilt(&results);
        assert_eq!(script.failures(&spoilt).len(), script.expectations(), "{name}: what is wrong passes");
    }
}

#[test]
fn a_driver_gives_what_offload_tests_expect_and_no_other_results_pass() {
    let (Some(dxc), Some(mut driver)) = (offload::compiler(), driver::open()) else { return };
    let mut n = 0;
    for (subject, rows) in library(6).chain(tricky()) {
        let Some(text) = written(&subject, &rows, Form::Offload) else { continue };
        let test = offload::read(&text);
        let results = test.run(&dxc, &mut driver);
        let name = subject.def().name;
        assert_eq!(test.failures(&results), 0, "{name}\n{text}");
        assert!(test.failures(&test.spoilt(&results)) > 0, "{name}: what is wrong passes");
        n += 1;
    }
    assert!(n > 15, "only {n} were written");
}

#[test]
fn what_a_route_returns_is_told_and_what_is_not_permitted_is_marked() {
    let subject = Subject::new(TRICKY[0].0).expect("a kernel");
    let rows = parse_rows(subject.def(), MIXED_ROWS).expect("rows");
    let mut broken = common::Spoilt {
        route: "spirv@broken".parse().expect("a route"),
        spoil: |output| output.columns[0][1] ^= 0x40_0000,
        driver: "",
    };
    let case = Case::new(&subject, &rows, Model::portable(), Some(&mut broken)).expect("a case");
    let text = export(&case, Form::Amber).expect("written");
    let marked: Vec<&str> = text.lines().filter(|line| line.contains("NOT permitted")).collect();
    assert!(text.contains("# Found on spirv@broken:"), "{text}");
    assert!(marked.len() == 1 && marked[0].starts_with("#   result[1].weight = "), "{marked:?}");
}

#[test]
fn what_a_form_has_no_words_for_is_refused_with_another_form() {
    let refused = |index: usize, text: &str, form| {
        let subject = Subject::new(TRICKY[index].0).expect("a kernel");
        let rows = parse_rows(subject.def(), text).expect("rows");
        exported(&subject, &rows, form).expect_err("refused").to_string()
    };
    let mixed = refused(0, TRICKY[0].1, Form::Offload);
    assert!(mixed.contains("mixed returns floats beside integers") && mixed.contains("amber"), "{mixed}");
    let partly = refused(3, "{\"x\": -1}", Form::Offload);
    assert!(partly.contains("nothing is known of `x`"), "{partly}");
    let nothing = refused(3, "{\"x\": \"nan\"}", Form::Amber);
    assert!(nothing.contains("nothing to expect"), "{nothing}");
}
