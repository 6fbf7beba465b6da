//! Many at once.

use crate::cases::{accepted, numbered, pending, put, somebody, step};
use crate::killed::{child, run_if_child};
use lobe_golden::Store;

/// Processes at once.
const MANY: u32 = 64;

#[test]
fn of_64_acceptances_at_once_none_is_lost() {
    if run_if_child() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let store = Store::open(folder.path());
    let names: Vec<String> = (0..MANY).map(|number| format!("box/m{number}")).collect();
    for (case, number) in names.iter().zip(0..) {
        put(&store, case, number);
    }
    let test = "concurrent::of_64_acceptances_at_once_none_is_lost";
    let all: Vec<_> = names.iter().map(|case| child(test, folder.path(), case, "accept")).collect();
    for mut child in all {
        assert!(child.wait().expect("it ends").success());
    }
    for (case, number) in names.iter().zip(0..) {
        assert_eq!((accepted(&store, case), pending(&store, case)), (Some(number), None));
    }
    let mut decided: Vec<String> =
        store.decisions().expect("a log").iter().map(|d| d.case.to_string()).collect();
    decided.sort();
    let mut names = names;
    names.sort();
    assert_eq!(decided, names);
}

/// All of them accept one golden: one does, the others find nothing pending.
#[test]
fn of_64_acceptances_of_one_golden_one_is_carried_out() {
    let folder = tempfile::tempdir().expect("a folder");
    put(&Store::open(folder.path()), "box/one", 5);
    let accept = || Store::open(folder.path()).carry_out(&[step("box/one", true)], &somebody()).is_ok();
    let carried_out = std::thread::scope(|scope| {
        let all: Vec<_> = (0..MANY).map(|_| scope.spawn(accept)).collect();
        all.into_iter().map(|one| one.join().expect("it ends")).filter(|ok| *ok).count()
    });
    assert_eq!(carried_out, 1);
    assert_eq!(accepted(&Store::open(folder.path()), "box/one"), Some(5));
}

/// Two checks write pending goldens while somebody reads: each reads one that is whole.
#[test]
fn two_checks_at_once_leave_whole_goldens() {
    let folder = tempfile::tempdir().expect("a folder");
    put(&Store::open(folder.path()), "box/a", 0);
    std::thread::scope(|scope| {
        for number in 1..=2 {
            let root = folder.path();
            scope.spawn(move || {
                for _ in 0..50 {
                    let (golden, record) = numbered("box/a", number);
                    Store::open(root).put_pending(&golden, &record).expect("it is pending");
                }
            });
        }
        for _ in 0..200 {
            assert!(pending(&Store::open(folder.path()), "box/a").is_some());
        }
    });
}
