//! A kernel under judgement: its program and the budgets it states.

use lobe_backends::executor::{ExecError, Program};
use lobe_backends::interp::{ShadowColumn, ShadowColumns};
use lobe_codegen::accuracy::Model;
use lobe_codegen::data::Columns;
use lobe_codegen::def::{FunctionDef, FunctionRef};

/// A kernel with everything that judging it needs.
#[derive(Debug)]
pub struct Subject {
    program: Program,
    budgets: Vec<Budget>,
}

/// A stated budget: the part of the result it is for, and the function that computes it.
#[derive(Debug)]
pub struct Budget {
    /// Field of the result; empty for the whole.
    pub path: &'static str,
    /// As written in the contract.
    pub text: &'static str,
    program: Program,
}

/// Permitted absolute errors, a column for each scalar of the result; `None` where none is stated.
pub type Permitted = Vec<Option<Vec<f64>>>;

impl Subject {
    /// Lowers `kernel` and its budgets.
    ///
    /// # Errors
    /// When one of them is not written in the kernel language.
    pub fn new(kernel: FunctionRef) -> Result<Self, ExecError> {
        let program = Program::new(kernel)?;
        let rows = program.def().contract.budget.iter();
        let budgets = rows
            .map(|row| Ok(Budget { path: row.path, text: row.text, program: Program::new(row.function)? }))
            .collect::<Result<_, ExecError>>()?;
        Ok(Self { program, budgets })
    }

    /// The same, but drivers are permitted what `accuracy` permits.
    #[must_use]
    pub fn with_accuracy(self, accuracy: &'static Model) -> Self {
        Self { program: self.program.with_accuracy(accuracy), ..self }
    }

    /// The kernel, ready to run.
    #[must_use]
    pub fn program(&self) -> &Program {
        &self.program
    }

    /// Its definition.
    #[must_use]
    pub fn def(&self) -> &'static FunctionDef {
        self.program.def()
    }

    /// The budget for scalar `leaf` of the result: the one with the longest path that covers it.
    #[must_use]
    pub fn budget(&self, leaf: usize) -> Option<&Budget> {
        let path = &self.program.results()[leaf].path;
        self.budgets.iter().filter(|b| covers(b.path, path)).max_by_key(|b| b.path.len())
    }

    /// What the budgets permit for each row: their f64 values at the arguments and the f64 results.
    ///
    /// # Errors
    /// When the interpreter gives up on a budget.
    pub fn permitted(&self, args: &Columns, shadow: &ShadowColumns) -> Result<Permitted, ExecError> {
        let (words, exact) = with_result(args, self.exact_args(args), shadow);
        let values = self.budgets.iter().map(|b| {
            let value = b.program.exact(&words, Some(&exact))?;
            Ok(value.columns.into_iter().next().map(exact_of).unwrap_or_default())
        });
        let values: Vec<Vec<f64>> = values.collect::<Result<_, ExecError>>()?;
        let leaves = 0..self.program.results().len();
        let index =
            |leaf| self.budget(leaf).and_then(|b| self.budgets.iter().position(|c| std::ptr::eq(b, c)));
        Ok(leaves.map(|leaf| index(leaf).map(|i| values[i].clone())).collect())
    }

    fn exact_args(&self, args: &Columns) -> Vec<Vec<f64>> {
        let columns = self.program.params().iter().zip(&args.columns);
        columns.map(|(leaf, words)| words.iter().map(|w| as_f64(leaf.scalar, *w)).collect()).collect()
    }
}

/// Whether the part `field` of a result (empty: all of it) holds the scalar at `path`.
#[must_use]
pub fn covers(field: &str, path: &str) -> bool {
    match path.strip_prefix(field) {
        Some(rest) => field.is_empty() || rest.is_empty() || rest.starts_with(['.', '[']),
        None => false,
    }
}

/// The value that a word stands for.
#[must_use]
pub fn as_f64(scalar: lobe_codegen::def::Scalar, word: u32) -> f64 {
    use lobe_codegen::def::Scalar;
    match scalar {
        Scalar::F32 => f32::from_bits(word).into(),
        Scalar::I32 => (word as i32).into(),
        Scalar::U32 | Scalar::Bool => word.into(),
    }
}

/// The arguments of a budget: those of the kernel, then its result.
fn with_result(args: &Columns, mut exact: Vec<Vec<f64>>, shadow: &ShadowColumns) -> (Columns, Vec<Vec<f64>>) {
    let mut words = args.clone();
    for column in &shadow.columns {
        match column {
            ShadowColumn::Float { value, exact: precise, .. } => {
                words.columns.push(value.iter().map(|v| v.to_bits()).collect());
                exact.push(precise.clone());
            }
            ShadowColumn::Word { value, .. } => {
                words.columns.push(value.clone());
                exact.push(value.iter().map(|w| f64::from(*w)).collect());
            }
        }
    }
    (words, exact)
}

fn exact_of(column: ShadowColumn) -> Vec<f64> {
    match column {
        ShadowColumn::Float { exact, .. } => exact,
        ShadowColumn::Word { value, .. } => value.into_iter().map(f64::from).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::covers;

    #[test]
    fn a_budget_covers_its_field_and_what_lies_in_it() {
        assert!(
            covers("", "axis.x") && covers("axis", "axis.x") && covers("axis", "axis") && covers("w", "w[2]")
        );
        assert!(!covers("axis", "axis2.x") && !covers("axis.x", "axis"));
    }
}
