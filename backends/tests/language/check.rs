//! A kernel is called as Rust and interpreted as lowered, on many inputs at once.

use lobe_backends::interp::Interpreter;
use lobe_codegen::data::{Columns, Leaf, WordReader, leaves};
use lobe_codegen::def::{FunctionRef, Scalar};
use lobe_codegen::{ValidModule, lower};

/// Lowers, and shows the error as a user would see it.
#[track_caller]
pub(crate) fn lowered(kernels: &[FunctionRef]) -> ValidModule {
    lower(kernels).unwrap_or_else(|e| panic!("{e}"))
}

/// The message of a kernel that must be refused.
#[track_caller]
pub(crate) fn refusal(kernel: FunctionRef) -> String {
    match lower(&[kernel]) {
        Ok(_) => panic!("`{}` is accepted", kernel().name),
        Err(error) => error.to_string(),
    }
}

/// Whether native and interpreted form agree bit for bit on many inputs.
#[track_caller]
pub(crate) fn agrees(kernel: FunctionRef) {
    let inputs: Vec<Leaf> = kernel().params.iter().flat_map(|p| leaves(p.name, &p.ty)).collect();
    let mut state = 7;
    let rows = (0..400).map(|_| inputs.iter().map(|leaf| sample(leaf.scalar, &mut state)).collect());
    agrees_on(kernel, rows.collect());
}

/// The same on given rows of words.
#[track_caller]
pub(crate) fn agrees_on(kernel: FunctionRef, rows: Vec<Vec<u32>>) {
    let def = kernel();
    let module = lowered(&[kernel]);
    let native = def.native.expect("a native form");
    let mut expected = Vec::new();
    let mut inputs = Vec::new();
    for row in rows {
        // A kernel may panic where Rust does: an index outside, a division by zero.
        let mut out = Vec::new();
        if lobe_codegen::quietly(|| native(&mut WordReader::new(&row), &mut out)).is_ok() {
            expected.push(out);
            inputs.push(row);
        }
    }
    assert!(!inputs.is_empty(), "`{}` was compared on no input", def.name);
    let function = module.function(def.name).expect("the function");
    let arguments = Columns::from_rows(inputs[0].len(), &inputs);
    let interpreter = Interpreter::new(&module).unwrap_or_else(|e| panic!("{e}"));
    let found = interpreter.call(function, &arguments).unwrap_or_else(|e| panic!("`{}`: {e}", def.name));
    for (r, (input, expected)) in inputs.iter().zip(&expected).enumerate() {
        let found = found.row(r);
        let same = |(a, b): (&u32, &u32)| a == b || (is_nan(*a) && is_nan(*b));
        assert!(
            expected.len() == found.len() && expected.iter().zip(&found).all(same),
            "`{}` on {input:x?}: Rust {expected:x?}, interpreted {found:x?}\n{}",
            def.name,
            wgsl(&module)
        );
    }
}

fn is_nan(word: u32) -> bool {
    f32::from_bits(word).is_nan()
}

fn sample(scalar: Scalar, state: &mut u64) -> u32 {
    *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    let random = (*state >> 33) as u32;
    match scalar {
        Scalar::Bool => random & 1,
        Scalar::U32 => random % 10,
        Scalar::I32 => ((random % 14) as i32 - 4) as u32,
        Scalar::F32 => match random % 8 {
            0 => [0.0, -0.0, 1.0, -1.0, f32::MAX, f32::INFINITY, f32::NAN, 1e-40][random as usize / 8 % 8],
            _ => (random / 8 % 4001) as f32 / 400.0 - 5.0,
        }
        .to_bits(),
    }
}

/// The module as WGSL.
#[track_caller]
pub(crate) fn wgsl(module: &ValidModule) -> String {
    let flags = naga::back::wgsl::WriterFlags::empty();
    naga::back::wgsl::write_string(module.module(), module.info(), flags).expect("WGSL")
}

/// The writers are tested beside the language.
pub(crate) fn writers_take(module: &ValidModule) {
    wgsl(module);
}
