//! Parts of a report: what one machine, or one test, found of a whole.

use serde::{Deserialize, Serialize};

/// Which part of which whole a report is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Part {
    /// The whole.
    #[serde(flatten)]
    pub whole: Whole,
    /// The part's name, one of those that the whole lists.
    pub name: String,
    /// Rows drawn for each kernel.
    pub inputs: usize,
}

/// What was split; parts of the same whole say the same of it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Whole {
    /// What it is called: `lobe check`, or the package and the module of tests.
    pub whole: String,
    /// The names of all parts, in order.
    pub parts: Vec<String>,
    /// The names of all kernels, in order.
    pub kernels: Vec<String>,
}

/// A share of a list: `2/3` takes the second of every three items.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Share {
    index: usize,
    count: usize,
}

impl Share {
    /// Whether the item at `place` is in it.
    #[must_use]
    pub fn has(self, place: usize) -> bool {
        place % self.count == self.index - 1
    }

    /// The part of `lobe check` that it is, of `kernels` by name.
    #[must_use]
    pub fn part(self, kernels: Vec<String>, inputs: usize) -> Part {
        let parts = (1..=self.count).map(|index| format!("{index}/{}", self.count)).collect();
        Part {
            whole: Whole { whole: "lobe check".to_owned(), parts, kernels },
            name: self.to_string(),
            inputs,
        }
    }
}

impl std::fmt::Display for Share {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

impl std::str::FromStr for Share {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let numbers =
            text.split_once('/').and_then(|(index, count)| Some((index.parse().ok()?, count.parse().ok()?)));
        match numbers {
            Some((index, count)) if (1..=count).contains(&index) => Ok(Self { index, count }),
            _ => Err("write 2/3 for the second of three parts".to_owned()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Share;

    #[test]
    fn shares_are_disjoint_and_leave_nothing_out() {
        let shares: Vec<Share> = ["1/3", "2/3", "3/3"].map(|text| text.parse().expect("a share")).to_vec();
        for place in 0..10 {
            assert_eq!(shares.iter().filter(|share| share.has(place)).count(), 1, "{place}");
        }
        for text in ["", "1", "0/3", "4/3", "1/0", "a/b", "1/2/3"] {
            assert!(text.parse::<Share>().is_err(), "{text}");
        }
    }
}
