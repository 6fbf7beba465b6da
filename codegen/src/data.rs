//! Values of kernels as 32-bit words: one word for each scalar, structure of arrays for batches.
//!
//! Every executor takes and returns [`Columns`]; a float travels as its bits, so nothing is lost,
//! NaN payloads included.
//!
//! ```
//! use lobe_codegen::data::{Columns, leaves};
//! use lobe_codegen::def::{Scalar, TypeDef};
//!
//! let names: Vec<String> = leaves("dir", &TypeDef::Vector(3, Scalar::F32)).into_iter().map(|leaf| leaf.path).collect();
//! assert_eq!(names, ["dir.x", "dir.y", "dir.z"]);
//!
//! // Two directions, a row each.
//! let rows = [[1.0_f32, 0.0, 0.0], [0.0, 0.6, 0.8]].map(|row| row.map(f32::to_bits).to_vec());
//! let columns = Columns::from_rows(3, &rows);
//! assert_eq!(columns.columns[2], [0, 0.8_f32.to_bits()]);
//! ```

use crate::def::{Scalar, StructDef, TypeDef};

/// Reads words in order; past the end it yields zeros.
#[derive(Debug)]
pub struct WordReader<'a>(std::slice::Iter<'a, u32>);

impl<'a> WordReader<'a> {
    /// Starts at the first word.
    pub fn new(words: &'a [u32]) -> Self {
        Self(words.iter())
    }

    /// The next word.
    pub fn word(&mut self) -> u32 {
        self.0.next().copied().unwrap_or(0)
    }
}

/// One scalar of a flattened type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Leaf {
    /// `lobe.axis.x`, `weights[2]`; empty for a plain scalar without a name.
    pub path: String,
    /// Its kind.
    pub scalar: Scalar,
}

/// The scalars of `ty` in order, their paths below `name`.
///
/// Slices and atomics have none: they do not travel by value.
pub fn leaves(name: &str, ty: &TypeDef) -> Vec<Leaf> {
    let mut out = Vec::new();
    push_leaves(name.to_owned(), ty, &mut out);
    out
}

fn push_leaves(path: String, ty: &TypeDef, out: &mut Vec<Leaf>) {
    match *ty {
        TypeDef::Scalar(scalar) => out.push(Leaf { path, scalar }),
        TypeDef::Vector(n, scalar) => push_components(&path, n, scalar, out),
        TypeDef::Matrix(columns, rows) => {
            for axis in ["x_axis", "y_axis", "z_axis", "w_axis"].iter().take(columns.into()) {
                push_components(&join(&path, axis), rows, Scalar::F32, out);
            }
        }
        TypeDef::Array(element, n) => (0..n).for_each(|i| push_leaves(format!("{path}[{i}]"), element, out)),
        TypeDef::Struct(def) => {
            let StructDef { fields, .. } = def();
            fields.iter().for_each(|f| push_leaves(join(&path, f.name), &f.ty, out));
        }
        TypeDef::Slice(_) | TypeDef::Atomic(_) => {}
    }
}

fn push_components(path: &str, n: u8, scalar: Scalar, out: &mut Vec<Leaf>) {
    for component in ["x", "y", "z", "w"].iter().take(n.into()) {
        out.push(Leaf { path: join(path, component), scalar });
    }
}

fn join(path: &str, name: &str) -> String {
    if path.is_empty() { name.to_owned() } else { format!("{path}.{name}") }
}

/// Rows of values as one column of words for each scalar.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Columns {
    /// All of the same length.
    pub columns: Vec<Vec<u32>>,
    /// Number of rows; kept apart since a value may have no scalars.
    pub rows: usize,
}

impl Columns {
    /// `width` columns of `rows` zeros.
    pub fn zeros(width: usize, rows: usize) -> Self {
        Self { columns: vec![vec![0; rows]; width], rows }
    }

    /// From rows of equal width.
    pub fn from_rows(width: usize, rows: &[Vec<u32>]) -> Self {
        let mut out = Self::zeros(width, rows.len());
        for (r, row) in rows.iter().enumerate() {
            for (column, word) in out.columns.iter_mut().zip(row) {
                column[r] = *word;
            }
        }
        out
    }

    /// The words of row `r`.
    pub fn row(&self, r: usize) -> Vec<u32> {
        self.columns.iter().map(|c| c[r]).collect()
    }

    /// Scalars a row.
    pub fn width(&self) -> usize {
        self.columns.len()
    }

    /// The rows `range` as columns of their own.
    pub fn slice(&self, range: std::ops::Range<usize>) -> Self {
        Self { rows: range.len(), columns: self.columns.iter().map(|c| c[range.clone()].to_vec()).collect() }
    }

    /// Appends the rows of `other`, which has the same width.
    pub fn append(&mut self, other: &Self) {
        self.rows += other.rows;
        for (column, more) in self.columns.iter_mut().zip(&other.columns) {
            column.extend_from_slice(more);
        }
    }
}
