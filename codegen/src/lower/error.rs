//! What goes wrong in lowering, shown at the Rust line.

use crate::def::{FunctionDef, Source, Span};
use codespan_reporting::diagnostic::{Diagnostic, Label};
use codespan_reporting::files::{Error as FilesError, Files};
use codespan_reporting::term;
use std::ops::Range;

/// Why kernels could not be lowered.
#[derive(Debug, thiserror::Error)]
pub enum LowerError {
    /// A kernel's Rust is not what the kernel language takes.
    #[error("{rendered}")]
    Kernel {
        /// Name of the kernel.
        kernel: &'static str,
        /// What is wrong, without the source.
        message: String,
        /// The message with file, line and caret.
        rendered: String,
    },
    /// naga's validator refuses the module that came out.
    #[error("{rendered}")]
    Invalid {
        /// naga's words.
        message: String,
        /// The same with the Rust lines it points at.
        rendered: String,
    },
}

/// A mistake inside one function, before it knows its source.
#[derive(Debug)]
pub(super) struct Fail {
    pub(super) message: String,
    pub(super) span: Span,
}

impl Fail {
    pub(super) fn new(span: Span, message: impl Into<String>) -> Self {
        Self { message: message.into(), span }
    }

    pub(super) fn in_function(self, def: &'static FunctionDef) -> LowerError {
        self.in_source(def.name, &def.source)
    }

    pub(super) fn in_source(self, kernel: &'static str, source: &Source) -> LowerError {
        let rendered = render(&self.message, source, &[(self.span, String::new())]);
        LowerError::Kernel { kernel, message: self.message, rendered }
    }
}

pub(super) type Lowered<T> = Result<T, Fail>;

/// The message with the source lines and a caret under each span.
pub(super) fn render(message: &str, source: &Source, labels: &[(Span, String)]) -> String {
    let file = Excerpt::new(source);
    let mut diagnostic = Diagnostic::<()>::error().with_message(message);
    for (i, (span, text)) in labels.iter().enumerate() {
        let range = file.range(span);
        let label = if i == 0 { Label::primary((), range) } else { Label::secondary((), range) };
        diagnostic = diagnostic.with_label(label.with_message(text));
    }
    let mut out = String::new();
    let config = term::Config::default();
    match term::emit_to_string(&mut out, &config, &file, &diagnostic) {
        Ok(()) => out,
        Err(_) => format!("error: {message}\n  --> {}:{}", source.file, source.line),
    }
}

/// Lines of a file, numbered as in the file.
pub(super) struct Excerpt<'a> {
    source: &'a Source,
    /// Where each line of the text begins.
    starts: Vec<usize>,
}

impl<'a> Excerpt<'a> {
    pub(super) fn new(source: &'a Source) -> Self {
        let ends = source.text.match_indices('\n').map(|(at, _)| at + 1);
        Self { source, starts: std::iter::once(0).chain(ends).collect() }
    }

    fn line_start(&self, line: usize) -> usize {
        self.starts.get(line).copied().unwrap_or(self.source.text.len())
    }

    fn offset(&self, (line, column): (u32, u32)) -> usize {
        let start = self.line_start(line.saturating_sub(self.source.line) as usize);
        let rest = &self.source.text[start..];
        start + rest.char_indices().nth(column as usize).map_or(rest.len(), |(i, _)| i)
    }

    /// The bytes of `span` in the text.
    pub(super) fn range(&self, span: &Span) -> Range<usize> {
        let start = self.offset(span.start).min(self.source.text.len());
        start..self.offset(span.end).clamp(start, self.source.text.len())
    }
}

impl<'a> Files<'a> for Excerpt<'a> {
    type FileId = ();
    type Name = &'a str;
    type Source = &'a str;

    fn name(&'a self, (): ()) -> Result<Self::Name, FilesError> {
        Ok(self.source.file)
    }

    fn source(&'a self, (): ()) -> Result<Self::Source, FilesError> {
        Ok(self.source.text)
    }

    fn line_index(&'a self, (): (), byte: usize) -> Result<usize, FilesError> {
        Ok(self.source.text[..byte.min(self.source.text.len())].matches('\n').count())
    }

    fn line_number(&'a self, (): (), index: usize) -> Result<usize, FilesError> {
        Ok(self.source.line as usize + index)
    }

    fn line_range(&'a self, (): (), index: usize) -> Result<Range<usize>, FilesError> {
        Ok(self.line_start(index)..self.line_start(index + 1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPAN: Span = Span { start: (7, 4), end: (7, 9) };

    #[test]
    fn a_caret_stands_below_the_characters_of_the_span() {
        let source = Source { file: "a.rs", line: 6, text: "fn f() {\n    αβγ + x\n}" };
        let text = render("wrong", &source, &[(SPAN, "here".to_owned())]);
        assert!(text.contains("a.rs:7:5"), "{text}");
        assert!(text.contains("^^^^^ here"), "{text}");
    }

    /// The file may have changed, or not be there, when the macro looks for its text.
    #[test]
    fn a_text_that_does_not_hold_the_span_is_survived() {
        for text in ["", "x", "x\n", "\n\n\n"] {
            let source = Source { file: "a.rs", line: 6, text };
            let rendered = render("wrong", &source, &[(SPAN, String::new())]);
            assert!(rendered.contains("wrong") && rendered.contains("a.rs"), "{rendered}");
        }
        let later = Source { file: "a.rs", line: 100, text: "x" };
        assert!(render("wrong", &later, &[(SPAN, String::new())]).contains("a.rs"));
    }
}
