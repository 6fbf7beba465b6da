//! What a model promises, as the shadow lane takes it.

use super::Float;
use super::round::{above, absolute, largest_ulp, ulp};
use crate::interp::precision::Precision;
use lobe_codegen::accuracy::{Accuracy, LERP, Model, Operation, Width};
use lobe_codegen::intrinsics::Intrinsic;
use naga::BinaryOperator;

const DIVIDE: Operation = Operation::Infix(BinaryOperator::Divide);
const REMAINDER: Operation = Operation::Infix(BinaryOperator::Modulo);

/// What the lane asks a model for; all else it takes for exact, correctly rounded, or a formula.
const LOOKED_UP: [Operation; 22] = [
    DIVIDE,
    REMAINDER,
    Operation::Builtin(Intrinsic::Sqrt),
    Operation::Builtin(Intrinsic::InverseSqrt),
    Operation::Builtin(Intrinsic::Exp),
    Operation::Builtin(Intrinsic::Exp2),
    Operation::Builtin(Intrinsic::Log),
    Operation::Builtin(Intrinsic::Log2),
    Operation::Builtin(Intrinsic::Pow),
    Operation::Builtin(Intrinsic::Sin),
    Operation::Builtin(Intrinsic::Cos),
    Operation::Builtin(Intrinsic::Tan),
    Operation::Builtin(Intrinsic::Asin),
    Operation::Builtin(Intrinsic::Acos),
    Operation::Builtin(Intrinsic::Atan),
    Operation::Builtin(Intrinsic::Atan2),
    Operation::Builtin(Intrinsic::Sinh),
    Operation::Builtin(Intrinsic::Cosh),
    Operation::Builtin(Intrinsic::Tanh),
    Operation::Builtin(Intrinsic::Asinh),
    Operation::Builtin(Intrinsic::Acosh),
    Operation::Builtin(Intrinsic::Atanh),
];

/// What it takes for granted.
fn granted() -> impl Iterator<Item = Operation> {
    Operation::all().filter(|operation| !LOOKED_UP.contains(operation))
}

fn is_granted(class: &Accuracy) -> bool {
    matches!(class, Accuracy::Exact | Accuracy::Correct | Accuracy::Inherited(_))
}

/// Of a quotient.
#[derive(Debug, Clone, Copy)]
pub(super) struct Quotient {
    /// Its error, in ULP.
    pub(super) ulps: f64,
    /// Magnitudes of the divisor for which that holds.
    pub(super) from: f64,
    pub(super) to: f64,
}

/// What a model promises of floats of each width.
#[derive(Debug, Clone, Copy)]
pub(in crate::interp) struct Promises {
    pub(super) half: Promise,
    pub(super) single: Promise,
    pub(super) double: Promise,
}

impl Promises {
    pub(in crate::interp) fn of(model: &'static Model) -> Self {
        let [half, single, double] =
            [Width::Half, Width::Single, Width::Double].map(|w| Promise::of(model, w));
        Self { half, single, double }
    }
}

/// A model and a width, with what is asked of them at every quotient and every root.
#[derive(Debug, Clone, Copy)]
pub(super) struct Promise {
    model: &'static Model,
    width: Width,
    /// Whether the model promises what is taken for granted: that most operations are exact, correctly rounded, or
    /// as a formula has it. Without that no number has a bound.
    pub(super) holds: bool,
    pub(super) quotient: Quotient,
    /// Error of a square root, in ULP.
    pub(super) root: f64,
    /// Whether a remainder is promised.
    pub(super) remainder: bool,
    /// Whether the terms of a sum may be taken in any order.
    pub(super) reassociation: bool,
    /// Whether `mix` may be by its other formula.
    pub(super) lerp: bool,
}

impl Promise {
    fn of(model: &'static Model, width: Width) -> Self {
        let of = |operation| model.classes_of(operation, width);
        let quotient = quotient(of(DIVIDE));
        Self {
            model,
            width,
            holds: granted().all(|operation| of(operation).iter().all(is_granted)),
            quotient,
            root: root(&of, quotient.ulps, width),
            remainder: !of(REMAINDER).contains(&Accuracy::Nothing),
            reassociation: model.rules.reassociation.0,
            lerp: of(Operation::Builtin(Intrinsic::Mix)).contains(&Accuracy::Inherited(LERP)),
        }
    }

    /// The classes of a built-in function; the worst one counts.
    pub(super) fn classes(&self, intrinsic: Intrinsic) -> &'static [Accuracy] {
        self.model.classes_of(Operation::Builtin(intrinsic), self.width)
    }

    /// Whether anything is promised of a built-in function.
    pub(super) fn has(&self, intrinsic: Intrinsic) -> bool {
        !self.classes(intrinsic).contains(&Accuracy::Nothing)
    }
}

/// The quotient of a model that promises none has no divisors.
fn quotient(divide: &[Accuracy]) -> Quotient {
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

/// Of `1 / inverse_sqrt(x)`: `(1 + m u)(1 + n u) = 1 + (m + n + m n u) u`, where `m n u` is below 0.0001 for f32, and
/// below 0.01 for f16.
fn root(of: &dyn Fn(Operation) -> &'static [Accuracy], quotient: f64, width: Width) -> f64 {
    let second_order = if width == Width::Half { 0.01 } else { 0.0001 };
    let ulps = |classes: &[Accuracy]| {
        let ulps = classes.iter().map(|class| match *class {
            Accuracy::Exact | Accuracy::Correct => 1.0,
            Accuracy::Ulp(n) => n,
            _ => f64::INFINITY,
        });
        ulps.fold(0.0, f64::max)
    };
    let all = |class: &Accuracy| match class {
        Accuracy::Inherited(_) => {
            ulps(of(Operation::Builtin(Intrinsic::InverseSqrt))) + quotient + second_order
        }
        class => ulps(&[*class]),
    };
    of(Operation::Builtin(Intrinsic::Sqrt)).iter().map(all).fold(0.0, f64::max)
}

/// Widens the exact results for arguments of `low ..= high` by the worst of the classes that are numbers.
pub(super) fn widen<P: Precision>(
    classes: &[Accuracy],
    argument: (f64, f64),
    results: (f64, f64),
) -> Option<(f64, f64)> {
    if let [class] = classes {
        return widen_by::<P>(*class, argument, results);
    }
    let mut wide = results;
    for class in classes.iter().filter(|class| is_number(class)) {
        let (low, high) = widen_by::<P>(*class, argument, results)?;
        wide = (wide.0.min(low), wide.1.max(high));
    }
    Some(wide)
}

/// Whether a class is an error rather than a formula.
pub(super) fn is_number(class: &Accuracy) -> bool {
    !matches!(class, Accuracy::Inherited(_))
}

fn widen_by<P: Precision>(
    accuracy: Accuracy,
    argument: (f64, f64),
    results: (f64, f64),
) -> Option<(f64, f64)> {
    let size = argument.0.abs().max(argument.1.abs());
    Some(match accuracy {
        Accuracy::Exact | Accuracy::Correct => ulp::<P>(1.0, results),
        Accuracy::Ulp(n) | Accuracy::UlpWhere { ulp: n, .. } => ulp::<P>(n, results),
        Accuracy::UlpScaled { base, slope } => ulp::<P>(base + slope * size, results),
        Accuracy::UlpOrAbsolute { ulp: n, absolute: error, from, to } => {
            let apart = argument.1 < from || argument.0 > to;
            let within = argument.0 >= from && argument.1 <= to;
            let (a, b) = (absolute(error, results), ulp::<P>(n, results));
            match (apart, within) {
                (true, _) => b,
                (_, true) => a,
                (false, false) => (a.0.min(b.0), a.1.max(b.1)),
            }
        }
        Accuracy::Absolute(error) => absolute(error, results),
        Accuracy::AbsoluteOn { absolute: error, from, to } => {
            // The number nearest to an end is taken for it.
            let (from, to) = (from.min(P::nearest(from)), to.max(P::nearest(to)));
            if argument.0 < from || argument.1 > to {
                return None;
            }
            absolute(error, results)
        }
        Accuracy::Inherited(_) | Accuracy::Nothing => return None,
    })
}

/// The own error of a result, as [`widen`] has it; `None` where it is not of one size.
pub(super) fn own<P: Precision>(classes: &[Accuracy], argument: (f64, f64), result: Float) -> Option<f64> {
    if let [class] = classes {
        return own_by::<P>(*class, argument, result);
    }
    let mut worst = 0.0_f64;
    for class in classes.iter().filter(|class| is_number(class)) {
        worst = worst.max(own_by::<P>(*class, argument, result)?);
    }
    Some(worst)
}

fn own_by<P: Precision>(accuracy: Accuracy, argument: (f64, f64), result: Float) -> Option<f64> {
    let size = argument.0.abs().max(argument.1.abs());
    let ulps = |n: f64| largest_ulp::<P>(n, (result.low, result.high));
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

    #[test]
    fn what_the_lane_takes_for_granted_stands_in_every_table() {
        for model in Model::all() {
            for operation in granted() {
                assert!(model.classes(operation).iter().all(is_granted), "{}: {operation}", model.name);
            }
        }
    }

    #[test]
    fn other_widths_have_promises_where_their_tables_do() {
        let held = |name| {
            let promises = Promises::of(Model::named(name).expect("a model"));
            [promises.half, promises.single, promises.double].map(|p| p.holds)
        };
        assert_eq!(held("portable"), [true; 3]);
        assert_eq!(held("vulkan"), [true; 3]);
        assert_eq!(held("wgsl"), [true, true, false]);
        assert_eq!(held("hlsl"), [false, true, false]);
    }

    #[test]
    fn a_root_costs_what_its_formula_does() {
        let root = |name| Promises::of(Model::named(name).expect("a model")).single.root;
        assert_eq!(["portable", "wgsl", "vulkan", "hlsl"].map(root), [4.5001, 4.5001, 4.5001, 1.0]);
    }
}
