//! WGSL.

use super::Accuracy::{
    Absolute, AbsoluteOn, Correct, Exact, Inherited, Ulp, UlpOrAbsolute, UlpScaled, UlpWhere,
};
use super::class::{
    MAX_DIVISOR, MAX_DIVISOR_16, MIN_NORMAL, MIN_NORMAL_16, TWO_TO_MINUS_7, TWO_TO_MINUS_11, TWO_TO_MINUS_21,
};
use super::{Accuracy, Model, Operation, Rounding, Row, Rules, Subnormal};
use crate::intrinsics::Intrinsic;
use naga::BinaryOperator;
use std::f64::consts::PI;

pub(super) fn model() -> Model {
    Model::new("wgsl", "WebGPU Shading Language", RULES, ROWS)
}

const RULES: Rules = Rules {
    subnormal: (Subnormal::MayFlush, "WGSL 15.7.2, Differences from IEEE-754"),
    rounding: (Rounding::Either, "WGSL 15.7.4, Floating Point Accuracy: correctly rounded"),
    contraction: (true, "WGSL 15.7.5, Reassociation and Fusion"),
    reassociation: (true, "WGSL 15.7.5, Reassociation and Fusion"),
    double: (false, "WGSL 15.7.1 has no f64"),
};

const OPERATIONS: &str = "WGSL 15.7.4.1, Accuracy of concrete floating point operations";
const FUNCTIONS: &str = "WGSL 15.7.4.1, Accuracy of concrete floating point built-in functions";
const CONVERSIONS: &str = "WGSL 15.7.6, Floating Point Conversion";

const LOG: Accuracy = UlpOrAbsolute { ulp: 3.0, absolute: TWO_TO_MINUS_21, from: 0.5, to: 2.0 };
const LOG_16: Accuracy = UlpOrAbsolute { ulp: 3.0, absolute: TWO_TO_MINUS_7, from: 0.5, to: 2.0 };
const WAVE: Accuracy = AbsoluteOn { absolute: TWO_TO_MINUS_11, from: -PI, to: PI };
const WAVE_16: Accuracy = AbsoluteOn { absolute: TWO_TO_MINUS_7, from: -PI, to: PI };

/// `atan2` is promised for normal `y` only, a division for such `|y|` only.
pub(super) const ROWS: &[Row] = &[
    Row::of(Operation::Negate, &[Correct], OPERATIONS),
    Row::of(Operation::FromInteger, &[Correct], CONVERSIONS),
    Row::of(Operation::Infix(BinaryOperator::Add), &[Correct], OPERATIONS),
    Row::of(Operation::Infix(BinaryOperator::Subtract), &[Correct], OPERATIONS),
    Row::of(Operation::Infix(BinaryOperator::Multiply), &[Correct], OPERATIONS),
    Row::each(
        Operation::Infix(BinaryOperator::Divide),
        &[UlpWhere { ulp: 2.5, from: MIN_NORMAL, to: MAX_DIVISOR }],
        &[UlpWhere { ulp: 2.5, from: MIN_NORMAL_16, to: MAX_DIVISOR_16 }],
        OPERATIONS,
    ),
    Row::of(Operation::Infix(BinaryOperator::Modulo), &[Inherited("x - y * trunc(x / y)")], OPERATIONS),
    Row::of(Operation::Infix(BinaryOperator::Equal), &[Exact], OPERATIONS),
    Row::of(Operation::Infix(BinaryOperator::NotEqual), &[Exact], OPERATIONS),
    Row::of(Operation::Infix(BinaryOperator::Less), &[Exact], OPERATIONS),
    Row::of(Operation::Infix(BinaryOperator::LessEqual), &[Exact], OPERATIONS),
    Row::of(Operation::Infix(BinaryOperator::Greater), &[Exact], OPERATIONS),
    Row::of(Operation::Infix(BinaryOperator::GreaterEqual), &[Exact], OPERATIONS),
    Row::of(Operation::Builtin(Intrinsic::Abs), &[Correct], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Min), &[Correct], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Max), &[Correct], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Clamp), &[Correct], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Sign), &[Correct], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Saturate), &[Correct], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Ceil), &[Correct], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Floor), &[Correct], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Round), &[Correct], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Trunc), &[Correct], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Step), &[Correct], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Fract), &[Inherited("x - floor(x)")], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Transpose), &[Correct], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Sqrt), &[Inherited("1.0 / inverse_sqrt(x)")], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::InverseSqrt), &[Ulp(2.0)], FUNCTIONS),
    Row::each(
        Operation::Builtin(Intrinsic::Exp),
        &[UlpScaled { base: 3.0, slope: 2.0 }],
        &[UlpScaled { base: 1.0, slope: 2.0 }],
        FUNCTIONS,
    ),
    Row::each(
        Operation::Builtin(Intrinsic::Exp2),
        &[UlpScaled { base: 3.0, slope: 2.0 }],
        &[UlpScaled { base: 1.0, slope: 2.0 }],
        FUNCTIONS,
    ),
    Row::each(Operation::Builtin(Intrinsic::Log), &[LOG], &[LOG_16], FUNCTIONS),
    Row::each(Operation::Builtin(Intrinsic::Log2), &[LOG], &[LOG_16], FUNCTIONS),
    Row::each(Operation::Builtin(Intrinsic::Sin), &[WAVE], &[WAVE_16], FUNCTIONS),
    Row::each(Operation::Builtin(Intrinsic::Cos), &[WAVE], &[WAVE_16], FUNCTIONS),
    Row::each(
        Operation::Builtin(Intrinsic::Asin),
        &[Absolute(6.81e-5), Inherited("atan2(x, sqrt(1.0 - x * x))")],
        &[Absolute(3.91e-3), Inherited("atan2(x, sqrt(1.0 - x * x))")],
        FUNCTIONS,
    ),
    Row::each(
        Operation::Builtin(Intrinsic::Acos),
        &[Absolute(6.77e-5), Inherited("atan2(sqrt(1.0 - x * x), x)")],
        &[Absolute(3.91e-3), Inherited("atan2(sqrt(1.0 - x * x), x)")],
        FUNCTIONS,
    ),
    Row::each(Operation::Builtin(Intrinsic::Atan), &[Ulp(4096.0)], &[Ulp(5.0)], FUNCTIONS),
    Row::each(
        Operation::Builtin(Intrinsic::Atan2),
        &[UlpWhere { ulp: 4096.0, from: MIN_NORMAL, to: MAX_DIVISOR }],
        &[UlpWhere { ulp: 5.0, from: MIN_NORMAL_16, to: MAX_DIVISOR_16 }],
        FUNCTIONS,
    ),
    Row::of(
        Operation::Builtin(Intrinsic::Tanh),
        &[Absolute(1e-5), Inherited("sinh(x) / cosh(x)")],
        FUNCTIONS,
    ),
    Row::of(Operation::Builtin(Intrinsic::Normalize), &[Inherited("x / length(x)")], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Degrees), &[Inherited("x * 57.295779513082322865")], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Radians), &[Inherited("x * 0.017453292519943295474")], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Tan), &[Inherited("sin(x) / cos(x)")], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Sinh), &[Inherited("(exp(x) - exp(-x)) * 0.5")], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Cosh), &[Inherited("(exp(x) + exp(-x)) * 0.5")], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Asinh), &[Inherited("log(x + sqrt(x * x + 1.0))")], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Acosh), &[Inherited("log(x + sqrt(x * x - 1.0))")], FUNCTIONS),
    Row::of(
        Operation::Builtin(Intrinsic::Atanh),
        &[Inherited("log((1.0 + x) / (1.0 - x)) * 0.5")],
        FUNCTIONS,
    ),
    Row::of(Operation::Builtin(Intrinsic::Pow), &[Inherited("exp2(y * log2(x))")], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Fma), &[Inherited("x * y + z")], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Mix), &[Inherited("x * (1.0 - z) + y * z")], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Dot), &[Inherited("x[0] * y[0] + x[1] * y[1] + ..")], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Length), &[Inherited("sqrt(dot(x, x))")], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Distance), &[Inherited("length(x - y)")], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Cross), &[Inherited("x[i] * y[j] - x[j] * y[i]")], FUNCTIONS),
    Row::of(Operation::Builtin(Intrinsic::Reflect), &[Inherited("x - 2.0 * dot(x, y) * y")], FUNCTIONS),
    Row::of(
        Operation::Builtin(Intrinsic::FaceForward),
        &[Inherited("select(-x, x, dot(y, z) < 0.0)")],
        FUNCTIONS,
    ),
    Row::of(
        Operation::Builtin(Intrinsic::SmoothStep),
        &[Inherited("t * t * (3.0 - 2.0 * t), t = clamp((z - x) / (y - x), 0.0, 1.0)")],
        FUNCTIONS,
    ),
    Row::of(
        Operation::Builtin(Intrinsic::Refract),
        &[Inherited(
            "z * x - (z * dot(y, x) + sqrt(k)) * y, k = 1.0 - z * z * (1.0 - dot(y, x) * dot(y, x))",
        )],
        FUNCTIONS,
    ),
];
