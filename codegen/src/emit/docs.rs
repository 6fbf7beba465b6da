//! Doc comments, which no writer of naga prints.
//!
//! `///` in every text target: it is an ordinary comment to the compilers, and the mark of a doc
//! comment to the tools that look for one.

use super::mark::Role;
use naga::{DocComments, Handle, Module, Type};
use std::borrow::Cow;

/// The doc comment of an item, with a line break at its end; empty when there is none.
pub(super) fn item(module: &Module, role: Role) -> String {
    lookup(module, role).map(|lines| comment(lines, "")).unwrap_or_default()
}

/// The doc comment of a structure's member, likewise.
pub(super) fn member(module: &Module, ty: Handle<Type>, index: usize) -> String {
    lookup(module, Role::Member(ty, index)).map(|lines| comment(lines, "    ")).unwrap_or_default()
}

/// The lines as the author wrote them, without comment marks.
pub(super) fn plain(module: &Module, role: Role) -> Vec<String> {
    lookup(module, role).into_iter().flat_map(clean).map(Cow::into_owned).collect()
}

fn lookup(module: &Module, role: Role) -> Option<&[String]> {
    let docs: &DocComments = module.doc_comments.as_deref()?;
    let lines = match role {
        Role::Function(handle) => docs.functions.get(&handle),
        Role::Entry(index) => docs.entry_points.get(&index),
        Role::Struct(ty) => docs.types.get(&ty),
        Role::Member(ty, index) => docs.struct_members.get(&(ty, index)),
        Role::Constant(handle) => docs.constants.get(&handle),
        Role::Global(handle) => docs.global_variables.get(&handle),
        Role::Argument | Role::Local => None,
    };
    lines.map(Vec::as_slice).filter(|lines| !lines.is_empty())
}

fn comment(lines: &[String], indent: &str) -> String {
    let length: usize = lines.iter().map(|line| indent.len() + line.len() + "/// \n".len()).sum();
    let mut out = String::with_capacity(length);
    let mut is_behind_blank = false;
    for line in clean(without_examples(lines)) {
        if line.is_empty() && is_behind_blank {
            continue;
        }
        is_behind_blank = line.is_empty();
        out.push_str(indent);
        out.push_str(if is_behind_blank { "///" } else { "/// " });
        out.push_str(&without_links(&line));
        out.push('\n');
    }
    out
}

/// Without code blocks, which are examples in Rust, and blank lines that they leave at the end.
fn without_examples(lines: &[String]) -> Vec<&String> {
    let mut inside = false;
    let is_kept = |line: &&String| {
        let is_fence = strip_marks(line).trim_start().starts_with("```");
        let keep = !inside && !is_fence;
        inside ^= is_fence;
        keep
    };
    let mut kept: Vec<&String> = lines.iter().filter(is_kept).collect();
    while kept.last().is_some_and(|line| strip_marks(line).is_empty()) {
        kept.pop();
    }
    kept
}

/// One line each, and nothing in it that would end the comment or drag the next line into it.
fn clean<'a>(lines: impl IntoIterator<Item = &'a String>) -> impl Iterator<Item = Cow<'a, str>> {
    lines.into_iter().flat_map(|text| text.split('\n')).map(|line| {
        let line = strip_marks(line);
        // In HLSL a backslash at the end continues the comment on the next line.
        let is_end = |c: char| c.is_whitespace() || c == '\\';
        match without_breaks(line) {
            Cow::Borrowed(line) => Cow::Borrowed(line.trim_end_matches(is_end)),
            Cow::Owned(line) => Cow::Owned(line.trim_end_matches(is_end).to_owned()),
        }
    })
}

/// Text without line breaks: every one that WGSL knows, and control characters, become blanks.
pub(super) fn without_breaks(text: &str) -> Cow<'_, str> {
    let is_break = |c: char| c.is_control() || matches!(c, '\u{2028}' | '\u{2029}');
    // Printable ASCII has none; all bytes are looked at, many at once.
    let is_plain = text.bytes().fold(true, |is_plain, byte| is_plain & matches!(byte, b' '..=b'~'));
    if is_plain || !text.contains(is_break) {
        return Cow::Borrowed(text);
    }
    text.chars().map(|c| if is_break(c) { ' ' } else { c }).collect::<String>().into()
}

/// Links to other items are Rust's: here their names will do.
pub(super) fn without_links(line: &str) -> Cow<'_, str> {
    let behind = line.as_bytes().get(1..).unwrap_or_default();
    let two = line.as_bytes().iter().zip(behind);
    // All bytes are looked at, many at once.
    let is_linked = |two| matches!(two, (b'[', b'`') | (b'`', b']'));
    match two.fold(false, |found, (&first, &second)| found | is_linked((first, second))) {
        true => unlinked(line).into(),
        false => line.into(),
    }
}

/// A line without brackets around code.
fn unlinked(line: &str) -> String {
    let mut out = String::with_capacity(line.len());
    let mut rest = line;
    while let Some((before, behind)) = rest.split_once('`') {
        out.push_str(before.strip_suffix('[').unwrap_or(before));
        out.push('`');
        rest = behind.strip_prefix(']').unwrap_or(behind);
    }
    out + rest
}

/// Front ends keep the comment marks, definitions do not.
fn strip_marks(line: &str) -> &str {
    let line = line.trim_end();
    let start = line.trim_start();
    if !start.starts_with('/') {
        return line;
    }
    for mark in ["///", "//!", "/**"] {
        if let Some(rest) = start.strip_prefix(mark) {
            let rest = rest.strip_suffix("*/").filter(|_| mark == "/**").unwrap_or(rest);
            return rest.strip_prefix(' ').unwrap_or(rest);
        }
    }
    line
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn examples_in_rust_stay_behind() {
        let lines = ["A.", "", "```", "assert!(true);", "```", ""].map(str::to_owned);
        assert_eq!(comment(&lines, ""), "/// A.\n");
    }

    #[test]
    fn links_become_names_and_blank_lines_single() {
        let lines = ["As [`erf`] of [x].", "", "", "B."].map(str::to_owned);
        assert_eq!(comment(&lines, ""), "/// As `erf` of [x].\n///\n/// B.\n");
    }

    #[test]
    fn no_line_leaves_its_comment() {
        let lines = ["/// a\\".to_owned(), "b\u{2028}c\rd\\ \\".to_owned(), String::new(), "e\nf".to_owned()];
        assert_eq!(comment(&lines, ""), "/// a\n/// b c d\n///\n/// e\n/// f\n");
    }
}
