//! What the tests share: modules from text, columns from numbers, a generator.

use lobe_backends::interp::{Interpreter, Isa, ShadowColumn, ShadowColumns};
use lobe_codegen::data::Columns;
use lobe_codegen::{ValidModule, validate};

/// A module from WGSL.
pub(crate) fn module(text: &str) -> ValidModule {
    validate::from_wgsl(text).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

/// A module from WGSL that may use whatever naga knows.
pub(crate) fn foreign(text: &str) -> ValidModule {
    validate::foreign_wgsl(text).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

/// One column for each list of words.
pub(crate) fn columns(columns: &[Vec<u32>]) -> Columns {
    Columns { rows: columns.first().map_or(0, Vec::len), columns: columns.to_vec() }
}

/// One column for each list of floats.
pub(crate) fn floats(lists: &[Vec<f32>]) -> Columns {
    columns(&lists.iter().map(|l| l.iter().map(|x| x.to_bits()).collect()).collect::<Vec<_>>())
}

/// Calls `f` of the module: on every instruction set that there is, and by the judge.
pub(crate) fn call(text: &str, args: &Columns) -> Columns {
    let module = module(text);
    let f = module.function("f").unwrap();
    let judged = Interpreter::new(&module).unwrap().call_judged(f, args).unwrap();
    for isa in Isa::available() {
        let called = Interpreter::new(&module).unwrap().with_isa(isa).call(f, args).unwrap();
        assert_eq!(without_nan(&called), without_nan(&judged), "{isa} and the judge\n{text}");
    }
    judged
}

/// The same with one NaN for all: which one an operation returns is the processor's choice.
fn without_nan(columns: &Columns) -> Columns {
    let one = |w: &u32| if f32::from_bits(*w).is_nan() { f32::NAN.to_bits() } else { *w };
    let columns_of = columns.columns.iter().map(|c| c.iter().map(one).collect()).collect();
    Columns { columns: columns_of, rows: columns.rows }
}

/// The shadow of `f`.
pub(crate) fn shadow(text: &str, args: &Columns) -> ShadowColumns {
    let module = module(text);
    let interpreter = Interpreter::new(&module).unwrap();
    interpreter.shadow(module.function("f").unwrap(), args, None).unwrap()
}

/// `f` of one row of words, with one result.
pub(crate) fn word(text: &str, args: &[u32]) -> u32 {
    let args = columns(&args.iter().map(|w| vec![*w]).collect::<Vec<_>>());
    call(text, &Columns { rows: 1, ..args }).columns[0][0]
}

/// Value, exact value and bound of a float column.
pub(crate) fn float_column(columns: &ShadowColumns, index: usize) -> (&[f32], &[f64], &[f64]) {
    match &columns.columns[index] {
        ShadowColumn::Float { value, exact, bound } => (value, exact, bound),
        ShadowColumn::Word { .. } => panic!("a column of words"),
    }
}

/// SplitMix64.
pub(crate) struct Chance(pub(crate) u64);

impl Chance {
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub(crate) fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    /// Mostly of ordinary size; small, large and round numbers too.
    pub(crate) fn float(&mut self) -> f32 {
        let unit = (self.bits() >> 40) as f32 / (1 << 24) as f32;
        let sign = if self.bits() & 1 == 0 { 1.0 } else { -1.0 };
        match self.below(8) {
            0 => sign * unit * 1e-3,
            1 => sign * (unit * 60.0 - 30.0).exp(),
            2 => sign * (self.below(5) as f32),
            3 => sign * unit,
            4 => f32::from_bits((self.bits() % 0x0100_0000) as u32) * sign,
            _ => sign * unit * 4.0,
        }
    }

    pub(crate) fn floats(&mut self, rows: usize) -> Vec<f32> {
        (0..rows).map(|_| self.float()).collect()
    }
}
