//! Extensions of WGSL that naga has, or has nothing of, but whose directives it does not know.
//!
//! Their names are blanked out, so that whatever follows keeps its place. Of an extension that naga lacks the use is
//! then refused, at its own place, and a module that does not use it runs.

use std::borrow::Cow;

/// What WGSL lets a module `enable`, without naga's knowledge.
const ENABLED: [&str; 1] = ["subgroups"];

/// What WGSL lets a module require, without naga's knowledge.
const REQUIRED: [&str; 11] = [
    "buffer_view",
    "fragment_depth",
    "immediate_address_space",
    "linear_indexing",
    "subgroup_id",
    "subgroup_uniformity",
    "swizzle_assignment",
    "texture_and_sampler_let",
    "texture_formats_tier1",
    "uniform_buffer_standard_layout",
    "unrestricted_pointer_parameters",
];

/// `text` without the directives, or the names in them, that naga needs not see; as long as `text`.
pub(crate) fn blanked(text: &str) -> Cow<'_, str> {
    let mut blanks = Vec::new();
    let mut at = skipped(text, 0);
    while let Some(end) = text[at..].find(';').map(|n| at + n) {
        let known = match word(&text[at..end]) {
            "enable" => &ENABLED[..],
            "requires" => &REQUIRED[..],
            "diagnostic" => &[],
            _ => break,
        };
        blank(text, at..end, known, &mut blanks);
        at = skipped(text, end + 1);
    }
    if blanks.is_empty() {
        return Cow::Borrowed(text);
    }
    let mut bytes = text.as_bytes().to_vec();
    for range in blanks {
        bytes[range].iter_mut().filter(|b| **b != b'\n').for_each(|b| *b = b' ');
    }
    Cow::Owned(String::from_utf8_lossy(&bytes).into_owned())
}

/// The word that `text` begins with.
fn word(text: &str) -> &str {
    let end = text.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(text.len());
    &text[..end]
}

/// Where the list of a directive has names that are known, each with its comma; all of the directive if it has no
/// others.
fn blank(
    text: &str,
    directive: std::ops::Range<usize>,
    known: &[&str],
    blanks: &mut Vec<std::ops::Range<usize>>,
) {
    let begin = directive.start + word(&text[directive.clone()]).len();
    let list = &text[begin..directive.end];
    let (mut at, mut is_whole, mut found) = (begin, true, Vec::new());
    for part in list.split_inclusive(',') {
        let name = part.trim_end_matches(',').trim();
        if known.contains(&name) {
            found.push(at..at + part.len());
        } else {
            is_whole &= name.is_empty();
        }
        at += part.len();
    }
    if is_whole && !found.is_empty() {
        blanks.push(directive.start..directive.end + 1);
    } else {
        blanks.append(&mut found);
    }
}

/// The place after spaces and comments.
fn skipped(text: &str, mut at: usize) -> usize {
    loop {
        let rest = text[at..].trim_start();
        at = text.len() - rest.len();
        at += match rest.get(..2) {
            Some("//") => rest.find('\n').unwrap_or(rest.len()),
            Some("/*") => comment(rest),
            _ => return at,
        };
    }
}

/// Bytes of the comment that `text` begins with; comments nest.
fn comment(text: &str) -> usize {
    let (mut depth, mut at) = (0, 0);
    while let Some(pair) = text.as_bytes().get(at..at + 2) {
        match pair {
            b"/*" => depth += 1,
            b"*/" => depth -= 1,
            _ => {
                at += 1;
                continue;
            }
        }
        at += 2;
        if depth == 0 {
            return at;
        }
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_names_are_blanked_in_directives_alone() {
        for (text, expected) in [
            ("enable subgroups;fn f() {}", "                 fn f() {}"),
            ("enable f16, subgroups;", "enable f16,          ;"),
            ("enable subgroups,f16;", "enable           f16;"),
            ("enable subgroups,;", "                  "),
            ("requires subgroup_id,\n buffer_view;", "                     \n             "),
            ("// é\n/* a /* b */ */enable subgroups;", "// é\n/* a /* b */ */                 "),
            ("diagnostic(off, x);enable subgroups;", "diagnostic(off, x);                 "),
        ] {
            assert_eq!(blanked(text), expected, "{text}");
        }
        let kept = [
            "",
            "enable",
            "enable subgroups",
            "enable f16;",
            "enable subgroup;",
            "requires subgroups;",
            "const a = 1; enable subgroups;",
            "/* enable subgroups;",
            "enablesubgroups;",
            "//",
        ];
        for text in kept {
            assert!(matches!(blanked(text), Cow::Borrowed(same) if same == text), "{text}");
        }
    }
}
