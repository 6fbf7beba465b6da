//! Every operation of the kernel language runs on every executor that this machine has, inside its bound.

mod common;

use lobe_backends::executor::Executor;
use lobe_backends::routes::{Machine, State};
use lobe_codegen::intrinsics::{Op, Shape, TABLE};
use lobe_tests::judge::judge;
use lobe_tests::operations::{OPERATIONS, OTHERS};
use lobe_tests::question::{Question, Verdict};
use std::io::Write;

/// Operations on memory have no function form: entry points test them.
fn is_on_memory(shape: Shape, op: Op) -> bool {
    matches!(shape, Shape::AtomicLoad | Shape::AtomicStore | Shape::AtomicUpdate)
        || matches!(op, Op::Barrier(_))
}

#[test]
fn every_operation_has_a_kernel() {
    for row in TABLE {
        let has_kernel = OPERATIONS.iter().any(|(intrinsic, _)| *intrinsic == row.intrinsic);
        assert!(has_kernel || is_on_memory(row.shape, row.op), "{}: no kernel calls it", row.name);
    }
}

/// What is known to fall short, by kernel and route or group of routes, each with the reason.
/// An entry that holds although its route ran is a failure: it has to go.
const KNOWN: &[(&str, &str, &str)] = &[
    (
        "op_atan2",
        "@swiftshader",
        "WGSL promises atan2 for a normal y only; the derived bound promises it at -0 too",
    ),
    (
        "op_mix",
        "@swiftshader",
        "it computes x + (y - x) t, which WGSL's conformance tests accept and its table does not",
    ),
    ("op_mix_vector", "@swiftshader", "as op_mix"),
    (
        "op_asinh",
        "routes @lavapipe",
        "HLSL has no asinh: the emitted text has its formula, the driver another one",
    ),
    ("op_acosh", "routes @swiftshader", "as op_asinh"),
    (
        "op_smoothstep",
        "routes @swiftshader",
        "Tint writes its formula out, t (t (3 - 2 t)); of the instruction the driver makes (t t) (3 - 2 t)",
    ),
    ("op_mix", "glsl@llvmpipe", "Mesa computes x + (y - x) t, as SwiftShader does"),
    ("op_mix_vector", "glsl@llvmpipe", "as op_mix"),
];

fn is_known(known: &(&str, &str, &str), kernel: &str, subject: &str) -> bool {
    known.0 == kernel && subject.ends_with(known.1)
}

/// All ready routes; those that are missing are said aloud, past libtest's capture.
fn routes() -> Vec<Box<dyn Executor>> {
    let machine = Machine::look();
    let mut opened = Vec::new();
    for (route, state) in machine.routes() {
        match state {
            State::Ready => opened.push(machine.open(&route).unwrap_or_else(|e| panic!("{e}"))),
            State::Missing { what, mend } => {
                let _ = writeln!(std::io::stderr(), "skipped {route}: {what}; {mend}");
            }
        }
    }
    opened
}

#[test]
fn every_operation_lies_inside_its_bound_on_every_route() {
    let mut routes = routes();
    let mut faults = Vec::new();
    let mut unseen: Vec<_> = KNOWN.iter().collect();
    let ran: Vec<String> = routes.iter().map(|r| r.route().to_string()).collect();
    let all = OPERATIONS.iter().map(|(_, kernel)| kernel).chain(OTHERS);
    for kernel in all {
        let report = judge(*kernel, &common::plan(2000), &mut routes, &|_| {});
        for answer in report.answers.iter().filter(|a| a.question != Question::Robust) {
            if let Verdict::FallsShort(why) = &answer.verdict {
                unseen.retain(|known| !is_known(known, &report.name, &answer.subject));
                if KNOWN.iter().any(|known| is_known(known, &report.name, &answer.subject)) {
                    continue;
                }
                faults
                    .push(format!("{} on {}: {why}; worst {:?}", report.name, answer.subject, answer.worst));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    // Three roads to a driver make the groups that differ.
    let has_all = |known: &(&str, &str, &str)| {
        let driver = known.1.trim_start_matches("routes ");
        ran.iter().filter(|route| route.ends_with(driver)).count() == 3
    };
    unseen.retain(|known| has_all(known));
    assert!(unseen.is_empty(), "these hold now, remove them from KNOWN: {unseen:?}");
}
