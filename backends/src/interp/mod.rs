//! The CPU interpreter: naga IR over lanes, structure of arrays.
//!
//! A value is a column for each of its scalars, a column holds that scalar in all lanes; an operation is
//! chosen once and then runs over its columns.
//! Control flow masks lanes ([`exec`], [`control`]).
//! The interpreter is written once over a [`model`] of what a lane holds:
//! - `Strict`, IEEE f32 by the functions of `lobe_codegen::math`, bit for bit what the native form does;
//! - `Shadow`, which carries beside each f32 the real value and a bound on what a legal driver may
//!   return ([`shadow`]), and follows both sides of a branch that may be decided either way ([`join`]).

mod control;
mod entry;
mod error;
mod exec;
mod expr;
mod join;
mod math;
mod matrix;
mod memory;
mod model;
mod operator;
mod shadow;
mod value;

pub use error::InterpError;

use exec::{Executor, Notes};
use lobe_codegen::ValidModule;
use lobe_codegen::data::Columns;
use model::{Model, Strict};
use naga::{Function, Handle};
use rayon::prelude::*;
use shadow::{Real, Shadow};
use std::rc::Rc;
use value::{Column, Kind, Slot, Value, kinds};

/// Lanes of a batch: a column of f32 fills 2 KiB, so that a function's values stay in the cache.
const BATCH: usize = 512;

/// Interprets one module.
#[derive(Debug, Clone, Copy)]
pub struct Interpreter<'m> {
    module: &'m ValidModule,
}

/// Memory behind a binding, in WGSL's layout.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Buffer {
    /// Bind group.
    pub group: u32,
    /// Binding.
    pub binding: u32,
    /// Its bytes.
    pub data: Vec<u8>,
}

/// What the shadow lane knows of a function's results.
#[derive(Debug, Clone, Default)]
pub struct ShadowColumns {
    /// A column for each scalar of the result.
    pub columns: Vec<ShadowColumn>,
    /// Rows.
    pub rows: usize,
    /// Rows that met a condition which legal drivers may decide either way; both ways are in the bound.
    pub ambiguous: Vec<bool>,
    /// Rows without a bound for a reason other than arithmetic.
    pub indeterminate: Vec<bool>,
}

/// One scalar of the results.
#[derive(Debug, Clone)]
pub enum ShadowColumn {
    /// A float.
    Float {
        /// The strict f32 result.
        value: Vec<f32>,
        /// The real value.
        exact: Vec<f64>,
        /// Distance of a legal result from it; infinite when nothing is promised.
        bound: Vec<f64>,
    },
    /// An integer or boolean.
    Word {
        /// The strict result.
        value: Vec<u32>,
        /// Whether every legal driver has it.
        known: Vec<bool>,
    },
}

impl<'m> Interpreter<'m> {
    /// Takes a module.
    ///
    /// # Errors
    /// None now; a function that cannot be interpreted is refused when it is called.
    pub fn new(module: &'m ValidModule) -> Result<Self, InterpError> {
        Ok(Self { module })
    }

    /// Calls a function on every row, in strict f32.
    ///
    /// # Errors
    /// When the columns do not fit the parameters, or the function does what this interpreter refuses.
    pub fn call(&self, function: Handle<Function>, args: &Columns) -> Result<Columns, InterpError> {
        let batches = self.batches::<Strict, Columns>(function, args, None, |result, _, rows| Columns {
            rows,
            columns: result.iter().map(strict_words).collect(),
        })?;
        let mut out = Columns::default();
        for batch in batches {
            if out.columns.is_empty() && out.rows == 0 {
                out = batch;
            } else {
                out.append(&batch);
            }
        }
        Ok(out)
    }

    /// Calls a function on every row in the shadow lane. `exact` are the real values of the arguments, a
    /// column for each scalar, of which those of integers are not read; without it they are the f32.
    ///
    /// # Errors
    /// As [`Interpreter::call`].
    pub fn shadow(
        &self,
        function: Handle<Function>,
        args: &Columns,
        exact: Option<&[Vec<f64>]>,
    ) -> Result<ShadowColumns, InterpError> {
        let batches = self.batches::<Shadow, ShadowColumns>(function, args, exact, shadow_batch)?;
        let mut out = ShadowColumns::default();
        for batch in batches {
            out.append(batch);
        }
        Ok(out)
    }

    /// Cuts the rows into batches and calls the function on each, in parallel.
    fn batches<M: Model, R: Send>(
        &self,
        function: Handle<Function>,
        args: &Columns,
        exact: Option<&[Vec<f64>]>,
        finish: impl Fn(&[Column<M>], &Notes, usize) -> R + Sync,
    ) -> Result<Vec<R>, InterpError> {
        let kinds = self.parameter_kinds(function)?;
        let name = self.name(function);
        let expected = kinds.iter().map(Vec::len).sum();
        if expected != args.width() {
            return Err(InterpError::Arguments { function: name, expected, found: args.width() });
        }
        // One empty batch gives no rows the right columns.
        let starts: Vec<usize> =
            if args.rows == 0 { vec![0] } else { (0..args.rows).step_by(BATCH).collect() };
        starts
            .into_par_iter()
            .map(|start| {
                let rows = start..(start + BATCH).min(args.rows);
                let lanes = rows.len();
                let slots = arguments::<M>(&kinds, args, exact, rows);
                let mut executor = Executor::<M>::new(self.module, lanes);
                let result = executor
                    .call(function, slots, &vec![true; lanes])
                    .map_err(|fault| fault.within(&name))?
                    .unwrap_or_default();
                Ok(finish(&result, &executor.notes, lanes))
            })
            .collect()
    }

    fn name(&self, function: Handle<Function>) -> String {
        self.module.module().functions[function].name.clone().unwrap_or_else(|| "a function".to_owned())
    }

    /// The kinds of the scalars of each parameter.
    fn parameter_kinds(&self, function: Handle<Function>) -> Result<Vec<Vec<Kind>>, InterpError> {
        let module = self.module.module();
        module.functions[function]
            .arguments
            .iter()
            .map(|argument| {
                let mut out = Vec::new();
                kinds(module, &module.types[argument.ty].inner, &mut out)
                    .map_err(|fault| fault.within(&self.name(function)))?;
                Ok(out)
            })
            .collect()
    }
}

/// The arguments of some rows.
fn arguments<M: Model>(
    kinds: &[Vec<Kind>],
    args: &Columns,
    exact: Option<&[Vec<f64>]>,
    rows: std::ops::Range<usize>,
) -> Vec<Slot<M>> {
    let mut next = 0;
    let mut column = |kind: Kind| {
        let words = &args.columns[next][rows.clone()];
        let exact = exact.and_then(|e| e.get(next)).map(|e| &e[rows.clone()]);
        next += 1;
        match kind {
            Kind::F => Column::F(
                words
                    .iter()
                    .enumerate()
                    .map(|(i, &w)| {
                        let value = f32::from_bits(w);
                        M::float(value, exact.map_or(value.into(), |e| e[i]))
                    })
                    .collect(),
            ),
            Kind::W => Column::W(words.iter().map(|&w| M::word(w)).collect()),
            Kind::B => Column::B(words.iter().map(|&w| M::bool(w != 0)).collect()),
        }
    };
    kinds
        .iter()
        .map(|kinds| {
            let value: Value<M> = Rc::new(kinds.iter().map(|&k| column(k)).collect());
            Slot::Value(value)
        })
        .collect()
}

fn strict_words(column: &Column<Strict>) -> Vec<u32> {
    match column {
        Column::F(lanes) => lanes.iter().map(|x| x.to_bits()).collect(),
        Column::W(lanes) => lanes.clone(),
        Column::B(lanes) => lanes.iter().map(|&b| b.into()).collect(),
    }
}

fn shadow_batch(result: &[Column<Shadow>], notes: &Notes, rows: usize) -> ShadowColumns {
    let column = |column: &Column<Shadow>| match column {
        Column::F(lanes) => ShadowColumn::Float {
            value: lanes.iter().map(|x| x.value).collect(),
            exact: lanes.iter().map(|x| x.exact).collect(),
            bound: lanes.iter().zip(&notes.indeterminate).map(|(x, &lost)| bound(x, lost)).collect(),
        },
        Column::W(lanes) => ShadowColumn::Word {
            value: lanes.iter().map(|x| x.value).collect(),
            known: lanes.iter().zip(&notes.indeterminate).map(|(x, &lost)| x.known && !lost).collect(),
        },
        Column::B(lanes) => ShadowColumn::Word {
            value: lanes.iter().map(|x| x.value.into()).collect(),
            known: lanes.iter().zip(&notes.indeterminate).map(|(x, &lost)| !x.ambiguous && !lost).collect(),
        },
    };
    ShadowColumns {
        columns: result.iter().map(column).collect(),
        rows,
        ambiguous: notes.ambiguous.clone(),
        indeterminate: notes.indeterminate.clone(),
    }
}

fn bound(x: &Real, indeterminate: bool) -> f64 {
    if indeterminate { f64::INFINITY } else { x.bound }
}

impl ShadowColumns {
    fn append(&mut self, more: Self) {
        if self.columns.is_empty() && self.rows == 0 {
            *self = more;
            return;
        }
        self.rows += more.rows;
        self.ambiguous.extend(more.ambiguous);
        self.indeterminate.extend(more.indeterminate);
        for (to, from) in self.columns.iter_mut().zip(more.columns) {
            match (to, from) {
                (
                    ShadowColumn::Float { value, exact, bound },
                    ShadowColumn::Float { value: v, exact: e, bound: b },
                ) => {
                    value.extend(v);
                    exact.extend(e);
                    bound.extend(b);
                }
                (ShadowColumn::Word { value, known }, ShadowColumn::Word { value: v, known: k }) => {
                    value.extend(v);
                    known.extend(k);
                }
                (ShadowColumn::Float { .. } | ShadowColumn::Word { .. }, _) => {}
            }
        }
    }
}
