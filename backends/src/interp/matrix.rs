//! Products of matrices, in the order of glam's `scalar-math`.

use super::error::Result;
use super::expr::f2;
use super::model::{F2, Model};
use super::value::Column;
use naga::TypeInner;

/// The product, if one of the operands is a matrix and the other no scalar.
pub(super) fn multiply<M: Model>(
    left: &TypeInner,
    right: &TypeInner,
    l: &[Column<M>],
    r: &[Column<M>],
) -> Result<Option<Vec<Column<M>>>> {
    Ok(match (left, right) {
        (TypeInner::Matrix { columns, rows, .. }, TypeInner::Vector { .. }) => {
            Some(matrix_vector(l, r, *columns as usize, *rows as usize)?)
        }
        (TypeInner::Matrix { columns, rows, .. }, TypeInner::Matrix { columns: others, .. }) => {
            let inner = *columns as usize;
            let products = (0..*others as usize)
                .map(|c| matrix_vector(l, &r[c * inner..(c + 1) * inner], inner, *rows as usize))
                .collect::<Result<Vec<_>>>()?;
            Some(products.concat())
        }
        (TypeInner::Vector { .. }, TypeInner::Matrix { columns, rows, .. }) => {
            let rows = *rows as usize;
            Some(
                (0..*columns as usize)
                    .map(|c| dot(l, &r[c * rows..(c + 1) * rows]))
                    .collect::<Result<_>>()?,
            )
        }
        _ => None,
    })
}

/// The columns scaled by the components, added from the first to the last.
fn matrix_vector<M: Model>(
    m: &[Column<M>],
    v: &[Column<M>],
    columns: usize,
    rows: usize,
) -> Result<Vec<Column<M>>> {
    (0..rows)
        .map(|row| {
            let mut sum = f2(F2::Multiply, &m[row], &v[0])?;
            for column in 1..columns {
                sum = f2(F2::Add, &sum, &f2(F2::Multiply, &m[column * rows + row], &v[column])?)?;
            }
            Ok(sum)
        })
        .collect()
}

/// `x[0] y[0] + x[1] y[1] + ..`, from the first to the last.
pub(super) fn dot<M: Model>(x: &[Column<M>], y: &[Column<M>]) -> Result<Column<M>> {
    let mut sum = f2(F2::Multiply, &x[0], &y[0])?;
    for (x, y) in x.iter().zip(y).skip(1) {
        sum = f2(F2::Add, &sum, &f2(F2::Multiply, x, y)?)?;
    }
    Ok(sum)
}
