//! Faults of others that are known: what a route gets wrong, and why that is not ours to mend.
//!
//! A file of them is TOML, one `[[expected]]` each. An expectation that no longer holds is as bad as a fault that none
//! expects: the list says what is true of these drivers today.

use crate::cases::Cases;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// The file of expectations in a folder of cases.
pub const FILE: &str = "expectations.toml";

/// How a route ends that gets something wrong.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Fault {
    /// Its results lie outside the bound.
    Beyond,
    /// A compiler or the driver does not take the shader, so there are no results.
    Refused,
    /// Floats differ, and nothing says by how much they may.
    Unjudged,
    /// It did not end in time.
    Timeout,
    /// It crashed or panicked.
    Crashed,
    /// Its results are not those of the other routes on its driver, bit for bit; asked of kernels only.
    Differs,
}

impl Fault {
    /// Its name in files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Beyond => "beyond",
            Self::Refused => "refused",
            Self::Unjudged => "unjudged",
            Self::Timeout => "timeout",
            Self::Crashed => "crashed",
            Self::Differs => "differs",
        }
    }
}

/// One known fault.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Expectation {
    /// The kernel's name, or the shader's file name without its ending; `*` stands for anything.
    pub subject: String,
    /// The route; `*` stands for anything.
    pub route: String,
    /// What the driver says of itself contains this; any driver's words if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub driver: Option<String>,
    /// How the route ends.
    pub fails: Fault,
    /// Why, and how we know.
    pub reason: String,
    /// Where it is reported or discussed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub link: Option<String>,
}

/// The form of a file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    expected: Vec<Expectation>,
}

/// Why a file of expectations is none.
#[derive(Debug, thiserror::Error)]
pub enum ExpectationError {
    /// It is not there, or no text.
    #[error("{path}: cannot be read: {cause}")]
    Read {
        /// The file.
        path: String,
        /// Why.
        cause: std::io::Error,
    },
    /// It is not of the form.
    #[error("{path}: {cause}")]
    Form {
        /// The file.
        path: String,
        /// Where, and what is wanted there.
        cause: Box<toml::de::Error>,
    },
    /// It gives no reason.
    #[error("{path}: the expectation of `{subject}` by {route} has no reason; say why, and how you know")]
    NoReason {
        /// The file.
        path: String,
        /// Of what.
        subject: String,
        /// By which route.
        route: String,
    },
}

/// The expectations of a file.
///
/// # Errors
/// When it cannot be read, is of another form, or has an expectation without a reason.
pub fn read(path: &Path) -> Result<Vec<Expectation>, ExpectationError> {
    let name = || path.display().to_string();
    let text =
        std::fs::read_to_string(path).map_err(|cause| ExpectationError::Read { path: name(), cause })?;
    let file: File = toml::from_str(&text)
        .map_err(|cause| ExpectationError::Form { path: name(), cause: Box::new(cause) })?;
    match file.expected.iter().find(|e| e.reason.trim().is_empty()) {
        None => Ok(file.expected),
        Some(e) => {
            let (subject, route) = (e.subject.clone(), e.route.clone());
            Err(ExpectationError::NoReason { path: name(), subject, route })
        }
    }
}

/// The expectations in a folder of cases; a folder without the [`FILE`] has none.
///
/// # Errors
/// As of [`read`].
pub fn of_cases(cases: &Cases) -> Result<Vec<Expectation>, ExpectationError> {
    let path = cases.folder().join(FILE);
    if path.exists() { read(&path) } else { Ok(Vec::new()) }
}

impl Expectation {
    /// Whether it is about this kernel or shader.
    #[must_use]
    pub fn is_of(&self, subject: &str) -> bool {
        matches(&self.subject, subject)
    }

    /// Whether it is about this route, to a driver that says this of itself.
    #[must_use]
    pub fn is_by(&self, route: &str, driver: &str) -> bool {
        matches(&self.route, route) && self.driver.as_ref().is_none_or(|part| driver.contains(part))
    }

    /// Why it is no matter that the route ended as it did, by this name; else what is wrong with that.
    ///
    /// # Errors
    /// When the route was expected to end otherwise.
    pub fn excuse(&self, ended: &str) -> Result<String, String> {
        if ended == self.fails.name() {
            return Ok(self.told());
        }
        Err(format!(
            "it is {ended}, not {} as expected ({}): the expectation has to go or to change",
            self.fails.name(),
            self.told()
        ))
    }

    /// The reason, and where more is said.
    #[must_use]
    pub fn told(&self) -> String {
        match &self.link {
            Some(link) => format!("{}, {link}", self.reason),
            None => self.reason.clone(),
        }
    }
}

/// Whether `pattern`, in which `*` stands for anything, is `text`.
fn matches(pattern: &str, text: &str) -> bool {
    match pattern.split_once('*') {
        None => pattern == text,
        Some((start, rest)) => text
            .strip_prefix(start)
            .is_some_and(|text| (0..=text.len()).any(|at| text.get(at..).is_some_and(|t| matches(rest, t)))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_star_stands_for_anything() {
        for (pattern, text, is_so) in [
            ("mix", "mix", true),
            ("mix", "mixed", false),
            ("*@lavapipe", "wgsl+naga@lavapipe", true),
            ("*@lavapipe", "spirv@swiftshader", false),
            ("hlsl*@*", "hlsl+dxc@a-card", true),
            ("*", "", true),
            ("a*b*c", "abbc", true),
            ("a*b*c", "acb", false),
        ] {
            assert_eq!(matches(pattern, text), is_so, "{pattern} {text}");
        }
    }

    fn read_text(text: &str) -> Result<Vec<Expectation>, String> {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("expectations.toml");
        std::fs::write(&path, text).expect("writable");
        read(&path).map_err(|error| error.to_string())
    }

    #[test]
    fn a_file_is_read_and_must_give_reasons() {
        let text =
            "[[expected]]\nsubject = 'mix'\nroute = 'spirv@*'\nfails = 'beyond'\nreason = 'x + z (y - x)'\n";
        let list = read_text(text).expect("expectations");
        assert!(list[0].is_of("mix") && list[0].is_by("spirv@x", "any") && !list[0].is_by("judge", ""));
        let fault = read_text(&text.replace("x + z (y - x)", " ")).expect_err("no reason");
        assert!(fault.contains("`mix` by spirv@*"), "{fault}");
        let fault = read_text(&text.replace("fails", "fail")).expect_err("no such field");
        assert!(fault.contains("unknown field `fail`") && fault.contains("line 4"), "{fault}");
        let fault = read_text(&text.replace("'beyond'", "'beyont'")).expect_err("no such fault");
        assert!(fault.contains("unknown variant `beyont`") && fault.contains("`differs`"), "{fault}");
    }
}
