//! A second look at what a check did not see: on many more inputs, does it change a bit?

use super::Plan;
use super::fault::Mutant;
use super::report::Outcome;
use super::trial::{Reference, module, run};
use crate::domain::Inputs;
use lobe_codegen::ValidModule;
use lobe_codegen::data::Columns;
use rayon::prelude::*;

/// Rows drawn at a time.
const CHUNK: usize = 1 << 17;

/// Runs all that was not seen on the rows of the plan; what never shows in a bit is equivalent.
pub(super) fn look_again(reference: &Reference, plan: &Plan, mutants: &[Mutant], outcomes: &mut [Outcome]) {
    let is_open = |outcome: &Outcome| matches!(outcome, Outcome::Unseen { .. });
    let all = outcomes.iter().enumerate().filter(|(_, outcome)| is_open(outcome));
    let mut open: Vec<(usize, ValidModule)> =
        all.filter_map(|(at, _)| Some((at, module(reference, &mutants[at])?))).collect();
    let mut rows = 0;
    while rows < plan.equivalence && !open.is_empty() && !plan.is_over() {
        let seed = plan.seed.wrapping_add(1 + rows as u64);
        let Some((args, results)) = drawn(reference, seed) else { return };
        rows += args.rows;
        let name = reference.program().name();
        let is_same = |(_, module): &(usize, ValidModule)| {
            let found = lobe_codegen::quietly(|| run(module, name, &args, None));
            matches!(found, Ok(Ok(found)) if found.columns == results.columns)
        };
        let same: Vec<bool> = open.par_iter().map(is_same).collect();
        for ((at, _), is_same) in open.iter().zip(&same) {
            let is_proved = rows >= plan.equivalence;
            outcomes[*at] = match (is_same, is_proved) {
                (false, _) => Outcome::Missed { rows },
                (true, true) => Outcome::Equivalent { rows },
                (true, false) => Outcome::Unseen { rows },
            };
        }
        open.retain(|(at, _)| is_open(&outcomes[*at]));
    }
}

/// A chunk of inputs, and what the kernel returns for them.
fn drawn(reference: &Reference, seed: u64) -> Option<(Columns, Columns)> {
    let program = reference.program();
    let none = Columns::zeros(program.params().len(), 0);
    let args = Inputs::draw(program.def(), CHUNK, seed, &none).ok()?.args;
    let results = run(program.module(), program.name(), &args, None).ok()?;
    Some((args, results))
}
