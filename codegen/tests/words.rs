//! `macros/words.txt`, the words that no kernel item may be called, holds what naga knows of WGSL.
//!
//! `LOBE_BLESS=1 cargo test -p lobe-codegen --test words` writes the file anew; the words of the other
//! languages stay as they are, since naga keeps its lists of them to itself.

use naga::keywords::wgsl::{BUILTIN_IDENTIFIERS, RESERVED};
use std::collections::{BTreeMap, BTreeSet};

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/macros/words.txt");

/// Words with their languages; `~` before a word stays with it.
type Words = BTreeMap<String, BTreeSet<String>>;

fn parse(text: &str) -> Words {
    let rows = text.lines().filter(|l| !l.starts_with('#'));
    rows.map(|line| {
        let (word, languages) = line.split_once(' ').unwrap_or_else(|| panic!("no language in {line:?}"));
        (word.to_owned(), languages.split(", ").map(str::to_owned).collect())
    })
    .collect()
}

fn render(words: &Words) -> String {
    let mut text = "# Words that a target reserves or predeclares; the languages follow each.\n\
                    # `~` marks a word that is taken in any mixture of cases.\n"
        .to_owned();
    for (word, languages) in words {
        let languages: Vec<&str> = languages.iter().map(String::as_str).collect();
        text += &format!("{word} {}\n", languages.join(", "));
    }
    text
}

/// Whether a rule of the macro refuses the name anyhow.
fn is_ruled_out(word: &str) -> bool {
    word.starts_with('_') || word.ends_with('_') || word.contains("__")
}

/// The words with those of WGSL taken from naga.
fn with_wgsl_of_naga(mut words: Words) -> Words {
    words.values_mut().for_each(|languages| {
        languages.remove("WGSL");
    });
    for word in RESERVED.iter().chain(BUILTIN_IDENTIFIERS).filter(|w| !is_ruled_out(w)) {
        words.entry((*word).to_owned()).or_default().insert("WGSL".to_owned());
    }
    words.retain(|_, languages| !languages.is_empty());
    words
}

#[test]
fn the_words_are_those_of_naga() {
    let text = std::fs::read_to_string(FILE).expect("the words");
    let wanted = render(&with_wgsl_of_naga(parse(&text)));
    if std::env::var_os("LOBE_BLESS").is_some_and(|v| v == "1") {
        std::fs::write(FILE, wanted).expect("the words are written");
        return;
    }
    assert!(text == wanted, "{FILE} is stale: run this test with LOBE_BLESS=1 and read the difference");
}

/// Each language is there, with words that a kernel might well use.
#[test]
fn each_language_has_its_say() {
    let words = parse(include_str!("../macros/words.txt"));
    for (language, word) in
        [("WGSL", "target"), ("HLSL", "line"), ("HLSL", "float4"), ("GLSL", "output"), ("MSL", "constant")]
    {
        assert!(words.get(word).is_some_and(|l| l.contains(language)), "{word} of {language}");
    }
    assert!(words.contains_key("~pass"));
    assert!(words.keys().all(|w| !is_ruled_out(w)));
}
