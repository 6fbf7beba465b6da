//! What a careful author would not write is taken out of a writer's text: temporaries that are used once,
//! parentheses that change nothing, and a last `return;`.
//!
//! All leave every operation, its operands and its order as they are, so a compiler reads the same.

mod inline;
mod lines;
mod parentheses;

use super::scan::Piece;
use super::words::Words;
use naga::{Function, Module};

/// Makes the functions of one text readable.
pub(super) struct Author<'a> {
    words: &'a Words<'a>,
    /// The functions that read and write nothing but values.
    pure: Vec<bool>,
}

impl<'a> Author<'a> {
    /// For functions of `module`.
    pub(super) fn new(module: &Module, words: &'a Words<'a>) -> Self {
        Self { words, pure: inline::of_values(module) }
    }

    /// The item that defines `function`, as one would write it.
    pub(super) fn written(&self, item: &[Piece<'a>], function: &Function) -> Vec<Piece<'a>> {
        let mut pieces = inline::inline(item, function, self.words, &self.pure);
        leave_out_return(&mut pieces);
        parentheses::leave_out(&mut pieces);
        pieces
    }
}

/// Leaves out a last `return;`, which is where the function ends anyway.
fn leave_out_return(pieces: &mut Vec<Piece<'_>>) {
    let [.., blanks, keyword, semicolon, line_break, brace] = pieces.as_mut_slice() else { return };
    let texts = (keyword.text, semicolon.text, line_break.text, brace.text);
    let rest = blanks.text.strip_suffix("    ").filter(|rest| !rest.ends_with("    "));
    let (("return", ";", "\n", "}"), Some(rest)) = (texts, rest) else { return };
    blanks.text = rest;
    *keyword = *brace;
    pieces.truncate(pieces.len() - 3);
}
