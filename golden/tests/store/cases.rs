//! Goldens for tests, and what they do.

use lobe_golden::{Chain, Golden, Hash, Kernel, Record, Reviewer, Step, Store};
use std::path::Path;

/// A golden that is told by its number, and its record.
pub(crate) fn numbered(case: &str, number: u32) -> (Golden, Record) {
    let values: Vec<f64> = (0..3 * 16 * 16).map(|at| f64::from(at) + f64::from(number) / 16.0).collect();
    let golden = Golden::new([16, 16], &values, &vec![1e-3; values.len()]).expect("a golden");
    let module = Hash::of(&number.to_le_bytes());
    let kernels = vec![Kernel { name: "k".to_owned(), module, is_judged: true }];
    let chain = Chain::new(None, Hash::of(b"settings"), kernels);
    let record = Record::new(case.parse().expect("a name"), "render", [16, 16], Hash::of(b""), chain);
    (golden, record)
}

pub(crate) fn put(store: &Store, case: &str, number: u32) -> Record {
    let (golden, record) = numbered(case, number);
    store.put_pending(&golden, &record).expect("it is pending")
}

pub(crate) fn step(case: &str, accepts: bool) -> Step {
    let reason = "a test".to_owned();
    Step { case: case.parse().expect("a name"), accepts, reason, chain: None, exr: None }
}

pub(crate) fn somebody() -> Reviewer {
    Reviewer { by: "somebody".to_owned(), at: "2026-01-01T00:00:00Z".to_owned() }
}

/// Accepts a golden.
pub(crate) fn accept(store: &Store, case: &str, number: u32) {
    put(store, case, number);
    store.carry_out(&[step(case, true)], &somebody()).expect("it is accepted");
}

/// The number of the accepted golden; none if there is none. One that cannot be used fails the test.
#[track_caller]
pub(crate) fn accepted(store: &Store, case: &str) -> Option<u32> {
    let found = store.golden(&case.parse().expect("a name")).expect("it can be used")?;
    assert!(found.record.accepted.is_some());
    Some(number(&found.golden))
}

/// The number of the pending golden.
#[track_caller]
pub(crate) fn pending(store: &Store, case: &str) -> Option<u32> {
    let found = store.pending(&case.parse().expect("a name")).expect("it can be used")?;
    assert!(found.record.accepted.is_none());
    Some(number(&found.golden))
}

fn number(golden: &Golden) -> u32 {
    (golden.truth()[0] * 16.0) as u32
}

/// Files of a folder and below that no reader of goldens should meet.
pub(crate) fn leftovers(root: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(root.join(".staging")).map(|e| e.collect::<Vec<_>>()).unwrap_or_default();
    entries.into_iter().map(|e| e.expect("an entry").file_name().to_string_lossy().into_owned()).collect()
}

#[test]
fn what_is_accepted_is_golden() {
    let folder = tempfile::tempdir().expect("a folder");
    let store = Store::open(folder.path());
    assert_eq!(accepted(&store, "box/direct"), None);
    put(&store, "box/direct", 1);
    assert_eq!((accepted(&store, "box/direct"), pending(&store, "box/direct")), (None, Some(1)));
    store.carry_out(&[step("box/direct", true)], &somebody()).expect("accepted");
    assert_eq!((accepted(&store, "box/direct"), pending(&store, "box/direct")), (Some(1), None));
    assert_eq!(store.accepted_cases().expect("cases"), ["box/direct".parse().expect("a name")]);
    assert!(store.bytes().expect("bytes") > 1000);
    assert!(leftovers(folder.path()).is_empty());
}

#[test]
fn decisions_are_taken_back_one_by_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let store = Store::open(folder.path());
    accept(&store, "box/direct", 1);
    accept(&store, "box/direct", 2);
    let record = put(&store, "box/direct", 3);
    store.carry_out(&[step("box/direct", false)], &somebody()).expect("rejected");
    assert_eq!((accepted(&store, "box/direct"), pending(&store, "box/direct")), (Some(2), None));
    let why = |store: &Store| store.rejection(&record.case, &record.exr).expect("the log").map(|d| d.reason);
    assert_eq!(why(&store).as_deref(), Some("a test"));
    let undo = || {
        store
            .undo(&somebody(), "a mistake")
            .map(|_| (accepted(&store, "box/direct"), pending(&store, "box/direct")))
    };
    assert_eq!(undo().expect("undone"), (Some(2), Some(3)));
    assert_eq!(why(&store), None);
    assert_eq!(undo().expect("undone"), (Some(1), Some(2)));
    assert_eq!(undo().expect("undone"), (None, Some(1)));
    assert!(undo().is_err());
    assert_eq!(store.decisions().expect("the log").len(), 6);
}

#[test]
fn what_no_case_names_is_pruned_and_comes_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let store = Store::open(folder.path());
    accept(&store, "box/direct", 1);
    store.prune(&["box/direct".parse().expect("a name")], &somebody(), "gone").expect("pruned");
    assert_eq!(accepted(&store, "box/direct"), None);
    store.undo(&somebody(), "not gone").expect("undone");
    assert_eq!(accepted(&store, "box/direct"), Some(1));
}

#[test]
fn many_are_accepted_together_or_not_at_all() {
    let folder = tempfile::tempdir().expect("a folder");
    let store = Store::open(folder.path());
    for number in 1..=3 {
        put(&store, &format!("box/m{number}"), number);
    }
    let all = ["box/m1", "box/m2", "box/m4"].map(|case| step(case, true));
    let error = store.carry_out(&all, &somebody()).expect_err("the last is not pending");
    assert!(error.to_string().starts_with("box/m4: there is no pending golden"), "{error}");
    assert_eq!(accepted(&store, "box/m1"), None);
    let twice = ["box/m1", "box/m1"].map(|case| step(case, true));
    assert!(store.carry_out(&twice, &somebody()).is_err());
    let unreasoned = Step { reason: " ".to_owned(), ..step("box/m1", true) };
    assert!(store.carry_out(&[unreasoned], &somebody()).is_err());
    assert!(store.decisions().expect("the log").is_empty());
    let all = ["box/m1", "box/m2", "box/m3"].map(|case| step(case, true));
    store.carry_out(&all, &somebody()).expect("accepted");
    assert_eq!([1, 2, 3].map(|n| accepted(&store, &format!("box/m{n}"))), [Some(1), Some(2), Some(3)]);
}

#[test]
fn what_was_not_seen_is_not_accepted() {
    let folder = tempfile::tempdir().expect("a folder");
    let store = Store::open(folder.path());
    let seen = put(&store, "box/direct", 1);
    put(&store, "box/direct", 2);
    let by_chain = Step { chain: Some(seen.chain.hash.clone()), ..step("box/direct", true) };
    let by_picture = Step { exr: Some(seen.exr.clone()), ..step("box/direct", true) };
    for step in [by_chain, by_picture] {
        let error = store.carry_out(&[step], &somebody()).expect_err("it is another by now");
        assert!(error.to_string().contains("look at it again"), "{error}");
    }
    assert_eq!(accepted(&store, "box/direct"), None);
}

#[test]
fn a_store_that_may_not_write_writes_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let store = Store::read_only(folder.path());
    let (golden, record) = numbered("box/direct", 1);
    assert!(store.put_pending(&golden, &record).is_err());
    assert!(store.carry_out(&[step("box/direct", true)], &somebody()).is_err());
    assert!(store.prune(&[], &somebody(), "").is_err());
    assert!(store.undo(&somebody(), "").is_err());
    assert_eq!(accepted(&store, "box/direct"), None);
    assert_eq!(std::fs::read_dir(folder.path()).expect("a folder").count(), 0);
}
