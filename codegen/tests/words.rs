//! `macros/words.txt`, the words that the macro refuses, is the table of `lobe_codegen::names`.
//!
//! A procedural macro cannot ask the crate that uses it, so the table is written out;
//! `LOBE_BLESS=1 cargo test -p lobe-codegen --test words` writes it anew.

use lobe_codegen::names;
use std::collections::BTreeSet;

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/macros/words.txt");

/// Whether a rule of the macro refuses the name anyhow.
fn is_ruled_out(word: &str) -> bool {
    word.starts_with('_') || word.ends_with('_') || word.contains("__")
}

fn render() -> String {
    let mut rows: BTreeSet<String> = names::words_in_any_case().map(|word| format!("~{word} HLSL")).collect();
    for (word, languages) in names::words().filter(|(word, _)| !is_ruled_out(word)) {
        let languages: Vec<String> = languages.iter().map(ToString::to_string).collect();
        rows.insert(format!("{word} {}", languages.join(", ")));
    }
    let head = "# Words that a target reserves or predeclares; the languages follow each.\n\
                # `~` marks a word that is taken in any mixture of cases.\n";
    rows.iter().fold(head.to_owned(), |text, row| text + row + "\n")
}

#[test]
fn the_words_are_those_of_the_table() {
    let text = std::fs::read_to_string(FILE).expect("the words");
    let wanted = render();
    if std::env::var_os("LOBE_BLESS").is_some_and(|v| v == "1") {
        std::fs::write(FILE, wanted).expect("the words are written");
        return;
    }
    assert!(text == wanted, "{FILE} is stale: run this test with LOBE_BLESS=1 and read the difference");
}

/// Each language is there, with words that a kernel might well use.
#[test]
fn each_language_has_its_say() {
    let text = render();
    for row in ["target WGSL", "line HLSL", "float4 HLSL", "output GLSL", "constant MSL"] {
        let (word, language) = row.split_once(' ').expect("two words");
        let is_there = text.lines().any(|l| {
            l.split_once(' ').is_some_and(|(w, languages)| w == word && languages.contains(language))
        });
        assert!(is_there, "{row}");
    }
    assert!(text.contains("\n~pass HLSL\n"));
}
