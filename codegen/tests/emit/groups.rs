//! Blank lines and comments within functions.

use crate::common::text;
use lobe_codegen::emit::{Options, Target, emit};
use lobe_codegen::prelude::*;

/// Statements in groups.
#[kernel]
fn grouped(x: f32, n: u32) -> f32 {
    let a = x * x;
    // Of the half.
    let b = 0.5 * a;
    let t = a + b;

    // A comment of two lines, \
    // with [`floor`] in it.
    if t > 2.0 {
        // At the beginning of a block.
        let t = floor(b);
        return t;
    }

    let mut sum = 0.0;
    for i in 0..n {
        let t = sum * x + i as f32;

        sum += t + a;
    }

    // The end.
    sum + a
}

/// What stands in one line of the emitted text, or before it.
#[track_caller]
fn check(target: Target, expected: &[&str]) {
    let module = lobe_codegen::lower(&lobe_codegen::kernels![grouped]).unwrap();
    let text = text(&module, target);
    for part in expected {
        assert!(text.contains(part), "{part}\n{text}");
    }
}

#[test]
fn statements_stand_in_the_groups_of_the_source() {
    check(
        Target::Wgsl,
        &[
            "    let a = x * x;\n    // Of the half.\n    let b = 0.5f * a;\n    let t = ",
            ";\n\n    // A comment of two lines,\n    // with `floor` in it.\n    if (t > 2f) {\n        // At the beginning of a \
             block.\n        let ",
            "    }\n\n    sum = 0f;",
            "}\n\n    // The end.\n    return sum + a;\n}",
        ],
    );
    check(
        Target::Hlsl,
        &["    // Of the half.\n    float b = 0.5 * a;", "\n\n    // The end.\n    return sum + a;\n}"],
    );
    check(Target::Msl, &["    // Of the half.\n    float b = ", "\n\n    // The end.\n    return "]);
    check(Target::Glsl, &["    // Of the half.\n    float b = ", "\n\n    // The end.\n    return "]);
}

#[test]
fn without_documentation_there_are_no_comments_but_groups() {
    let module = lobe_codegen::lower(&lobe_codegen::kernels![grouped]).unwrap();
    let options = Options { docs: false, header: false, ..Options::default() };
    let artifact = emit(&module, Target::Hlsl, &options).unwrap();
    let text = artifact.content.text().unwrap();
    assert!(!text.contains("//"), "{text}");
    assert!(text.contains("\n\n    if (t > 2.0) {\n        float "), "{text}");
}
