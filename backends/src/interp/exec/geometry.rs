//! Functions of whole vectors, composed of scalar operations in the written order.

use super::super::error::Res;
use super::super::leaf::Leaf;
use super::super::model::Model;
use super::{InterpError, Machine};

impl<M: Model> Machine<'_, M> {
    /// `a * b`; a column times itself is a square.
    pub(super) fn mul_leaf(&self, a: &Leaf<M>, b: &Leaf<M>) -> Res<Leaf<M>> {
        if a.same(b) {
            return self.map_f(a, |a| self.model.square(a));
        }
        self.zip_f(a, b, |a, b| self.model.mul(a, b))
    }

    fn sub_leaf(&self, a: &Leaf<M>, b: &Leaf<M>) -> Res<Leaf<M>> {
        self.zip_f(a, b, |a, b| self.model.sub(a, b))
    }

    fn splat(&self, value: f32) -> Leaf<M> {
        Leaf::from_floats(vec![self.model.float(value, value.into()); self.lanes])
    }

    /// `x[0] * y[0] + x[1] * y[1] + ..`
    pub(super) fn dot(&self, x: &[Leaf<M>], y: &[Leaf<M>]) -> Res<Leaf<M>> {
        let mut products = x.iter().zip(y).map(|(x, y)| self.mul_leaf(x, y));
        let first = products.next().ok_or(InterpError::Malformed("a vector without components"))??;
        products.try_fold(first, |sum, product| self.zip_f(&sum, &product?, |a, b| self.model.add(a, b)))
    }

    /// The same on integers, wrapping.
    pub(super) fn dot_words(&self, x: &[Leaf<M>], y: &[Leaf<M>]) -> Res<Leaf<M>> {
        let mut products = x.iter().zip(y).map(|(x, y)| self.zip_w(x, y, u32::wrapping_mul));
        let first = products.next().ok_or(InterpError::Malformed("a vector without components"))??;
        products.try_fold(first, |sum, product| self.zip_w(&sum, &product?, u32::wrapping_add))
    }

    /// `sqrt(dot(x, x))`; of a scalar, its magnitude.
    pub(super) fn length(&self, x: &[Leaf<M>]) -> Res<Leaf<M>> {
        match x {
            [x] => self.map_f(x, |x| self.model.abs(x)),
            x => self.map_f(&self.dot(x, x)?, |d| self.model.sqrt(d)),
        }
    }

    /// `length(x - y)`
    pub(super) fn distance(&self, x: &[Leaf<M>], y: &[Leaf<M>]) -> Res<Leaf<M>> {
        self.length(&self.columns(x, y, |x, y| self.sub_leaf(x, y))?)
    }

    /// `x / length(x)`
    pub(super) fn normalize(&self, x: &[Leaf<M>]) -> Res<Vec<Leaf<M>>> {
        let length = self.length(x)?;
        x.iter().map(|x| self.zip_f(x, &length, |x, l| self.model.div(x, l))).collect()
    }

    /// `x[i] * y[j] - x[j] * y[i]`
    pub(super) fn cross(&self, x: &[Leaf<M>], y: &[Leaf<M>]) -> Res<Vec<Leaf<M>>> {
        let ([x0, x1, x2], [y0, y1, y2]) = (x, y) else {
            return Err(InterpError::Malformed("a cross product is of three components"));
        };
        let part = |a, b, c, d| self.sub_leaf(&self.mul_leaf(a, b)?, &self.mul_leaf(c, d)?);
        Ok(vec![part(x1, y2, x2, y1)?, part(x2, y0, x0, y2)?, part(x0, y1, x1, y0)?])
    }

    /// `x - y * (2 * dot(y, x))`
    pub(super) fn reflect(&self, x: &[Leaf<M>], y: &[Leaf<M>]) -> Res<Vec<Leaf<M>>> {
        let twice = self.mul_leaf(&self.splat(2.0), &self.dot(y, x)?)?;
        let mirrored = |(x, y)| self.sub_leaf(x, &self.mul_leaf(y, &twice)?);
        x.iter().zip(y).map(mirrored).collect()
    }

    /// `x * eta - y * (eta * d + sqrt(k))`, `k = 1 - eta * eta * (1 - d * d)`, `d = dot(y, x)`; zero where `k < 0`.
    pub(super) fn refract(&self, x: &[Leaf<M>], y: &[Leaf<M>], eta: &Leaf<M>) -> Res<Vec<Leaf<M>>> {
        let m = &self.model;
        let (zero, one) = (self.splat(0.0), self.splat(1.0));
        let d = self.dot(y, x)?;
        let sine2 = self.sub_leaf(&one, &self.mul_leaf(&d, &d)?)?;
        let k = self.sub_leaf(&one, &self.mul_leaf(&self.mul_leaf(eta, eta)?, &sine2)?)?;
        let inside = self.compare_f(&k, &zero, |k, zero| m.less(k, zero))?;
        // The root counts only where `k` is not negative.
        let root = self.map_f(&k, |k| m.sqrt(m.nonnegative(k)))?;
        let along = self.zip_f(&self.mul_leaf(eta, &d)?, &root, |a, b| m.add(a, b))?;
        let bend = |(x, y)| {
            let bent = self.sub_leaf(&self.mul_leaf(x, eta)?, &self.mul_leaf(y, &along)?)?;
            self.choose(&inside, &zero, &bent)
        };
        x.iter().zip(y).map(bend).collect()
    }

    /// `x` if `dot(z, y) < 0`, otherwise `-x`
    pub(super) fn face_forward(&self, x: &[Leaf<M>], y: &[Leaf<M>], z: &[Leaf<M>]) -> Res<Vec<Leaf<M>>> {
        let m = &self.model;
        let facing = self.compare_f(&self.dot(z, y)?, &self.splat(0.0), |d, zero| m.less(d, zero))?;
        x.iter().map(|x| self.choose(&facing, x, &self.map_f(x, |x| m.neg(x))?)).collect()
    }

    /// Rows become columns.
    pub(super) fn transpose(rows: usize, x: &[Leaf<M>]) -> Vec<Leaf<M>> {
        (0..rows).flat_map(|row| x.iter().skip(row).step_by(rows)).cloned().collect()
    }
}
