//! Operations on floats: each is one of the model's.

use super::super::model::Model;
use super::super::program::Value;
use super::super::program::op::{Comparison, FloatOp};
use super::column::Column;
use super::{MISMATCH, Machine, Res};

/// A model of the same lanes, for floats of some width.
pub(super) trait Like<M: Model>: Model<F = M::F, W = M::W, B = M::B> {}

impl<M: Model, N: Model<F = M::F, W = M::W, B = M::B>> Like<M> for N {}

impl<M: Model> Machine<'_, M> {
    /// An operation of `m`, the model for the width of the operands.
    pub(super) fn float<N: Like<M>>(
        &self,
        m: &N,
        op: FloatOp,
        args: &[Value],
        to: &mut Column<M>,
    ) -> Res<()> {
        use FloatOp as O;
        match op {
            O::Add => self.two(args, to, |a, b| m.add(a, b)),
            O::Sub => self.two(args, to, |a, b| m.sub(a, b)),
            O::Mul => self.two(args, to, |a, b| m.mul(a, b)),
            O::Div => self.two(args, to, |a, b| m.div(a, b)),
            O::Rem => self.two(args, to, |a, b| m.rem(a, b)),
            O::Neg => self.one(args, to, |a| m.neg(a)),
            O::Square => self.one(args, to, |a| m.square(a)),
            O::Nonnegative => self.one(args, to, |a| m.nonnegative(a)),
            O::Abs => self.one(args, to, |a| m.abs(a)),
            O::Min => self.two(args, to, |a, b| m.min(a, b)),
            O::Max => self.two(args, to, |a, b| m.max(a, b)),
            O::Sign => self.one(args, to, |a| m.sign(a)),
            O::Ceil => self.one(args, to, |a| m.ceil(a)),
            O::Floor => self.one(args, to, |a| m.floor(a)),
            O::Round => self.one(args, to, |a| m.round(a)),
            O::Trunc => self.one(args, to, |a| m.trunc(a)),
            O::Fract => self.one(args, to, |a| m.fract(a)),
            O::Step => self.two(args, to, |a, b| m.step(a, b)),
            O::Clamp => self.three(args, to, |a, b, c| m.clamp(a, b, c)),
            O::Saturate => self.one(args, to, |a| m.saturate(a)),
            O::Sqrt => self.one(args, to, |a| m.sqrt(a)),
            O::InverseSqrt => self.one(args, to, |a| m.inverse_sqrt(a)),
            O::Exp => self.one(args, to, |a| m.exp(a)),
            O::Exp2 => self.one(args, to, |a| m.exp2(a)),
            O::Log => self.one(args, to, |a| m.log(a)),
            O::Log2 => self.one(args, to, |a| m.log2(a)),
            O::Pow => self.two(args, to, |a, b| m.pow(a, b)),
            O::Sin => self.one(args, to, |a| m.sin(a)),
            O::Cos => self.one(args, to, |a| m.cos(a)),
            O::Tan => self.one(args, to, |a| m.tan(a)),
            O::Asin => self.one(args, to, |a| m.asin(a)),
            O::Acos => self.one(args, to, |a| m.acos(a)),
            O::Atan => self.one(args, to, |a| m.atan(a)),
            O::Atan2 => self.two(args, to, |a, b| m.atan2(a, b)),
            O::Sinh => self.one(args, to, |a| m.sinh(a)),
            O::Cosh => self.one(args, to, |a| m.cosh(a)),
            O::Tanh => self.one(args, to, |a| m.tanh(a)),
            O::Asinh => self.one(args, to, |a| m.asinh(a)),
            O::Acosh => self.one(args, to, |a| m.acosh(a)),
            O::Atanh => self.one(args, to, |a| m.atanh(a)),
            O::Degrees => self.one(args, to, |a| m.degrees(a)),
            O::Radians => self.one(args, to, |a| m.radians(a)),
            O::Length => self.one(args, to, |a| m.length(a)),
            O::Fma => self.three(args, to, |a, b, c| m.fma(a, b, c)),
            O::Mix => self.three(args, to, |a, b, c| m.mix(a, b, c)),
            O::SmoothStep => self.three(args, to, |a, b, c| m.smoothstep(a, b, c)),
            O::Significand => Err(MISMATCH),
        }
    }

    pub(super) fn one(&self, args: &[Value], to: &mut Column<M>, f: impl Fn(M::F) -> M::F) -> Res<()> {
        let &[a] = args else { return Err(MISMATCH) };
        let a = self.floats(a)?;
        self.each_float(to, |_, lane| f(a.at(lane)))
    }

    fn two(&self, args: &[Value], to: &mut Column<M>, f: impl Fn(M::F, M::F) -> M::F) -> Res<()> {
        let &[a, b] = args else { return Err(MISMATCH) };
        let (a, b) = (self.floats(a)?, self.floats(b)?);
        self.each_float(to, |_, lane| f(a.at(lane), b.at(lane)))
    }

    fn three(&self, args: &[Value], to: &mut Column<M>, f: impl Fn(M::F, M::F, M::F) -> M::F) -> Res<()> {
        let &[a, b, c] = args else { return Err(MISMATCH) };
        let (a, b, c) = (self.floats(a)?, self.floats(b)?, self.floats(c)?);
        self.each_float(to, |_, lane| f(a.at(lane), b.at(lane), c.at(lane)))
    }

    /// A comparison of floats by `m`, the model for their width.
    pub(super) fn compare_floats<N: Like<M>>(
        &self,
        m: &N,
        comparison: Comparison,
        args: &[Value],
        to: &mut Column<M>,
    ) -> Res<()> {
        let &[a, b] = args else { return Err(MISMATCH) };
        let (a, b) = (self.floats(a)?, self.floats(b)?);
        match comparison {
            Comparison::Equal => self.each_bool(to, |_, l| m.equal(a.at(l), b.at(l))),
            Comparison::NotEqual => self.each_bool(to, |_, l| m.not(m.equal(a.at(l), b.at(l)))),
            Comparison::Less => self.each_bool(to, |_, l| m.less(a.at(l), b.at(l))),
            Comparison::LessEqual => self.each_bool(to, |_, l| m.less_equal(a.at(l), b.at(l))),
        }
    }

    /// A question about a float.
    pub(super) fn test(&self, args: &[Value], to: &mut Column<M>, f: impl Fn(&M, M::F) -> M::B) -> Res<()> {
        let &[a] = args else { return Err(MISMATCH) };
        let a = self.floats(a)?;
        self.each_bool(to, |m, lane| f(m, a.at(lane)))
    }
}
