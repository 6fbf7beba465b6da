//! Each module by the judge of the interpreter: the same words, and no driver drawn by chance leaves its bounds.

use crate::resources::{Given, Owned};
use crate::{Case, compare, modules};
use lobe_backends::interp::{Checks, InterpError, Interpreter, ShadowBuffer, ShadowWord};

const SUBGROUP: u32 = 8;
const DRIVERS: u64 = 3;

/// What a run leaves.
fn left(
    case: &Case,
    run: impl FnOnce(&Interpreter<'_>, &mut Owned) -> Result<(), InterpError>,
) -> Result<Owned, String> {
    let mut owned = Owned::of(&case.given)?;
    let interpreter = Interpreter::new(&case.module).map_err(|error| error.to_string())?;
    run(&interpreter.with_subgroup_size(SUBGROUP), &mut owned).map_err(|error| error.to_string())?;
    Ok(owned)
}

fn fault(case: &Case) -> Result<(), String> {
    let groups = case.options.groups;
    let ran = left(case, |i, owned| i.run(0, groups, owned.lend()))?;
    let judged = left(case, |i, owned| i.run_judged(0, groups, owned.lend()))?;
    for given in case.given.iter().filter(|g| g.written()) {
        compare::agree(given.kind, ran.bytes(given), judged.bytes(given), None)
            .map_err(|difference| format!("judged: `{}`: {difference}", given.name))?;
    }
    let mut bounds = Vec::new();
    left(case, |i, owned| {
        bounds = i.shadow_run(0, groups, owned.lend())?;
        i.sanitize(0, groups, owned.lend(), Checks::default()).map(|_| ())
    })?;
    within(&bounds, &ran, &case.given).map_err(|fault| format!("run: {fault}"))?;
    for driver in 1..=DRIVERS {
        let driven = left(case, |i, owned| i.perturbed_run(0, groups, owned.lend(), driver))?;
        within(&bounds, &driven, &case.given).map_err(|fault| format!("driver {driver}: {fault}"))?;
    }
    Ok(())
}

/// Whether all words are as the bounds promise.
fn within(bounds: &[ShadowBuffer], left: &Owned, given: &[Given]) -> Result<(), String> {
    for ShadowBuffer { group, binding, words } in bounds {
        let given =
            given.iter().find(|g| (g.group, g.binding) == (*group, *binding)).ok_or("a buffer of its own")?;
        let found = left.bytes(given).chunks_exact(4).map(|c| u32::from_le_bytes([c[0], c[1], c[2], c[3]]));
        for (at, (word, promised)) in found.zip(words).enumerate() {
            let holds = match *promised {
                ShadowWord::Float { exact, bound, .. } => {
                    bound.is_infinite() || (f64::from(f32::from_bits(word)) - exact).abs() <= bound
                }
                ShadowWord::Word { value, known } => !known || value == word,
            };
            if !holds {
                return Err(format!("word {at} of `{}` is {word:#x}, not {promised:?}", given.name));
            }
        }
    }
    Ok(())
}

#[test]
fn the_judge_leaves_the_same_and_bounds_it() {
    let only = std::env::var("LOBE_CORPUS").ok();
    let wanted =
        modules().into_iter().filter(|(name, _)| only.as_ref().is_none_or(|only| name.contains(only)));
    let faults: Vec<String> = wanted
        .filter_map(|(name, text)| {
            let fault = Case::new(name.clone(), text).and_then(|case| fault(&case));
            fault.err().map(|fault| format!("{name}: {fault}"))
        })
        .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
