//! One check for all topics: a kernel is called as Rust and evaluated as lowered, on many inputs,
//! and its module goes through every writer.

use crate::evaluate::{self, Value};
use lobe_codegen::data::{Leaf, WordReader, leaves};
use lobe_codegen::def::{FunctionRef, Scalar};
use lobe_codegen::{ValidModule, lower};
use naga::{Handle, Module};
use std::io::Write;
use std::process::{Command, Stdio};

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

/// Whether native and lowered form agree bit for bit on many inputs; integers are small, since they
/// bound loops.
#[track_caller]
pub(crate) fn agrees(kernel: FunctionRef) {
    let def = kernel();
    let inputs: Vec<Leaf> = def.params.iter().flat_map(|p| leaves(p.name, &p.ty)).collect();
    let mut state = 7;
    let rows = (0..400).map(|_| inputs.iter().map(|leaf| sample(leaf.scalar, &mut state)).collect());
    agrees_on(kernel, rows.collect());
}

/// The same on given rows of words.
#[track_caller]
pub(crate) fn agrees_on(kernel: FunctionRef, rows: Vec<Vec<u32>>) {
    let def = kernel();
    let module = lowered(&[kernel]);
    writers_take(&module);
    let native = def.native.expect("a native form");
    let function = &module.module().functions[module.function(def.name).expect("the function")];
    let mut compared = 0;
    for row in rows {
        // A kernel may panic where Rust does: an index outside, a division by zero.
        let mut expected = Vec::new();
        if lobe_codegen::quietly(|| native(&mut WordReader::new(&row), &mut expected)).is_err() {
            continue;
        }
        let mut words = row.iter().copied();
        let arguments = function.arguments.iter().map(|a| read(module.module(), a.ty, &mut words)).collect();
        let mut found = Vec::new();
        if let Some(value) = evaluate::run(module.module(), function, arguments) {
            write(&value, &mut found);
        }
        let same = |(a, b): (&u32, &u32)| a == b || (is_nan(*a) && is_nan(*b));
        assert!(
            expected.len() == found.len() && expected.iter().zip(&found).all(same),
            "`{}` on {row:x?}: Rust {expected:x?}, lowered {found:x?}\n{}",
            def.name,
            wgsl(&module)
        );
        compared += 1;
    }
    assert!(compared > 0, "`{}` was compared on no input", def.name);
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

fn read(module: &Module, ty: Handle<naga::Type>, words: &mut impl Iterator<Item = u32>) -> Value {
    fn fill(value: &mut Value, words: &mut impl Iterator<Item = u32>) {
        match value {
            Value::Parts(parts) => parts.iter_mut().for_each(|p| fill(p, words)),
            Value::F32(v) => *v = f32::from_bits(words.next().unwrap_or(0)),
            Value::I32(v) => *v = words.next().unwrap_or(0) as i32,
            Value::U32(v) => *v = words.next().unwrap_or(0),
            Value::Bool(v) => *v = words.next().unwrap_or(0) != 0,
            Value::Pointer(..) => panic!("a pointer as an argument"),
        }
    }
    let mut value = evaluate::zero(module, ty);
    fill(&mut value, words);
    value
}

fn write(value: &Value, words: &mut Vec<u32>) {
    match value {
        Value::Parts(parts) => parts.iter().for_each(|p| write(p, words)),
        Value::F32(v) => words.push(v.to_bits()),
        Value::I32(v) => words.push(*v as u32),
        Value::U32(v) => words.push(*v),
        Value::Bool(v) => words.push((*v).into()),
        Value::Pointer(..) => panic!("a pointer as a result"),
    }
}

/// The module as WGSL.
#[track_caller]
pub(crate) fn wgsl(module: &ValidModule) -> String {
    let flags = naga::back::wgsl::WriterFlags::empty();
    naga::back::wgsl::write_string(module.module(), module.info(), flags).expect("WGSL")
}

/// WGSL (parsed again), HLSL and SPIR-V (validated) come out without error.
#[track_caller]
pub(crate) fn writers_take(module: &ValidModule) {
    let text = wgsl(module);
    lobe_codegen::validate::from_wgsl(&text).unwrap_or_else(|e| panic!("{e}\n{text}"));
    let options = naga::back::hlsl::Options::default();
    let mut hlsl = String::new();
    let pipeline = naga::back::hlsl::PipelineOptions::default();
    naga::back::hlsl::Writer::new(&mut hlsl, &options, &pipeline)
        .write(module.module(), module.info(), None)
        .expect("HLSL");
    let options = naga::back::spv::Options { lang_version: (1, 3), ..Default::default() };
    let words = naga::back::spv::write_vec(module.module(), module.info(), &options, None).expect("SPIR-V");
    spirv_val(&words, &text);
}

#[track_caller]
fn spirv_val(words: &[u32], text: &str) {
    let child = Command::new("spirv-val")
        .args(["--target-env", "spv1.3", "-"])
        .stdin(Stdio::piped())
        .stderr(Stdio::piped())
        .stdout(Stdio::null())
        .spawn();
    let Ok(mut child) = child else {
        assert!(std::env::var_os("LOBE_REQUIRE_TOOLS").is_none_or(|v| v != "1"), "spirv-val is missing");
        eprintln!("SKIPPED: spirv-val is not on PATH (Debian: apt-get install spirv-tools)");
        return;
    };
    let bytes: Vec<u8> = words.iter().flat_map(|w| w.to_le_bytes()).collect();
    child.stdin.take().expect("piped").write_all(&bytes).expect("spirv-val reads");
    let output = child.wait_with_output().expect("spirv-val runs");
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "spirv-val: {message}\n{text}");
}
