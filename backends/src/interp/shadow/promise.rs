//! What a model promises, as the shadow lane takes it.

use super::Float;
use super::round::{above, absolute, largest_ulp, ulp};
use lobe_codegen::accuracy::{Accuracy, LERP, Model, Operation};
use lobe_codegen::intrinsics::Intrinsic;
use naga::BinaryOperator;

const REMAINDER: Operation = Operation::Infix(BinaryOperator::Modulo);

/// Of a quotient.
#[derive(Debug, Clone, Copy)]
pub(super) struct Quotient {
    /// Its error, in ULP.
    pub(super) ulps: f64,
    /// Magnitudes of the divisor for which that holds.
    pub(super) from: f64,
    pub(super) to: f64,
}

/// A model, with what is asked of it at every quotient and every root.
#[derive(Debug, Clone, Copy)]
pub(in crate::interp) struct Promise {
    model: &'static Model,
    pub(super) quotient: Quotient,
    /// Error of a square root, in ULP.
    pub(super) root: f64,
    /// Whether a remainder is promised.
    pub(super) remainder: bool,
    /// Whether `mix` may be by its other formula.
    pub(super) lerp: bool,
}

impl Promise {
    pub(in crate::interp) fn of(model: &'static Model) -> Self {
        let quotient = quotient(model);
        Self {
            model,
            quotient,
            root: root(model, quotient.ulps),
            remainder: !model.classes(REMAINDER).contains(&Accuracy::Nothing),
            lerp: model.builtin(Intrinsic::Mix).contains(&Accuracy::Inherited(LERP)),
        }
    }

    /// The classes of a built-in function; the worst one counts.
    pub(super) fn classes(&self, intrinsic: Intrinsic) -> &'static [Accuracy] {
        self.model.builtin(intrinsic)
    }

    /// Whether anything is promised of a built-in function.
    pub(super) fn holds(&self, intrinsic: Intrinsic) -> bool {
        !self.classes(intrinsic).contains(&Accuracy::Nothing)
    }
}

/// The quotient of a model that promises none has no divisors.
fn quotient(model: &Model) -> Quotient {
    let divide = model.classes(Operation::Infix(BinaryOperator::Divide));
    let known = |class: &Accuracy| match *class {
        Accuracy::UlpWhere { ulp, from, to } => Quotient { ulps: ulp, from, to },
        _ => Quotient { ulps: 0.0, from: f64::INFINITY, to: 0.0 },
    };
    let worse = |a: Quotient, b: Quotient| Quotient {
        ulps: a.ulps.max(b.ulps),
        from: a.from.max(b.from),
        to: a.to.min(b.to),
    };
    let any = Quotient { ulps: 0.0, from: 0.0, to: f64::INFINITY };
    divide.iter().map(known).fold(any, worse)
}

/// Of `1 / inverse_sqrt(x)`: `(1 + m u)(1 + n u) < 1 + (m + n + 0.0001) u`.
fn root(model: &Model, quotient: f64) -> f64 {
    let ulps = |classes: &[Accuracy]| {
        let ulps = classes.iter().map(|class| match *class {
            Accuracy::Exact | Accuracy::Correct => 1.0,
            Accuracy::Ulp(n) => n,
            _ => f64::INFINITY,
        });
        ulps.fold(0.0, f64::max)
    };
    let of = |class: &Accuracy| match class {
        Accuracy::Inherited(_) => ulps(model.builtin(Intrinsic::InverseSqrt)) + quotient + 0.0001,
        class => ulps(&[*class]),
    };
    model.builtin(Intrinsic::Sqrt).iter().map(of).fold(0.0, f64::max)
}

/// Widens the exact results for arguments of `low ..= high` by the worst of the classes that are numbers.
pub(super) fn widen(classes: &[Accuracy], argument: (f64, f64), results: (f64, f64)) -> Option<(f64, f64)> {
    if let [class] = classes {
        return widen_by(*class, argument, results);
    }
    let mut wide = results;
    for class in classes.iter().filter(|class| is_number(class)) {
        let (low, high) = widen_by(*class, argument, results)?;
        wide = (wide.0.min(low), wide.1.max(high));
    }
    Some(wide)
}

/// Whether a class is an error rather than a formula.
pub(super) fn is_number(class: &Accuracy) -> bool {
    !matches!(class, Accuracy::Inherited(_))
}

fn widen_by(accuracy: Accuracy, argument: (f64, f64), results: (f64, f64)) -> Option<(f64, f64)> {
    let size = argument.0.abs().max(argument.1.abs());
    Some(match accuracy {
        Accuracy::Exact | Accuracy::Correct => ulp(1.0, results),
        Accuracy::Ulp(n) | Accuracy::UlpWhere { ulp: n, .. } => ulp(n, results),
        Accuracy::UlpScaled { base, slope } => ulp(base + slope * size, results),
        Accuracy::UlpOrAbsolute { ulp: n, absolute: error, from, to } => {
            let apart = argument.1 < from || argument.0 > to;
            let within = argument.0 >= from && argument.1 <= to;
            let (a, b) = (absolute(error, results), ulp(n, results));
            match (apart, within) {
                (true, _) => b,
                (_, true) => a,
                (false, false) => (a.0.min(b.0), a.1.max(b.1)),
            }
        }
        Accuracy::Absolute(error) => absolute(error, results),
        Accuracy::AbsoluteOn { absolute: error, from, to } => {
            // The f32 nearest to an end is taken for it.
            let (from, to) = (from.min(f64::from(from as f32)), to.max(f64::from(to as f32)));
            if argument.0 < from || argument.1 > to {
                return None;
            }
            absolute(error, results)
        }
        Accuracy::Inherited(_) | Accuracy::Nothing => return None,
    })
}

/// The own error of a result, as [`widen`] has it; `None` where it is not of one size.
pub(super) fn own(classes: &[Accuracy], argument: (f64, f64), result: Float) -> Option<f64> {
    if let [class] = classes {
        return own_by(*class, argument, result);
    }
    let mut worst = 0.0_f64;
    for class in classes.iter().filter(|class| is_number(class)) {
        worst = worst.max(own_by(*class, argument, result)?);
    }
    Some(worst)
}

fn own_by(accuracy: Accuracy, argument: (f64, f64), result: Float) -> Option<f64> {
    let size = argument.0.abs().max(argument.1.abs());
    let ulps = |n: f64| largest_ulp(n, (result.low, result.high));
    match accuracy {
        Accuracy::Exact | Accuracy::Correct => Some(ulps(1.0)),
        Accuracy::Ulp(n) | Accuracy::UlpWhere { ulp: n, .. } => Some(ulps(n)),
        Accuracy::UlpScaled { base, slope } => Some(ulps(base + slope * size)),
        Accuracy::UlpOrAbsolute { ulp: n, absolute: error, from, to } => {
            let apart = argument.1 < from || argument.0 > to;
            let within = argument.0 >= from && argument.1 <= to;
            Some(match (apart, within) {
                (true, _) => ulps(n),
                (_, true) => above(error),
                (false, false) => ulps(n).max(above(error)),
            })
        }
        Accuracy::Absolute(error) | Accuracy::AbsoluteOn { absolute: error, .. } => Some(above(error)),
        Accuracy::Inherited(_) | Accuracy::Nothing => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Intrinsic as I;

    /// What the lane asks a model for; all else it takes for exact, correctly rounded, or a formula.
    const LOOKED_UP: [Operation; 22] = [
        Operation::Infix(BinaryOperator::Divide),
        REMAINDER,
        Operation::Builtin(I::Sqrt),
        Operation::Builtin(I::InverseSqrt),
        Operation::Builtin(I::Exp),
        Operation::Builtin(I::Exp2),
        Operation::Builtin(I::Log),
        Operation::Builtin(I::Log2),
        Operation::Builtin(I::Pow),
        Operation::Builtin(I::Sin),
        Operation::Builtin(I::Cos),
        Operation::Builtin(I::Tan),
        Operation::Builtin(I::Asin),
        Operation::Builtin(I::Acos),
        Operation::Builtin(I::Atan),
        Operation::Builtin(I::Atan2),
        Operation::Builtin(I::Sinh),
        Operation::Builtin(I::Cosh),
        Operation::Builtin(I::Tanh),
        Operation::Builtin(I::Asinh),
        Operation::Builtin(I::Acosh),
        Operation::Builtin(I::Atanh),
    ];

    #[test]
    fn what_the_lane_takes_for_granted_stands_in_every_table() {
        for model in Model::all() {
            for row in model.rows().iter().filter(|row| !LOOKED_UP.contains(&row.operation)) {
                let is_granted =
                    |c: &Accuracy| matches!(c, Accuracy::Exact | Accuracy::Correct | Accuracy::Inherited(_));
                assert!(row.f32.iter().all(is_granted), "{}: {}", model.name, row.operation);
            }
        }
    }

    #[test]
    fn a_root_costs_what_its_formula_does() {
        let root = |name| Promise::of(Model::named(name).expect("a model")).root;
        assert_eq!(["portable", "wgsl", "vulkan", "hlsl"].map(root), [4.5001, 4.5001, 4.5001, 1.0]);
    }
}
