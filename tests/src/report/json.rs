//! The report as JSON: the fields of [`Report`], `schema` first, the `tally`, and `tightness` where drivers were drawn.
//!
//! Floats that JSON cannot write are the strings `"inf"`, `"-inf"` and `"nan"`.

use super::{Report, Tally};
use crate::perturbed::Overall;
use serde::Serialize;

/// Version of the format.
pub const SCHEMA: u32 = 1;

#[derive(Serialize)]
struct WithTally<'a> {
    #[serde(flatten)]
    report: &'a Report,
    tally: Tally,
    #[serde(skip_serializing_if = "Option::is_none")]
    tightness: Option<Overall>,
}

/// The report, indented, with a line feed at its end.
#[must_use]
pub fn render(report: &Report) -> String {
    let with_tally = WithTally { report, tally: report.tally(), tightness: report.tightness() };
    // Maps with string keys and finite numbers only: this cannot fail, and if it did the text would say so.
    let text = serde_json::to_string_pretty(&with_tally);
    text.unwrap_or_else(|e| format!("{{\"schema\":{SCHEMA},\"error\":{:?}}}", e.to_string())) + "\n"
}
