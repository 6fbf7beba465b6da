//! Each operation alone: what it may return for the operands that the route itself had.

use super::ExplainError;
use super::reorder::Sums;
use super::value::{Place, Value};
use lobe_backends::interp::{Interpreter, ShadowColumn, ShadowColumns};
use lobe_codegen::ValidModule;
use lobe_codegen::data::Columns;
use lobe_codegen::trace::{Operation, Origin, operation};
use naga::{BinaryOperator, Expression};
use std::collections::hash_map::Entry;
use std::collections::{BTreeMap, HashMap};

/// A scalar of an operation's value, against what is permitted for its operands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Local {
    /// A float.
    Float {
        /// The route's.
        found: f32,
        /// In real numbers, of the route's operands.
        exact: f64,
        /// Largest permitted distance from it; infinite where nothing is promised.
        bound: f64,
    },
    /// An integer or a boolean.
    Word {
        /// The route's.
        found: u32,
        /// What it has to be.
        wanted: u32,
        /// Whether it has to be that.
        is_known: bool,
    },
}

impl Local {
    /// Whether the value is none of those permitted.
    #[must_use]
    pub fn breaks(self) -> bool {
        match self {
            Self::Float { found, exact, bound } => {
                bound.is_finite() && (found.is_nan() || (f64::from(found) - exact).abs() > bound)
            }
            Self::Word { found, wanted, is_known } => is_known && found != wanted,
        }
    }

    fn widen(&mut self, by: f64) {
        if let Self::Float { bound, .. } = self {
            *bound += by;
        }
    }

    /// The error of a float, as far as there is one.
    #[must_use]
    pub fn error(self) -> Option<f64> {
        match self {
            Self::Float { found, exact, .. } => Some(f64::from(found) - exact).filter(|e| e.is_finite()),
            Self::Word { .. } => None,
        }
    }
}

/// An operation that was executed and judged.
#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    /// Its place in the values.
    pub value: usize,
    /// Its operands' scalars.
    pub operands: Vec<Operands>,
    /// Its own scalars.
    pub scalars: Vec<Local>,
    /// Whether it is permitted only if a product and a sum were contracted.
    pub contracted: bool,
    /// Whether it is permitted only if the terms of a sum were taken in another order.
    pub reordered: bool,
}

/// What an operation read: the expression, and its scalars.
pub type Operands = (Place, Vec<u32>);

/// Judges every operation in `values`, in their order; what reads memory, and what calls return, is no operation.
///
/// # Errors
/// When an operation cannot be judged, which is a defect.
pub fn judge(module: &ValidModule, values: &[Value]) -> Result<Vec<Judged>, ExplainError> {
    let mut judged = BTreeMap::new();
    for group in groups(module, values)? {
        let rows = group.executions.iter().map(|(_, operands)| flat(operands)).collect::<Vec<_>>();
        let permitted = permitted(&group.operation, &rows, None)?;
        for (row, (value, operands)) in group.executions.into_iter().enumerate() {
            let scalars = scalars(&values[value], &permitted, row);
            judged.insert(value, Judged { value, operands, scalars, contracted: false, reordered: false });
        }
    }
    let products = products(module, values, &judged);
    for one in judged.values_mut().filter(|one| one.breaks()) {
        one.contract(module, values, &products)?;
    }
    let sums = Sums::new(module, values, &judged);
    judged.values_mut().filter(|one| one.breaks()).for_each(|one| one.reorder(&sums));
    Ok(judged.into_values().collect())
}

/// An operation with its executions.
struct Group {
    operation: Operation,
    executions: Vec<(usize, Vec<Operands>)>,
}

fn groups(module: &ValidModule, values: &[Value]) -> Result<Vec<Group>, ExplainError> {
    let mut groups: HashMap<Place, Option<Group>> = HashMap::new();
    let mut latest: HashMap<Place, &[u32]> = HashMap::new();
    for (index, value) in values.iter().enumerate() {
        let (function, expression) = value.place;
        if value.origin == Origin::Value {
            let group = match groups.entry(value.place) {
                Entry::Occupied(known) => known.into_mut(),
                Entry::Vacant(new) => {
                    let operation = operation(module, function, expression)?;
                    new.insert(operation.map(|operation| Group { operation, executions: Vec::new() }))
                }
            };
            if let Some(group) = group {
                // No function calls itself, so what was computed last was computed in this call.
                let operands = group.operation.operands.iter().map(|operand| {
                    let place = (function, operand.expression);
                    latest.get(&place).map(|bits| (place, bits.to_vec()))
                });
                if let Some(operands) = operands.collect() {
                    group.executions.push((index, operands));
                }
            }
        }
        latest.insert(value.place, &value.bits);
    }
    Ok(groups.into_values().flatten().collect())
}

fn flat(operands: &[Operands]) -> Vec<u32> {
    operands.iter().flat_map(|(_, bits)| bits.iter().copied()).collect()
}

/// What the operation permits on each row of operands, of which `exact` gives the real numbers.
fn permitted(
    operation: &Operation,
    rows: &[Vec<u32>],
    exact: Option<&[Vec<f64>]>,
) -> Result<ShadowColumns, ExplainError> {
    let width = operation.operands.iter().map(|o| o.width as usize).sum();
    let args = Columns::from_rows(width, rows);
    Ok(Interpreter::new(&operation.module)?.shadow(operation.function, &args, exact)?)
}

fn scalars(value: &Value, permitted: &ShadowColumns, row: usize) -> Vec<Local> {
    let scalars = value.bits.iter().zip(&permitted.columns);
    scalars.map(|(bits, column)| scalar(*bits, column, row)).collect()
}

/// A product of the trace.
struct Product {
    value: usize,
    bits: u32,
    /// Before it is rounded.
    exact: f64,
    /// What rounding may do to it.
    bound: f64,
}

fn products(module: &ValidModule, values: &[Value], judged: &BTreeMap<usize, Judged>) -> Vec<Product> {
    let is_product = |value: usize| {
        let (function, expression) = values[value].place;
        let expression = &module.module().functions[function].expressions[expression];
        matches!(expression, Expression::Binary { op: BinaryOperator::Multiply, .. })
    };
    let scalars = judged.values().filter(|one| is_product(one.value)).flat_map(|one| {
        one.scalars.iter().filter_map(|scalar| match *scalar {
            Local::Float { found, exact, bound } => {
                Some(Product { value: one.value, bits: found.to_bits(), exact, bound })
            }
            Local::Word { .. } => None,
        })
    });
    scalars.collect()
}

impl Judged {
    /// Whether some scalar is none of those permitted.
    #[must_use]
    pub fn breaks(&self) -> bool {
        self.scalars.iter().any(|scalar| scalar.breaks())
    }

    /// Judges again, with the terms of a sum in any order.
    fn reorder(&mut self, sums: &Sums<'_>) {
        let mut scalars = self.scalars.clone();
        for (component, scalar) in scalars.iter_mut().enumerate() {
            scalar.widen(sums.margin(self.value, component).unwrap_or(0.0));
        }
        if !scalars.iter().any(|scalar| scalar.breaks()) {
            (self.scalars, self.reordered) = (scalars, true);
        }
    }

    /// Judges again, with products among the operands as they are before they are rounded: a driver may contract them.
    /// A product is known by its bits, whatever way it came.
    fn contract(
        &mut self,
        module: &ValidModule,
        values: &[Value],
        products: &[Product],
    ) -> Result<(), ExplainError> {
        const SIGN: u32 = 1 << 31;
        let (function, expression) = values[self.value].place;
        let Some(operation) = operation(module, function, expression)? else { return Ok(()) };
        let row = flat(&self.operands);
        let product = |bits: &u32| {
            let mut before = products.iter().rev().filter(|p| p.value < self.value);
            before.find(|p| p.bits & !SIGN == bits & !SIGN)
        };
        let exact = row.iter().map(|bits| match product(bits) {
            Some(product) if product.bits == *bits => vec![product.exact],
            Some(product) => vec![-product.exact],
            None => vec![f64::from(f32::from_bits(*bits))],
        });
        let exact: Vec<Vec<f64>> = exact.collect();
        // A sum with 0 rounds nothing more, so the rounding that it does is that of the product.
        let late: f64 = row.iter().filter_map(product).map(|p| p.bound).sum();
        let permitted = permitted(&operation, &[row], Some(&exact))?;
        let mut scalars = scalars(&values[self.value], &permitted, 0);
        scalars.iter_mut().for_each(|scalar| scalar.widen(late));
        if !scalars.iter().any(|scalar| scalar.breaks()) {
            *self = Self { scalars, contracted: true, operands: std::mem::take(&mut self.operands), ..*self };
        }
        Ok(())
    }
}

fn scalar(bits: u32, column: &ShadowColumn, row: usize) -> Local {
    match column {
        ShadowColumn::Float { exact, bound, .. } => {
            Local::Float { found: f32::from_bits(bits), exact: exact[row], bound: bound[row] }
        }
        ShadowColumn::Word { value, known } => {
            Local::Word { found: bits, wanted: value[row], is_known: known[row] }
        }
    }
}
