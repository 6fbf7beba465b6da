//! Functions of matrices, which lie column after column.

use super::super::error::Res;
use super::super::program::Value;
use super::super::program::op::FloatOp;
use super::{Lowerer, malformed};

impl Lowerer<'_> {
    /// Rows become columns.
    pub(crate) fn transpose(rows: usize, x: &[Value]) -> Vec<Value> {
        (0..rows).flat_map(|row| x.iter().skip(row).step_by(rows)).copied().collect()
    }

    /// Column after column, `x` times a component of `y`.
    pub(crate) fn outer(&mut self, x: &[Value], y: &[Value]) -> Vec<Value> {
        y.iter().flat_map(|y| x.iter().map(|x| self.mul(*x, *y)).collect::<Vec<_>>()).collect()
    }

    /// By its first column, and so on.
    pub(crate) fn determinant(&mut self, n: usize, x: &[Value]) -> Res<Value> {
        let all: Vec<usize> = (0..n).collect();
        self.minor(n, x, &all, &all)
    }

    /// The transposed cofactors by the determinant.
    pub(crate) fn inverse(&mut self, n: usize, x: &[Value]) -> Res<Vec<Value>> {
        let determinant = self.determinant(n, x)?;
        let without = |skipped: usize| -> Vec<usize> { (0..n).filter(|i| *i != skipped).collect() };
        let mut out = Vec::with_capacity(n * n);
        for column in 0..n {
            for row in 0..n {
                let minor = self.minor(n, x, &without(row), &without(column))?;
                let even = (row + column) % 2 == 0;
                let cofactor = if even { minor } else { self.b.float_op(FloatOp::Neg, &[minor]) };
                out.push(self.b.float_op(FloatOp::Div, &[cofactor, determinant]));
            }
        }
        Ok(out)
    }

    /// The determinant of these columns and rows.
    fn minor(&mut self, n: usize, x: &[Value], columns: &[usize], rows: &[usize]) -> Res<Value> {
        let (first, others) = columns.split_first().ok_or(malformed("a matrix without columns"))?;
        let mut sum = None;
        for (at, row) in rows.iter().enumerate() {
            let element = x[first * n + row];
            if others.is_empty() {
                return Ok(element);
            }
            let remaining: Vec<usize> = rows.iter().filter(|r| *r != row).copied().collect();
            let smaller = self.minor(n, x, others, &remaining)?;
            let term = self.mul(element, smaller);
            sum = Some(match sum {
                None => term,
                Some(sum) if at % 2 == 0 => self.add(sum, term),
                Some(sum) => self.sub(sum, term),
            });
        }
        sum.ok_or(malformed("a matrix without rows"))
    }
}
