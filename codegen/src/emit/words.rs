//! The words of a text, numbered, and what each stands for: found out once, however often a word is there.

use super::mark::{LENGTH, Mark, Marks, PREFIX, Role};
use super::scan::{Piece, PieceKind};
use naga::FastHashMap as HashMap;
use std::borrow::Cow;

/// A word of a text.
pub(super) struct Word<'a> {
    /// Its letters.
    pub(super) text: &'a str,
    /// The word with the declared names in place of the marks inside it.
    pub(super) spelled: Cow<'a, str>,
    /// The mark that it begins with.
    pub(super) mark: Option<&'a Mark>,
    /// Whether it names something by itself, and is not only found behind dots.
    pub(super) is_free: bool,
    /// Whether another word is spelled like it.
    pub(super) is_shared: bool,
}

impl<'a> Word<'a> {
    fn new(text: &'a str, marks: &'a Marks) -> Self {
        let spelled = spelled(text, marks);
        Self { text, spelled, mark: marks.at(text), is_free: false, is_shared: false }
    }

    /// Whether it is a mark, and nothing more.
    pub(super) fn is_whole_mark(&self) -> bool {
        self.mark.is_some() && self.text.len() == LENGTH
    }

    /// What the mark stands for that it begins with.
    pub(super) fn role(&self) -> Option<Role> {
        self.mark.map(|mark| mark.role)
    }
}

/// The words of a text.
pub(super) struct Words<'a>(Vec<Word<'a>>);

impl<'a> Words<'a> {
    /// Finds the words of a text and tells each piece the number of its word.
    pub(super) fn number(pieces: &mut [Piece<'a>], marks: &'a Marks) -> Self {
        // Kernels with all that they call have a hundred words or two.
        let mut numbers: HashMap<&'a str, u32> = HashMap::with_capacity_and_hasher(256, Default::default());
        let mut words = Vec::new();
        for piece in pieces.iter_mut().filter(|piece| piece.is_word()) {
            piece.word = *numbers.entry(piece.text).or_insert_with(|| {
                words.push(Word::new(piece.text, marks));
                words.len() as u32 - 1
            });
            words[piece.word as usize].is_free |= piece.kind == PieceKind::Word;
        }
        share(&mut words);
        Self(words)
    }

    /// The word with this number.
    pub(super) fn at(&self, number: u32) -> &Word<'a> {
        &self.0[number as usize]
    }

    /// The word of a piece, if it is one.
    pub(super) fn of(&self, piece: &Piece<'_>) -> Option<&Word<'a>> {
        piece.is_word().then(|| self.at(piece.word))
    }

    /// All words.
    pub(super) fn iter(&self) -> impl Iterator<Item = &Word<'a>> {
        self.0.iter()
    }

    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }
}

/// Finds the words that are spelled alike.
fn share(words: &mut [Word<'_>]) {
    let mut first = HashMap::with_capacity_and_hasher(words.len(), Default::default());
    for i in 0..words.len() {
        let other = *first.entry(words[i].spelled.clone()).or_insert(i);
        words[other].is_shared |= other != i;
        words[i].is_shared |= other != i;
    }
}

/// A word with the declared names in place of the marks inside it.
fn spelled<'a>(word: &'a str, marks: &'a Marks) -> Cow<'a, str> {
    let Some(first) = mark_in(word) else { return Cow::Borrowed(word) };
    match marks.at(word) {
        Some(mark) if word.len() == LENGTH => return Cow::Borrowed(&mark.exact),
        _ => {}
    }
    let (mut out, mut rest, mut next) = (String::new(), word, Some(first));
    while let Some(at) = next {
        out.push_str(&rest[..at]);
        let known = marks.at(&rest[at..]);
        out.push_str(known.map_or(PREFIX, |mark| &mark.exact));
        rest = &rest[at + if known.is_some() { LENGTH } else { PREFIX.len() }..];
        next = mark_in(rest);
    }
    out.push_str(rest);
    Cow::Owned(out)
}

/// Where what may be a mark begins.
fn mark_in(word: &str) -> Option<usize> {
    word.as_bytes().windows(PREFIX.len()).position(|bytes| bytes == PREFIX.as_bytes())
}
