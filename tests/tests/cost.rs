//! What kernels cost, in scalar operations of the lowered module: a change of form is noticed.

use lobe_backends::executor::Program;
use lobe_codegen::prelude::*;
use lobe_kernels::registry::KERNELS;
use lobe_tests::cost::{self, Cost};

fn program(name: &str) -> Program {
    let kernel = KERNELS.iter().find(|k| k().name == name).expect("a kernel of this name");
    Program::new(*kernel).expect("it lowers")
}

/// A kernel, a function that it calls, and what that function costs in all.
const HELD: &[(&str, &str, usize)] = &[
    // Once for each rectangle.
    ("rect_laplace", "rect_laplace_bitangent", 9),
    // Once for each rectangle and light.
    ("rect_laplace", "rect_laplace_reflector", 21),
    // Once for each pixel and rectangle.
    ("rect_laplace", "rect_laplace_receiver", 100),
    // For each pixel, rectangle and light.
    ("rect_laplace", "rect_laplace_integral", 712),
    ("rect_laplace_sg", "rect_laplace_integral_sg", 721),
    ("rect_laplace_fast", "rect_laplace_fast_integral", 421),
    ("rect_laplace_fast_sg", "rect_laplace_fast_integral_sg", 425),
    // All together.
    ("rect_laplace", "rect_laplace", 845),
    ("rect_laplace_sg", "rect_laplace_sg", 854),
    ("rect_laplace_fast", "rect_laplace_fast", 554),
    ("rect_laplace_fast_sg", "rect_laplace_fast_sg", 558),
];

#[test]
fn kernels_cost_what_is_stated() {
    let mut wrong = Vec::new();
    for (kernel, function, total) in HELD {
        let found = cost::of_callee(&program(kernel), function).expect("it is called");
        println!("{function}: {found}");
        if found.total() != *total {
            wrong.push(format!("{function}: {} instead of {total}", found.total()));
        }
    }
    assert!(wrong.is_empty(), "state the new counts, in the documentation too:\n{}", wrong.join("\n"));
}

#[kernel]
fn squares(v: Vec3) -> f32 {
    dot(v, v)
}

/// One of each kind.
#[kernel]
fn of_each_kind(a: Vec3, b: Vec3, x: f32) -> f32 {
    let c = 2.0 * a + b;
    let d = max(c, b) / x;
    if x > 1.0 {
        return squares(d) + squares(-c);
    }
    exp(select(x, 1.0, x < 0.5)) * sqrt(abs(d.x))
}

#[test]
fn every_component_of_every_call_counts() {
    let program = Program::new(lobe_codegen::kernels![of_each_kind][0]).expect("it lowers");
    let expected =
        Cost { add_mul: 6 + 5 + 5 + 1 + 1, div: 3, sqrt: 1, elementary: 1, min_max: 3 + 1, choice: 3 };
    assert_eq!(cost::of(&program), expected);
}
