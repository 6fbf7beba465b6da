//! What a careful author would not write is taken out of a writer's text: temporaries that are used once,
//! parentheses that change nothing, and a last `return;`.
//!
//! All leave every operation, its operands and its order as they are, so a compiler reads the same.

mod inline;
mod parentheses;

use super::mark::Marks;
use super::scan;
use naga::{Function, Module};

/// An item's text, made readable; its `body` is the function that it defines, if it defines one.
pub(super) fn readable(
    pieces: &[scan::Piece<'_>],
    body: Option<(&Module, &Function)>,
    marks: &Marks,
) -> String {
    let text: String = pieces.iter().map(|p| p.text).collect();
    let Some((module, function)) = body else { return text };
    let text = inline::inline(&text, module, function, marks);
    without_return(parentheses::without(&text))
}

/// The text without a last `return;`, which is where the function ends anyway.
fn without_return(text: String) -> String {
    match text.trim_end().strip_suffix("    return;\n}") {
        Some(rest) if !rest.ends_with("    ") => format!("{rest}}}"),
        _ => text,
    }
}
