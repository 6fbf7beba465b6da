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

impl<'a> WithTally<'a> {
    fn of(report: &'a Report) -> Self {
        Self { report, tally: report.tally(), tightness: report.tightness() }
    }
}

/// The report, indented, with a line feed at its end.
#[must_use]
pub fn render(report: &Report) -> String {
    written(serde_json::to_string_pretty(&WithTally::of(report))) + "\n"
}

/// The report in one line.
#[must_use]
pub fn compact(report: &Report) -> String {
    written(serde_json::to_string(&WithTally::of(report)))
}

/// Maps with string keys and finite numbers only: this cannot fail, and if it did the text would say so.
fn written(text: serde_json::Result<String>) -> String {
    text.unwrap_or_else(|e| format!("{{\"schema\":{SCHEMA},\"error\":{:?}}}", e.to_string()))
}

/// The report that [`render`] wrote.
///
/// # Errors
/// When the text is none, with the line and what is wrong there.
pub fn parse(text: &str) -> Result<Report, serde_json::Error> {
    serde_json::from_str(text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::question::{Answer, Question, Verdict, Worst};
    use crate::report::KernelReport;

    #[test]
    fn a_report_comes_back_to_the_byte() {
        let worst = Worst {
            args: serde_json::json!({ "x": "0x1.8p3", "n": 4 }),
            leaf: "axis.x".to_owned(),
            found: f64::NAN,
            wanted: 0.1 + 0.2,
            permitted: f64::NEG_INFINITY,
            again: None,
        };
        let falls_short = Verdict::FallsShort("1 of 10 rows".to_owned());
        let answers = vec![
            Answer {
                worst: Some(worst),
                share: f64::INFINITY,
                ..Answer::bare(Question::Agree, "a", falls_short)
            },
            Answer { ulp: 1e-310, absolute: 3.0, ..Answer::bare(Question::Robust, "", Verdict::Holds) },
        ];
        let report = Report {
            routes: vec!["interp".to_owned()],
            kernels: vec![KernelReport { answers, ..KernelReport::unknown("k") }],
            ..Report::new("check", 7)
        };
        let text = render(&report);
        assert_eq!(render(&parse(&text).expect("a report")), text);
        assert!(parse("{\"schema\": 1}").is_err());
    }
}
