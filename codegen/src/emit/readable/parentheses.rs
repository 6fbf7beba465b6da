//! Parentheses that change nothing are left out.
//!
//! naga's writers put every operation in parentheses.
//! A pair goes where the grammar of every target reads the same without it, and where a reader does: between sums,
//! products, comparisons and the logical operators; around what stands alone.
//! Those that help are kept: around operations on bits, comparisons of comparisons and in lists (where WGSL could
//! take `a < b, c > d` for a template), `&&` beside `||`, and a minus sign behind an operator.

use crate::emit::scan::{self, Piece, PieceKind};

/// How tightly what stands between parentheses, or the operator beside them, binds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Level {
    /// Nothing: a bracket, a comma, an assignment, the end of a statement.
    Open,
    /// `? :`
    Choice,
    /// `&`, `|`, `^`, shifts, and whatever is not known here.
    Bits,
    Or,
    And,
    Comparison,
    Sum,
    Product,
    /// A sign, `!`, `~`, `&`, `*` before its operand.
    Prefix,
    /// A name, a number, a call, and what is behind a dot or in brackets.
    Primary,
}

/// The level of what is beside or between parentheses; `None` where they are kept.
type Found = Option<Level>;

/// The pieces of `text` without the parentheses that change nothing.
pub(super) fn without(text: &str) -> Vec<Piece<'_>> {
    let mut pieces = scan::pieces(text);
    // Inner pairs come first: what is left out decides about what is around it.
    for (open, close) in pairs(&pieces) {
        if is_idle(&pieces, open, close) {
            pieces[open] = GONE;
            pieces[close] = GONE;
        }
    }
    pieces
}

/// What stands for a parenthesis that is left out.
const GONE: Piece<'_> = Piece { text: "", kind: PieceKind::Space };

/// The parentheses that group: those of calls, declarations and conditions are not among them. Inner ones come first.
fn pairs(pieces: &[Piece<'_>]) -> Vec<(usize, usize)> {
    let mut opened = Vec::new();
    let mut found = Vec::new();
    for (i, piece) in pieces.iter().enumerate().filter(|(_, p)| p.kind == PieceKind::Mark) {
        match piece.text {
            "(" => opened.push(i),
            ")" => found.extend(opened.pop().filter(|&open| is_group(pieces, open)).map(|open| (open, i))),
            _ => {}
        }
    }
    found
}

/// Whether a parenthesis begins a group: it stands behind a blank or an operator, and behind no `if` or the like.
fn is_group(pieces: &[Piece<'_>], open: usize) -> bool {
    let Some(before) = open.checked_sub(1).map(|i| pieces[i]) else { return true };
    match before.kind {
        PieceKind::Mark => !matches!(before.text, ")" | "]" | ">"),
        PieceKind::Space => {
            let word = pieces[..open].iter().rev().find(|p| p.kind != PieceKind::Space);
            !word.is_some_and(|w| matches!(w.text, "if" | "while" | "switch" | "for" | "main" | "in"))
        }
        PieceKind::Word | PieceKind::Selector | PieceKind::Opaque => false,
    }
}

/// Whether the text means the same without this pair.
fn is_idle(pieces: &[Piece<'_>], open: usize, close: usize) -> bool {
    let (Some(left), Some(right)) = (left(pieces, open), right(pieces, close)) else { return false };
    let inside = &pieces[open + 1..close];
    let Some(level) = inside_level(inside) else { return false };
    let first = inside.iter().find(|piece| !piece.text.is_empty());
    let begins_with_sign = first.is_some_and(|p| matches!(p.text, "-" | "+" | "!" | "~" | "&" | "*"));
    let is_list = |at: Option<&Piece<'_>>| at.is_some_and(|p| p.text == ",");
    let in_list = is_list(solid_before(pieces, open)) || is_list(solid_after(pieces, close));
    match level {
        Level::Primary => true,
        Level::Open => false,
        _ if left == Level::Bits || right == Level::Bits => false,
        Level::Comparison if in_list || left == Level::Comparison || right == Level::Comparison => false,
        Level::And | Level::Or if [left, right].iter().any(|l| is_other(level, *l)) => false,
        _ if begins_with_sign && left != Level::Open => false,
        // What stands on the right of its equal belongs together: `a - (b - c)`.
        _ => {
            level > left && level >= right
                || (level == Level::Choice && left == Level::Open && right == Level::Open)
        }
    }
}

/// `&&` beside `||`
fn is_other(level: Level, beside: Level) -> bool {
    matches!((level, beside), (Level::And, Level::Or) | (Level::Or, Level::And))
}

fn solid_before<'p, 'a>(pieces: &'p [Piece<'a>], at: usize) -> Option<&'p Piece<'a>> {
    pieces[..at].iter().rev().find(|p| p.kind != PieceKind::Space)
}

fn solid_after<'p, 'a>(pieces: &'p [Piece<'a>], at: usize) -> Option<&'p Piece<'a>> {
    pieces[at + 1..].iter().find(|p| p.kind != PieceKind::Space)
}

/// Whether no blank comes next.
fn touches<'p, 'a: 'p>(mut pieces: impl Iterator<Item = &'p Piece<'a>>) -> bool {
    pieces.find(|piece| !piece.text.is_empty()).is_some_and(|piece| piece.kind != PieceKind::Space)
}

/// The operator on the left of a group.
fn left(pieces: &[Piece<'_>], open: usize) -> Found {
    let Some(before) = solid_before(pieces, open) else { return Some(Level::Open) };
    let touches = touches(pieces[..open].iter().rev());
    match (before.kind, before.text) {
        (PieceKind::Word, "return") | (PieceKind::Mark, "(" | "[" | "," | "{" | ";") => Some(Level::Open),
        (PieceKind::Mark, "=") => equals(pieces, open),
        (PieceKind::Mark, "-" | "+" | "!" | "~" | "&" | "*") if touches => Some(Level::Prefix),
        (PieceKind::Mark, _) => operator(&pieces[..open], true),
        _ => None,
    }
}

/// An assignment, or the end of `==`, `<=`, `>=`, `!=`.
fn equals(pieces: &[Piece<'_>], open: usize) -> Found {
    let at = pieces[..open].iter().rposition(|p| p.text == "=")?;
    match at.checked_sub(1).map(|i| pieces[i].text) {
        Some("=" | "<" | ">" | "!") => Some(Level::Comparison),
        _ => Some(Level::Open),
    }
}

/// The operator on the right of a group.
fn right(pieces: &[Piece<'_>], close: usize) -> Found {
    let Some(after) = solid_after(pieces, close) else { return Some(Level::Open) };
    let touches = touches(pieces[close + 1..].iter());
    match (after.kind, after.text) {
        (PieceKind::Mark, ")" | "]" | "," | ";" | "}" | "{") => Some(Level::Open),
        (PieceKind::Mark, "." | "[") if touches => Some(Level::Primary),
        // A cast: `(int)x`.
        _ if touches => None,
        (PieceKind::Mark, _) => operator(&pieces[close + 1..], false),
        _ => None,
    }
}

/// The operator between blanks that ends or begins `pieces`.
fn operator(pieces: &[Piece<'_>], at_end: bool) -> Found {
    let mut marks = [0; 3];
    let mut count = 0;
    let mut take = |piece: &Piece<'_>| {
        let is_mark = piece.kind == PieceKind::Mark;
        if is_mark && let (Some(place), Some(&byte)) = (marks.get_mut(count), piece.text.as_bytes().first()) {
            (*place, count) = (byte, count + 1);
        }
        is_mark
    };
    let is_blank = |piece: &&Piece<'_>| piece.kind == PieceKind::Space;
    match at_end {
        true => pieces.iter().rev().skip_while(is_blank).all(&mut take),
        false => pieces.iter().skip_while(is_blank).all(&mut take),
    };
    let marks = &mut marks[..count];
    if at_end {
        marks.reverse();
    }
    level_of(marks)
}

fn level_of(marks: &[u8]) -> Found {
    match marks {
        b"*" | b"/" | b"%" => Some(Level::Product),
        b"+" | b"-" => Some(Level::Sum),
        b"<" | b">" | b"<=" | b">=" | b"==" | b"!=" => Some(Level::Comparison),
        b"&&" => Some(Level::And),
        b"||" => Some(Level::Or),
        b"?" | b":" => Some(Level::Choice),
        b"" => None,
        _ => Some(Level::Bits),
    }
}

/// The loosest operator of what stands between the parentheses.
fn inside_level(inside: &[Piece<'_>]) -> Found {
    let first = inside.iter().find(|piece| !piece.text.is_empty())?;
    let sign = matches!(first.text, "-" | "+" | "!" | "~" | "&" | "*") && first.kind == PieceKind::Mark;
    let mut loosest = if sign { Level::Prefix } else { Level::Primary };
    let mut depth = 0usize;
    for (i, piece) in inside.iter().enumerate() {
        match (piece.kind, piece.text) {
            (PieceKind::Mark, "(" | "[" | "{") => depth += 1,
            (PieceKind::Mark, ")" | "]" | "}") => depth = depth.checked_sub(1)?,
            (PieceKind::Mark, "," | ";") if depth == 0 => return None,
            (PieceKind::Space, "") => {}
            (PieceKind::Space, _) if depth == 0 => {
                let next = inside.get(i + 1)?;
                let is_else = |p: &&Piece<'_>| p.kind != PieceKind::Mark && !p.text.is_empty();
                let ends_with_blank = || inside[i + 1..].iter().find(is_else);
                let is_operator = next.kind == PieceKind::Mark
                    && !matches!(next.text, "(" | "[" | "{")
                    && ends_with_blank().is_some_and(|p| p.kind == PieceKind::Space);
                if is_operator {
                    loosest = loosest.min(operator(&inside[i..], false)?);
                }
            }
            _ => {}
        }
    }
    Some(loosest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_changes_nothing_goes_and_what_helps_stays() {
        for (with, expected) in [
            ("return ((a * b) + (c * d));", "return a * b + c * d;"),
            ("return ((a + b) * (c + d));", "return (a + b) * (c + d);"),
            ("let x = (((a + b) + c) - d);", "let x = a + b + c - d;"),
            ("let x = (a - (b - c));", "let x = a - (b - c);"),
            ("let x = (a + (b + c));", "let x = a + (b + c);"),
            ("let x = (a * (b * c));", "let x = a * (b * c);"),
            ("let x = ((a / b) * c);", "let x = a / b * c;"),
            ("if ((a >= 4.0)) {", "if (a >= 4.0) {"),
            ("if (((a < b) && (c > d))) {", "if (a < b && c > d) {"),
            ("if (((a && b) || c)) {", "if ((a && b) || c) {"),
            ("if (((a && b) && c)) {", "if (a && b && c) {"),
            ("let x = (!(a) && (b == c));", "let x = !a && b == c;"),
            ("let x = ((a < b) == (c < d));", "let x = (a < b) == (c < d);"),
            ("f((a < b), (c > (d)));", "f((a < b), (c > d));"),
            ("f((a + b), -(c));", "f(a + b, -c);"),
            ("let x = -((a * b));", "let x = -(a * b);"),
            ("let x = (-(a) * b);", "let x = -a * b;"),
            ("let x = (a - (-b));", "let x = a - (-b);"),
            ("let x = (-b);", "let x = -b;"),
            ("let x = -(-(b));", "let x = -(-b);"),
            ("let x = (a & (b | c));", "let x = a & (b | c);"),
            ("let x = ((a << 2u) + c);", "let x = (a << 2u) + c;"),
            ("return ((x > 0.0) ? y : -(y));", "return x > 0.0 ? y : -y;"),
            ("let x = (c ? (a + b) : d) * 2.0;", "let x = (c ? a + b : d) * 2.0;"),
            ("let x = (v.mixed).xx / (a + b).yx;", "let x = v.mixed.xx / (a + b).yx;"),
            ("let x = (int)y + (float3)0;", "let x = (int)y + (float3)0;"),
            ("let x = (*p).axis;", "let x = (*p).axis;"),
            ("let p = (*(p));", "let p = *p;"),
            ("let x = vec3<f32>((a + b), c, d);", "let x = vec3<f32>(a + b, c, d);"),
            ("let x = array<f32, 2>((a), (b - c));", "let x = array<f32, 2>(a, b - c);"),
            ("let x = (f(a) + g((b * c)));", "let x = f(a) + g(b * c);"),
            ("values[(i + 1u)] = (a);", "values[i + 1u] = a;"),
            ("total += (a * b);", "total += a * b;"),
            ("while(true) { switch (x) { } }", "while(true) { switch (x) { } }"),
        ] {
            let text: String = without(with).iter().map(|piece| piece.text).collect();
            assert_eq!(text, expected, "{with}");
        }
    }
}
