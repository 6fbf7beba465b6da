//! What of a file was passed over or changed.

use gltf::Document;

/// Sentences, each with the names of what it is said of.
#[derive(Debug, Default)]
pub(super) struct Notes(Vec<(String, Vec<String>)>);

/// Names that a sentence lists.
const LISTED: usize = 5;

/// Extensions that are read.
const KNOWN: [&str; 4] =
    ["KHR_lights_punctual", "KHR_materials_ior", "KHR_materials_specular", "KHR_texture_transform"];

impl Notes {
    /// Says `sentence` of `name`, once.
    pub(super) fn say(&mut self, sentence: &str, name: impl Into<String>) {
        let name = name.into();
        match self.0.iter_mut().find(|(said, _)| said == sentence) {
            Some((_, names)) if names.contains(&name) => {}
            Some((_, names)) => names.push(name),
            None => self.0.push((sentence.to_owned(), vec![name])),
        }
    }

    /// What is said of the file as a whole.
    pub(super) fn of_document(&mut self, document: &Document) {
        for extension in document.extensions_used().filter(|name| !KNOWN.contains(name)) {
            self.say("an extension is passed over", extension);
        }
        if document.animations().len() > 0 {
            self.say("animations are passed over, everything stands where its node says", "");
        }
    }

    /// All of them, in the order in which they came up.
    pub(super) fn sentences(self) -> Vec<String> {
        self.0.iter().map(|(sentence, names)| told(sentence, names)).collect()
    }
}

fn told(sentence: &str, names: &[String]) -> String {
    let listed: Vec<&str> =
        names.iter().map(String::as_str).filter(|name| !name.is_empty()).take(LISTED).collect();
    match (listed.len(), names.len().saturating_sub(LISTED)) {
        (0, _) => sentence.to_owned(),
        (_, 0) => format!("{sentence}: {}", listed.join(", ")),
        (_, others) => format!("{sentence}: {}, and {others} more", listed.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sentence_is_said_once_with_its_names() {
        let mut notes = Notes::default();
        for i in 0..8 {
            notes.say("textures are passed over", format!("m{}", i % 7));
        }
        notes.say("all is well", "");
        let said = notes.sentences();
        assert_eq!(said, ["textures are passed over: m0, m1, m2, m3, m4, and 2 more", "all is well"]);
    }
}
