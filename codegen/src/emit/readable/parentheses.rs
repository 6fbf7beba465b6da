//! Parentheses that change nothing are left out.
//!
//! naga's writers put every operation in parentheses.
//! A pair goes where the grammar of every target reads the same without it, and where a reader does: between sums,
//! products, comparisons and the logical operators; around what stands alone.
//! Those that help are kept: around operations on bits, comparisons of comparisons and in lists (where WGSL could
//! take `a < b, c > d` for a template), `&&` beside `||`, and a minus sign behind an operator.

use crate::emit::scan::{Piece, PieceKind};

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

/// Leaves out the parentheses that change nothing, in one pass: what is left out decides about what is around it.
pub(super) fn leave_out(pieces: &mut [Piece<'_>]) {
    let mut frames: Vec<Frame> = Vec::new();
    for at in 0..pieces.len() {
        match pieces[at].kind {
            PieceKind::Mark => match pieces[at].text.as_bytes() {
                [b'(' | b'[' | b'{'] => frames.push(Frame::new(pieces, at)),
                [b')' | b']' | b'}'] => close(pieces, &mut frames, at),
                [b',' | b';'] => frames.iter_mut().last().into_iter().for_each(|frame| frame.inside = None),
                _ => {}
            },
            PieceKind::Space => {
                if let Some(frame) = frames.last_mut() {
                    frame.take_blank(&pieces[at + 1..]);
                }
            }
            PieceKind::Word | PieceKind::Selector | PieceKind::Opaque => {}
        }
    }
}

/// What stands for a parenthesis that is left out.
const GONE: Piece<'_> = Piece { text: "", kind: PieceKind::Space, word: 0 };

/// A bracket that is open.
struct Frame {
    /// Where it opens.
    open: usize,
    /// Whether it is a parenthesis that groups: those of calls, declarations and conditions do not.
    is_group: bool,
    /// The loosest operator of what stands between the brackets so far.
    inside: Found,
}

impl Frame {
    fn new(pieces: &[Piece<'_>], open: usize) -> Self {
        let is_group = pieces[open].text == "(" && is_group(pieces, open);
        let first = pieces.get(open + 1).filter(|first| first.text != ")");
        let inside = first.map(|first| if is_sign(first) { Level::Prefix } else { Level::Primary });
        Self { open, is_group, inside }
    }

    /// Takes the operator in that stands between a blank and the next, if `rest` begins with one.
    fn take_blank(&mut self, rest: &[Piece<'_>]) {
        let next = rest.first().filter(|next| next.kind == PieceKind::Mark);
        match next.map(|next| next.text.as_bytes()) {
            Some([b')' | b']' | b'}']) => self.inside = None,
            Some([b'(' | b'[' | b'{']) | None => {}
            Some(_) => {
                let mut behind =
                    rest.iter().filter(|piece| piece.kind != PieceKind::Mark && !piece.text.is_empty());
                if behind.next().is_some_and(|piece| piece.kind == PieceKind::Space) {
                    self.inside = self.inside.and_then(|level| Some(level.min(operator(rest.iter())?)));
                }
            }
        }
    }
}

/// Closes a bracket, and leaves the pair out if the text means the same without.
fn close(pieces: &mut [Piece<'_>], frames: &mut Vec<Frame>, at: usize) {
    let Some(frame) = frames.pop() else { return };
    let (true, Some(level)) = (frame.is_group && pieces[at].text == ")", frame.inside) else { return };
    if is_idle(pieces, frame.open, at, level) {
        pieces[frame.open] = GONE;
        pieces[at] = GONE;
        if let Some(around) = frames.last_mut() {
            around.inside = around.inside.map(|loosest| loosest.min(level));
        }
    }
}

/// Whether a parenthesis begins a group: it stands behind a blank or an operator, and behind no `if` or the like.
fn is_group(pieces: &[Piece<'_>], open: usize) -> bool {
    let Some(before) = open.checked_sub(1).map(|i| pieces[i]) else { return true };
    match before.kind {
        PieceKind::Mark => !matches!(before.text, ")" | "]" | ">"),
        // A parenthesis that was left out.
        PieceKind::Space if before.text.is_empty() => false,
        PieceKind::Space => {
            let word = solid_before(pieces, open);
            !word.is_some_and(|w| matches!(w.text, "if" | "while" | "switch" | "for" | "main" | "in"))
        }
        PieceKind::Word | PieceKind::Selector | PieceKind::Opaque => false,
    }
}

fn is_sign(piece: &Piece<'_>) -> bool {
    piece.kind == PieceKind::Mark && matches!(piece.text, "-" | "+" | "!" | "~" | "&" | "*")
}

/// Whether the text means the same without this pair, between which `level` is the loosest operator.
fn is_idle(pieces: &[Piece<'_>], open: usize, close: usize, level: Level) -> bool {
    let (Some(left), Some(right)) = (left(pieces, open), right(pieces, close)) else { return false };
    let begins_with_sign =
        || pieces[open + 1..close].iter().find(|p| !p.text.is_empty()).is_some_and(is_sign);
    let is_list = |at: Option<&Piece<'_>>| at.is_some_and(|p| p.text == ",");
    let in_list = || is_list(solid_before(pieces, open)) || is_list(solid_after(pieces, close));
    match level {
        Level::Primary => true,
        Level::Open => false,
        _ if left == Level::Bits || right == Level::Bits => false,
        Level::Comparison if left == Level::Comparison || right == Level::Comparison || in_list() => false,
        Level::And | Level::Or if [left, right].iter().any(|l| is_other(level, *l)) => false,
        _ if left != Level::Open && begins_with_sign() => false,
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
        (PieceKind::Mark, _) => last_operator(&pieces[..open]),
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
        (PieceKind::Mark, _) => operator(pieces[close + 1..].iter()),
        _ => None,
    }
}

/// The operator between blanks that `pieces` begin with.
fn operator<'p, 'a: 'p>(pieces: impl Iterator<Item = &'p Piece<'a>>) -> Found {
    let (marks, count) = marks(pieces);
    level_of(&marks[..count])
}

/// The operator between blanks that ends `pieces`.
fn last_operator(pieces: &[Piece<'_>]) -> Found {
    let (mut marks, count) = marks(pieces.iter().rev());
    marks[..count].reverse();
    level_of(&marks[..count])
}

/// The first characters of the marks that come behind blanks, and their number; no operator has more than two.
fn marks<'p, 'a: 'p>(pieces: impl Iterator<Item = &'p Piece<'a>>) -> ([u8; 3], usize) {
    let (mut marks, mut count) = ([0; 3], 0);
    for piece in pieces.skip_while(|piece| piece.kind == PieceKind::Space) {
        let (PieceKind::Mark, Some(place)) = (piece.kind, marks.get_mut(count)) else { break };
        *place = piece.text.as_bytes().first().copied().unwrap_or_default();
        count += 1;
    }
    (marks, count)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emit::scan;

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
            let mut pieces = scan::pieces(with);
            leave_out(&mut pieces);
            let text: String = pieces.iter().map(|piece| piece.text).collect();
            assert_eq!(text, expected, "{with}");
        }
    }
}
