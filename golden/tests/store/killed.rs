//! Processes that are killed while they accept.

use crate::cases::{accepted, pending, put, somebody, step};
use lobe_golden::Store;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

const ROOT: &str = "LOBE_TEST_GOLDEN_ROOT";
const CASE: &str = "LOBE_TEST_GOLDEN_CASE";
const ACT: &str = "LOBE_TEST_GOLDEN_ACT";
/// How often a process is killed; `LOBE_TEST_KILLS` says another number.
const TRIALS: u64 = 200;
/// What a process says that is about to begin.
const READY: &str = "lobe: ready";

/// Starts this test program once more, to do something to the store in `root` in the test of this name.
pub(crate) fn child(test: &str, root: &Path, case: &str, act: &str) -> Child {
    Command::new(std::env::current_exe().expect("this program"))
        .args(["--exact", test, "--nocapture", "--test-threads=1"])
        .envs([(ROOT, root.as_os_str()), (CASE, case.as_ref()), (ACT, act.as_ref())])
        .stdout(Stdio::piped())
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
        _ => {
            println!("{READY}");
            for number in 1.. {
                put(&store, &case, number);
                store.carry_out(&[step(&case, true)], &somebody()).expect("it is accepted");
            }
        }
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
    let begin = Instant::now();
    crate::cases::accept(&store, "box/a", 0);
    let one = begin.elapsed().as_micros() as u64;
    let mut interrupted = 0;
    let mut most = 0;
    let mut pictures = std::collections::BTreeSet::new();
    for trial in 0..trials {
        let mut child =
            child("killed::whoever_is_killed_leaves_goldens_whole", folder.path(), "box/a", "for ever");
        let lines = BufReader::new(child.stdout.take().expect("its output")).lines();
        assert!(lines.map_while(Result::ok).any(|line| line.contains(READY)), "it did not begin");
        // Within the time of two acceptances, and so in the midst of one.
        std::thread::sleep(Duration::from_micros(drawn(trial) % (2 * one)));
        child.kill().expect("it is killed");
        child.wait().expect("it is dead");
        interrupted += u64::from(Store::read_only(folder.path()).is_interrupted());
        // Both fail where a golden is half of one.
        let found = (accepted(&store, "box/a"), pending(&store, "box/a"));
        pictures.insert(found);
        let decided = store.decisions().expect("a log").len();
        assert!(decided >= most, "trial {trial}: {found:?}, {decided} decisions after {most}");
        most = decided;
        if decided > 200 {
            std::fs::remove_file(folder.path().join("decisions.jsonl")).expect("removed");
            most = 0;
        }
    }
    println!(
        "{trials} trials, {interrupted} after a decision and before its end, {} outcomes",
        pictures.len()
    );
    assert!(
        trials < 100 || (interrupted > 0 && pictures.len() > 2),
        "none was killed in the midst of an acceptance"
    );
}
