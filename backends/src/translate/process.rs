//! Child processes that read a shader from their standard input.

use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::thread;

/// Runs a program with `input` on its standard input.
pub(super) fn feed(program: &Path, arguments: &[&str], input: Vec<u8>) -> io::Result<Output> {
    let mut child = Command::new(program)
        .args(arguments.iter().map(OsStr::new))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()?;
    let writer = write_input(&mut child, input);
    let output = child.wait_with_output()?;
    if let Some(writer) = writer {
        // A program that stops reading early says why in its output, which tells more than the broken pipe.
        let _ = writer.join();
    }
    Ok(output)
}

/// Writes on a thread of its own: a program that answers before it has read everything would otherwise block us.
fn write_input(child: &mut Child, input: Vec<u8>) -> Option<thread::JoinHandle<io::Result<()>>> {
    let mut stdin = child.stdin.take()?;
    Some(thread::spawn(move || stdin.write_all(&input)))
}
