//! Each step of each decision fails once; afterwards goldens are those before or those after, all of them.

use crate::cases::{accept, accepted, leftovers, pending, put, somebody, step};
use crate::failing::{Failing, Fault, Quick};
use lobe_golden::{Store, StoreError};
use std::path::Path;

/// Steps of the longest decision here, and more.
const STEPS: usize = 80;

type Act = fn(&Store) -> Result<(), StoreError>;

/// What is accepted and pending of both cases, and how many decisions there are.
fn state(store: &Store) -> ([Option<u32>; 4], usize) {
    let both = ["box/a", "box/b"];
    let [a, b] = both.map(|case| accepted(store, case));
    let [c, d] = both.map(|case| pending(store, case));
    ([a, b, c, d], store.decisions().expect("a log").len())
}

fn quick(root: &Path) -> Store {
    Store::with_files(root, Box::new(Quick))
}

fn prepare(root: &Path) {
    let store = quick(root);
    accept(&store, "box/a", 1);
    put(&store, "box/a", 2);
    put(&store, "box/b", 3);
}

#[track_caller]
fn check(act: Act) {
    let after = {
        let folder = tempfile::tempdir().expect("a folder");
        prepare(folder.path());
        act(&quick(folder.path())).expect("it works where nothing fails");
        state(&quick(folder.path()))
    };
    for fault in [Fault::Full, Fault::StaysFull, Fault::Killed] {
        let mut failed = 0;
        for at in 0..STEPS {
            let folder = tempfile::tempdir().expect("a folder");
            prepare(folder.path());
            let before = state(&quick(folder.path()));
            let outcome = act(&Store::with_files(folder.path(), Box::new(Failing::new(fault, at))));
            let found = state(&quick(folder.path()));
            let place = format!("{fault:?} at step {at}: {outcome:?}");
            match outcome {
                Ok(()) => assert_eq!(found, after, "{place}"),
                Err(StoreError::Incomplete { .. }) => assert_eq!(found, after, "{place}"),
                // Of a step that is flushed and whose flush fails, nobody can say whether it is done.
                Err(_) => assert!(found == before || found == after, "{place}: {found:?}"),
            }
            failed += usize::from(at == STEPS - 1 && found != after);
            // Whoever writes next finds nothing in the way.
            let store = quick(folder.path());
            accept(&store, "box/c", 9);
            assert_eq!(accepted(&store, "box/c"), Some(9), "{place}");
            assert!(leftovers(folder.path()).is_empty(), "{place}");
        }
        assert_eq!(failed, 0, "{fault:?}: a decision has more steps than {STEPS}");
    }
}

#[test]
fn accepting_many_survives() {
    check(|store| store.carry_out(&["box/a", "box/b"].map(|c| step(c, true)), &somebody()).map(drop));
}

#[test]
fn accepting_and_rejecting_survive() {
    check(|store| store.carry_out(&[step("box/a", false), step("box/b", true)], &somebody()).map(drop));
}

#[test]
fn pruning_survives() {
    check(|store| store.prune(&["box/a".parse().expect("a name")], &somebody(), "gone").map(drop));
}

#[test]
fn undoing_survives() {
    check(|store| store.undo(&somebody(), "a mistake").map(drop));
}

#[test]
fn writing_pending_goldens_survives() {
    check(|store| {
        let (golden, record) = crate::cases::numbered("box/b", 7);
        store.put_pending(&golden, &record).map(drop)
    });
}

/// A store that may not write does not complete what was decided, and says so.
#[test]
fn an_interrupted_decision_is_seen_where_nothing_is_written() {
    for at in 0..STEPS {
        let folder = tempfile::tempdir().expect("a folder");
        prepare(folder.path());
        let killed = Store::with_files(folder.path(), Box::new(Failing::new(Fault::Killed, at)));
        let outcome = killed.carry_out(&["box/a", "box/b"].map(|c| step(c, true)), &somebody());
        let reader = Store::read_only(folder.path());
        let case = "box/a".parse().expect("a name");
        match (outcome, reader.is_interrupted()) {
            (_, true) => assert!(matches!(reader.golden(&case), Err(StoreError::Interrupted))),
            (_, false) => assert!(accepted(&reader, "box/a").is_some()),
        }
    }
}
