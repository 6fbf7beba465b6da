//! Vulkan: core SPIR-V and GLSL.std.450.

use super::Accuracy::{AbsoluteOn, Correct, Exact, Inherited, Ulp, UlpOrAbsolute, UlpScaled, UlpWhere};
use super::class::{
    MAX_DIVISOR, MAX_DIVISOR_16, MIN_NORMAL, MIN_NORMAL_16, TWO_TO_MINUS_7, TWO_TO_MINUS_11, TWO_TO_MINUS_21,
};
use super::{Accuracy, Model, Operation, Rounding, Row, Rules, Subnormal};
use crate::intrinsics::Intrinsic;
use naga::BinaryOperator;
use std::f64::consts::PI;

pub(super) fn model() -> Model {
    Model::new("vulkan", "Vulkan, appendix Precision and Operation of SPIR-V Instructions", RULES, ROWS)
}

const RULES: Rules = Rules {
    subnormal: (Subnormal::MayFlush, FLUSHING),
    rounding: (Rounding::Either, "Vulkan, Correctly Rounded with Implementation-Defined Rounding Mode"),
    contraction: (true, "Vulkan, Evaluation of Expressions: unless decorated NoContraction"),
    reassociation: (true, "Vulkan, Evaluation of Expressions: unless decorated NoContraction (SPIR-V 3.20)"),
    double: (true, DOUBLE),
};

const FLUSHING: &str = "Vulkan, Precision and Operation of SPIR-V Instructions: unless DenormPreserve";
const DOUBLE: &str =
    "Vulkan, Precision and Operation of SPIR-V Instructions: double precision is at least single";
const CORE: &str = "Vulkan, Precision of Core SPIR-V Instructions";
const EXTENDED: &str = "Vulkan, Precision of GLSL.std.450 Instructions";
const CONVERSIONS: &str = "Vulkan, Precision of Core SPIR-V Instructions: conversions between types";
const MOVES: &str = "Vulkan, Precision and Operation of SPIR-V Instructions: OpTranspose moves data";

const LOG: Accuracy = UlpOrAbsolute { ulp: 3.0, absolute: TWO_TO_MINUS_21, from: 0.5, to: 2.0 };
const LOG_16: Accuracy = UlpOrAbsolute { ulp: 3.0, absolute: TWO_TO_MINUS_7, from: 0.5, to: 2.0 };
const WAVE: Accuracy = AbsoluteOn { absolute: TWO_TO_MINUS_11, from: -PI, to: PI };
const WAVE_16: Accuracy = AbsoluteOn { absolute: TWO_TO_MINUS_7, from: -PI, to: PI };

pub(super) const ROWS: &[Row] = &[
    Row::of(Operation::Negate, &[Exact], CORE),
    Row::of(Operation::FromInteger, &[Correct], CONVERSIONS),
    Row::of(Operation::Infix(BinaryOperator::Add), &[Correct], CORE),
    Row::of(Operation::Infix(BinaryOperator::Subtract), &[Correct], CORE),
    Row::of(Operation::Infix(BinaryOperator::Multiply), &[Correct], CORE),
    Row::each(
        Operation::Infix(BinaryOperator::Divide),
        &[UlpWhere { ulp: 2.5, from: MIN_NORMAL, to: MAX_DIVISOR }],
        &[UlpWhere { ulp: 2.5, from: MIN_NORMAL_16, to: MAX_DIVISOR_16 }],
        CORE,
    ),
    Row::of(Operation::Infix(BinaryOperator::Modulo), &[Inherited("x - y * trunc(x / y)")], CORE),
    Row::of(Operation::Infix(BinaryOperator::Equal), &[Exact], CORE),
    Row::of(Operation::Infix(BinaryOperator::NotEqual), &[Exact], CORE),
    Row::of(Operation::Infix(BinaryOperator::Less), &[Exact], CORE),
    Row::of(Operation::Infix(BinaryOperator::LessEqual), &[Exact], CORE),
    Row::of(Operation::Infix(BinaryOperator::Greater), &[Exact], CORE),
    Row::of(Operation::Infix(BinaryOperator::GreaterEqual), &[Exact], CORE),
    Row::of(Operation::Builtin(Intrinsic::Abs), &[Exact], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Min), &[Exact], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Max), &[Exact], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Clamp), &[Exact], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Sign), &[Exact], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Saturate), &[Exact], "Vulkan, fclamp: naga writes FClamp(x, 0, 1)"),
    Row::of(Operation::Builtin(Intrinsic::Ceil), &[Correct], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Floor), &[Correct], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Round), &[Correct], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Trunc), &[Correct], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Step), &[Correct], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Fract), &[Correct], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Transpose), &[Exact], MOVES),
    Row::of(Operation::Builtin(Intrinsic::Sqrt), &[Inherited("1.0 / inverse_sqrt(x)")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::InverseSqrt), &[Ulp(2.0)], EXTENDED),
    Row::each(
        Operation::Builtin(Intrinsic::Exp),
        &[UlpScaled { base: 3.0, slope: 2.0 }],
        &[UlpScaled { base: 1.0, slope: 2.0 }],
        EXTENDED,
    ),
    Row::each(
        Operation::Builtin(Intrinsic::Exp2),
        &[UlpScaled { base: 3.0, slope: 2.0 }],
        &[UlpScaled { base: 1.0, slope: 2.0 }],
        EXTENDED,
    ),
    Row::each(Operation::Builtin(Intrinsic::Log), &[LOG], &[LOG_16], EXTENDED),
    Row::each(Operation::Builtin(Intrinsic::Log2), &[LOG], &[LOG_16], EXTENDED),
    Row::each(Operation::Builtin(Intrinsic::Sin), &[WAVE], &[WAVE_16], EXTENDED),
    Row::each(Operation::Builtin(Intrinsic::Cos), &[WAVE], &[WAVE_16], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Asin), &[Inherited("atan2(x, sqrt(1.0 - x * x))")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Acos), &[Inherited("atan2(sqrt(1.0 - x * x), x)")], EXTENDED),
    Row::each(Operation::Builtin(Intrinsic::Atan), &[Ulp(4096.0)], &[Ulp(5.0)], EXTENDED),
    Row::each(Operation::Builtin(Intrinsic::Atan2), &[Ulp(4096.0)], &[Ulp(5.0)], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Tanh), &[Inherited("sinh(x) / cosh(x)")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Normalize), &[Inherited("x * inverse_sqrt(dot(x, x))")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Degrees), &[Inherited("x * 57.295779513082322865")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Radians), &[Inherited("x * 0.017453292519943295474")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Tan), &[Inherited("sin(x) / cos(x)")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Sinh), &[Inherited("(exp(x) - exp(-x)) * 0.5")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Cosh), &[Inherited("(exp(x) + exp(-x)) * 0.5")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Asinh), &[Inherited("log(x + sqrt(x * x + 1.0))")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Acosh), &[Inherited("log(x + sqrt(x * x - 1.0))")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Atanh), &[Inherited("log((1.0 + x) / (1.0 - x)) * 0.5")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Pow), &[Inherited("exp2(y * log2(x))")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Fma), &[Inherited("x * y + z")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Mix), &[Inherited("x * (1.0 - z) + y * z")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Dot), &[Inherited("x[0] * y[0] + x[1] * y[1] + ..")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Length), &[Inherited("sqrt(dot(x, x))")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Distance), &[Inherited("length(x - y)")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Cross), &[Inherited("x[i] * y[j] - x[j] * y[i]")], EXTENDED),
    Row::of(Operation::Builtin(Intrinsic::Reflect), &[Inherited("x - 2.0 * dot(x, y) * y")], EXTENDED),
    Row::of(
        Operation::Builtin(Intrinsic::FaceForward),
        &[Inherited("select(-x, x, dot(y, z) < 0.0)")],
        EXTENDED,
    ),
    Row::of(
        Operation::Builtin(Intrinsic::SmoothStep),
        &[Inherited("t * t * (3.0 - 2.0 * t), t = clamp((z - x) / (y - x), 0.0, 1.0)")],
        EXTENDED,
    ),
    Row::of(
        Operation::Builtin(Intrinsic::Refract),
        &[Inherited(
            "z * x - (z * dot(y, x) + sqrt(k)) * y, k = 1.0 - z * z * (1.0 - dot(y, x) * dot(y, x))",
        )],
        EXTENDED,
    ),
];
