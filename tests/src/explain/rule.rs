//! The accuracy rule of an expression, in words.

use lobe_codegen::intrinsics::{Accuracy, math_row, operator_accuracy};
use naga::Expression;

/// What the specification permits of `expression` on floats.
#[must_use]
pub fn rule(expression: &Expression) -> String {
    match expression {
        Expression::Math { fun, .. } => math_row(*fun).map_or_else(String::new, |row| told(row.accuracy)),
        Expression::Binary { op, .. } => told(operator_accuracy(*op)),
        _ => told(Accuracy::Exact),
    }
}

fn told(accuracy: Accuracy) -> String {
    match accuracy {
        Accuracy::Exact => "exact".to_owned(),
        Accuracy::Correct => "correctly rounded".to_owned(),
        Accuracy::Ulp(ulp) => format!("{ulp} ULP"),
        Accuracy::UlpScaled { base, slope } => format!("{base} + {slope} |x| ULP"),
        Accuracy::UlpOrAbsolute { ulp, absolute, from, to } => {
            format!("{} absolute where x is in {from} ..= {to}, {ulp} ULP elsewhere", power(absolute))
        }
        Accuracy::AbsoluteOn { absolute, from, to } => {
            format!("{} absolute where x is in {from:.4} ..= {to:.4}, nothing elsewhere", power(absolute))
        }
        Accuracy::Inherited(formula) => format!("as accurate as {formula}"),
        Accuracy::InheritedOrAbsolute(formula, absolute) => {
            format!("as accurate as {formula}, or {} absolute", power(absolute))
        }
    }
}

/// A power of two as one.
fn power(x: f64) -> String {
    let exponent = x.log2();
    if exponent.fract() == 0.0 { format!("2^{exponent}") } else { format!("{x:e}") }
}
