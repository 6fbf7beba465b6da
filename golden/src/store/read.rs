//! What is in the store.

use super::error::Why;
use super::{Found, IMAGES, PENDING, Store, StoreError, Unusable, files_of};
use crate::decision::{Action, Decision};
use crate::hash::Hash;
use crate::image;
use crate::name::{CaseName, Name};
use crate::record::{self, Record};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

impl Store {
    /// The accepted golden of a case; none if there is none.
    ///
    /// # Errors
    /// When it is there and cannot be used: [`StoreError::Unusable`].
    pub fn golden(&self, case: &CaseName) -> Result<Option<Found>, StoreError> {
        let _lock = self.reading()?;
        Ok(self.found(files_of(IMAGES, case), case)?)
    }

    /// The pending golden of a case.
    ///
    /// # Errors
    /// As of [`Store::golden`].
    pub fn pending(&self, case: &CaseName) -> Result<Option<Found>, StoreError> {
        let _lock = self.reading()?;
        Ok(self.found(files_of(PENDING, case), case)?)
    }

    /// The names of all accepted goldens, of which a file is there.
    ///
    /// # Errors
    /// When a folder cannot be read.
    pub fn accepted_cases(&self) -> Result<Vec<CaseName>, StoreError> {
        let _lock = self.reading()?;
        self.cases(IMAGES)
    }

    /// The names of all pending ones.
    ///
    /// # Errors
    /// When a folder cannot be read.
    pub fn pending_cases(&self) -> Result<Vec<CaseName>, StoreError> {
        let _lock = self.reading()?;
        self.cases(PENDING)
    }

    /// Bytes of all accepted goldens and their records.
    ///
    /// # Errors
    /// When a folder cannot be read.
    pub fn bytes(&self) -> Result<u64, StoreError> {
        let _lock = self.reading()?;
        let files = self.cases(IMAGES)?.into_iter().flat_map(|case| files_of(IMAGES, &case));
        Ok(files.filter_map(|path| std::fs::metadata(self.root.join(path)).ok()).map(|file| file.len()).sum())
    }

    /// Why this picture was rejected, if it was and nobody took that back.
    ///
    /// # Errors
    /// When the log cannot be read.
    pub fn rejection(&self, case: &CaseName, exr: &Hash) -> Result<Option<Decision>, StoreError> {
        let of_it = |d: &Decision| d.case == *case && d.exr.as_ref() == Some(exr);
        let last = standing(self.decisions()?).into_iter().rev().find(of_it);
        Ok(last.filter(|decision| decision.action == Action::Reject))
    }

    pub(super) fn found(&self, files: [PathBuf; 2], case: &CaseName) -> Result<Option<Found>, Unusable> {
        let [exr, toml] = files;
        let bad = |path: &Path, why| Unusable {
            case: case.clone(),
            path: self.root.join(path),
            why: Box::new(why),
        };
        let bytes = |path: &Path, most| self.bytes_of(path, most).map_err(|why| bad(path, why));
        let (Some(picture), Some(text)) =
            (match (bytes(&exr, image::MOST_BYTES)?, bytes(&toml, record::MOST_BYTES)?) {
                (None, None) => return Ok(None),
                (None, _) => return Err(bad(&exr, Why::Half)),
                (_, None) => return Err(bad(&toml, Why::Half)),
                both => both,
            })
        else {
            return Ok(None);
        };
        let record = Record::parse(&text, case).map_err(|cause| bad(&toml, Why::Record(cause)))?;
        let hash = Hash::of(&picture);
        if image::is_pointer(&picture) || picture.is_empty() || hash == record.exr {
            let golden = image::read_golden(&picture).map_err(|cause| bad(&exr, Why::Image(cause)))?;
            return match golden.size() == record.size {
                true => Ok(Some(Found { golden, record })),
                false => Err(bad(&exr, Why::Size { found: golden.size(), wanted: record.size })),
            };
        }
        Err(bad(&exr, Why::Hash { bytes: picture.len(), found: hash, wanted: record.exr }))
    }

    /// A file, if it is there.
    fn bytes_of(&self, path: &Path, most: u64) -> Result<Option<Vec<u8>>, Why> {
        self.check_plain(path).map_err(|_| Why::Linked)?;
        let path = self.root.join(path);
        match std::fs::metadata(&path) {
            Err(cause) if cause.kind() == std::io::ErrorKind::NotFound => Ok(None),
            Err(cause) => Err(Why::Io(cause)),
            Ok(file) if file.len() > most => Err(Why::Long { found: file.len(), most }),
            Ok(_) => std::fs::read(&path).map(Some).map_err(Why::Io),
        }
    }

    /// Names of which there is a file; what is no name is not of ours.
    pub(super) fn cases(&self, folder: &str) -> Result<Vec<CaseName>, StoreError> {
        let mut found = BTreeSet::new();
        for scene in names(&self.root.join(folder), |name| Some(name.to_owned()))? {
            let stem = |name: &str| {
                let (stem, ending) = name.rsplit_once('.')?;
                ["exr", "toml"].contains(&ending).then(|| stem.to_owned())
            };
            for method in names(&self.root.join(folder).join(scene.as_str()), stem)? {
                found.insert(CaseName { scene: scene.clone(), method });
            }
        }
        Ok(found.into_iter().collect())
    }
}

/// What of the entries of a folder are names; none where there is no folder.
fn names(folder: &Path, part: impl Fn(&str) -> Option<String>) -> Result<BTreeSet<Name>, StoreError> {
    let failed = |cause| StoreError::Io { path: folder.to_owned(), cause };
    let entries = match std::fs::read_dir(folder) {
        Err(cause) if cause.kind() == std::io::ErrorKind::NotFound => return Ok(BTreeSet::new()),
        Err(cause) if cause.kind() == std::io::ErrorKind::NotADirectory => return Ok(BTreeSet::new()),
        entries => entries.map_err(failed)?,
    };
    let mut found = BTreeSet::new();
    for entry in entries {
        let name = entry.map_err(failed)?.file_name();
        found.extend(name.to_str().and_then(&part).and_then(|part| part.parse().ok()));
    }
    Ok(found)
}

/// Decisions that nobody took back, oldest first.
pub(super) fn standing(log: Vec<Decision>) -> Vec<Decision> {
    let mut standing = Vec::new();
    for decision in log {
        match decision.action {
            Action::Undo => drop(standing.pop()),
            Action::Accept | Action::Reject | Action::Prune => standing.push(decision),
        }
    }
    standing
}
