//! Mistakes that only lowering sees: each names its Rust file, line and columns.

use crate::check::refusal;
use lobe_codegen::kernels;
use lobe_codegen::prelude::*;

/// Whether the message stands at `line`, with a caret below `marked`.
#[track_caller]
fn points_at(message: &str, words: &str, marked: &str) {
    assert!(message.contains(words), "{message}");
    assert!(message.contains("mistakes.rs:"), "{message}");
    let lines: Vec<&str> = message.lines().collect();
    let carets =
        lines.iter().position(|l| l.contains('^')).unwrap_or_else(|| panic!("no caret in\n{message}"));
    let (line, caret) = (lines[carets - 1], lines[carets]);
    let start = caret.chars().position(|c| c == '^').unwrap();
    let end = start + caret.chars().filter(|c| *c == '^').count();
    let found: String = line.chars().skip(start).take(end - start).collect();
    assert_eq!(found, marked, "{message}");
}

/// A lobe.
#[kernel]
struct Sg {
    /// Sharpness.
    sharpness: f32,
}

#[kernel]
fn compares_structures(a: Sg, b: Sg) -> bool {
    let äöü = 1.0;
    let _ = äöü;
    a == b
}

#[kernel(domain(sg.width = 0.0..=1.0))]
fn domain_of_no_field(sg: Sg) -> f32 {
    sg.sharpness
}

#[kernel(domain(x = 2.0..=1.0))]
fn empty_domain(x: f32) -> f32 {
    x
}

#[kernel(domain(x = unit))]
fn unit_scalar(x: f32) -> f32 {
    x
}

#[kernel(budget(width = 1e-6))]
fn budget_of_no_field(x: f32) -> Sg {
    Sg { sharpness: x }
}

#[test]
fn contracts_speak_of_what_there_is() {
    points_at(&refusal(kernels![domain_of_no_field][0]), "Sg has no part `width`", "sg.width");
    points_at(&refusal(kernels![empty_domain][0]), "the domain 2.0..=1.0 is empty", "x");
    points_at(&refusal(kernels![unit_scalar][0]), "`unit` speaks of vectors, `x` is f32", "x");
    assert!(refusal(kernels![budget_of_no_field][0]).contains("Sg has no part `width`"));
}

#[kernel]
fn chosen(a: Sg, b: Sg, p: bool) -> Sg {
    select(a, b, p)
}

#[test]
fn mistakes_are_shown_at_their_columns() {
    points_at(&refusal(kernels![chosen][0]), "`select` does not take (Sg, Sg, bool)", "select(a, b, p)");
    points_at(&refusal(kernels![compares_structures][0]), "cannot compare Sg with Sg", "a == b");
}

mod elsewhere {
    use lobe_codegen::prelude::*;

    #[kernel]
    pub(crate) const ENDLESS: f32 = 1.0 / 0.0;

    #[kernel]
    pub(crate) fn ordered(p: bool, q: bool) -> bool {
        p < q
    }
}

#[kernel]
fn uses_endless(x: f32) -> f32 {
    x * elsewhere::ENDLESS
}

#[kernel]
fn calls_ordered(p: bool) -> bool {
    !elsewhere::ordered(p, true)
}

/// The mistake is where the item stands, not where it is used.
#[test]
fn mistakes_of_others_are_shown_at_their_lines() {
    let message = refusal(kernels![uses_endless][0]);
    points_at(&message, "`ENDLESS` is not finite", "pub(crate) const ENDLESS: f32 = 1.0 / 0.0;");
    points_at(&refusal(kernels![calls_ordered][0]), "orders booleans", "p < q");
}

mod uniform {
    use lobe_codegen::prelude::*;

    #[kernel(workgroup_size(1))]
    pub(crate) fn stride(#[uniform(0, 0)] weights: &[f32; 4], #[storage(0, 1)] found: &mut [f32]) {
        found[0] = weights[2];
    }

    #[kernel(workgroup_size(1))]
    pub(crate) fn truths(#[storage(0, 0)] flags: &[bool], #[storage(0, 1)] found: &mut [f32]) {
        found[0] = if flags[1] { 1.0 } else { 0.0 };
    }

    #[kernel(workgroup_size(1))]
    pub(crate) fn one_place(#[storage(0, 0)] given: &[f32], #[storage(0, 0)] found: &mut [f32]) {
        found[0] = given[0];
    }

    #[kernel]
    pub(crate) fn nothing(x: f32) -> f32 {
        let none = [x; 0];
        x + none.len() as f32
    }

    #[kernel(workgroup_size(0))]
    pub(crate) fn no_threads(#[storage(0, 0)] found: &mut [f32]) {
        found[0] = 1.0;
    }
}

/// naga's own words, at the Rust line.
#[test]
fn what_naga_refuses_is_shown_at_the_rust_line() {
    let message = refusal(kernels![uniform::stride][0]);
    points_at(&message, "naga refuses the module", "#[uniform(0, 0)] weights: &[f32; 4]");
    assert!(message.contains("stride"), "{message}");
    let message = refusal(kernels![uniform::truths][0]);
    points_at(&message, "naga refuses the module", "#[storage(0, 0)] flags: &[bool]");
    points_at(&refusal(kernels![uniform::nothing][0]), "'nothing' is invalid", "let none = [x; 0];");
    let message = refusal(kernels![uniform::one_place][0]);
    assert!(message.contains("mistakes.rs:") && message.contains('^'), "{message}");
    let message = refusal(kernels![uniform::no_threads][0]);
    assert!(message.contains("mistakes.rs:") && message.contains('^'), "{message}");
}
