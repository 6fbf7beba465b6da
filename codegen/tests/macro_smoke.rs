//! The macro's expansion compiles, stays callable, and writes down what was written.
use lobe_codegen::prelude::*;

/// A lobe.
#[kernel]
pub struct Sg {
    /// Axis.
    #[domain(unit)]
    pub axis: Vec3,
    /// Sharpness.
    #[domain(0.0..=1e6)]
    pub sharpness: f32,
}

/// Half.
#[kernel]
pub const HALF_OF_IT: f32 = 0.5;

/// Evaluates.
#[kernel(family = "sg", domain(dir = unit), budget(1e-6 * result), truth = no)]
pub fn evaluate(dir: Vec3, sg: Sg) -> f32 {
    let d = dir - sg.axis;
    let mut sum = 0.0;
    for i in 0..3 {
        if i == 1 {
            continue;
        }
        sum += i as f32;
    }
    exp(-sg.sharpness * HALF_OF_IT * dot(d, d)) + sum * 0.0
}
fn no(x: f64, _: f64) -> f64 {
    x
}

#[kernel]
fn pick(n: u32) -> f32 {
    match n {
        0 | 1 => 1.0,
        2 => {
            let x = evaluate(Vec3::X, Sg { axis: Vec3::Z, sharpness: 1.0 });
            x
        }
        _ => -1.0,
    }
}

#[kernel(workgroup_size(64))]
fn scale(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] input: &[f32],
    #[storage(0, 1)] output: &mut [f32],
) {
    if id.x < input.len() as u32 {
        output[id.x as usize] = 2.0 * input[id.x as usize];
    }
}

#[test]
fn expands() {
    assert!(pick(2) > 0.0);
    let mut out = [0.0; 2];
    scale(UVec3::new(1, 0, 0), &[1.0, 2.0], &mut out);
    assert_eq!(out, [0.0, 4.0]);
    let lobe_codegen::def::Callee::Function(f) = <evaluate as lobe_codegen::def::Callable>::CALLEE else {
        panic!()
    };
    println!("{:#?}", f());
}
