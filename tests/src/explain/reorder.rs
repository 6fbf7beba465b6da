//! Sums whose terms a driver may have taken in another order.

use super::local::{Judged, Operands};
use super::value::Value;
use lobe_codegen::ValidModule;
use naga::{BinaryOperator, Expression, MathFunction};
use std::collections::BTreeMap;

const SIGN: u32 = 1 << 31;

/// Numbers that are added: how many, and their magnitudes added up.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Terms {
    count: usize,
    size: f64,
}

impl Terms {
    fn of(numbers: impl IntoIterator<Item = f64>) -> Self {
        numbers
            .into_iter()
            .fold(Self { count: 0, size: 0.0 }, |all, x| all.and(Self { count: 1, size: x.abs() }))
    }

    fn and(self, b: Self) -> Self {
        Self { count: self.count + b.count, size: self.size + b.size }
    }
}

/// The sums of a trace.
pub(super) struct Sums<'a> {
    module: &'a ValidModule,
    values: &'a [Value],
    operands: BTreeMap<usize, Vec<Operands>>,
}

impl<'a> Sums<'a> {
    pub(super) fn new(
        module: &'a ValidModule,
        values: &'a [Value],
        judged: &BTreeMap<usize, Judged>,
    ) -> Self {
        let operands = judged.iter().map(|(value, one)| (*value, one.operands.clone()));
        Self { module, values, operands: operands.collect() }
    }

    /// How far from what is permitted of it alone a component of a sum may be, if its terms are taken in another order;
    /// `None` where it has no more than two.
    pub(super) fn margin(&self, value: usize, component: usize) -> Option<f64> {
        let terms = self.terms_of(value, component)?;
        // Once for the sum, once for the one that was taken for its operand, and once for the products.
        let margin = 3.0 * terms.count as f64 * terms.size * f64::from(f32::EPSILON);
        (terms.count > 2).then_some(margin)
    }

    /// The terms of a component of a value that is a sum.
    fn terms_of(&self, value: usize, component: usize) -> Option<Terms> {
        let operands = self.operands.get(&value)?;
        let bits = |operand: usize, component: usize| -> Option<u32> {
            let (_, bits) = operands.get(operand)?;
            bits.get(if bits.len() == 1 { 0 } else { component }).copied()
        };
        let float = |operand, component| bits(operand, component).map(|bits| f64::from(f32::from_bits(bits)));
        let (function, expression) = self.values[value].place;
        match self.module.module().functions[function].expressions[expression] {
            Expression::Binary { op: BinaryOperator::Add | BinaryOperator::Subtract, left, right } => {
                let read = |side| operands.iter().position(|(place, _)| *place == (function, side));
                let side = |side| match read(side) {
                    Some(operand) => Some(self.terms(bits(operand, component)?, value)),
                    // A constant is what is left of the sum.
                    None => {
                        let sum = self.values[value].bits.get(component).copied().map(f32::from_bits)?;
                        Some(Terms::of([f64::from(sum).abs() + float(0, component)?.abs()]))
                    }
                };
                Some(side(left)?.and(side(right)?))
            }
            Expression::Math { fun: MathFunction::Dot, .. } => {
                let width = operands.first()?.1.len();
                let product = |i| Some(float(0, i)? * float(1, i).or(float(0, i))?);
                (0..width).map(product).collect::<Option<Vec<_>>>().map(Terms::of)
            }
            Expression::Math { fun: MathFunction::Fma, .. } => {
                let product = float(0, component)? * float(1, component)?;
                Some(Terms::of([product]).and(self.terms(bits(2, component)?, value)))
            }
            Expression::Math { fun: MathFunction::Mix, .. } => {
                let [x, y, t] = [float(0, component)?, float(1, component)?, float(2, component)?];
                Some(Terms::of([x, x * t, y * t]))
            }
            _ => None,
        }
    }

    /// What a number is to a sum at `before`: a sum is known by its bits, whatever way it came.
    fn terms(&self, bits: u32, before: usize) -> Terms {
        let same = |found: &u32| found & !SIGN == bits & !SIGN;
        let sums = self.operands.range(..before).rev().filter_map(|(value, _)| {
            let component = self.values[*value].bits.iter().position(same)?;
            self.terms_of(*value, component)
        });
        sums.into_iter().next().unwrap_or_else(|| Terms::of([f64::from(f32::from_bits(bits))]))
    }
}
