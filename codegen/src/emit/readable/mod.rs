//! What a careful author would not write is taken out of a writer's text: temporaries that are used once,
//! parentheses that change nothing, and a last `return;`.
//!
//! All leave every operation, its operands and its order as they are, so a compiler reads the same.

mod inline;
mod parentheses;

use super::mark::Marks;
use super::scan;
use naga::{Function, Module};

/// The text of an item that defines a function, `body`, without temporaries and a last `return;`.
pub(super) fn text(
    pieces: &[scan::Piece<'_>],
    (module, function): (&Module, &Function),
    marks: &Marks,
) -> String {
    let text: String = pieces.iter().map(|p| p.text).collect();
    without_return(inline::inline(&text, module, function, marks))
}

/// The pieces of such a text, without parentheses that change nothing.
pub(super) fn pieces(text: &str) -> Vec<scan::Piece<'_>> {
    parentheses::without(text)
}

/// The text without a last `return;`, which is where the function ends anyway.
fn without_return(text: String) -> String {
    match text.trim_end().strip_suffix("    return;\n}") {
        Some(rest) if !rest.ends_with("    ") => format!("{rest}}}"),
        _ => text,
    }
}
