//! Operations on floats: each is one of the model's.

use super::super::model::Model;
use super::super::program::op::{Comparison, FloatOp};
use super::super::program::{Op, Scalar, Value};
use super::column::Column;
use super::{MISMATCH, Machine, Res};

impl<M: Model> Machine<'_, M> {
    pub(super) fn float(&self, op: FloatOp, args: &[Value], to: &mut Column<M>) -> Res<()> {
        use FloatOp as O;
        match op {
            O::Add => self.two(args, to, M::add),
            O::Sub => self.two(args, to, M::sub),
            O::Mul => self.two(args, to, M::mul),
            O::Div => self.two(args, to, M::div),
            O::Rem => self.two(args, to, M::rem),
            O::Neg => self.one(args, to, M::neg),
            O::Square => self.one(args, to, M::square),
            O::Nonnegative => self.one(args, to, M::nonnegative),
            O::Abs => self.one(args, to, M::abs),
            O::Min => self.two(args, to, M::min),
            O::Max => self.two(args, to, M::max),
            O::Sign => self.one(args, to, M::sign),
            O::Ceil => self.one(args, to, M::ceil),
            O::Floor => self.one(args, to, M::floor),
            O::Round => self.one(args, to, M::round),
            O::Trunc => self.one(args, to, M::trunc),
            O::Fract => self.one(args, to, M::fract),
            O::Step => self.two(args, to, M::step),
            O::Clamp => self.three(args, to, M::clamp),
            O::Saturate => self.one(args, to, M::saturate),
            O::Sqrt => self.one(args, to, M::sqrt),
            O::InverseSqrt => self.one(args, to, M::inverse_sqrt),
            O::Exp => self.one(args, to, M::exp),
            O::Exp2 => self.one(args, to, M::exp2),
            O::Log => self.one(args, to, M::log),
            O::Log2 => self.one(args, to, M::log2),
            O::Pow => self.two(args, to, M::pow),
            O::Sin => self.one(args, to, M::sin),
            O::Cos => self.one(args, to, M::cos),
            O::Tan => self.one(args, to, M::tan),
            O::Asin => self.one(args, to, M::asin),
            O::Acos => self.one(args, to, M::acos),
            O::Atan => self.one(args, to, M::atan),
            O::Atan2 => self.two(args, to, M::atan2),
            O::Sinh => self.one(args, to, M::sinh),
            O::Cosh => self.one(args, to, M::cosh),
            O::Tanh => self.one(args, to, M::tanh),
            O::Asinh => self.one(args, to, M::asinh),
            O::Acosh => self.one(args, to, M::acosh),
            O::Atanh => self.one(args, to, M::atanh),
            O::Degrees => self.one(args, to, M::degrees),
            O::Radians => self.one(args, to, M::radians),
            O::Fma => self.three(args, to, M::fma),
            O::Mix => self.three(args, to, M::mix),
            O::SmoothStep => self.three(args, to, M::smoothstep),
            O::Significand => self.by_bits(Op::Float(Scalar::F32, op), args, to),
        }
    }

    pub(super) fn one(&self, args: &[Value], to: &mut Column<M>, f: impl Fn(&M, M::F) -> M::F) -> Res<()> {
        let &[a] = args else { return Err(MISMATCH) };
        let a = self.floats(a)?;
        self.each_float(to, |m, lane| f(m, a.at(lane)))
    }

    fn two(&self, args: &[Value], to: &mut Column<M>, f: impl Fn(&M, M::F, M::F) -> M::F) -> Res<()> {
        let &[a, b] = args else { return Err(MISMATCH) };
        let (a, b) = (self.floats(a)?, self.floats(b)?);
        self.each_float(to, |m, lane| f(m, a.at(lane), b.at(lane)))
    }

    fn three(&self, args: &[Value], to: &mut Column<M>, f: impl Fn(&M, M::F, M::F, M::F) -> M::F) -> Res<()> {
        let &[a, b, c] = args else { return Err(MISMATCH) };
        let (a, b, c) = (self.floats(a)?, self.floats(b)?, self.floats(c)?);
        self.each_float(to, |m, lane| f(m, a.at(lane), b.at(lane), c.at(lane)))
    }

    /// A comparison of floats.
    pub(super) fn compare_floats(
        &self,
        comparison: Comparison,
        args: &[Value],
        to: &mut Column<M>,
    ) -> Res<()> {
        let &[a, b] = args else { return Err(MISMATCH) };
        let (a, b) = (self.floats(a)?, self.floats(b)?);
        match comparison {
            Comparison::Equal => self.each_bool(to, |m, l| m.equal(a.at(l), b.at(l))),
            Comparison::NotEqual => self.each_bool(to, |m, l| m.not(m.equal(a.at(l), b.at(l)))),
            Comparison::Less => self.each_bool(to, |m, l| m.less(a.at(l), b.at(l))),
            Comparison::LessEqual => self.each_bool(to, |m, l| m.less_equal(a.at(l), b.at(l))),
        }
    }

    /// A question about a float.
    pub(super) fn test(&self, args: &[Value], to: &mut Column<M>, f: impl Fn(&M, M::F) -> M::B) -> Res<()> {
        let &[a] = args else { return Err(MISMATCH) };
        let a = self.floats(a)?;
        self.each_bool(to, |m, lane| f(m, a.at(lane)))
    }
}
