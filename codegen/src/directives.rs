//! First lines that naga does not know, before a module that it may know all the same.
//!
//! Extensions of WGSL that naga has, or has nothing of: their names are blanked out, so that whatever follows keeps its
//! place. Of an extension that naga lacks the use is then refused, at its own place, and a module that does not use it
//! runs. In GLSL it is the version.

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

/// Versions of GLSL that have compute shaders, but that naga does not know by name.
const VERSIONS: [&str; 4] = ["310", "320", "420", "430"];

/// GLSL with its version raised to 450, which has all of theirs; as long as `text`.
pub(crate) fn versioned(text: &str) -> Cow<'_, str> {
    let at = skipped(text, 0);
    let Some(line) = text[at..].lines().next().filter(|line| line.starts_with("#version")) else {
        return Cow::Borrowed(text);
    };
    let mut words = line.split_whitespace().skip(1);
    let is_known = words.next().is_some_and(|version| VERSIONS.contains(&version));
    if !is_known || line.contains("//") {
        return Cow::Borrowed(text);
    }
    let raised = format!("{:width$}", "#version 450", width = line.len());
    Cow::Owned(format!("{}{raised}{}", &text[..at], &text[at + line.len()..]))
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
    fn versions_with_compute_shaders_are_raised() {
        for (text, expected) in [
            ("#version 310 es\nvoid", "#version 450   \nvoid"),
            ("// a\n#version 430 core\n", "// a\n#version 450     \n"),
            ("#version 430", "#version 450"),
        ] {
            assert_eq!(versioned(text), expected);
        }
        for text in ["", "#version", "#version 450", "#version 300 es", "#define X\n#version 430"] {
            assert_eq!(versioned(text), text);
        }
    }

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
