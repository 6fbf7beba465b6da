//! The store: accepted goldens, pending ones, decisions.
//!
//! | in the folder | what it is |
//! |---|---|
//! | `images/SCENE/METHOD.exr`, `.toml` | an accepted golden and its record |
//! | `pending/SCENE/METHOD.exr`, `.toml` | one that waits for a decision; not for the repository |
//! | `pending/.undo/` | what decisions have replaced, so that they can be taken back |
//! | `decisions.jsonl` | all decisions, oldest first |
//! | `.lock`, `.staging/` | for one writer at a time, all or nothing |

mod decide;
mod error;
mod read;

pub use error::{StoreError, Unusable};

use crate::decision::Decision;
use crate::files::{Disk, Files};
use crate::golden::Golden;
use crate::hash::Hash;
use crate::image;
use crate::lock::{self, Lock};
use crate::name::CaseName;
use crate::record::Record;
use crate::transaction::{self, Change, Failed};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

const IMAGES: &str = "images";
const PENDING: &str = "pending";
const UNDO: &str = "pending/.undo";
const DECISIONS: &str = "decisions.jsonl";
const LOCK: &str = ".lock";

/// Bytes of all accepted goldens, at most.
pub(crate) const MOST_BYTES: u64 = 40_000_000;

/// A folder of goldens.
#[derive(Debug)]
pub struct Store {
    root: PathBuf,
    files: Box<dyn Files>,
    writes: bool,
}

/// A golden and what is written down of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// The golden.
    pub golden: Golden,
    /// What is written down.
    pub record: Record,
}

/// Who decides, and when.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reviewer {
    /// Who.
    pub by: String,
    /// When, UTC, RFC 3339.
    pub at: String,
}

impl Reviewer {
    /// The reviewer of this name, now.
    #[must_use]
    pub fn now(by: &str) -> Self {
        let at = humantime::format_rfc3339_seconds(SystemTime::now()).to_string();
        Self { by: by.to_owned(), at }
    }
}

impl Store {
    /// The store in a folder.
    #[must_use]
    pub fn open(root: &Path) -> Self {
        Self::with_files(root, Box::new(Disk))
    }

    /// The same, but it changes nothing, as in CI.
    #[must_use]
    pub fn read_only(root: &Path) -> Self {
        Self { writes: false, ..Self::open(root) }
    }

    /// The store in a folder, whose files change by `files`.
    #[must_use]
    pub fn with_files(root: &Path, files: Box<dyn Files>) -> Self {
        Self { root: root.to_owned(), files, writes: true }
    }

    /// The folder.
    #[must_use]
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// Whether a decision was broken off after it was made, and is not completed since this store may not write.
    #[must_use]
    pub fn is_interrupted(&self) -> bool {
        transaction::is_interrupted(&self.root)
    }

    /// Puts a golden where it waits for a decision, in the place of one that did. Its record is given the golden's hash, size
    /// and number of indeterminate pixels.
    ///
    /// # Errors
    /// When files cannot be written.
    pub fn put_pending(&self, golden: &Golden, record: &Record) -> Result<Record, StoreError> {
        let exr = image::write_golden(golden)
            .map_err(|cause| StoreError::Image { case: record.case.clone(), cause })?;
        let mut record = record.clone();
        record.exr = Hash::of(&exr);
        record.size = golden.size();
        record.indeterminate = golden.unbounded() as u32;
        record.accepted = None;
        let _lock = self.writing()?;
        let toml = self.toml(&record)?;
        self.commit(vec![
            put(files_of(PENDING, &record.case)[0].clone(), exr),
            put(files_of(PENDING, &record.case)[1].clone(), toml),
        ])?;
        Ok(record)
    }

    /// Removes the pending golden of a case, since there is nothing to be decided any more.
    ///
    /// # Errors
    /// When files cannot be removed.
    pub fn clear_pending(&self, case: &CaseName) -> Result<(), StoreError> {
        if files_of(PENDING, case).iter().all(|path| !self.root.join(path).exists()) {
            return Ok(());
        }
        let _lock = self.writing()?;
        self.commit(files_of(PENDING, case).map(remove).to_vec())
    }

    fn toml(&self, record: &Record) -> Result<Vec<u8>, StoreError> {
        let text = record.to_toml();
        text.map(String::into_bytes).map_err(|cause| StoreError::Record { case: record.case.clone(), cause })
    }

    /// Waits until nobody else writes or reads, and completes what was broken off.
    fn writing(&self) -> Result<Lock, StoreError> {
        if !self.writes {
            return Err(StoreError::ReadOnly);
        }
        let failed = |cause| StoreError::Io { path: self.root.clone(), cause };
        self.files.make_folder(&self.root).map_err(failed)?;
        let lock = lock::exclusive(&self.root.join(LOCK)).map_err(failed)?;
        transaction::recover(self.files.as_ref(), &self.root).map_err(failed)?;
        Ok(lock)
    }

    /// Waits until nobody writes.
    fn reading(&self) -> Result<Lock, StoreError> {
        let failed = |cause| StoreError::Io { path: self.root.clone(), cause };
        let lock = lock::shared(&self.root.join(LOCK)).map_err(failed)?;
        match (self.is_interrupted(), self.writes) {
            (false, _) => Ok(lock),
            (true, false) => Err(StoreError::Interrupted),
            (true, true) => {
                drop(lock);
                drop(self.writing()?);
                lock::shared(&self.root.join(LOCK)).map_err(failed)
            }
        }
    }

    fn commit(&self, changes: Vec<Change>) -> Result<(), StoreError> {
        for change in &changes {
            self.check_plain(&change.path)?;
        }
        transaction::commit(self.files.as_ref(), &self.root, &changes).map_err(|failed| match failed {
            Failed::Before(cause) => StoreError::Io { path: self.root.clone(), cause },
            Failed::After(cause) => StoreError::Incomplete { cause },
        })
    }

    /// Whether nothing on the way to a file leads out of the store.
    fn check_plain(&self, path: &Path) -> Result<(), StoreError> {
        let mut here = self.root.clone();
        for part in path.components() {
            here.push(part);
            if here.is_symlink() {
                return Err(StoreError::Linked { path: here });
            }
        }
        Ok(())
    }

    /// The log with these lines at its end.
    fn logged(&self, lines: &[Decision]) -> Result<Change, StoreError> {
        let mut text = self.log_text()?;
        if !text.is_empty() && !text.ends_with('\n') {
            text.push('\n');
        }
        text.extend(lines.iter().map(Decision::line));
        Ok(put(PathBuf::from(DECISIONS), text.into_bytes()))
    }

    fn log_text(&self) -> Result<String, StoreError> {
        let path = self.root.join(DECISIONS);
        match std::fs::read_to_string(&path) {
            Err(cause) if cause.kind() == std::io::ErrorKind::NotFound => Ok(String::new()),
            outcome => outcome.map_err(|cause| StoreError::Io { path, cause }),
        }
    }

    /// All decisions, oldest first.
    ///
    /// # Errors
    /// When the log cannot be read, or a line of it is none.
    pub fn decisions(&self) -> Result<Vec<Decision>, StoreError> {
        let _lock = self.reading()?;
        self.log()
    }

    fn log(&self) -> Result<Vec<Decision>, StoreError> {
        let damaged = |(line, why)| StoreError::Log { path: self.root.join(DECISIONS), line, why };
        Decision::parse(&self.log_text()?).map_err(damaged)
    }
}

/// The files of a golden, within the store: the picture, the record.
fn files_of(folder: &str, case: &CaseName) -> [PathBuf; 2] {
    let folder = Path::new(folder).join(case.scene.as_str());
    ["exr", "toml"].map(|ending| folder.join(format!("{}.{ending}", case.method)))
}

/// Where files go that a decision has replaced.
fn undo_files(case: &CaseName, exr: &Hash) -> [PathBuf; 2] {
    let folder = Path::new(UNDO).join(case.scene.as_str()).join(case.method.as_str());
    ["exr", "toml"].map(|ending| folder.join(format!("{exr}.{ending}")))
}

fn put(path: PathBuf, bytes: Vec<u8>) -> Change {
    Change { path, bytes: Some(bytes) }
}

fn remove(path: PathBuf) -> Change {
    Change { path, bytes: None }
}
