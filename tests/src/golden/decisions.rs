//! Decisions in a file, as those who review a report export them: `tests/schema/golden-decisions-1.json`.

use lobe_golden::{CaseName, Hash, Name, Step};
use serde::{Deserialize, Serialize};

/// Version of the format.
const SCHEMA: u32 = 1;

/// The file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Decisions {
    /// Version of the format.
    pub schema: u32,
    /// Who decided.
    #[serde(default)]
    pub by: String,
    /// What.
    pub decisions: Vec<One>,
}

/// A decision on a golden.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct One {
    /// The scene.
    pub scene: Name,
    /// The method.
    pub method: Name,
    /// What was decided.
    pub action: Verdict,
    /// Why.
    pub reason: String,
    /// The chain of the item that was seen.
    pub chain: Hash,
    /// The SHA-256 of the EXR file that was seen.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub exr: Option<Hash>,
}

/// What was decided of a golden.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// It is right.
    Accept,
    /// It is wrong.
    Reject,
}

impl Decisions {
    /// The decisions of a text.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn parse(text: &str) -> Result<Self, String> {
        let found: Self = serde_json::from_str(text).map_err(|error| error.to_string())?;
        match (found.schema, found.decisions.is_empty()) {
            (SCHEMA, false) => Ok(found),
            (SCHEMA, true) => Err("it holds no decision".to_owned()),
            (other, _) => {
                Err(format!("it is of version {other} of the format, and this Lobe reads {SCHEMA}"))
            }
        }
    }

    /// What they ask of the store.
    #[must_use]
    pub fn steps(&self) -> Vec<Step> {
        let step = |one: &One| Step {
            case: CaseName { scene: one.scene.clone(), method: one.method.clone() },
            accepts: one.action == Verdict::Accept,
            reason: one.reason.clone(),
            chain: Some(one.chain.clone()),
            exr: one.exr.clone(),
        };
        self.decisions.iter().map(step).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(change: (&str, &str)) -> String {
        let hash = Hash::of(b"");
        let one = format!(
            r#"{{"schema": 1, "by": "a", "decisions": [{{"scene": "box", "method": "direct", "action": "accept", "reason": "right", "chain": "{hash}"}}]}}"#
        );
        one.replace(change.0, change.1)
    }

    #[test]
    fn what_is_exported_is_carried_out() {
        let steps = Decisions::parse(&text(("", ""))).expect("decisions").steps();
        assert_eq!((steps.len(), steps[0].case.to_string()), (1, "box/direct".to_owned()));
        assert!(steps[0].accepts && steps[0].chain.is_some());
    }

    #[test]
    fn what_is_no_decision_is_refused() {
        for (change, expected) in [
            (("\"schema\": 1", "\"schema\": 2"), "version 2"),
            (("\"box\"", "\"../box\""), "is no name"),
            (("\"box\"", "\"\\u0000\""), "is no name"),
            (("\"direct\"", "\"\\\"><script>\""), "is no name"),
            (("\"accept\"", "\"undo\""), "unknown variant"),
            (("\"by\"", "\"who\""), "unknown field"),
            (("e3b0", "E3B0"), "64 digits"),
        ] {
            let error = Decisions::parse(&text(change)).expect_err("no decision");
            assert!(error.contains(expected), "{error}");
        }
        assert!(Decisions::parse(r#"{"schema": 1, "decisions": []}"#).is_err());
    }
}
