//! From naga's spans back to Rust lines.

use super::error::{LowerError, byte_range, render};
use crate::def::{FunctionDef, Source, Span};
use crate::validate::ValidateError;

/// Gives each item a stretch of one virtual text, so that a naga span finds its way back.
#[derive(Default)]
pub(super) struct SourceMap {
    /// First offset and source; offsets start at 1, since naga takes 0..0 for "unknown".
    stretches: Vec<(u32, &'static Source)>,
    end: u32,
    /// Functions and entry points, for errors that know no more than a name.
    functions: Vec<&'static FunctionDef>,
}

/// Turns spans of one item into naga's.
pub(super) struct Spans {
    base: u32,
    source: &'static Source,
}

impl Spans {
    pub(super) fn naga(&self, span: Span) -> naga::Span {
        let range = byte_range(self.source, &span);
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
        let known = self.stretches.iter().find(|(_, s)| std::ptr::eq(*s, source));
        let base = known.map(|(base, _)| *base).unwrap_or_else(|| {
            let base = self.end.max(1);
            self.end = base + source.text.len() as u32 + 1;
            self.stretches.push((base, source));
            base
        });
        Spans { base, source }
    }

    /// The source and the range in its text.
    fn find(&self, span: naga::Span) -> Option<(&'static Source, std::ops::Range<usize>)> {
        let range = span.to_range()?;
        let (base, source) = self.stretches.iter().rev().find(|(base, _)| *base as usize <= range.start)?;
        Some((source, range.start - *base as usize..range.end - *base as usize))
    }

    /// A validation error at the Rust lines that it points at.
    pub(super) fn explain(&self, error: &ValidateError) -> LowerError {
        let message = error.to_string();
        let mut found: Vec<(&'static Source, Span, String)> = Vec::new();
        if let Some(def) = error.function().and_then(|n| self.functions.iter().find(|d| d.name == n)) {
            found.push((&def.source, def.span, String::new()));
        }
        for (span, label) in error.spans() {
            if let Some((source, range)) = self.find(span) {
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

/// Lines and columns of a byte range of a source's text.
fn span_of(source: &Source, range: std::ops::Range<usize>) -> Span {
    let position = |offset: usize| {
        let before = &source.text[..offset.min(source.text.len())];
        let line = before.matches('\n').count() as u32;
        let column = before.rsplit('\n').next().map_or(0, |l| l.chars().count() as u32);
        (source.line + line, column)
    };
    Span { start: position(range.start), end: position(range.end) }
}
