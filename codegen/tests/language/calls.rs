//! Calls across modules; functions without result.

use crate::check::{agrees, lowered, refusal, writers_take};
use lobe_codegen::kernels;
use lobe_codegen::prelude::*;

mod inner {
    use lobe_codegen::prelude::*;

    /// Squares.
    #[kernel]
    pub(crate) fn square(x: f32) -> f32 {
        x * x
    }

    pub(crate) mod deep {
        pub(crate) use super::square as super_square;
        use super::square as squared;
        use lobe_codegen::prelude::*;

        #[kernel]
        pub(crate) fn fourth(x: f32) -> f32 {
            squared(squared(x))
        }
    }
}

use inner::deep;

#[kernel]
fn polynomial(x: f32) -> f32 {
    deep::fourth(x) + inner::square(x) + deep::super_square(2.0) + min(x, 1.0)
}

#[kernel]
fn nothing(x: f32) {
    let y = x + 1.0;
    if y > 2.0 {
        return;
    }
    let _ = y * 2.0;
}

#[kernel]
fn nothing_twice(x: f32) {
    if x > 0.0 {
        return nothing(x);
    }
    match x as i32 {
        0 => nothing(1.0),
        _ => {}
    }
    if x < 0.0 {
        nothing(x);
    }
}

#[kernel]
fn calls_nothing(x: f32) -> f32 {
    nothing_twice(x);
    nothing(x);
    deep::fourth(x);
    x
}

#[test]
fn calls_reach_kernels_of_other_modules() {
    agrees(kernels![polynomial][0]);
    agrees(kernels![calls_nothing][0]);
    agrees(kernels![nothing][0]);
}

#[test]
fn each_function_is_lowered_once() {
    let module = lowered(&kernels![polynomial, deep::fourth, polynomial]);
    writers_take(&module);
    assert_eq!(module.module().functions.len(), 3);
    assert_eq!(module.meta().definitions.len(), 3);
}

#[kernel]
fn even(n: u32) -> u32 {
    if n == 0 { 1 } else { odd(n - 1) }
}

#[kernel]
fn odd(n: u32) -> u32 {
    if n == 0 { 0 } else { even(n - 1) }
}

#[test]
fn functions_that_call_each_other_are_refused() {
    let message = refusal(kernels![even][0]);
    assert!(message.contains("recursion: even -> odd -> even"), "{message}");
}
