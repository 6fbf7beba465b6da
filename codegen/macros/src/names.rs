//! Names: what is refused at the definition, since it could not be emitted as it is.

use crate::errors::Errors;
use proc_macro2::Ident;

/// Words that some target reserves or predeclares, `word language` a line (see the file's head).
const WORDS: &str = include_str!("../words.txt");

/// Notes a name that some target could not carry.
pub(crate) fn check(name: &Ident, errors: &mut Errors) {
    let text = crate::scope::plain(name);
    if let Some(reason) = reason(&text) {
        errors.at(name, format!("`{text}` cannot be emitted under this name: {reason}; choose another"));
    }
}

fn reason(name: &str) -> Option<String> {
    if !name.is_ascii() {
        return Some("shading languages want ASCII letters, digits and `_`".to_owned());
    }
    if name.starts_with('_') || name.ends_with('_') || name.contains("__") {
        return Some(
            "`_` at an end, or doubled, is reserved in GLSL or WGSL, or dropped by writers".to_owned(),
        );
    }
    if name.starts_with("gl_") || name.to_ascii_lowercase().starts_with("naga") {
        return Some("the prefix is reserved".to_owned());
    }
    WORDS.lines().filter(|l| !l.starts_with('#')).find_map(|line| {
        let (word, languages) = line.split_once(' ')?;
        let is_taken = match word.strip_prefix('~') {
            Some(word) => word.eq_ignore_ascii_case(name),
            None => word == name,
        };
        is_taken.then(|| format!("it is a word of {languages}"))
    })
}
