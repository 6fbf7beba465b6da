//! The lines of a function's text, as ranges of its pieces.

use crate::emit::scan::{Piece, PieceKind};
use std::ops::Range;

/// A line.
#[derive(Debug)]
pub(super) struct Line {
    /// Its pieces; before them stands the one with the line break.
    pub(super) pieces: Range<usize>,
    /// Whether a line without anything in it stands before it.
    pub(super) is_behind_blank: bool,
    /// What it declares: `let NAME = VALUE;`, `float NAME = VALUE;`
    pub(super) declares: Option<Declaration>,
    /// Whether it was taken out.
    pub(super) is_gone: bool,
}

/// The parts of a declaration, by their first pieces.
#[derive(Debug, Clone, Copy)]
pub(super) struct Declaration {
    /// The name, if it is a single word.
    pub(super) name: Option<usize>,
    /// The value, which ends before the semicolon that ends the line.
    pub(super) value: usize,
}

impl Line {
    fn new(pieces: &[Piece<'_>], range: Range<usize>) -> Self {
        let blanks = range.start.checked_sub(1).map_or("", |before| pieces[before].text);
        Self {
            is_behind_blank: blanks.bytes().filter(|&byte| byte == b'\n').count() > 1,
            declares: declaration(pieces, &range),
            pieces: range,
            is_gone: false,
        }
    }

    /// The value that it declares.
    pub(super) fn value(&self) -> Option<Range<usize>> {
        self.declares.map(|it| it.value..self.pieces.end - 1)
    }
}

/// Cuts pieces into lines.
pub(super) fn lines(pieces: &[Piece<'_>]) -> Vec<Line> {
    let is_break =
        |piece: &Piece<'_>| piece.kind == PieceKind::Space && piece.text.as_bytes().contains(&b'\n');
    let mut lines = Vec::with_capacity(pieces.len() / 8);
    let mut start = 0;
    for (i, _) in pieces.iter().enumerate().filter(|(_, piece)| is_break(piece)) {
        lines.push(Line::new(pieces, start..i));
        start = i + 1;
    }
    lines.push(Line::new(pieces, start..pieces.len()));
    lines
}

fn declaration(pieces: &[Piece<'_>], line: &Range<usize>) -> Option<Declaration> {
    if pieces[line.clone()].last()?.text != ";" {
        return None;
    }
    // The last two blanks.
    let (mut before, mut blank) = (None, None);
    for at in line.clone() {
        match (pieces[at].kind, pieces[at].text.as_bytes()) {
            (PieceKind::Space, _) => (before, blank) = (blank, Some(at)),
            (PieceKind::Mark, [b'(' | b'{' | b'[']) => return None,
            (PieceKind::Mark, b"=") if is_between_blanks(pieces, at) => {
                let (before, blank) = (before.filter(|&before| before > line.start)?, blank?);
                let name = Some(before + 1).filter(|name| name + 1 == blank);
                return Some(Declaration { name, value: at + 2 });
            }
            _ => {}
        }
    }
    None
}

fn is_between_blanks(pieces: &[Piece<'_>], at: usize) -> bool {
    let is_blank = |at: usize| pieces.get(at).is_some_and(|piece| piece.kind == PieceKind::Space);
    at.checked_sub(1).is_some_and(is_blank) && is_blank(at + 1)
}
