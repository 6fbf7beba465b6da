//! From naga's spans back to Rust lines.

use super::error::{Excerpt, LowerError, render};
use crate::def::{FunctionDef, Source, Span};
use crate::source::{Sources, span_of};
use crate::validate::ValidateError;

/// The sources of what is lowered, and its functions.
#[derive(Default)]
pub(super) struct SourceMap {
    sources: Sources,
    /// Functions and entry points, for errors that know no more than a name.
    functions: Vec<&'static FunctionDef>,
}

/// Turns spans of one item into naga's.
pub(super) struct Spans {
    base: u32,
    lines: Excerpt<'static>,
}

impl Spans {
    pub(super) fn naga(&self, span: Span) -> naga::Span {
        let range = self.lines.range(&span);
        naga::Span::new(self.base + range.start as u32, self.base + range.end as u32)
    }
}

impl SourceMap {
    /// Notes a function, or an entry point, by its name.
    pub(super) fn name(&mut self, def: &'static FunctionDef) {
        self.functions.push(def);
    }

    /// The spans of an item's source.
    pub(super) fn spans(&mut self, source: &'static Source) -> Spans {
        Spans { base: self.sources.base(source), lines: Excerpt::new(source) }
    }

    /// The sources so far.
    pub(super) fn sources(&self) -> &Sources {
        &self.sources
    }

    /// A validation error at the Rust lines that it points at.
    pub(super) fn explain(&self, error: &ValidateError) -> LowerError {
        let message = error.to_string();
        let mut found: Vec<(&'static Source, Span, String)> = Vec::new();
        if let Some(def) = error.function().and_then(|n| self.functions.iter().find(|d| d.name == n)) {
            found.push((&def.source, def.span, String::new()));
        }
        for (span, label) in error.spans() {
            if let Some((source, range)) = self.sources.find(span) {
                found.push((source, span_of(source, range), label));
            }
        }
        // The innermost label says most; it is the last one with a source.
        let rendered = match found.last() {
            Some((source, _, _)) => {
                let labels: Vec<_> = found
                    .iter()
                    .rev()
                    .filter(|(s, ..)| std::ptr::eq(*s, *source))
                    .map(|(_, span, label)| (*span, label.clone()))
                    .collect();
                render(&message, source, &labels)
            }
            None => format!("error: {message}"),
        };
        LowerError::Invalid { message, rendered }
    }
}
