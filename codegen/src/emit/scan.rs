//! Text as words and what stands between them, cut into the items of a module.

/// A piece of text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Piece<'a> {
    /// The characters.
    pub(crate) text: &'a str,
    /// What they are.
    pub(crate) kind: PieceKind,
    /// Of a word, its number among the [words](super::words) of the text, once they are numbered.
    pub(crate) word: u32,
}

impl<'a> Piece<'a> {
    /// A piece; its word has no number yet.
    pub(crate) fn new(text: &'a str, kind: PieceKind) -> Self {
        Self { text, kind, word: 0 }
    }

    /// Whether it is a word, be it behind a dot.
    pub(crate) fn is_word(&self) -> bool {
        matches!(self.kind, PieceKind::Word | PieceKind::Selector)
    }
}

/// What a piece is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PieceKind {
    /// An identifier or keyword.
    Word,
    /// The same behind a dot: a member, a method or a swizzle.
    Selector,
    /// A number, a comment, a string or a line of the preprocessor: never renamed.
    Opaque,
    /// Blanks.
    Space,
    /// A single other character.
    Mark,
}

/// Cuts `text` into pieces; together they are the text.
pub(crate) fn pieces(text: &str) -> Vec<Piece<'_>> {
    // Shaders have a piece for every three characters or so.
    let mut out: Vec<Piece<'_>> = Vec::with_capacity(text.len() / 3);
    let mut rest = text;
    let mut behind_dot = false;
    while let Some(&first) = rest.as_bytes().first() {
        let (mut kind, length) = measure(rest, first);
        if kind == PieceKind::Word && behind_dot {
            kind = PieceKind::Selector;
        }
        let (piece, after) = rest.split_at(length);
        if kind != PieceKind::Space {
            behind_dot = first == b'.';
        }
        out.push(Piece::new(piece, kind));
        rest = after;
    }
    hide_attributes(&mut out);
    out
}

/// Makes attributes opaque: `@builtin(x)` and `register(b0)` name nothing that a user declares.
fn hide_attributes(pieces: &mut [Piece<'_>]) {
    let mut depth = None;
    let mut is_behind_at = false;
    for piece in pieces {
        let is_begin = is_behind_at || piece.is_word() && piece.text == "register";
        is_behind_at = piece.text == "@";
        if depth.is_none() && !is_begin {
            continue;
        }
        depth = match (depth, piece.text) {
            (None, _) if is_begin => Some(0),
            (Some(0), "(") => Some(1),
            // An attribute without parentheses is over.
            (None | Some(0), _) => None,
            (Some(n), "(") => Some(n + 1),
            (Some(1), ")") => None,
            (Some(n), ")") => Some(n - 1),
            (inside, _) => inside,
        };
        if depth.is_some() && piece.kind == PieceKind::Word {
            piece.kind = PieceKind::Opaque;
        }
    }
}

/// What a byte begins.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Begin {
    Word,
    Number,
    Blanks,
    Mark,
    /// What more than one byte tells.
    Other,
}

/// What each byte begins.
const BEGINS: [Begin; 256] = {
    let mut table = [Begin::Other; 256];
    let mut byte = b' ';
    while byte <= b'~' {
        table[byte as usize] = match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'_' => Begin::Word,
            b'0'..=b'9' => Begin::Number,
            b' ' => Begin::Blanks,
            b'/' | b'#' | b'"' => Begin::Other,
            _ => Begin::Mark,
        };
        byte += 1;
    }
    table[b'\n' as usize] = Begin::Blanks;
    table
};

/// Kind and length of the piece that `rest` begins with, whose first byte is given.
fn measure(rest: &str, first: u8) -> (PieceKind, usize) {
    let begin = |byte: u8| BEGINS[usize::from(byte)];
    let is_word = |byte: u8| matches!(begin(byte), Begin::Word | Begin::Number);
    match begin(first) {
        Begin::Word => (PieceKind::Word, run(rest, is_word)),
        Begin::Number => (PieceKind::Opaque, run(rest, |byte| is_word(byte) || byte == b'.')),
        Begin::Blanks => (PieceKind::Space, run(rest, |byte| begin(byte) == Begin::Blanks)),
        Begin::Mark => (PieceKind::Mark, 1),
        Begin::Other => measure_other(rest),
    }
}

/// How many bytes at the beginning are of a kind; the first is.
fn run(rest: &str, is_kept: impl Fn(u8) -> bool) -> usize {
    rest.bytes().skip(1).position(|byte| !is_kept(byte)).map_or(rest.len(), |end| end + 1)
}

/// A comment, a string, a line of the preprocessor, or a blank or mark that is no such byte.
fn measure_other(rest: &str) -> (PieceKind, usize) {
    let length = match rest.as_bytes() {
        [b'#', ..] | [b'/', b'/', ..] => rest.find('\n'),
        [b'/', b'*', ..] => rest.find("*/").map(|i| i + 2),
        [b'"', ..] => string_length(rest),
        _ => {
            let first = rest.chars().next().unwrap_or_default();
            let kind = if first.is_whitespace() { PieceKind::Space } else { PieceKind::Mark };
            return (kind, first.len_utf8());
        }
    };
    (PieceKind::Opaque, length.unwrap_or(rest.len()))
}

fn string_length(rest: &str) -> Option<usize> {
    let mut escaped = true;
    for (i, c) in rest.char_indices() {
        match c {
            '"' if !escaped => return Some(i + 1),
            '\\' => escaped = !escaped,
            _ => escaped = false,
        }
    }
    None
}

/// Cuts pieces into items: each ends with a `;` outside of braces, or with the brace that closes it; a line of the
/// preprocessor is one.
pub(crate) fn items<'p, 'a>(pieces: &'p [Piece<'a>]) -> Vec<&'p [Piece<'a>]> {
    let mut out = Vec::new();
    let (mut start, mut depth) = (0, 0usize);
    for (i, piece) in pieces.iter().enumerate() {
        let ends = match (piece.kind, piece.text.as_bytes()) {
            (PieceKind::Mark, b"{") => {
                depth += 1;
                false
            }
            (PieceKind::Mark, b"}") => {
                depth = depth.saturating_sub(1);
                depth == 0 && next_text(pieces, i) != Some(";")
            }
            (PieceKind::Mark, b";") => depth == 0,
            (PieceKind::Opaque, line) => line.starts_with(b"#") && depth == 0,
            _ => false,
        };
        if ends {
            out.push(&pieces[start..=i]);
            start = i + 1;
        }
    }
    if pieces[start..].iter().any(|p| p.kind != PieceKind::Space) {
        out.push(&pieces[start..]);
    }
    out
}

/// The next piece that is not blank.
fn next_text<'a>(pieces: &[Piece<'a>], index: usize) -> Option<&'a str> {
    pieces[index + 1..].iter().find(|p| p.kind != PieceKind::Space).map(|p| p.text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_add_up_and_know_words_from_comments_and_numbers() {
        let text = "let a.b = x2 /* c */ + 0x1fu * 1.5f; // lobeq é\n\"s\\\"t\" é_";
        let all = pieces(text);
        assert_eq!(all.iter().map(|p| p.text).collect::<String>(), text);
        let words: Vec<&str> = all.iter().filter(|p| p.kind == PieceKind::Word).map(|p| p.text).collect();
        assert_eq!(words, ["let", "a", "x2", "_"]);
        assert!(all.contains(&Piece::new("b", PieceKind::Selector)));
    }

    #[test]
    fn items_end_at_outer_semicolons_and_braces() {
        let all = pieces("struct A { int b; };\nconst int c = 1;\nvoid d() { if (e) { f(); } }\n");
        let texts: Vec<String> = items(&all)
            .into_iter()
            .map(|item| item.iter().map(|p| p.text).collect::<String>().trim().to_owned())
            .collect();
        assert_eq!(texts, ["struct A { int b; };", "const int c = 1;", "void d() { if (e) { f(); } }"]);
    }
}
