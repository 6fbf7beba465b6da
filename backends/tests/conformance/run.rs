//! An expression of WGSL over rows of bits, on the interpreter.

use crate::soft::{F16, F32, F64, Format};
use lobe_backends::interp::{Buffer, Interpreter, Isa};
use lobe_codegen::validate;

/// A scalar type.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Ty {
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F16,
    F32,
    F64,
    /// As a result only.
    Bool,
}

pub(crate) const INTEGERS: [Ty; 6] = [Ty::I16, Ty::U16, Ty::I32, Ty::U32, Ty::I64, Ty::U64];
pub(crate) const FLOATS: [Ty; 3] = [Ty::F16, Ty::F32, Ty::F64];

impl Ty {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::I16 => "i16",
            Self::U16 => "u16",
            Self::I32 => "i32",
            Self::U32 => "u32",
            Self::I64 => "i64",
            Self::U64 => "u64",
            Self::F16 => "f16",
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::Bool => "bool",
        }
    }

    pub(crate) fn bits(self) -> u32 {
        match self {
            Self::I16 | Self::U16 | Self::F16 => 16,
            Self::I32 | Self::U32 | Self::F32 | Self::Bool => 32,
            Self::I64 | Self::U64 | Self::F64 => 64,
        }
    }

    pub(crate) fn signed(self) -> bool {
        matches!(self, Self::I16 | Self::I32 | Self::I64)
    }

    /// The format of a float.
    pub(crate) fn format(self) -> Option<Format> {
        match self {
            Self::F16 => Some(F16),
            Self::F32 => Some(F32),
            Self::F64 => Some(F64),
            _ => None,
        }
    }

    /// The integer that the bits are.
    pub(crate) fn value(self, bits: u64) -> i128 {
        let bits = i128::from(bits);
        let full = 1_i128 << self.bits();
        if self.signed() && bits >= full / 2 { bits - full } else { bits }
    }

    /// The lower bits of an integer.
    pub(crate) fn wrap(self, value: i128) -> u64 {
        (value & ((1 << self.bits()) - 1)) as u64
    }

    /// The least and the largest integer.
    pub(crate) fn range(self) -> (i128, i128) {
        let full = 1_i128 << self.bits();
        if self.signed() { (-full / 2, full / 2 - 1) } else { (0, full - 1) }
    }

    /// Numbers at which something changes.
    pub(crate) fn edges(self) -> Vec<u64> {
        match self.format() {
            Some(format) => {
                let (infinity, top) = (format.infinity_bits(), 1_u64 << (self.bits() - 1));
                let one = format.encode(crate::soft::of_integer(1));
                let half = one - (1 << (format.digits - 1));
                let least_normal = 1_u64 << (format.digits - 1);
                let positive = [0, 1, least_normal - 1, least_normal, half - 1, half, one - 1, one, one + 1];
                let more = [1.5, 2.0, 2.5, 3.7, 255.0, 65504.0, 65536.0, 2147483648.0, 9.3e18]
                    .map(|x: f32| format.encode(F32.decode(x.to_bits().into())));
                let large = [infinity - 1, infinity, format.nan()];
                let all: Vec<u64> = positive.into_iter().chain(more).chain(large).collect();
                all.iter().copied().chain(all.iter().map(|b| b | top)).collect()
            }
            None => {
                let (low, high) = self.range();
                let near = |x: i128| [x - 1, x, x + 1];
                let values =
                    [near(0), near(low), near(high), near(31), near(64), [5, -7, 0x55aa], [16, 15, 17]];
                let mut bits: Vec<u64> = values.concat().into_iter().map(|v| self.wrap(v)).collect();
                bits.sort_unstable();
                bits.dedup();
                bits
            }
        }
    }

    /// Any bits; of integers as often small ones, of floats as often ones of moderate size.
    pub(crate) fn random(self, chance: &mut impl FnMut() -> u64) -> u64 {
        let bits = chance() >> (64 - self.bits());
        match (self.format(), chance() % 2) {
            (_, 0) => bits,
            (None, _) => self.wrap(self.value(bits) >> (chance() % u64::from(self.bits()))),
            (Some(format), _) => {
                let exponents = format.infinity_bits();
                let one = format.encode(crate::soft::of_integer(1));
                let near = (chance() % 16) << (format.digits - 1);
                bits & !exponents | (one + near - (8 << (format.digits - 1)))
            }
        }
    }
}

/// The bits of a result, by the bits of the operands.
pub(crate) type Oracle = Box<dyn Fn(&[u64]) -> u64>;

/// An operation: its expression, its types, what it is.
pub(crate) struct Operation {
    /// Of `a`, `b`, `c`, `d`.
    pub(crate) wgsl: String,
    pub(crate) args: Vec<Ty>,
    pub(crate) result: Ty,
    pub(crate) oracle: Oracle,
}

impl Operation {
    /// A compute shader that computes it, row by row.
    pub(crate) fn text(&self) -> String {
        let names = ["a", "b", "c", "d"];
        let buffers: String =
            names.iter().zip(&self.args).enumerate().fold(String::new(), |text, (i, (n, ty))| {
                text + &format!("@group(0) @binding({i}) var<storage, read> in_{n}: array<{}>;\n", ty.name())
            });
        let lets: String =
            names.iter().zip(&self.args).map(|(n, _)| format!("let {n} = in_{n}[id.x]; ")).collect();
        let (result, value) = match self.result {
            Ty::Bool => ("u32", format!("select(0u, 1u, {})", self.wgsl)),
            ty => (ty.name(), self.wgsl.clone()),
        };
        format!(
            "enable f16;\nenable wgpu_int16;\n{buffers}
            @group(0) @binding(9) var<storage, read_write> out: array<{result}>;
            @compute @workgroup_size(64) fn main(@builtin(global_invocation_id) id: vec3u) {{
                if id.x < arrayLength(&out) {{ {lets} out[id.x] = {value}; }}
            }}"
        )
    }

    /// Panics on the first row whose result is not the oracle's; NaN equals NaN.
    pub(crate) fn check(&self, rows: &[Vec<u64>], isa: Isa) {
        let text = self.text();
        let module = validate::foreign_wgsl(&text).unwrap_or_else(|e| panic!("{e}\n{text}"));
        let mut buffers: Vec<Buffer> =
            (0..).zip(&self.args).map(|(i, ty)| buffer(i, *ty, rows, i as usize)).collect();
        let width = self.result.bits() as usize / 8;
        buffers.push(Buffer { group: 0, binding: 9, data: vec![0; rows.len() * width] });
        let interpreter = Interpreter::new(&module).unwrap().with_isa(isa);
        interpreter.run(0, [rows.len().div_ceil(64) as u32, 1, 1], buffers.as_mut_slice()).unwrap();
        let results = buffers.pop().unwrap().data;
        for (row, result) in rows.iter().zip(results.chunks(width)) {
            let (got, want) = (bits_of(result), (self.oracle)(row));
            let nan = self.result.format().is_some_and(|f| f.is_nan(got) && f.is_nan(want));
            assert!(
                got == want || nan,
                "{} of {:?} = {row:#x?} is {want:#x}, not {got:#x} ({isa})",
                self.wgsl,
                self.args
            );
        }
    }
}

fn buffer(binding: u32, ty: Ty, rows: &[Vec<u64>], column: usize) -> Buffer {
    Buffer { group: 0, binding, data: bytes(ty, rows, column) }
}

/// A column of the rows.
pub(crate) fn bytes(ty: Ty, rows: &[Vec<u64>], column: usize) -> Vec<u8> {
    let width = ty.bits() as usize / 8;
    rows.iter().flat_map(|row| row[column].to_le_bytes()[..width].to_vec()).collect()
}

/// The bits that up to eight bytes are.
pub(crate) fn bits_of(bytes: &[u8]) -> u64 {
    let mut all = [0; 8];
    all[..bytes.len()].copy_from_slice(bytes);
    u64::from_le_bytes(all)
}
