//! naga's HLSL with the buffers declared that its arrays stand for, and with variables that are declared alike.

use super::structured::Structured;
use crate::emit::mark::{LENGTH, Marks};
use crate::emit::scan::{self, Piece, PieceKind};

/// Mends a text, whose names are `marks`.
pub(super) fn mended<'a>(
    pieces: &[Piece<'a>],
    structured: Option<&'a Structured>,
    marks: &'a Marks,
) -> Vec<Piece<'a>> {
    let mut mender = Mender { structured, marks, out: Vec::with_capacity(pieces.len() + pieces.len() / 8) };
    mender.take(pieces);
    mender.out
}

struct Mender<'a> {
    structured: Option<&'a Structured>,
    marks: &'a Marks,
    out: Vec<Piece<'a>>,
}

impl<'a> Mender<'a> {
    fn take(&mut self, mut pieces: &[Piece<'a>]) {
        let is_begin = |piece: &Piece<'_>| match piece.kind {
            PieceKind::Mark => piece.text == "[",
            PieceKind::Word => matches!(piece.text, "const" | "static"),
            PieceKind::Selector | PieceKind::Opaque | PieceKind::Space => false,
        };
        while let Some(at) = pieces.iter().position(is_begin) {
            let (before, rest) = pieces.split_at(at);
            self.out.extend_from_slice(before);
            let taken = match rest[0].text {
                "[" => self.index(rest),
                "const" => self.qualifier(),
                _ => self.declaration(rest),
            };
            if taken.is_none() {
                self.out.push(rest[0]);
            }
            pieces = &rest[taken.unwrap_or(1)..];
        }
        self.out.extend_from_slice(pieces);
    }

    /// Takes a `const` that begins a line within a function: naga makes those constant that hold the result of a call.
    fn qualifier(&self) -> Option<usize> {
        let blanks = self.out.last()?.text;
        let is_indented = blanks.contains('\n') && !blanks.ends_with('\n');
        // The word and the blank behind it.
        is_indented.then_some(2)
    }

    /// Takes `static Element name[..] = ..;` where that stands for a buffer.
    fn declaration(&mut self, rest: &[Piece<'a>]) -> Option<usize> {
        let [_, blank, element, _, name, Piece { text: "[", .. }, ..] = rest else { return None };
        let buffer = self.structured?.buffer(name.text, self.marks)?;
        let element =
            if buffer.is_wider { Piece { text: wider(element.text), ..*element } } else { *element };
        let mark = |text| Piece::new(text, PieceKind::Mark);
        let kind = Piece::new(buffer.kind(), PieceKind::Word);
        self.out.extend([kind, mark("<"), element, mark(">"), *blank, *name]);
        self.out.extend(scan::pieces(&buffer.place));
        rest.iter().position(|piece| piece.text == ";").map(|end| end + 1)
    }

    /// Takes the index of an element that is wider than what it stands for, which is taken out of it.
    fn index(&mut self, rest: &[Piece<'a>]) -> Option<usize> {
        let array = self.out.last().filter(|array| array.text.len() == LENGTH)?;
        self.structured?.buffer(array.text, self.marks).filter(|buffer| buffer.is_wider)?;
        let end = closing(rest)?;
        self.out.push(rest[0]);
        self.take(&rest[1..end]);
        self.out.push(rest[end]);
        if rest.get(end + 1).is_none_or(|behind| behind.text != ".") {
            self.out.extend([Piece::new(".", PieceKind::Mark), Piece::new("xyz", PieceKind::Selector)]);
        }
        Some(end + 1)
    }
}

/// The vector of four of what a vector of three has.
fn wider(element: &str) -> &str {
    match element {
        "float3" => "float4",
        "int3" => "int4",
        "uint3" => "uint4",
        other => other,
    }
}

/// Where the bracket is closed that `pieces` begin with.
fn closing(pieces: &[Piece<'_>]) -> Option<usize> {
    let mut depth = 0usize;
    pieces.iter().position(|piece| {
        match piece.text {
            "[" => depth += 1,
            "]" => depth -= 1,
            _ => {}
        }
        depth == 0
    })
}
