//! The words that no kernel item may be called, and why.
//!
//! A kernel's name is a contract: the declared name is the emitted name, in every target.
//! A writer that meets a reserved word renames the item instead (`half` becomes `half_`), in one
//! language and not in another, and the caller's code breaks on the day a target is added.
//! So a name must be free in *all* shading languages, also in those not written today, and the
//! refusal comes when the item is defined.
//!
//! Refused are keywords, predeclared types, macros, built-in functions (a user function may overload
//! `lerp` in HLSL, but then a reader cannot tell which one is called) and the spellings that a
//! language or naga keeps for itself.
//! Members of structures stand behind a dot and may be called as a built-in function is.

mod words;

use naga::FastHashMap;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::sync::LazyLock;

/// A shading language that has a say in names.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Language {
    /// WebGPU.
    Wgsl,
    /// Direct3D, shader model 6.
    Hlsl,
    /// Vulkan and OpenGL (4.60, ES 3.20).
    Glsl,
    /// Metal.
    Msl,
}

impl fmt::Display for Language {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Wgsl => "WGSL",
            Self::Hlsl => "HLSL",
            Self::Glsl => "GLSL",
            Self::Msl => "MSL",
        })
    }
}

/// What a word already means in a language.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Meaning {
    /// A type.
    Type,
    /// A built-in function.
    Function,
    /// A macro.
    Macro,
    /// Part of the grammar, or kept for its future.
    Keyword,
    /// Declared beforehand: a type, an enumerant or a function.
    Predeclared,
}

impl fmt::Display for Meaning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Keyword => "reserved",
            Self::Type => "a type",
            Self::Predeclared => "predeclared",
            Self::Macro => "a macro",
            Self::Function => "a built-in function",
        })
    }
}

/// Why a name is refused.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum NameError {
    /// No characters.
    #[error("a name has at least one letter")]
    Empty,
    /// A character that some language does not allow, at the beginning or at all.
    #[error(
        "`{name}` contains {character:?} where shading languages want an ASCII letter, digit or underscore \
         (a letter at the beginning)"
    )]
    Character {
        /// The name.
        name: String,
        /// The offending character.
        character: char,
    },
    /// `_x`, `x_` or `a__b`.
    #[error(
        "`{0}` begins or ends with an underscore, or has two in a row; languages and translators keep such \
         names for themselves, so use single underscores inside the name"
    )]
    Underscore(String),
    /// A prefix that belongs to someone else.
    #[error("`{name}` begins with `{prefix}`, which {owner} keeps for itself; choose another name")]
    Prefix {
        /// The name.
        name: String,
        /// How it begins.
        prefix: &'static str,
        /// Whose prefix that is.
        owner: &'static str,
    },
    /// A word that means something already.
    #[error(
        "`{name}` is {meaning}; the emitted name must be the declared one in every language, so choose another"
    )]
    Word {
        /// The name.
        name: String,
        /// What it is, and where: `a type in HLSL and MSL`.
        meaning: String,
    },
}

const PREFIXES: &[(&str, &str)] = &[
    ("LoadedStorageValueFrom", "naga's HLSL writer"),
    ("gl_", "GLSL"),
    ("lobeq", "Lobe's emitter"),
    ("naga", "naga"),
];

/// Checks the name of a function, structure, constant, binding or parameter.
///
/// # Errors
/// When some shading language does not let an item be called so.
pub fn check(name: &str) -> Result<(), NameError> {
    check_spelling(name)?;
    refuse(name, |_| true)
}

/// Checks the name of a structure's member; built-in functions do not stand in its way, but for `length`.
///
/// # Errors
/// When some shading language does not let a member be called so.
pub fn check_member(name: &str) -> Result<(), NameError> {
    check_spelling(name)?;
    // What is behind a dot and called so is GLSL's number of elements, whatever it stands behind.
    let is_method = name == "length";
    refuse(name, |meaning| is_method || !matches!(meaning, Meaning::Function | Meaning::Predeclared))
}

/// What `name` already means, by language; empty for a free word.
pub fn meanings(name: &str) -> Vec<(Meaning, Language)> {
    let mut found = WORDS.get(name).cloned().unwrap_or_default();
    if is_word_in_any_case(name) && !found.iter().any(|&(_, language)| language == Language::Hlsl) {
        found.push((Meaning::Keyword, Language::Hlsl));
    }
    found
}

/// Every word that means something, with the languages in which it does.
pub fn words() -> impl Iterator<Item = (&'static str, BTreeSet<Language>)> {
    WORDS.iter().map(|(word, meanings)| (word.as_str(), meanings.iter().map(|&(_, l)| l).collect()))
}

/// The words that HLSL keeps for itself in any mixture of cases.
pub fn words_in_any_case() -> impl Iterator<Item = &'static str> {
    words::HLSL_ANY_CASE.into_iter()
}

fn is_word_in_any_case(name: &str) -> bool {
    words::HLSL_ANY_CASE.iter().any(|word| word.len() == name.len() && word.eq_ignore_ascii_case(name))
}

fn check_spelling(name: &str) -> Result<(), NameError> {
    let first = name.chars().next().ok_or(NameError::Empty)?;
    let is_portable = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_';
    if first.is_ascii_digit() || !name.bytes().all(is_portable) {
        let offending = |c: &char| !u8::try_from(*c).is_ok_and(is_portable);
        let wrong = name.chars().find(offending).filter(|_| !first.is_ascii_digit());
        let character = wrong.unwrap_or(first);
        return Err(NameError::Character { name: name.to_owned(), character });
    }
    if name.starts_with('_') || name.ends_with('_') || name.as_bytes().windows(2).any(|two| two == b"__") {
        return Err(NameError::Underscore(name.to_owned()));
    }
    match PREFIXES.iter().find(|(prefix, _)| name.starts_with(prefix)) {
        Some(&(prefix, owner)) => Err(NameError::Prefix { name: name.to_owned(), prefix, owner }),
        None => Ok(()),
    }
}

fn refuse(name: &str, counts: impl Fn(Meaning) -> bool) -> Result<(), NameError> {
    // Most names mean nothing, and every name of a module is asked for.
    if !WORDS.contains_key(name) && !is_word_in_any_case(name) {
        return Ok(());
    }
    let mut by_meaning: BTreeMap<Meaning, Vec<Language>> = BTreeMap::new();
    for (meaning, language) in meanings(name).into_iter().filter(|&(meaning, _)| counts(meaning)) {
        by_meaning.entry(meaning).or_default().push(language);
    }
    if by_meaning.is_empty() {
        return Ok(());
    }
    let parts: Vec<String> = by_meaning
        .iter()
        .map(|(meaning, languages)| format!("{meaning} in {}", enumerate(languages)))
        .collect();
    Err(NameError::Word { name: name.to_owned(), meaning: parts.join(", ") })
}

/// `A`, `A and B`, `A, B and C`.
fn enumerate(languages: &[Language]) -> String {
    let names: Vec<String> = languages.iter().map(Language::to_string).collect();
    match names.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
        _ => names.concat(),
    }
}

type Table = FastHashMap<String, Vec<(Meaning, Language)>>;

static WORDS: LazyLock<Table> = LazyLock::new(|| {
    use Language::{Glsl, Hlsl, Msl, Wgsl};
    use Meaning::{Function, Keyword, Macro, Predeclared, Type};
    let mut table = Table::default();
    add(&mut table, Keyword, Wgsl, naga::keywords::wgsl::RESERVED.iter().map(|&w| w.to_owned()));
    let predeclared = naga::keywords::wgsl::BUILTIN_IDENTIFIERS.iter().map(|&w| w.to_owned());
    add(&mut table, Predeclared, Wgsl, predeclared);
    add(&mut table, Type, Wgsl, wgsl_shorthands());
    add(&mut table, Type, Hlsl, words::HLSL_SCALARS.split(' ').flat_map(hlsl_shapes));
    for (meaning, language, list) in [
        (Keyword, Hlsl, words::HLSL_KEYWORDS),
        (Type, Hlsl, words::HLSL_TYPES),
        (Function, Hlsl, words::HLSL_FUNCTIONS),
        (Keyword, Glsl, words::GLSL_KEYWORDS),
        (Type, Glsl, words::GLSL_TYPES),
        (Function, Glsl, words::GLSL_FUNCTIONS),
        (Keyword, Msl, words::MSL_KEYWORDS),
        (Type, Msl, words::MSL_TYPES),
        (Macro, Msl, words::MSL_MACROS),
        (Function, Msl, words::MSL_FUNCTIONS),
    ] {
        add(&mut table, meaning, language, list.split(' ').map(str::to_owned));
    }
    table
});

fn add(table: &mut Table, meaning: Meaning, language: Language, list: impl Iterator<Item = String>) {
    for word in list {
        table.entry(word).or_default().push((meaning, language));
    }
}

/// `vec3f`, `mat2x3h` and their like, which naga's list lacks.
fn wgsl_shorthands() -> impl Iterator<Item = String> {
    let sizes = 2..=4;
    let vectors = sizes.clone().flat_map(|n| ["f", "h", "i", "u"].map(|kind| format!("vec{n}{kind}")));
    let shapes = sizes.flat_map(|c| (2..=4).map(move |r| format!("mat{c}x{r}")));
    vectors.chain(shapes.flat_map(|shape| ["f", "h"].map(|kind| format!("{shape}{kind}"))))
}

/// A scalar type of HLSL, its vectors and its matrices.
fn hlsl_shapes(scalar: &str) -> impl Iterator<Item = String> + '_ {
    let sizes = 1..=4;
    let vectors = sizes.clone().map(move |n| format!("{scalar}{n}"));
    let matrices = sizes.clone().flat_map(move |r| (1..=4).map(move |c| format!("{scalar}{r}x{c}")));
    std::iter::once(scalar.to_owned()).chain(vectors).chain(matrices)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_sorted_and_single_within_each_list() {
        for list in [
            words::HLSL_KEYWORDS,
            words::HLSL_SCALARS,
            words::HLSL_TYPES,
            words::HLSL_FUNCTIONS,
            words::GLSL_KEYWORDS,
            words::GLSL_TYPES,
            words::GLSL_FUNCTIONS,
            words::MSL_KEYWORDS,
            words::MSL_TYPES,
            words::MSL_MACROS,
            words::MSL_FUNCTIONS,
        ] {
            assert!(list.split(' ').is_sorted_by(|a, b| a < b), "{list}");
        }
    }

    #[test]
    fn a_refusal_says_what_the_word_is_and_where() {
        let message = check("half").unwrap_err().to_string();
        assert!(message.starts_with("`half` is a type in HLSL and MSL"), "{message}");
        let message = check("lerp").unwrap_err().to_string();
        assert!(message.starts_with("`lerp` is a built-in function in HLSL;"), "{message}");
    }

    #[test]
    fn members_may_be_called_as_functions_but_not_as_keywords() {
        assert!(check_member("length").is_err(), "GLSL takes it for the method");
        for name in ["distance", "reflect", "lerp"] {
            assert!(check(name).is_err() && check_member(name).is_ok(), "{name}");
        }
        for name in ["half", "float3", "sample", "kernel", "uvec2", "double4x3"] {
            assert!(check_member(name).is_err(), "{name}");
        }
    }

    #[test]
    fn plain_names_are_free() {
        let free =
            "sg_product x x2 f1 axis sharpness log_amplitude expm1_over_x rect a b Sg half_angle RowCount";
        for name in free.split(' ') {
            assert_eq!(check(name), Ok(()), "{name}");
        }
    }
}
