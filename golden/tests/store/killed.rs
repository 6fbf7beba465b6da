//! Processes that are killed while they accept.

use crate::cases::{accepted, pending, put, somebody, step};
use lobe_golden::Store;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

const ROOT: &str = "LOBE_TEST_GOLDEN_ROOT";
const CASE: &str = "LOBE_TEST_GOLDEN_CASE";
const ACT: &str = "LOBE_TEST_GOLDEN_ACT";
/// How often a process is killed; `LOBE_TEST_KILLS` says another number.
const TRIALS: u64 = 200;
/// Microseconds within which it is.
const WITHIN: u64 = 12_000;

/// Starts this test program once more, to do something to the store in `root` in the test of this name.
pub(crate) fn child(test: &str, root: &Path, case: &str, act: &str) -> Child {
    Command::new(std::env::current_exe().expect("this program"))
        .args(["--exact", test, "--nocapture", "--test-threads=1"])
        .envs([(ROOT, root.as_os_str()), (CASE, case.as_ref()), (ACT, act.as_ref())])
        .stdout(Stdio::null())
        .spawn()
        .expect("it starts")
}

/// Does what this process was started for, if it was.
pub(crate) fn run_if_child() -> bool {
    let [Ok(root), Ok(case), Ok(act)] = [ROOT, CASE, ACT].map(std::env::var) else { return false };
    let store = Store::open(Path::new(&root));
    match act.as_str() {
        "accept" => {
            store.carry_out(&[step(&case, true)], &somebody()).expect("it is accepted");
        }
        // Until it is killed.
        _ => loop {
            for number in 1.. {
                put(&store, &case, number);
                store.carry_out(&[step(&case, true)], &somebody()).expect("it is accepted");
            }
        },
    }
    true
}

/// Numbers that look drawn.
fn drawn(seed: u64) -> u64 {
    let x = (seed + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    (x ^ (x >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9) >> 33
}

#[cfg(unix)]
#[test]
fn whoever_is_killed_leaves_goldens_whole() {
    if run_if_child() {
        return;
    }
    let trials = std::env::var("LOBE_TEST_KILLS").ok().and_then(|n| n.parse().ok()).unwrap_or(TRIALS);
    let folder = tempfile::tempdir().expect("a folder");
    let store = Store::open(folder.path());
    let mut interrupted = 0;
    let mut most = 0;
    for trial in 0..trials {
        let mut child =
            child("killed::whoever_is_killed_leaves_goldens_whole", folder.path(), "box/a", "for ever");
        // The first decisions take as long as the program takes to start.
        std::thread::sleep(Duration::from_micros(2000 + drawn(trial) % WITHIN));
        child.kill().expect("it is killed");
        child.wait().expect("it is dead");
        interrupted += u64::from(Store::read_only(folder.path()).is_interrupted());
        // Both fail where a golden is half of one.
        let found = (accepted(&store, "box/a"), pending(&store, "box/a"));
        let decided = store.decisions().expect("a log").len();
        assert!(decided >= most, "trial {trial}: {found:?}, {decided} decisions after {most}");
        most = decided;
        if decided > 200 {
            std::fs::remove_file(folder.path().join("decisions.jsonl")).expect("removed");
            most = 0;
        }
    }
    println!("{trials} trials, {interrupted} after the decision and before its end");
    assert!(accepted(&store, "box/a").is_some(), "none of the processes came so far");
}
