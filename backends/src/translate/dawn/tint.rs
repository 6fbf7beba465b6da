//! Tint as a judge of WGSL, without a device.

use std::time::Duration;

use serde_json::json;

use super::Dawn;
use super::process::{Fault, Frame, Process};
use crate::translate::TranslateError;

const TOOL: &str = "Tint";

/// How long it may take to start, or to read one shader.
const LIMIT: Duration = Duration::from_secs(60);

/// A process that says what Tint thinks of any number of shaders.
#[derive(Debug)]
pub struct Tint {
    dawn: Dawn,
    /// `None` after it has ended, until the next shader.
    process: Option<Process>,
}

impl Tint {
    /// Starts the Tint of `dawn`.
    ///
    /// # Errors
    ///
    /// [`TranslateError::Unusable`] if it does not start.
    pub fn start(dawn: &Dawn) -> Result<Self, TranslateError> {
        let process = Some(start(dawn)?);
        Ok(Self { dawn: dawn.clone(), process })
    }

    /// Whether Tint accepts `wgsl`, which may be a shader or a library without entry points.
    ///
    /// # Errors
    ///
    /// [`TranslateError::Rejected`] with its message, or what kept it from answering. After any the next shader is
    /// judged, by a fresh process if need be.
    pub fn validate(&mut self, wgsl: &str) -> Result<(), TranslateError> {
        let process = match self.process.take() {
            Some(process) => process,
            None => start(&self.dawn)?,
        };
        let answer = process.send(&json!({ "validate": wgsl }), &[]).and_then(|()| process.answer(LIMIT));
        match answer {
            Ok(frame) => {
                self.process = Some(process);
                verdict(&frame)
            }
            Err(fault) => Err(given_up(process, fault)),
        }
    }
}

fn start(dawn: &Dawn) -> Result<Process, TranslateError> {
    let unusable = |reason| TranslateError::Unusable { tool: TOOL, path: dawn.package.clone(), reason };
    let process =
        dawn.start(&["backend=null".to_owned()], None).map_err(|error| unusable(error.to_string()))?;
    match process.answer(LIMIT) {
        Ok(frame) => match frame.error() {
            None => Ok(process),
            Some((_, message)) => Err(unusable(message.to_owned())),
        },
        Err(fault) => Err(given_up(process, fault)),
    }
}

fn verdict(frame: &Frame) -> Result<(), TranslateError> {
    match frame.error() {
        None => Ok(()),
        Some(("wgsl", message)) => Err(TranslateError::Rejected { tool: TOOL, message: message.to_owned() }),
        Some((_, message)) => Err(TranslateError::BadOutput { tool: TOOL, reason: message.to_owned() }),
    }
}

fn given_up(process: Process, fault: Fault) -> TranslateError {
    process.kill();
    let reason = match fault {
        Fault::Ended(reason) => reason,
        Fault::Late => format!("no answer after {LIMIT:?}"),
    };
    TranslateError::BadOutput { tool: TOOL, reason }
}
