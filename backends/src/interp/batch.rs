//! Rows in, rows out.

use super::error::{InterpError, Res};
use super::exec::{Machine, Value};
use super::layout::{Kind, Pointee, Types};
use super::leaf::Leaf;
use super::mask::Mask;
use super::model::Model;
use super::shadow::{Float, Shadow};
use super::{ShadowColumn, ShadowColumns};
use lobe_codegen::ValidModule;
use lobe_codegen::data::Columns;
use lobe_codegen::module::Scope;
use naga::{Function, Handle};
use std::ops::Range;

/// A function with its arguments.
pub(super) struct Signature<'a> {
    function: Handle<Function>,
    /// Kinds of each parameter's scalars.
    parameters: Vec<Vec<Kind>>,
    /// Kinds of the result's scalars.
    pub(super) results: Vec<Kind>,
    args: &'a Columns,
    exact: Option<&'a [Vec<f64>]>,
}

impl<'a> Signature<'a> {
    pub(super) fn of(
        module: &ValidModule,
        function: Handle<Function>,
        args: &'a Columns,
        exact: Option<&'a [Vec<f64>]>,
    ) -> Res<Self> {
        let types = Types(&module.module().types);
        let definition = &module.module().functions[function];
        let name = || definition.name.clone().unwrap_or_default();
        let kinds = |ty| types.kinds(Pointee::Type(ty));
        let parameters = definition.arguments.iter().map(|a| kinds(a.ty)).collect::<Res<Vec<_>>>()?;
        let expected = parameters.iter().map(Vec::len).sum();
        if args.width() != expected || args.columns.iter().any(|c| c.len() != args.rows) {
            return Err(InterpError::Arguments { function: name(), expected, found: args.width() });
        }
        if exact.is_some_and(|e| e.len() != expected || e.iter().any(|c| c.len() != args.rows)) {
            return Err(InterpError::ExactColumns { function: name(), expected });
        }
        let results = definition.result.as_ref().map_or(Ok(Vec::new()), |r| kinds(r.ty))?;
        Ok(Self { function, parameters, results, args, exact })
    }

    /// The arguments of some rows.
    fn values<M: Model>(&self, m: &M, rows: &Range<usize>) -> Vec<Value<M>> {
        let mut column = 0..;
        let mut leaf = |kind: &Kind| {
            let index = column.next().unwrap_or(0);
            let words = &self.args.columns[index][rows.clone()];
            match (kind, self.exact) {
                (Kind::F32, Some(exact)) => {
                    let pairs = words.iter().zip(&exact[index][rows.clone()]);
                    Leaf::from_floats(pairs.map(|(w, e)| m.float(f32::from_bits(*w), *e)).collect())
                }
                (Kind::F32 | Kind::I32 | Kind::U32 | Kind::Bool, _) => {
                    Leaf::from_value_bits(m, *kind, words.iter().copied())
                }
            }
        };
        self.parameters.iter().map(|kinds| Value::data(kinds.iter().map(&mut leaf).collect())).collect()
    }
}

/// The ranges of rows that are computed together, `lanes` at a time.
pub(super) fn chunks(rows: usize, lanes: usize) -> Vec<Range<usize>> {
    (0..rows).step_by(lanes).map(|start| start..rows.min(start + lanes)).collect()
}

/// Some rows of a call.
pub(super) struct Batch<'m, 'a, M: Model> {
    module: &'m ValidModule,
    model: M,
    fuel: u64,
    signature: &'a Signature<'a>,
}

impl<'m, 'a, M: Model> Batch<'m, 'a, M> {
    pub(super) fn new(module: &'m ValidModule, model: M, fuel: u64, signature: &'a Signature<'a>) -> Self {
        Self { module, model, fuel, signature }
    }

    fn execute(self, rows: Range<usize>) -> Res<(Machine<'m, M>, Vec<Leaf<M>>)> {
        let lanes = rows.len();
        let mut machine = Machine::new(self.module, self.model, lanes, self.fuel)?;
        let arguments = self.signature.values(&machine.model, &rows);
        let scope = Scope::Function(self.signature.function);
        let result = machine.invoke(scope, arguments, Mask::all(lanes))?;
        Ok((machine, result))
    }

    /// The results' words.
    pub(super) fn words(self, rows: Range<usize>) -> Res<Columns> {
        let count = rows.len();
        let (machine, result) = self.execute(rows)?;
        let columns = result.iter().map(|leaf| leaf.value_bits(&machine.model)).collect();
        Ok(Columns { columns, rows: count })
    }
}

impl Batch<'_, '_, Shadow> {
    /// The results with their bounds.
    pub(super) fn shadow(self, rows: Range<usize>) -> Res<ShadowColumns> {
        let count = rows.len();
        let (machine, result) = self.execute(rows)?;
        let flags = &machine.flags;
        let columns: Vec<_> = result.iter().map(|leaf| column(&machine.model, leaf, &flags.lost)).collect();
        let unbounded = |row: usize| columns.iter().any(|c| !holds(c, row));
        let indeterminate =
            (0..count).map(|row| flags.lost[row] || (flags.tainted[row] && unbounded(row))).collect();
        Ok(ShadowColumns { rows: count, ambiguous: flags.ambiguous.clone(), indeterminate, columns })
    }
}

fn column(shadow: &Shadow, leaf: &Leaf<Shadow>, lost: &[bool]) -> ShadowColumn {
    match leaf {
        Leaf::Float(lanes) => ShadowColumn::Float {
            value: lanes.iter().map(|a| a.value).collect(),
            exact: lanes.iter().map(|a| a.exact).collect(),
            bound: bounds(shadow, lanes, lost),
        },
        Leaf::Word(lanes) => ShadowColumn::Word {
            value: lanes.iter().map(|a| a.value).collect(),
            known: lanes.iter().zip(lost).map(|(a, lost)| a.known && !lost).collect(),
        },
        Leaf::Bool(lanes) => ShadowColumn::Word {
            value: lanes.iter().map(|a| a.value.into()).collect(),
            known: lanes.iter().zip(lost).map(|(a, lost)| !a.ambiguous && !lost).collect(),
        },
    }
}

fn bounds(shadow: &Shadow, lanes: &[Float], lost: &[bool]) -> Vec<f64> {
    lanes.iter().zip(lost).map(|(a, lost)| if *lost { f64::INFINITY } else { shadow.bound(*a) }).collect()
}

/// Whether something is promised.
fn holds(column: &ShadowColumn, row: usize) -> bool {
    match column {
        ShadowColumn::Float { bound, .. } => bound[row].is_finite(),
        ShadowColumn::Word { known, .. } => known[row],
    }
}

/// Columns of these kinds without rows.
pub(super) fn no_rows(kinds: &[Kind]) -> ShadowColumns {
    let empty = |kind: &Kind| match kind {
        Kind::F32 => ShadowColumn::Float { value: Vec::new(), exact: Vec::new(), bound: Vec::new() },
        Kind::I32 | Kind::U32 | Kind::Bool => ShadowColumn::Word { value: Vec::new(), known: Vec::new() },
    };
    ShadowColumns { columns: kinds.iter().map(empty).collect(), ..ShadowColumns::default() }
}

/// Appends rows of the same kinds.
pub(super) fn append(to: &mut ShadowColumns, from: ShadowColumns) {
    to.rows += from.rows;
    to.ambiguous.extend(from.ambiguous);
    to.indeterminate.extend(from.indeterminate);
    for pair in to.columns.iter_mut().zip(from.columns) {
        match pair {
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
