//! The command that runs a job again.

use super::job::{Entry, Job};

impl Job {
    /// `lobe run` with all that this job says, on `route` alone.
    ///
    /// `entry` is the entry point; what is the same without a word is left out.
    #[must_use]
    pub fn command(&self, entry: Option<&str>, route: &str) -> String {
        let mut words = vec!["lobe".to_owned(), "run".to_owned(), self.file.display().to_string()];
        let mut say = |name: &str, value: String| words.extend([format!("--{name}"), value]);
        let named = match &self.entry {
            Entry::Named(name) => Some(name.as_str()),
            Entry::Only => None,
            Entry::Each => entry,
        };
        named.into_iter().for_each(|name| say("entry", name.to_owned()));
        if self.workgroups != [1; 3] {
            say("workgroups", self.workgroups.map(|n| n.to_string()).join(","));
        }
        self.inputs.iter().for_each(|(name, feed)| say("input", format!("{name}={feed}")));
        if self.usual != super::job::usual() {
            say("fill", self.usual.to_string());
        }
        self.sizes.iter().for_each(|(name, size)| say("size", format!("{name}={size}")));
        self.elements.iter().for_each(|(name, count)| say("elements", format!("{name}={count}")));
        for (name, sketch) in &self.textures {
            say("texture", format!("{name}={}", String::from(sketch.clone())));
        }
        for (name, sampler) in &self.samplers {
            say("sampler", format!("{name}={}", String::from(sampler.clone())));
        }
        self.within.iter().for_each(|(name, bound)| say("within", format!("{name}={bound}")));
        self.overrides.iter().for_each(|(name, value)| say("override", format!("{name}={value}")));
        if self.fuel != super::job::FUEL {
            say("fuel", self.fuel.to_string());
        }
        self.model.iter().for_each(|model| say("model", model.clone()));
        say("route", route.to_owned());
        words.iter().map(|word| quoted(word)).collect::<Vec<_>>().join(" ")
    }
}

/// A word as a shell reads it.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_=:,./@+%".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        return word.to_owned();
    }
    format!("'{}'", word.replace('\'', "'\\''"))
}
