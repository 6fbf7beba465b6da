//! Functions of whole vectors, composed of scalar operations in the written order.

use super::super::error::Res;
use super::super::program::op::{Comparison, FloatOp, IntOp};
use super::super::program::{Op, Scalar, Value};
use super::{Lowerer, malformed};

impl Lowerer<'_> {
    pub(crate) fn mul(&mut self, a: Value, b: Value) -> Value {
        self.b.float_op(FloatOp::Mul, &[a, b])
    }

    pub(crate) fn add(&mut self, a: Value, b: Value) -> Value {
        self.b.float_op(FloatOp::Add, &[a, b])
    }

    pub(crate) fn sub(&mut self, a: Value, b: Value) -> Value {
        self.b.float_op(FloatOp::Sub, &[a, b])
    }

    /// `x[0] * y[0] + x[1] * y[1] + ..`
    pub(crate) fn dot(&mut self, x: &[Value], y: &[Value]) -> Res<Value> {
        self.sum_of_products(x, y, Self::mul, Self::add)
    }

    /// The same on integers, wrapping.
    pub(crate) fn dot_words(&mut self, x: &[Value], y: &[Value]) -> Res<Value> {
        self.sum_of_products(
            x,
            y,
            |this, a, b| this.b.int_op(IntOp::Mul, &[a, b]),
            |this, a, b| this.b.int_op(IntOp::Add, &[a, b]),
        )
    }

    fn sum_of_products(
        &mut self,
        x: &[Value],
        y: &[Value],
        mul: impl Fn(&mut Self, Value, Value) -> Value,
        add: impl Fn(&mut Self, Value, Value) -> Value,
    ) -> Res<Value> {
        let mut sum = None;
        for (x, y) in x.iter().zip(y) {
            let product = mul(self, *x, *y);
            sum = Some(match sum {
                Some(sum) => add(self, sum, product),
                None => product,
            });
        }
        sum.ok_or(malformed("a vector without components"))
    }

    /// `sqrt(dot(x, x))`; of a scalar, its magnitude.
    pub(crate) fn length(&mut self, x: &[Value]) -> Res<Value> {
        match x {
            [x] => Ok(self.b.float_op(FloatOp::Length, &[*x])),
            x => {
                let squared = self.dot(x, x)?;
                Ok(self.b.float_op(FloatOp::Sqrt, &[squared]))
            }
        }
    }

    /// `length(x - y)`
    pub(crate) fn distance(&mut self, x: &[Value], y: &[Value]) -> Res<Value> {
        let difference = self.pairs(x, y, Self::sub);
        self.length(&difference)
    }

    /// `x / length(x)`
    pub(crate) fn normalize(&mut self, x: &[Value]) -> Res<Vec<Value>> {
        let length = self.length(x)?;
        Ok(x.iter().map(|x| self.b.float_op(FloatOp::Div, &[*x, length])).collect())
    }

    /// `x[i] * y[j] - x[j] * y[i]`
    pub(crate) fn cross(&mut self, x: &[Value], y: &[Value]) -> Res<Vec<Value>> {
        let ([x0, x1, x2], [y0, y1, y2]) = (x, y) else {
            return Err(malformed("a cross product is of three components"));
        };
        let mut part = |a, b, c, d| {
            let (left, right) = (self.mul(a, b), self.mul(c, d));
            self.sub(left, right)
        };
        Ok(vec![part(*x1, *y2, *x2, *y1), part(*x2, *y0, *x0, *y2), part(*x0, *y1, *x1, *y0)])
    }

    /// `x - y * (2 * dot(y, x))`
    pub(crate) fn reflect(&mut self, x: &[Value], y: &[Value]) -> Res<Vec<Value>> {
        let dot = self.dot(y, x)?;
        let two = self.constant_like(dot, 2.0);
        let twice = self.mul(two, dot);
        let mirrored = |(x, y): (&Value, &Value)| {
            let along = self.mul(*y, twice);
            self.sub(*x, along)
        };
        Ok(x.iter().zip(y).map(mirrored).collect())
    }

    /// `x * eta - y * (eta * d + sqrt(k))`, `k = 1 - eta * eta * (1 - d * d)`, `d = dot(y, x)`; zero where `k < 0`.
    pub(crate) fn refract(&mut self, x: &[Value], y: &[Value], eta: Value) -> Res<Vec<Value>> {
        let d = self.dot(y, x)?;
        let (zero, one) = (self.constant_like(d, 0.0), self.constant_like(d, 1.0));
        let cosine2 = self.mul(d, d);
        let sine2 = self.sub(one, cosine2);
        let eta2 = self.mul(eta, eta);
        let bent2 = self.mul(eta2, sine2);
        let k = self.sub(one, bent2);
        let inside = self.less(k, zero);
        // The root counts only where `k` is not negative.
        let positive = self.b.float_op(FloatOp::Nonnegative, &[k]);
        let root = self.b.float_op(FloatOp::Sqrt, &[positive]);
        let scaled = self.mul(eta, d);
        let along = self.add(scaled, root);
        let bend = |(x, y): (&Value, &Value)| {
            let (ahead, aside) = (self.mul(*x, eta), self.mul(*y, along));
            let bent = self.sub(ahead, aside);
            self.b.select(inside, zero, bent)
        };
        Ok(x.iter().zip(y).map(bend).collect())
    }

    /// `x` if `dot(z, y) < 0`, otherwise `-x`
    pub(crate) fn face_forward(&mut self, x: &[Value], y: &[Value], z: &[Value]) -> Res<Vec<Value>> {
        let dot = self.dot(z, y)?;
        let zero = self.constant_like(dot, 0.0);
        let facing = self.less(dot, zero);
        let face = |x: &Value| {
            let back = self.b.float_op(FloatOp::Neg, &[*x]);
            self.b.select(facing, *x, back)
        };
        Ok(x.iter().map(face).collect())
    }

    fn less(&mut self, a: Value, b: Value) -> Value {
        let scalar = self.b.scalar(a);
        self.b.eval(Op::Compare(scalar, Comparison::Less), &[a, b])
    }

    /// A float constant of the width of `like`.
    pub(crate) fn constant_like(&mut self, like: Value, value: f32) -> Value {
        let scalar: Scalar = self.b.scalar(like);
        self.b.float(scalar, value)
    }
}
