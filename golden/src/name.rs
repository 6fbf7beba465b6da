//! Names of goldens: what becomes a path is checked by a strict grammar.

use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;

/// Bytes of a name, at most.
const MOST: usize = 64;
/// Names that are devices on some systems, whatever the ending.
const DEVICES: [&str; 4] = ["con", "prn", "aux", "nul"];

/// A part of a golden's name: 1 to 64 of `a-z`, `0-9`, `_` and `-`, a letter or digit first, and no name of a device.
///
/// ```
/// use lobe_golden::Name;
///
/// assert!("rect-quadrature".parse::<Name>().is_ok());
/// assert!("../secrets".parse::<Name>().is_err());
/// ```
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Name(String);

/// A golden's name: scene and method, written `scene/method`.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct CaseName {
    /// The scene, or `plots`.
    pub scene: Name,
    /// The method, or the plot's name.
    pub method: Name,
}

/// Why a text is no name.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "`{}` is no name{}: take 1 to 64 of a-z, 0-9, _ and -, a letter or digit first, and none that is a device elsewhere",
    shown(text),
    if *is_whole { " of a golden, which is SCENE/METHOD" } else { "" }
)]
pub struct NameError {
    text: String,
    is_whole: bool,
}

/// A text for a message: short, and without what a terminal would obey.
fn shown(text: &str) -> String {
    let plain: String = text.chars().take(MOST).flat_map(char::escape_default).collect();
    if text.chars().count() > MOST { plain + ".." } else { plain }
}

impl Name {
    /// The text.
    #[must_use]
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

fn is_name(text: &str) -> bool {
    let inner = |c: u8| c.is_ascii_lowercase() || c.is_ascii_digit() || c == b'_' || c == b'-';
    let first = |c: u8| inner(c) && c != b'_' && c != b'-';
    let is_port = |text: &str| {
        let number = text.strip_prefix("com").or_else(|| text.strip_prefix("lpt"));
        number.is_some_and(|n| n.len() == 1 && n.as_bytes()[0].is_ascii_digit())
    };
    text.len() <= MOST
        && text.bytes().next().is_some_and(first)
        && text.bytes().all(inner)
        && !DEVICES.contains(&text)
        && !is_port(text)
}

impl FromStr for Name {
    type Err = NameError;

    fn from_str(text: &str) -> Result<Self, NameError> {
        match is_name(text) {
            true => Ok(Self(text.to_owned())),
            false => Err(NameError { text: text.to_owned(), is_whole: false }),
        }
    }
}

impl TryFrom<String> for Name {
    type Error = NameError;

    fn try_from(text: String) -> Result<Self, NameError> {
        text.parse()
    }
}

impl From<Name> for String {
    fn from(name: Name) -> Self {
        name.0
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl fmt::Display for CaseName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.scene, self.method)
    }
}

impl FromStr for CaseName {
    type Err = NameError;

    fn from_str(text: &str) -> Result<Self, NameError> {
        let parts = text.split_once('/').filter(|(scene, method)| is_name(scene) && is_name(method));
        let (scene, method) = parts.ok_or_else(|| NameError { text: text.to_owned(), is_whole: true })?;
        Ok(Self { scene: Name(scene.to_owned()), method: Name(method.to_owned()) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, is_good: bool) {
        assert_eq!(text.parse::<Name>().is_ok(), is_good, "{text:?}");
        let json = serde_json::Value::String(text.to_owned());
        assert_eq!(serde_json::from_value::<Name>(json).is_ok(), is_good, "{text:?}");
    }

    #[test]
    fn only_plain_names_are_names() {
        for good in
            ["a", "0", "cornell_L0".to_lowercase().as_str(), "rect-laplace-fast", &"a".repeat(64), "con1"]
        {
            check(good, true);
        }
        let long = "a".repeat(300);
        for bad in [
            "",
            ".",
            "..",
            "../a",
            "a/../b",
            "a/b",
            "/a",
            "a\\b",
            "a\0",
            "\0",
            "-a",
            "_a",
            "A",
            "é",
            "a b",
            "a.",
            "con",
            "nul",
            "com1",
            "lpt9",
            "\"><script>",
            "a\u{202e}b",
            "\u{430}",
            &long,
            &"a".repeat(65),
        ] {
            check(bad, false);
        }
    }

    #[test]
    fn a_message_is_short_and_plain() {
        let message = format!("{}\0\u{1b}[31m", "x".repeat(3)).parse::<Name>().unwrap_err().to_string();
        assert!(message.contains("xxx\\u{0}\\u{1b}[31m"), "{message}");
        assert!("b".repeat(5000).parse::<CaseName>().unwrap_err().to_string().len() < 300);
    }

    #[test]
    fn a_golden_has_two_names() {
        assert_eq!("a/b".parse::<CaseName>().unwrap().to_string(), "a/b");
        for bad in ["a", "a/", "/b", "a/b/c", "../b", "a/..", "a//b"] {
            assert!(bad.parse::<CaseName>().is_err(), "{bad}");
        }
    }
}
