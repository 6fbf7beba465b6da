//! What is written down beside a golden: what it depends on, who accepted it, and what routes returned then.

use crate::hash::Hash;
use crate::image;
use crate::name::CaseName;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Version of the format.
const SCHEMA: u32 = 1;
/// Bytes of a record, at most.
pub(crate) const MOST_BYTES: u64 = 1 << 20;

/// What is written down beside a golden.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Record {
    /// Version of the format.
    schema: u32,
    /// Which golden it is.
    pub case: CaseName,
    /// A scene rendered (`render`) or a kernel over a grid (`plot`).
    pub kind: String,
    /// Columns and rows.
    pub size: [u32; 2],
    /// Of the EXR file.
    pub exr: Hash,
    /// Pixels of which nothing is promised.
    pub indeterminate: u32,
    /// Where it was made.
    pub environment: String,
    /// Parameters, by name; a seed is one.
    pub settings: BTreeMap<String, String>,
    /// Who accepted it; nobody yet, of one that is pending.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub accepted: Option<Acceptance>,
    /// What it depends on.
    pub chain: Chain,
    /// What routes returned.
    #[serde(default)]
    pub routes: Vec<RouteRecord>,
}

/// Who accepted a golden, when, and why.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Acceptance {
    /// Who.
    pub by: String,
    /// When, UTC, RFC 3339.
    pub at: String,
    /// The reason.
    pub why: String,
}

/// What a golden depends on, in hashes.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Chain {
    /// Of all the others.
    pub hash: Hash,
    /// Of the scene's file, if there is a scene.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub scene: Option<Hash>,
    /// Of the parameters and the size.
    pub settings: Hash,
    /// Of the kernels, in the order in which they run.
    pub kernels: Vec<Kernel>,
}

/// A kernel that a golden depends on.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Kernel {
    /// Its name.
    pub name: String,
    /// Hash of it and all that it calls.
    pub module: Hash,
    /// Whether its results are judged.
    pub is_judged: bool,
}

/// What a route returned.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RouteRecord {
    /// The route.
    pub route: String,
    /// What decides its results: driver, version, device, processor.
    pub driver: String,
    /// Hash of what its target was given, if anything is emitted.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub emitted: Option<Hash>,
    /// Hash of the picture's bits.
    pub output: Hash,
    /// The largest share of the permitted error; infinite where it was outside.
    pub share: f64,
    /// Relative RMSE, where the truth is not black.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub relative_rmse: Option<f64>,
    /// Mean HDR-FLIP.
    pub flip_hdr: f64,
    /// Mean LDR-FLIP.
    pub flip_ldr: f64,
}

/// Why a text is no record.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RecordError {
    /// There is no text.
    #[error("it is empty")]
    Empty,
    /// It stands for a file that is kept elsewhere.
    #[error("it is a pointer of Git LFS and not the record: run `git lfs pull`")]
    Pointer,
    /// It is no text, or no TOML of this form.
    #[error("it is no record: {0}")]
    Form(String),
    /// It is of another version.
    #[error("it is of version {0} of the format, and this Lobe reads {SCHEMA}")]
    Version(u32),
    /// It is of another golden.
    #[error("it is the record of {found}, not of {wanted}")]
    Other {
        /// Whose it is.
        found: String,
        /// Whose it should be.
        wanted: String,
    },
    /// Its chain does not have the hash that it says.
    #[error("its chain has another hash than it says: it was edited, or it is damaged")]
    Chain,
}

impl Chain {
    /// The chain of these, with the hash of all.
    #[must_use]
    pub fn new(scene: Option<Hash>, settings: Hash, kernels: Vec<Kernel>) -> Self {
        let mut text = format!("{}\n{settings}\n", scene.as_ref().map(Hash::as_str).unwrap_or_default());
        for Kernel { name, module, is_judged } in &kernels {
            text += &format!("{name} {module} {is_judged}\n");
        }
        Self { hash: Hash::of(text.as_bytes()), scene, settings, kernels }
    }

    /// What of `self` is other than in `accepted`, in words; empty if nothing is.
    #[must_use]
    pub fn changes(&self, accepted: &Self) -> Vec<String> {
        let mut changes = Vec::new();
        if self.scene != accepted.scene {
            changes.push("scene".to_owned());
        }
        if self.settings != accepted.settings {
            changes.push("settings".to_owned());
        }
        let of = |chain: &Self, name: &str| chain.kernels.iter().find(|k| k.name == name).cloned();
        for kernel in &self.kernels {
            match of(accepted, &kernel.name) {
                None => changes.push(format!("{} (new)", kernel.name)),
                Some(before) if before != *kernel => changes.push(kernel.name.clone()),
                Some(_) => {}
            }
        }
        let gone = accepted.kernels.iter().filter(|kernel| of(self, &kernel.name).is_none());
        changes.extend(gone.map(|kernel| format!("{} (gone)", kernel.name)));
        if changes.is_empty() && self.hash != accepted.hash {
            changes.push("order of the kernels".to_owned());
        }
        changes
    }

    /// The hashes in words.
    #[must_use]
    pub fn proof(&self) -> String {
        let kernels: Vec<String> =
            self.kernels.iter().map(|k| format!("{} {}", k.name, k.module.short())).collect();
        let scene = self.scene.as_ref().map(|hash| format!(", scene {}", hash.short())).unwrap_or_default();
        format!("unaffected: kernels {}{scene}, settings {}", kernels.join(", "), self.settings.short())
    }
}

impl Record {
    /// A record of this format's version, accepted by nobody.
    #[must_use]
    pub fn new(case: CaseName, kind: &str, size: [u32; 2], exr: Hash, chain: Chain) -> Self {
        Self {
            schema: SCHEMA,
            case,
            kind: kind.to_owned(),
            size,
            exr,
            indeterminate: 0,
            environment: String::new(),
            settings: BTreeMap::new(),
            accepted: None,
            chain,
            routes: Vec::new(),
        }
    }

    /// The record as TOML.
    ///
    /// # Errors
    /// None that a record could cause.
    pub fn to_toml(&self) -> Result<String, RecordError> {
        let text = toml::to_string(self).map_err(|cause| RecordError::Form(cause.to_string()))?;
        Ok(format!("# Written by `lobe golden`; edit nothing here.\n{text}"))
    }

    /// The record of `case` in these bytes.
    ///
    /// # Errors
    /// When they are none.
    pub fn parse(bytes: &[u8], case: &CaseName) -> Result<Self, RecordError> {
        #[derive(Deserialize)]
        struct Version {
            schema: u32,
        }
        if bytes.is_empty() {
            return Err(RecordError::Empty);
        }
        if image::is_pointer(bytes) {
            return Err(RecordError::Pointer);
        }
        let text = std::str::from_utf8(bytes).map_err(|cause| RecordError::Form(cause.to_string()))?;
        let form = |cause: toml::de::Error| RecordError::Form(cause.message().to_owned());
        match toml::from_str(text).map_err(form)? {
            Version { schema: SCHEMA } => {}
            Version { schema } => return Err(RecordError::Version(schema)),
        }
        let record: Self = toml::from_str(text).map_err(form)?;
        if record.case != *case {
            return Err(RecordError::Other { found: record.case.to_string(), wanted: case.to_string() });
        }
        let Chain { hash, scene, settings, kernels } = record.chain.clone();
        if Chain::new(scene, settings, kernels).hash != hash {
            return Err(RecordError::Chain);
        }
        Ok(record)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kernel(name: &str, text: &str) -> Kernel {
        Kernel { name: name.to_owned(), module: Hash::of(text.as_bytes()), is_judged: true }
    }

    fn record() -> Record {
        let kernels = vec![kernel("a", "1"), kernel("b", "2")];
        let chain = Chain::new(Some(Hash::of(b"s")), Hash::of(b"p"), kernels);
        let case: CaseName = "box/direct".parse().unwrap();
        let mut record = Record::new(case, "render", [4, 4], Hash::of(b"x"), chain);
        record.settings.insert("samples".to_owned(), "\"><script>".to_owned());
        record.accepted =
            Some(Acceptance { by: "A \"B\"\n".to_owned(), at: String::new(), why: "'''".to_owned() });
        record.routes.push(RouteRecord {
            route: "interp".to_owned(),
            driver: String::new(),
            emitted: None,
            output: Hash::of(b"o"),
            share: f64::INFINITY,
            relative_rmse: None,
            flip_hdr: 0.0,
            flip_ldr: 0.1,
        });
        record
    }

    #[test]
    fn a_record_comes_back() {
        let (record, text) = (record(), record().to_toml().unwrap());
        assert_eq!(Record::parse(text.as_bytes(), &record.case).unwrap(), record);
    }

    #[test]
    fn what_is_no_record_is_refused() {
        let (record, text) = (record(), record().to_toml().unwrap());
        let parse = |text: &str| Record::parse(text.as_bytes(), &record.case);
        assert_eq!(parse(""), Err(RecordError::Empty));
        assert_eq!(parse("version https://git-lfs.github.com/spec/v1\n"), Err(RecordError::Pointer));
        assert_eq!(parse(&text.replace("schema = 1", "schema = 2")), Err(RecordError::Version(2)));
        assert!(matches!(
            parse(&text.replace("method = \"direct\"", "method = \"..\"")),
            Err(RecordError::Form(_))
        ));
        assert!(matches!(
            parse(&text.replace("method = \"direct\"", "method = \"d\"")),
            Err(RecordError::Other { .. })
        ));
        assert_eq!(parse(&text.replace("name = \"a\"", "name = \"c\"")), Err(RecordError::Chain));
        assert!(matches!(parse(&text.replace("kind", "sort")), Err(RecordError::Form(_))));
        assert!(matches!(Record::parse(&[0xff, 0xfe], &record.case), Err(RecordError::Form(_))));
        for end in (0..text.len()).step_by(64).skip(1) {
            assert!(
                parse(&text[..end]).is_err()
                    || text[end..].trim_start().is_empty()
                    || parse(&text[..end]) != Ok(record.clone())
            );
        }
    }

    #[test]
    fn a_chain_says_what_changed() {
        let accepted = record().chain;
        let changed = |kernels: Vec<Kernel>| {
            Chain::new(accepted.scene.clone(), accepted.settings.clone(), kernels).changes(&accepted)
        };
        assert!(changed(accepted.kernels.clone()).is_empty());
        assert_eq!(changed(vec![kernel("a", "1"), kernel("b", "3")]), ["b"]);
        assert_eq!(changed(vec![kernel("a", "1"), kernel("c", "2")]), ["c (new)", "b (gone)"]);
        assert_eq!(changed(vec![kernel("b", "2"), kernel("a", "1")]), ["order of the kernels"]);
    }
}
