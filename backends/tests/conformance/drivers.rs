//! The same operations on a driver, over their edges: integers to the bit, floats as near as WGSL asks.

use crate::common;
use crate::run::{Operation, Ty, bits_of, bytes};
use crate::soft::{self, Format, Number};
use lobe_backends::gpu::{Binding, BindingKind, Gpu, Job, Shader};
use lobe_codegen::validate;
use naga::back::spv;

/// What naga's SPIR-V or the driver cannot do: bit functions of 16 and 64 bits crash one or the other, and
/// widening extends by the sign of the type that is wanted, not of the one that is there. A remainder of floats inherits what the quotient
/// before it was rounded to: it is any number of the divisor's size.
fn is_beyond(operation: &Operation) -> bool {
    let from = operation.args[0];
    let names = ["count", "reverseBits", "first", "extractBits", "insertBits"];
    let of_bits = from.bits() != 32 && names.iter().any(|name| operation.wgsl.starts_with(name));
    let widens = |to: Ty| {
        let is_conversion = operation.wgsl == format!("{}(a)", to.name());
        is_conversion && from.signed() != to.signed() && from.bits() < to.bits()
    };
    // Beyond their range WGSL says nothing of them, for it has no such integers.
    let to_short = from.format().is_some() && ["i16(a)", "u16(a)"].contains(&&*operation.wgsl);
    let of_floats = operation.wgsl == "a % b" && from.format().is_some();
    of_bits
        || to_short
        || of_floats
        || (from.format().is_none() && crate::run::INTEGERS.into_iter().any(widens))
}

fn spirv(text: &str) -> Vec<u32> {
    let module = validate::foreign_wgsl(text).unwrap_or_else(|e| panic!("{e}\n{text}"));
    let options = spv::Options { lang_version: (1, 3), capabilities: None, ..Default::default() };
    spv::write_vec(module.module(), module.info(), &options, None).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

/// Whether drivers must know the number: it is neither NaN nor infinite nor subnormal.
fn ordinary(format: Format, bits: u64) -> bool {
    match format.decode(bits) {
        Number::Nan | Number::Infinite { .. } => false,
        Number::Finite { size, .. } => size == 0 || size >> (format.digits - 1) != 0,
    }
}

/// ULPs that WGSL lets an operation of one name be off, of results that are ordinary.
fn ulps(wgsl: &str) -> u64 {
    match wgsl {
        "a / b" | "sqrt(a)" => 3,
        _ if wgsl.starts_with("unpack") => 3,
        _ => 1,
    }
}

/// Whether two numbers are so many ULPs apart; zeros are one number.
fn near(format: Format, a: u64, b: u64, ulps: u64) -> bool {
    let sign = |bits: u64| bits >> (format.bits - 1);
    let magnitude = |bits: u64| bits & ((1 << (format.bits - 1)) - 1);
    let are_zeros = magnitude(a) == 0 && magnitude(b) == 0;
    are_zeros || (sign(a) == sign(b) && magnitude(a).abs_diff(magnitude(b)) <= ulps)
}

/// A product and then a sum, as `fma` may be; the product is rounded either way.
fn in_two_steps(format: Format, row: &[u64]) -> impl Iterator<Item = u64> {
    let product = format.encode(soft::mul(format.decode(row[0]), format.decode(row[1])));
    let more = format.decode(row[2]);
    [product.saturating_sub(1), product, product + 1]
        .into_iter()
        .map(move |product| format.encode(soft::add(format.decode(product), more)))
}

impl Operation {
    /// Whether a driver may return `got` where `want` is the right result.
    fn permits(&self, row: &[u64], got: u64, want: u64) -> bool {
        let formats = self.args.iter().zip(row).filter_map(|(ty, bits)| Some((ty.format()?, *bits)));
        let mut plain = formats.into_iter().all(|(format, bits)| ordinary(format, bits));
        let Some(format) = self.result.format() else {
            return got == want || !plain;
        };
        plain &= ordinary(format, want);
        let is_near = |want| near(format, got, want, ulps(&self.wgsl));
        !plain || is_near(want) || (self.wgsl.starts_with("fma") && in_two_steps(format, row).any(is_near))
    }

    /// Panics on the first row whose result WGSL does not permit.
    pub(crate) fn check_on(&self, gpu: &mut Gpu, rows: &[Vec<u64>]) {
        if is_beyond(self) {
            return;
        }
        // Words are bound, so that numbers of 16 bits come in pairs.
        let mut rows = rows.to_vec();
        rows.extend((rows.len() % 2 == 1).then(|| rows[0].clone()));
        let columns: Vec<Vec<u8>> =
            self.args.iter().enumerate().map(|(column, ty)| bytes(*ty, &rows, column)).collect();
        let width = self.result.bits() as usize / 8;
        let empty = vec![0; rows.len() * width];
        let binding = |binding, kind, data| Binding { group: 0, binding, element: None, kind, data };
        let mut bindings: Vec<Binding<'_>> =
            (0..).zip(&columns).map(|(at, data)| binding(at, BindingKind::StorageRead, &data[..])).collect();
        bindings.push(binding(9, BindingKind::StorageReadWrite, &empty));
        let (words, groups) = (spirv(&self.text()), [rows.len().div_ceil(64) as u32, 1, 1]);
        let job = Job {
            shader: Shader::Spirv(&words),
            entry: "main",
            workgroup_size: [64, 1, 1],
            groups,
            bindings: &bindings,
            immediates: &[],
        };
        let outputs = gpu.run(&job).unwrap_or_else(|e| panic!("{e}\n{}", self.text()));
        for (row, got) in rows.iter().zip(outputs[0].chunks(width).map(bits_of)) {
            let want = (self.oracle)(row);
            assert!(
                self.permits(row, got, want),
                "{} of {:?} = {row:#x?} is {want:#x}, not {got:#x}",
                self.wgsl,
                self.args
            );
        }
    }
}

/// lavapipe, or a skip that says so.
pub(crate) fn lavapipe() -> Option<Gpu> {
    common::driver("lavapipe").map(|driver| Gpu::open(&driver).expect("a listed driver opens"))
}
