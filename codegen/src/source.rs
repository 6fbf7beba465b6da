//! From naga's spans back to Rust lines.

use crate::def::{Source, Span};
use std::ops::Range;

/// Where in the Rust sources something stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RustPlace {
    /// The file, as rustc was given it.
    pub file: &'static str,
    /// Its line, from 1.
    pub line: u32,
    /// Its column in characters, from 1.
    pub column: u32,
    /// The text itself.
    pub text: &'static str,
}

impl std::fmt::Display for RustPlace {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}:{}:{}", self.file, self.line, self.column)
    }
}

/// The sources of a module: each item has a stretch of one virtual text, in which naga's spans lie.
#[derive(Debug, Clone, Default)]
pub struct Sources {
    /// First offset and source; offsets start at 1, since naga takes 0..0 for "unknown".
    stretches: Vec<(u32, &'static Source)>,
    end: u32,
}

impl Sources {
    /// Where a span lies; `None` if it is of no kernel, or its file could not be read when it was compiled.
    #[must_use]
    pub fn place(&self, span: naga::Span) -> Option<RustPlace> {
        let (source, range) = self.find(span)?;
        let text = source.text.get(range.clone())?;
        let (line, column) = span_of(source, range).start;
        Some(RustPlace { file: source.file, line, column: column + 1, text })
    }

    /// The offset at which an item's source begins.
    pub(crate) fn base(&mut self, source: &'static Source) -> u32 {
        let known = self.stretches.iter().find(|(_, s)| std::ptr::eq(*s, source));
        known.map(|(base, _)| *base).unwrap_or_else(|| {
            let base = self.end.max(1);
            self.end = base + source.text.len() as u32 + 1;
            self.stretches.push((base, source));
            base
        })
    }

    /// The source and the range in its text.
    pub(crate) fn find(&self, span: naga::Span) -> Option<(&'static Source, Range<usize>)> {
        let range = span.to_range()?;
        let (base, source) = self.stretches.iter().rev().find(|(base, _)| *base as usize <= range.start)?;
        Some((source, range.start - *base as usize..range.end - *base as usize))
    }
}

/// Lines and columns of a byte range of a source's text.
pub(crate) fn span_of(source: &Source, range: Range<usize>) -> Span {
    let position = |offset: usize| {
        let before = &source.text[..offset.min(source.text.len())];
        let line = before.matches('\n').count() as u32;
        let column = before.rsplit('\n').next().map_or(0, |l| l.chars().count() as u32);
        (source.line + line, column)
    };
    Span { start: position(range.start), end: position(range.end) }
}
