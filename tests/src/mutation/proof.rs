//! A second look at what survived: on many more inputs, and with the bound where the fault shows most.

use super::Plan;
use super::fault::Mutant;
use super::report::Outcome;
use super::trial::{Reference, compare, module, run};
use crate::domain::Inputs;
use lobe_codegen::ValidModule;
use lobe_codegen::data::Columns;
use rayon::prelude::*;

/// Rows drawn at a time.
const CHUNK: usize = 1 << 17;

/// Rows of a chunk that are held against their bounds, for each of the ways in which a fault can show.
const LOOKED_AT: usize = 64;

/// Runs all that survived on the rows of the plan; what never shows in a bit is equivalent.
pub(super) fn look_again(reference: &Reference, plan: &Plan, mutants: &[Mutant], outcomes: &mut [Outcome]) {
    let survived = |outcome: &Outcome| matches!(outcome, Outcome::Survived { .. });
    let mut open: Vec<(usize, ValidModule)> = outcomes
        .iter()
        .enumerate()
        .filter(|(_, outcome)| survived(outcome))
        .filter_map(|(at, _)| Some((at, module(reference, &mutants[at])?)))
        .collect();
    let mut rows = 0;
    while rows < plan.equivalence && !open.is_empty() && !plan.is_over() {
        let seed = plan.seed.wrapping_add(1 + rows as u64);
        let Some((args, results)) = drawn(reference, seed) else { return };
        rows += args.rows;
        let found: Vec<(usize, Outcome)> =
            open.par_iter().map(|(at, module)| (*at, look(reference, module, &args, &results))).collect();
        for (at, outcome) in found {
            outcomes[at] = outcomes[at].clone().worse(outcome);
        }
        open.retain(|(at, _)| survived(&outcomes[*at]));
    }
    for (at, _) in open {
        if let Outcome::Survived { same: true, .. } = outcomes[at]
            && rows >= plan.equivalence
        {
            outcomes[at] = Outcome::Equivalent { rows };
        }
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

/// What a fault does on a chunk.
fn look(reference: &Reference, module: &ValidModule, args: &Columns, results: &Columns) -> Outcome {
    let program = reference.program();
    let Ok(Ok(found)) = lobe_codegen::quietly(|| run(module, program.name(), args, None)) else {
        return Outcome::Killed { how: "it does not end".to_owned() };
    };
    if found.columns == results.columns {
        return Outcome::Survived { share: 0.0, same: true };
    }
    let worst = most_changed(results, &found);
    let some = |all: &Columns| {
        let rows: Vec<Vec<u32>> = worst.iter().map(|row| all.row(*row)).collect();
        Columns::from_rows(all.columns.len(), &rows)
    };
    let Ok(shadow) = program.shadow(&some(args), None) else {
        return Outcome::Survived { share: 0.0, same: false };
    };
    compare(&shadow, &some(&found)).unwrap_or_else(|share| Outcome::Survived { share, same: false })
}

/// The rows at which a fault shows most: by the distance, and by the distance for the size of the result.
fn most_changed(results: &Columns, found: &Columns) -> Vec<usize> {
    let mut absolute = Vec::new();
    let mut relative = Vec::new();
    for (before, after) in results.columns.iter().zip(&found.columns) {
        for (row, (a, b)) in before.iter().zip(after).enumerate().filter(|(_, (a, b))| a != b) {
            let (x, y) = (f64::from(f32::from_bits(*a)), f64::from(f32::from_bits(*b)));
            let distance = if x.is_finite() && y.is_finite() { (x - y).abs() } else { f64::INFINITY };
            absolute.push((distance, row));
            relative.push((distance / x.abs().max(1e-30), row));
        }
    }
    let mut rows = Vec::new();
    for mut list in [absolute, relative] {
        list.sort_unstable_by(|a, b| b.0.total_cmp(&a.0));
        rows.extend(list.into_iter().take(LOOKED_AT).map(|(_, row)| row));
    }
    rows.sort_unstable();
    rows.dedup();
    rows
}
