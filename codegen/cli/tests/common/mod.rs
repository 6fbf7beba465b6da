//! The binary, run and judged.
#![allow(dead_code, reason = "each test binary uses a part")]

use std::io::Write;
use std::process::{Command, Output, Stdio};

pub(crate) fn command(args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lobe"));
    command.args(args).stdin(Stdio::null());
    command
}

pub(crate) fn lobe(args: &[&str]) -> Output {
    command(args).output().expect("the binary runs")
}

pub(crate) fn lobe_with_input(args: &[&str], input: &str) -> Output {
    let mut command = command(args);
    let mut child = command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the binary runs");
    // A child that ends before it reads is judged by its output.
    let _ = child.stdin.take().expect("a pipe").write_all(input.as_bytes());
    child.wait_with_output().expect("it ends")
}

pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

#[track_caller]
pub(crate) fn assert_fails(output: &Output, code: i32, parts: &[&str]) {
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{message}{}", text(&output.stdout));
    for part in parts {
        assert!(message.contains(part), "no `{part}` in: {message}");
    }
    assert!(!message.contains("panicked"), "{message}");
}

#[track_caller]
pub(crate) fn assert_holds(output: &Output) -> String {
    assert_eq!(output.status.code(), Some(0), "{}{}", text(&output.stderr), text(&output.stdout));
    text(&output.stdout)
}

/// Says that a test does not run in full and how to change that; fails instead where `LOBE_REQUIRE_TOOLS=1`.
#[track_caller]
pub(crate) fn skip(what: &str, mend: &str) {
    let required = std::env::var_os("LOBE_REQUIRE_TOOLS").is_some_and(|value| value == "1");
    assert!(!required, "{what} is required (LOBE_REQUIRE_TOOLS=1) but missing: {mend}");
    // Not eprintln!, which the test runner swallows when the test passes.
    let _ = writeln!(std::io::stderr(), "SKIPPED: {what} ({mend})");
}
