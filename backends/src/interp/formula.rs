//! The formulas from which composite operations inherit their accuracy, term by term as the tables of
//! [`lobe_codegen::accuracy`] state them.
//!
//! A model that has nothing better takes its operations from here; the shadow lane takes its bounds from
//! here and its exact values from f64 functions.

use super::model::Model;

pub(super) fn clamp<M: Model>(m: &M, x: M::F, low: M::F, high: M::F) -> M::F {
    m.min(m.max(x, low), high)
}

pub(super) fn saturate<M: Model>(m: &M, x: M::F) -> M::F {
    clamp(m, x, m.constant(0.0), m.constant(1.0))
}

pub(super) fn exp<M: Model>(m: &M, x: M::F) -> M::F {
    m.exp2(m.mul(x, m.constant(std::f64::consts::LOG2_E)))
}

pub(super) fn log<M: Model>(m: &M, x: M::F) -> M::F {
    m.mul(m.log2(x), m.constant(std::f64::consts::LN_2))
}

pub(super) fn pow<M: Model>(m: &M, x: M::F, y: M::F) -> M::F {
    m.exp2(m.mul(y, m.log2(x)))
}

pub(super) fn tan<M: Model>(m: &M, x: M::F) -> M::F {
    m.div(m.sin(x), m.cos(x))
}

/// `sqrt(1 - x * x)`
fn co<M: Model>(m: &M, x: M::F) -> M::F {
    m.sqrt(m.sub(m.constant(1.0), m.square(x)))
}

pub(super) fn asin<M: Model>(m: &M, x: M::F) -> M::F {
    m.atan2(x, co(m, x))
}

pub(super) fn acos<M: Model>(m: &M, x: M::F) -> M::F {
    m.atan2(co(m, x), x)
}

pub(super) fn sinh<M: Model>(m: &M, x: M::F) -> M::F {
    m.mul(m.sub(m.exp(x), m.exp(m.neg(x))), m.constant(0.5))
}

pub(super) fn cosh<M: Model>(m: &M, x: M::F) -> M::F {
    m.mul(m.add(m.exp(x), m.exp(m.neg(x))), m.constant(0.5))
}

pub(super) fn tanh<M: Model>(m: &M, x: M::F) -> M::F {
    m.div(sinh(m, x), cosh(m, x))
}

pub(super) fn asinh<M: Model>(m: &M, x: M::F) -> M::F {
    m.log(m.add(x, m.sqrt(m.add(m.square(x), m.constant(1.0)))))
}

pub(super) fn acosh<M: Model>(m: &M, x: M::F) -> M::F {
    m.log(m.add(x, m.sqrt(m.sub(m.square(x), m.constant(1.0)))))
}

pub(super) fn atanh<M: Model>(m: &M, x: M::F) -> M::F {
    let one = m.constant(1.0);
    m.mul(m.log(m.div(m.add(one, x), m.sub(one, x))), m.constant(0.5))
}

pub(super) fn degrees<M: Model>(m: &M, x: M::F) -> M::F {
    m.mul(x, m.constant(57.295779513082322865))
}

pub(super) fn radians<M: Model>(m: &M, x: M::F) -> M::F {
    m.mul(x, m.constant(0.017453292519943295474))
}

/// Of a number. Its magnitude is permitted too.
pub(super) fn length<M: Model>(m: &M, x: M::F) -> M::F {
    m.sqrt(m.square(x))
}

pub(super) fn fma<M: Model>(m: &M, x: M::F, y: M::F, z: M::F) -> M::F {
    m.add(m.mul(x, y), z)
}

pub(super) fn mix<M: Model>(m: &M, x: M::F, y: M::F, t: M::F) -> M::F {
    m.add(m.mul(x, m.sub(m.constant(1.0), t)), m.mul(y, t))
}

/// The other formula of `mix`; see [`lobe_codegen::accuracy::LERP`].
pub(super) fn lerp<M: Model>(m: &M, x: M::F, y: M::F, t: M::F) -> M::F {
    m.add(x, m.mul(t, m.sub(y, x)))
}

pub(super) fn smoothstep<M: Model>(m: &M, low: M::F, high: M::F, x: M::F) -> M::F {
    let t = saturate(m, m.div(m.sub(x, low), m.sub(high, low)));
    m.mul(m.mul(t, t), m.sub(m.constant(3.0), m.mul(m.constant(2.0), t)))
}
