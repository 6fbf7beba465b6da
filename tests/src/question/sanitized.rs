//! Question 2's other half, where it is asked for: does the kernel make a mistake over its domain (divide by zero, give
//! birth to a NaN, leave an array, loop without end)?

use super::{Answer, Batch, Question, Verdict};
use crate::subject::Subject;
use crate::value::{Floats, args_json};
use lobe_backends::interp::{Checks, Fault, Finding, Invocation};
use lobe_codegen::source::RustPlace;
use serde_json::Value;
use std::collections::BTreeMap;

/// What the answer is called.
pub const SANITIZED: &str = "sanitized";

/// Mistakes that the answer tells; it counts the others.
const TOLD: usize = 3;

/// Collects the mistakes.
#[derive(Debug, Default)]
pub struct Sanitized {
    rows: usize,
    /// The first of each kind at each place.
    found: BTreeMap<(Fault, Option<RustPlace>), Mistake>,
    gave_up: Option<String>,
}

#[derive(Debug)]
struct Mistake {
    message: String,
    /// The arguments.
    args: Option<Value>,
}

impl Sanitized {
    /// Takes a batch.
    pub fn absorb(&mut self, batch: &Batch<'_>) {
        self.rows += batch.args.rows;
        match batch.subject.program().sanitize(batch.args, Checks::default()) {
            Ok(findings) => findings.into_iter().for_each(|finding| self.note(batch, finding)),
            Err(error) => self.gave_up = Some(error.to_string()),
        }
    }

    fn note(&mut self, batch: &Batch<'_>, Finding { kind, span, invocation, message }: Finding) {
        let place = batch.subject.program().module().meta().sources.place(span);
        let args = match invocation {
            Invocation::Row(row) => Some(args_json(batch.subject.def(), &batch.args.row(row), Floats::Hex)),
            Invocation::Global { .. } => None,
        };
        self.found.entry((kind, place)).or_insert(Mistake { message, args });
    }

    /// The answer; a kernel that is known not to be robust may make mistakes.
    #[must_use]
    pub fn finish(self, subject: &Subject) -> Answer {
        let verdict = match (&self.gave_up, self.found.is_empty()) {
            (Some(why), _) => Verdict::FallsShort(why.clone()),
            (None, true) => Verdict::Holds,
            (None, false) if subject.def().contract.not_robust.is_some() => {
                Verdict::ExpectedFailure(self.told())
            }
            (None, false) => Verdict::FallsShort(self.told()),
        };
        Answer { cases: self.rows, ..Answer::bare(Question::Robust, SANITIZED, verdict) }
    }

    fn told(&self) -> String {
        let told = self.found.iter().take(TOLD).map(|((kind, place), Mistake { message, args })| {
            let place = place.map(|p| format!(" at {p} `{}`", p.text)).unwrap_or_default();
            let args = args.as_ref().map(|args| format!(", of {args}")).unwrap_or_default();
            format!("{kind:?}{place}: {message}{args}")
        });
        let told: Vec<String> = told.collect();
        let more = self.found.len().saturating_sub(TOLD);
        let more = if more > 0 { format!("; and {more} more") } else { String::new() };
        told.join("; ") + &more
    }
}
