//! The node process at the near end: frames to it, frames from it, and what becomes of it when it is late or dead.

use std::ffi::OsString;
use std::io::{self, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStderr, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError, Sender};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::Value;

/// The far end.
const SCRIPT: &str = include_str!("dawn.mjs");

/// How long the process may take to end by itself.
const CLOSING_TIME: Duration = Duration::from_secs(5);

/// How much is kept of what it says on standard error: the last words matter.
const KEPT: usize = 4096;

/// What goes one way or the other: a header, and bytes.
#[derive(Debug)]
pub(crate) struct Frame {
    pub(crate) header: Value,
    pub(crate) bytes: Vec<u8>,
}

impl Frame {
    /// The kind of error that the frame tells of, and the message.
    pub(crate) fn error(&self) -> Option<(&str, &str)> {
        let error = self.header.get("error")?;
        Some((error["fault"].as_str().unwrap_or_default(), error["message"].as_str().unwrap_or_default()))
    }
}

/// Why there was no answer. The process is of no use any more.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Fault {
    /// It did not start, or ended, or answered what nobody understands.
    Ended(String),
    /// It did not answer in time.
    Late,
}

/// A node process that has Dawn loaded.
pub(crate) struct Process {
    child: Child,
    /// `None` once the process has been told to end.
    requests: Option<Sender<Vec<u8>>>,
    answers: Receiver<io::Result<Frame>>,
    /// The last of what it says on standard error, once it has ended.
    last_words: Receiver<String>,
}

impl Process {
    /// Starts `node` with Dawn's `options`; `icd` is the manifest of the one Vulkan driver that it is to see.
    /// The first answer comes unasked.
    pub(crate) fn start(
        node: &Path,
        package: &Path,
        options: &[OsString],
        icd: Option<&Path>,
    ) -> io::Result<Self> {
        let mut command = Command::new(node);
        command.args(["--input-type=module", "--eval", SCRIPT]).arg(package);
        command.arg(std::process::id().to_string()).args(options);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        if let Some(icd) = icd {
            command.env("VK_DRIVER_FILES", icd);
        }
        let mut child = command.spawn()?;
        let pipes = (child.stdin.take(), child.stdout.take(), child.stderr.take());
        let (Some(input), Some(output), Some(words)) = pipes else {
            return Err(io::Error::other("the process has no pipes"));
        };
        let (words_there, last_words) = mpsc::channel();
        let (requests, requests_there) = mpsc::channel();
        let (answers_there, answers) = mpsc::channel();
        thread::Builder::new().name("dawn words".to_owned()).spawn(move || listen(words, &words_there))?;
        let serve = move || converse(input, output, &requests_there, &answers_there);
        thread::Builder::new().name("dawn".to_owned()).spawn(serve)?;
        Ok(Self { child, requests: Some(requests), answers, last_words })
    }

    /// Sends a frame: `header`, and `parts` one after another.
    pub(crate) fn send(&self, header: &Value, parts: &[&[u8]]) -> Result<(), Fault> {
        let frame = encode(header, parts).ok_or_else(|| Fault::Ended("the job is too large".to_owned()))?;
        if let Some(requests) = &self.requests {
            // A process that has ended shows when the answer is waited for.
            let _ = requests.send(frame);
        }
        Ok(())
    }

    /// Waits for an answer.
    pub(crate) fn answer(&self, limit: Duration) -> Result<Frame, Fault> {
        match self.answers.recv_timeout(limit) {
            Ok(Ok(frame)) => Ok(frame),
            Ok(Err(error)) if error.kind() == io::ErrorKind::UnexpectedEof => Err(self.ended()),
            Ok(Err(error)) => Err(Fault::Ended(format!("its answer is none: {error}"))),
            Err(RecvTimeoutError::Timeout) => Err(Fault::Late),
            Err(RecvTimeoutError::Disconnected) => Err(self.ended()),
        }
    }

    fn ended(&self) -> Fault {
        // What it has started itself may keep the pipe open.
        let words = self.last_words.recv_timeout(Duration::from_secs(1)).unwrap_or_default();
        let said = if words.is_empty() { "without a word".to_owned() } else { format!("and said: {words}") };
        Fault::Ended(format!("the process has ended {said}"))
    }

    /// Ends a process that does not answer.
    pub(crate) fn kill(mut self) {
        // It may have ended meanwhile, which is as well.
        let _ = self.child.kill();
    }
}

impl std::fmt::Debug for Process {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Process").field("id", &self.child.id()).finish_non_exhaustive()
    }
}

impl Drop for Process {
    /// The end of its input ends the process; one that does not take it is killed.
    fn drop(&mut self) {
        self.requests = None;
        let begin = Instant::now();
        while let Ok(None) = self.child.try_wait() {
            if begin.elapsed() > CLOSING_TIME {
                let _ = self.child.kill();
                let _ = self.child.wait();
                break;
            }
            thread::sleep(Duration::from_millis(2));
        }
    }
}

/// The lengths of both parts, the header, the bytes; `None` where a length has no room.
fn encode(header: &Value, parts: &[&[u8]]) -> Option<Vec<u8>> {
    let header = header.to_string().into_bytes();
    let length: usize = parts.iter().map(|part| part.len()).sum();
    let lengths = [u32::try_from(header.len()).ok()?, u32::try_from(length).ok()?];
    let mut frame = Vec::with_capacity(8 + header.len() + length);
    lengths.iter().for_each(|n| frame.extend(n.to_le_bytes()));
    frame.extend(header);
    parts.iter().for_each(|part| frame.extend(*part));
    Some(frame)
}

fn read_frame(from: &mut impl Read) -> io::Result<Frame> {
    let mut length = || {
        let mut bytes = [0; 4];
        from.read_exact(&mut bytes).map(|()| u32::from_le_bytes(bytes) as usize)
    };
    let (header_length, length) = (length()?, length()?);
    let (mut header, mut bytes) = (vec![0; header_length], vec![0; length]);
    from.read_exact(&mut header)?;
    from.read_exact(&mut bytes)?;
    Ok(Frame { header: serde_json::from_slice(&header)?, bytes })
}

/// Passes requests on, and answers back, until either side has gone.
fn converse(
    mut input: ChildStdin,
    mut output: ChildStdout,
    requests: &Receiver<Vec<u8>>,
    answers: &Sender<io::Result<Frame>>,
) {
    loop {
        let answer = read_frame(&mut output);
        let has_failed = answer.is_err();
        if answers.send(answer).is_err() || has_failed {
            return;
        }
        let Ok(request) = requests.recv() else { return };
        // If it cannot be sent, the process has ended, and reading says so.
        let _ = input.write_all(&request);
    }
}

fn listen(mut words: ChildStderr, last: &Sender<String>) {
    let (mut said, mut part) = (Vec::new(), [0; 1024]);
    while let Ok(count @ 1..) = words.read(&mut part) {
        said.extend(&part[..count]);
        said.drain(..said.len().saturating_sub(KEPT));
    }
    // Nobody listens if the process was no longer needed.
    let _ = last.send(String::from_utf8_lossy(&said).trim().to_owned());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_come_back_as_they_went() {
        let header = serde_json::json!({ "wgsl": "fn f() {} // ä" });
        let sent = encode(&header, &[&[1, 2], &[], &[3]]).expect("small");
        let frame = read_frame(&mut sent.as_slice()).expect("whole");
        assert_eq!((frame.header, frame.bytes), (header, vec![1, 2, 3]));
        assert!(read_frame(&mut &sent[..sent.len() - 1]).is_err());
    }
}
