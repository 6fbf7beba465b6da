//! The accuracy rule of an expression, in words.

use lobe_codegen::accuracy::{Model, Operation};
use lobe_codegen::intrinsics::math_row;
use naga::{Expression, UnaryOperator};

/// What holds for `expression` on floats by every specification that drivers are held to, and where they say so.
#[must_use]
pub fn rule(expression: &Expression) -> String {
    let operation = match expression {
        Expression::Math { fun, .. } => math_row(*fun).map(|row| Operation::Builtin(row.intrinsic)),
        Expression::Binary { op, .. } => Some(Operation::Infix(*op)),
        Expression::Unary { op: UnaryOperator::Negate, .. } => Some(Operation::Negate),
        _ => None,
    };
    match operation.and_then(|operation| Model::portable().row(operation)) {
        Some(row) => {
            let classes: Vec<String> = row.f32.iter().map(ToString::to_string).collect();
            format!("{} ({})", classes.join(" or "), row.section)
        }
        None => EXACT.to_owned(),
    }
}

/// The rule of what computes with integers and booleans, and of what moves numbers.
pub(super) const EXACT: &str = "exact";
