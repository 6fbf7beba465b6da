//! NaN and infinite arguments: the languages promise nothing about the result, but every route returns,
//! and the native form still equals the interpreter bit for bit.

mod common;

use lobe_backends::executor::{Executor, Interp, Native, Program};
use lobe_backends::routes::{Machine, State};
use lobe_codegen::data::Columns;
use lobe_codegen::def::Scalar;
use lobe_kernels::registry::KERNELS;

const STRANGE: [f32; 6] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN, -0.0];

/// One strange value in each argument's scalar in turn, the others 0.5.
fn arguments(program: &Program) -> Columns {
    let width = program.params().len();
    let mut rows = Vec::new();
    for place in 0..width {
        for value in STRANGE {
            let mut row: Vec<u32> = program
                .params()
                .iter()
                .map(|leaf| if leaf.scalar == Scalar::F32 { 0.5_f32.to_bits() } else { 1 })
                .collect();
            row[place] = value.to_bits();
            rows.push(row);
        }
    }
    Columns::from_rows(width, &rows)
}

fn same(a: u32, b: u32) -> bool {
    a == b || f32::from_bits(a).is_nan() && f32::from_bits(b).is_nan()
}

#[test]
fn native_equals_interp() {
    for kernel in KERNELS {
        let program = Program::new(*kernel).unwrap_or_else(|e| panic!("{e}"));
        let args = arguments(&program);
        let native = Native.run(&program, &args).unwrap_or_else(|e| panic!("{e}"));
        let interp = Interp.run(&program, &args).unwrap_or_else(|e| panic!("{e}"));
        for row in 0..args.rows {
            let (n, i) = (native.row(row), interp.row(row));
            assert!(n.iter().zip(&i).all(|(n, i)| same(*n, *i)), "{}: {n:x?} {i:x?}", program.name());
        }
    }
}

#[test]
fn every_route_returns() {
    let machine = Machine::look();
    // A program is translated once for all drivers.
    let programs: Vec<Program> =
        KERNELS.iter().map(|kernel| Program::new(*kernel).unwrap_or_else(|e| panic!("{e}"))).collect();
    for (route, state) in machine.routes() {
        if let State::Missing { what, mend } = state {
            common::skip(&format!("{route}: {what}"), &mend);
            continue;
        }
        let mut executor = machine.open(&route).unwrap_or_else(|e| panic!("{e}"));
        for program in &programs {
            let args = arguments(program);
            let out =
                executor.run(program, &args).unwrap_or_else(|e| panic!("{} {route}: {e}", program.name()));
            assert_eq!(out.rows, args.rows, "{} {route}", program.name());
        }
    }
}

/// What `kernels/src/lib.rs` says: NaN comes in, and IEEE arithmetic decides what comes out.
#[test]
fn nan_in_a_lobe_gives_nan_or_the_clamped_zero_natively() {
    use lobe_codegen::glam::Vec3;
    use lobe_kernels::{hsg, sg, special};
    let lobe = sg::Sg { axis: Vec3::Z, sharpness: f32::NAN, log_amplitude: 0.0 };
    assert!(sg::sg_eval(Vec3::X, lobe).is_nan());
    assert!(sg::sg_integral(f32::NAN).is_nan() && special::erf(f32::NAN).is_nan());
    assert!(special::expm1_over_x(f32::NAN).is_nan());
    assert_eq!(hsg::hsg_cosine_product_integral(lobe, Vec3::Z), 0.0);
}
