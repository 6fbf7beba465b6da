//! Faults in the text that is emitted: a translator's, or a user's who pastes it.

use super::fault::{Edit, Kind, Mutant};
use lobe_backends::executor::Program;
use lobe_codegen::emit::{Options, Target, emit};
use std::ops::Range;

/// Every literal's last digit and every operator of the kernel's own function in WGSL.
#[must_use]
pub fn faults(program: &Program) -> Vec<Mutant> {
    let options = Options { docs: false, header: false, ..Options::default() };
    let Ok(artifact) = emit(program.module(), Target::Wgsl, &options) else { return Vec::new() };
    let Some(text) = artifact.content.text() else { return Vec::new() };
    let own = function(text, program.name());
    let mut all: Vec<Change> = literals(text).into_iter().filter_map(|l| last_digit(text, l)).collect();
    all.extend(operators(text));
    all.retain(|(_, at, ..)| own.contains(at));
    let with = |(kind, at, change, text): Change| Mutant {
        kind,
        function: program.name().to_owned(),
        place: None,
        change: format!("line {}: {change}", text_line(&text, at)),
        edit: Edit::Text(text),
    };
    all.into_iter().map(with).collect()
}

/// Where the function of this name stands.
fn function(text: &str, name: &str) -> Range<usize> {
    let start = text.find(&format!("fn {name}(")).unwrap_or(text.len());
    let end = text[start..].find("\n}").map_or(text.len(), |length| start + length);
    start..end
}

/// A kind, where, what, and the text with it.
type Change = (Kind, usize, String, String);

fn text_line(text: &str, at: usize) -> usize {
    text[..at].matches('\n').count() + 1
}

/// The parts of the text that are code: no comments.
fn code(text: &str) -> Vec<(usize, usize)> {
    let mut parts = Vec::new();
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let end = line.find("//").unwrap_or(line.len());
        parts.push((at, at + end));
        at += line.len();
    }
    parts
}

/// Where float literals stand.
fn literals(text: &str) -> Vec<(usize, usize)> {
    let bytes = text.as_bytes();
    let is_word = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_' || byte == b'.';
    let mut found = Vec::new();
    for (from, to) in code(text) {
        let mut at = from;
        while at < to {
            let start = at;
            // The sign of an exponent is part of its number.
            let is_signed = |at: usize| {
                matches!(bytes[at], b'+' | b'-') && bytes[at - 1] == b'e' && bytes[start].is_ascii_digit()
            };
            while at < to && (is_word(bytes[at]) || (at > start && is_signed(at))) {
                at += 1;
            }
            let word = &text[start..at];
            if word.starts_with(|c: char| c.is_ascii_digit()) && word.contains('.') {
                found.push((start, at));
            }
            at = at.max(start + 1);
        }
    }
    found
}

/// The literal with its last digit one more: 9 becomes 8.
fn last_digit(text: &str, (start, end): (usize, usize)) -> Option<Change> {
    let literal = &text[start..end];
    // Digits of an exponent are no last digits of the number, and a fraction of zeros says that it is whole.
    let mantissa = literal.split(['e', 'f', 'h']).next()?;
    let significant = mantissa.trim_end_matches('0').trim_end_matches('.');
    let digit = significant.chars().last().filter(char::is_ascii_digit)?;
    let at = start + significant.len() - 1;
    let other = if digit == '9' { '8' } else { (digit as u8 + 1) as char };
    let changed = format!("{}{other}{}", &text[..at], &text[at + 1..]);
    let now = &changed[start..end];
    Some((Kind::LastDigit, at, format!("{literal} becomes {now}"), changed))
}

/// Operators between blanks, each once.
fn operators(text: &str) -> Vec<Change> {
    let pairs = [
        (" + ", " - "),
        (" - ", " + "),
        (" * ", " / "),
        (" / ", " * "),
        (" < ", " > "),
        (" > ", " < "),
        (" <= ", " >= "),
        (" >= ", " <= "),
        (" == ", " != "),
        (" != ", " == "),
        (" && ", " || "),
        (" || ", " && "),
    ];
    let mut all = Vec::new();
    for (from, to) in code(text) {
        for (operator, other) in pairs {
            for (at, _) in text[from..to].match_indices(operator) {
                let at = from + at;
                let changed = format!("{}{other}{}", &text[..at], &text[at + operator.len()..]);
                let line = text[from..to].trim();
                all.push((Kind::TextOperator, at, format!("{operator}becomes{other}in `{line}`"), changed));
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literals_lose_their_last_digit_and_comments_do_not() {
        let text = "// 1.5\nlet x = 0.25 + 3.0e-5 * y2.x; // 7.5\n";
        let found: Vec<&str> = literals(text).into_iter().map(|(a, b)| &text[a..b]).collect();
        assert_eq!(found, ["0.25", "3.0e-5"]);
        let changes: Vec<String> =
            literals(text).into_iter().filter_map(|l| last_digit(text, l)).map(|c| c.2).collect();
        assert_eq!(changes, ["0.25 becomes 0.26", "3.0e-5 becomes 4.0e-5"]);
        assert_eq!(operators(text).len(), 2);
    }
}
