//! A kernel with a fault, run and held against the bound of the kernel without it.

use super::Plan;
use super::fault::Mutant;
use super::report::Outcome;
use crate::domain::Inputs;
use crate::judge::JudgeError;
use crate::question::conformant::sample;
use lobe_backends::executor::Program;
use lobe_backends::interp::{InterpError, Interpreter, ShadowColumns};
use lobe_codegen::ValidModule;
use lobe_codegen::data::Columns;
use lobe_codegen::def::FunctionRef;
use lobe_codegen::module::Meta;
use lobe_codegen::validate::validate;

/// Rounds of a loop that a kernel with a fault may run; no kernel needs so many.
const FUEL: u64 = 1 << 16;

/// A kernel without a fault, on the inputs of its trial.
#[derive(Debug)]
pub struct Reference {
    program: Program,
    args: Columns,
    results: Columns,
    shadow: ShadowColumns,
}

impl Reference {
    /// Runs `kernel` on the inputs that a check would draw.
    pub(super) fn new(kernel: FunctionRef, plan: &Plan) -> Result<Self, JudgeError> {
        let program = Program::new(kernel)?;
        if program.results().is_empty() {
            return Err(JudgeError::NoResult { kernel: program.name() });
        }
        let listed = plan.cases.listed(program.def())?;
        let args = Inputs::draw(program.def(), plan.inputs, plan.seed, &listed)?.args;
        let results = run(program.module(), program.name(), &args, None).map_err(|cause| {
            lobe_backends::executor::ExecError::Interp { kernel: program.name(), cause: cause.into() }
        })?;
        let shadow = program.shadow(&args, None)?;
        Ok(Self { program, args, results, shadow })
    }

    /// The kernel.
    #[must_use]
    pub fn program(&self) -> &Program {
        &self.program
    }
}

/// The module with the fault, if it is one.
pub(super) fn module(reference: &Reference, mutant: &Mutant) -> Option<ValidModule> {
    let original = reference.program.module().module();
    let made = lobe_codegen::quietly(|| {
        let changed = mutant.edit.apply(original)?;
        validate(changed, Meta::default()).ok()
    });
    made.ok().flatten()
}

/// What `module`'s function of this name returns for `args`.
pub(super) fn run(
    module: &ValidModule,
    name: &str,
    args: &Columns,
    fuel: Option<u64>,
) -> Result<Columns, InterpError> {
    let function = module.function(name).ok_or(InterpError::NoEntryPoint(0))?;
    let interpreter = Interpreter::new(module)?;
    fuel.map_or(interpreter.clone(), |fuel| interpreter.with_fuel(fuel)).call(function, args)
}

/// Runs a fault on the inputs of the trial.
pub(super) fn judge(reference: &Reference, mutant: &Mutant) -> Outcome {
    let Some(module) = module(reference, mutant) else { return Outcome::Stillborn };
    let name = reference.program.name();
    let outcome = lobe_codegen::quietly(|| run(&module, name, &reference.args, Some(FUEL)));
    match outcome {
        Ok(Ok(found)) => compare(reference, &found),
        Ok(Err(error)) => Outcome::OutsideBound { how: error.to_string() },
        Err(panic) => Outcome::OutsideBound { how: format!("panicked: {panic}") },
    }
}

/// What tells `found` from the results of the kernel without a fault.
fn compare(reference: &Reference, found: &Columns) -> Outcome {
    match outside(&reference.shadow, found) {
        Ok(how) => Outcome::OutsideBound { how },
        Err(share) => {
            let differs = |row: &usize| reference.results.row(*row) != found.row(*row);
            match (0..found.rows).filter(differs).count() {
                0 => Outcome::Unseen { rows: found.rows },
                rows => Outcome::OtherBits { share, rows },
            }
        }
    }
}

/// The first row outside its bound, or else the largest share of a bound.
fn outside(shadow: &ShadowColumns, found: &Columns) -> Result<String, f64> {
    let mut share: f64 = 0.0;
    for (column, words) in shadow.columns.iter().zip(&found.columns) {
        let rows = words.iter().enumerate().filter(|(row, _)| !shadow.indeterminate[*row]);
        for (row, word) in rows {
            let Some(sample) = sample(column, row, *word) else { continue };
            let of_row = sample.share();
            if of_row > 1.0 {
                let how = format!(
                    "row {row} is {} and not {} within {:e}",
                    sample.found, sample.wanted, sample.permitted
                );
                return Ok(how);
            }
            share = share.max(of_row);
        }
    }
    Err(share)
}
