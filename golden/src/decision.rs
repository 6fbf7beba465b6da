//! Decisions on goldens: a line each, in a log that only grows.

use crate::hash::Hash;
use crate::name::CaseName;
use serde::{Deserialize, Serialize};

/// What was decided.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Action {
    /// The pending golden is right: it is accepted.
    Accept,
    /// It is wrong, and stays so whenever it comes again.
    Reject,
    /// The decision before is taken back.
    Undo,
    /// The golden is of no case any more.
    Prune,
}

/// A line of the log.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Decision {
    /// When, UTC, RFC 3339.
    pub at: String,
    /// Who.
    pub by: String,
    /// What was decided.
    pub action: Action,
    /// Of which golden.
    pub case: CaseName,
    /// Why.
    pub reason: String,
    /// Of the pending golden: what it depends on.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub chain: Option<Hash>,
    /// Of its EXR file; none of a golden that is gone.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub exr: Option<Hash>,
    /// Of the EXR file that was accepted before.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub replaced: Option<Hash>,
}

/// One of many decisions to carry out, all or none.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Step {
    /// The golden.
    pub case: CaseName,
    /// Whether it is accepted, else rejected.
    pub accepts: bool,
    /// Why.
    pub reason: String,
    /// What was seen: the chain of the pending golden. One that is another by now is refused.
    pub chain: Option<Hash>,
    /// Its EXR file.
    pub exr: Option<Hash>,
}

impl Decision {
    /// The lines of a log; one that was cut off by hand, or merged wrong, is an error with its number.
    pub(crate) fn parse(text: &str) -> Result<Vec<Self>, (usize, String)> {
        let lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
        let parsed = lines.map(|(at, line)| serde_json::from_str(line).map_err(|e| (at + 1, e.to_string())));
        parsed.collect()
    }

    /// As a line.
    pub(crate) fn line(&self) -> String {
        // Strings and names only: this cannot fail, and if it did the log would be found damaged.
        serde_json::to_string(self).unwrap_or_else(|cause| cause.to_string()) + "\n"
    }
}
