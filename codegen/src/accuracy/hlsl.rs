//! HLSL, by the rules of Direct3D.
//!
//! Direct3D speaks of instructions. A function of HLSL that is none is what it is built of, where its definition is one
//! formula of arithmetic, and else no promise.

use super::Accuracy::{AbsoluteOn, Correct, Exact, Inherited, Nothing, Ulp, UlpOrAbsolute, UlpWhere};
use super::class::{LERP, MAX_DIVISOR, MIN_NORMAL, TWO_TO_MINUS_21};
use super::{Accuracy, Model, Operation, Rounding, Row, Rules, Subnormal};
use crate::intrinsics::Intrinsic;
use naga::BinaryOperator;
use std::f64::consts::PI;

pub(super) fn model() -> Model {
    Model::new("hlsl", "HLSL, Direct3D 11.3 Functional Specification", RULES, ROWS)
}

const RULES: Rules = Rules {
    subnormal: (Subnormal::Flushed, "D3D11.3 3.1.3.2, Deviations or Additional Requirements vs. IEEE-754"),
    rounding: (Rounding::Nearest, "D3D11.3 3.1.3.1, Honored IEEE-754 Rules: within 0.5 ULP"),
    contraction: (true, "D3D11.3 3.1.3.2: fused operations; 22.19.2, unless declared precise"),
    reassociation: (true, "D3D11.3 22.19.2, Precise: unless declared so"),
    double: (false, "D3D11.3 3.1.3 is of 32 bits"),
};

const BASIC: &str = "D3D11.3 3.1.3.1: within 0.5 ULP; 3.1.5 for f16";
const DIVIDE: &str = "D3D11.3 3.1.3.2: x * (1 / y), 1 ULP and 0.5 ULP; 22.10.2 for divisors above 2^126";
const BUILT: &str = "HLSL Reference: by its definition, no instruction of its own in D3D11.3 22.10";
const WRITTEN: &str = "no function of HLSL: naga writes the formula";
const UNKNOWN: &str = "HLSL Reference: no accuracy; no instruction of its own in D3D11.3 22.10";

/// A relative error of `2^-21`, in ULP.
const RELATIVE: f64 = TWO_TO_MINUS_21 * 8_388_608.0;
/// A reciprocal within 1 ULP, then a product within 0.5 ULP: `(1 + u)(1 + u / 2) = 1 + 1.5 u + u² / 2`, `u = 2^-23`.
const TWO_STEPS: f64 = 1.5 + 0.5 / 8_388_608.0;
const LOG: Accuracy = UlpOrAbsolute { ulp: RELATIVE, absolute: TWO_TO_MINUS_21, from: 0.5, to: 2.0 };
const WAVE: Accuracy = AbsoluteOn { absolute: 0.0008, from: -100.0 * PI, to: 100.0 * PI };

pub(super) const ROWS: &[Row] = &[
    Row::of(Operation::Negate, &[Exact], "D3D11.3 22.18.2, negate"),
    Row::each(Operation::FromInteger, &[Correct], &[Nothing], "D3D11.3 22.13.5 and 22.13.6, itof and utof"),
    Row::of(Operation::Infix(BinaryOperator::Add), &[Correct], BASIC),
    Row::of(Operation::Infix(BinaryOperator::Subtract), &[Correct], BASIC),
    Row::of(Operation::Infix(BinaryOperator::Multiply), &[Correct], BASIC),
    Row::each(
        Operation::Infix(BinaryOperator::Divide),
        &[UlpWhere { ulp: TWO_STEPS, from: MIN_NORMAL, to: MAX_DIVISOR }],
        &[Nothing],
        DIVIDE,
    ),
    Row::of(Operation::Infix(BinaryOperator::Modulo), &[Nothing], "HLSL Reference, fmod: no accuracy"),
    Row::of(
        Operation::Infix(BinaryOperator::Equal),
        &[Exact],
        "D3D11.3 3.1.3.1, Honored IEEE-754 Rules: comparisons",
    ),
    Row::of(
        Operation::Infix(BinaryOperator::NotEqual),
        &[Exact],
        "D3D11.3 3.1.3.1, Honored IEEE-754 Rules: comparisons",
    ),
    Row::of(
        Operation::Infix(BinaryOperator::Less),
        &[Exact],
        "D3D11.3 3.1.3.1, Honored IEEE-754 Rules: comparisons",
    ),
    Row::of(
        Operation::Infix(BinaryOperator::LessEqual),
        &[Exact],
        "D3D11.3 3.1.3.1, Honored IEEE-754 Rules: comparisons",
    ),
    Row::of(
        Operation::Infix(BinaryOperator::Greater),
        &[Exact],
        "D3D11.3 3.1.3.1, Honored IEEE-754 Rules: comparisons",
    ),
    Row::of(
        Operation::Infix(BinaryOperator::GreaterEqual),
        &[Exact],
        "D3D11.3 3.1.3.1, Honored IEEE-754 Rules: comparisons",
    ),
    Row::of(Operation::Builtin(Intrinsic::Abs), &[Exact], "D3D11.3 22.18.1, _abs"),
    Row::of(Operation::Builtin(Intrinsic::Min), &[Exact], "D3D11.3 22.10.11, min"),
    Row::of(Operation::Builtin(Intrinsic::Max), &[Exact], "D3D11.3 22.10.10, max"),
    Row::of(Operation::Builtin(Intrinsic::Clamp), &[Exact], "D3D11.3 22.10.10 and 22.10.11, max and min"),
    Row::of(Operation::Builtin(Intrinsic::Saturate), &[Exact], "D3D11.3 22.19.1, _sat"),
    Row::of(Operation::Builtin(Intrinsic::Sign), &[Exact], BUILT),
    Row::of(Operation::Builtin(Intrinsic::Step), &[Exact], BUILT),
    Row::of(Operation::Builtin(Intrinsic::Ceil), &[Exact], "D3D11.3 22.10.16, round_pi"),
    Row::of(Operation::Builtin(Intrinsic::Floor), &[Exact], "D3D11.3 22.10.15, round_ni"),
    Row::of(Operation::Builtin(Intrinsic::Round), &[Exact], "D3D11.3 22.10.14, round_ne"),
    Row::of(Operation::Builtin(Intrinsic::Trunc), &[Exact], "D3D11.3 22.10.17, round_z"),
    Row::of(Operation::Builtin(Intrinsic::Fract), &[Inherited("x - floor(x)")], "D3D11.3 22.10.7, frc"),
    Row::of(Operation::Builtin(Intrinsic::Transpose), &[Exact], "D3D11.3 3.1.3.2: moves alter no data"),
    Row::each(
        Operation::Builtin(Intrinsic::Sqrt),
        &[Ulp(1.0)],
        &[Correct],
        "D3D11.3 22.10.21, sqrt; 3.1.5 for f16",
    ),
    Row::each(
        Operation::Builtin(Intrinsic::InverseSqrt),
        &[Ulp(RELATIVE)],
        &[Nothing],
        "D3D11.3 22.10.19, rsq: relative error 2^-21",
    ),
    Row::each(
        Operation::Builtin(Intrinsic::Exp2),
        &[Ulp(RELATIVE)],
        &[Nothing],
        "D3D11.3 22.10.6, exp: relative error 2^-21",
    ),
    Row::each(
        Operation::Builtin(Intrinsic::Exp),
        &[Inherited("exp2(x * 1.4426950408889634)")],
        &[Nothing],
        BUILT,
    ),
    Row::each(
        Operation::Builtin(Intrinsic::Log2),
        &[LOG],
        &[Nothing],
        "D3D11.3 22.10.8, log: relative error 2^-21, absolute 2^-21 on 0.5 ..= 2",
    ),
    Row::each(
        Operation::Builtin(Intrinsic::Log),
        &[Inherited("log2(x) * 0.6931471805599453")],
        &[Nothing],
        BUILT,
    ),
    Row::each(Operation::Builtin(Intrinsic::Pow), &[Inherited("exp2(y * log2(x))")], &[Nothing], BUILT),
    Row::each(Operation::Builtin(Intrinsic::Sin), &[WAVE], &[Nothing], "D3D11.3 22.10.20, sincos"),
    Row::each(Operation::Builtin(Intrinsic::Cos), &[WAVE], &[Nothing], "D3D11.3 22.10.20, sincos"),
    Row::of(Operation::Builtin(Intrinsic::Tan), &[Nothing], UNKNOWN),
    Row::of(Operation::Builtin(Intrinsic::Asin), &[Nothing], UNKNOWN),
    Row::of(Operation::Builtin(Intrinsic::Acos), &[Nothing], UNKNOWN),
    Row::of(Operation::Builtin(Intrinsic::Atan), &[Nothing], UNKNOWN),
    Row::of(Operation::Builtin(Intrinsic::Atan2), &[Nothing], UNKNOWN),
    Row::of(Operation::Builtin(Intrinsic::Sinh), &[Nothing], UNKNOWN),
    Row::of(Operation::Builtin(Intrinsic::Cosh), &[Nothing], UNKNOWN),
    Row::of(Operation::Builtin(Intrinsic::Tanh), &[Nothing], UNKNOWN),
    Row::each(
        Operation::Builtin(Intrinsic::Asinh),
        &[Inherited("log(x + sqrt(x * x + 1.0))")],
        &[Nothing],
        WRITTEN,
    ),
    Row::each(
        Operation::Builtin(Intrinsic::Acosh),
        &[Inherited("log(x + sqrt(x * x - 1.0))")],
        &[Nothing],
        WRITTEN,
    ),
    Row::each(
        Operation::Builtin(Intrinsic::Atanh),
        &[Inherited("log((1.0 + x) / (1.0 - x)) * 0.5")],
        &[Nothing],
        WRITTEN,
    ),
    Row::of(
        Operation::Builtin(Intrinsic::Fma),
        &[Inherited("x * y + z")],
        "D3D11.3 3.1.3.2: mad is no less accurate than the worst serial order",
    ),
    Row::of(
        Operation::Builtin(Intrinsic::Dot),
        &[Inherited("x[0] * y[0] + x[1] * y[1] + ..")],
        "D3D11.3 3.1.3.2: dp3 is no less accurate than the worst serial order",
    ),
    Row::of(
        Operation::Builtin(Intrinsic::Mix),
        &[Inherited("x * (1.0 - z) + y * z"), Inherited(LERP)],
        "HLSL Reference, lerp: either formula",
    ),
    Row::of(Operation::Builtin(Intrinsic::Degrees), &[Inherited("x * 57.295779513082322865")], BUILT),
    Row::of(Operation::Builtin(Intrinsic::Radians), &[Inherited("x * 0.017453292519943295474")], BUILT),
    Row::each(Operation::Builtin(Intrinsic::Length), &[Inherited("sqrt(dot(x, x))")], &[Nothing], BUILT),
    Row::each(Operation::Builtin(Intrinsic::Distance), &[Inherited("length(x - y)")], &[Nothing], BUILT),
    Row::of(Operation::Builtin(Intrinsic::Cross), &[Inherited("x[i] * y[j] - x[j] * y[i]")], BUILT),
    Row::of(Operation::Builtin(Intrinsic::Reflect), &[Inherited("x - 2.0 * dot(x, y) * y")], BUILT),
    Row::of(
        Operation::Builtin(Intrinsic::FaceForward),
        &[Inherited("select(-x, x, dot(y, z) < 0.0)")],
        BUILT,
    ),
    Row::each(
        Operation::Builtin(Intrinsic::Normalize),
        &[Inherited("x / length(x)")],
        &[Nothing],
        "HLSL Reference, normalize",
    ),
    Row::each(
        Operation::Builtin(Intrinsic::SmoothStep),
        &[Inherited("t * t * (3.0 - 2.0 * t), t = clamp((z - x) / (y - x), 0.0, 1.0)")],
        &[Nothing],
        BUILT,
    ),
    Row::each(
        Operation::Builtin(Intrinsic::Refract),
        &[Inherited(
            "z * x - (z * dot(y, x) + sqrt(k)) * y, k = 1.0 - z * z * (1.0 - dot(y, x) * dot(y, x))",
        )],
        &[Nothing],
        BUILT,
    ),
];
