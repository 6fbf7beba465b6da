//! Why the store did not do what was asked.

use crate::hash::Hash;
use crate::image::ImageError;
use crate::name::CaseName;
use crate::record::RecordError;
use std::path::PathBuf;

/// Why the store did not do what was asked.
#[derive(Debug, thiserror::Error)]
pub enum StoreError {
    /// Files cannot be read or written; nothing has changed.
    #[error("{}: {cause}", path.display())]
    Io {
        /// Where.
        path: PathBuf,
        /// Why.
        cause: std::io::Error,
    },
    /// The decision is made, but files could not be moved.
    #[error(
        "the decision is made, but not all files could be moved: {cause}; the next `lobe golden` completes it"
    )]
    Incomplete {
        /// Why.
        cause: std::io::Error,
    },
    /// The store may not write.
    #[error("goldens are not written here (CI, or --no-write): decide where the repository is worked on")]
    ReadOnly,
    /// A decision was broken off, and the store may not complete it.
    #[error(
        "a decision was broken off and not all files are moved: run `lobe golden check` where it may write"
    )]
    Interrupted,
    /// A path leads elsewhere.
    #[error("{}: it is a symbolic link: goldens are plain files in plain folders", path.display())]
    Linked {
        /// Where.
        path: PathBuf,
    },
    /// A golden cannot be used.
    #[error(transparent)]
    Unusable(#[from] Unusable),
    /// A golden is no file.
    #[error("{case}: the golden cannot be written: {cause}")]
    Image {
        /// Which one.
        case: CaseName,
        /// Why.
        cause: ImageError,
    },
    /// A record is no file.
    #[error("{case}: the record cannot be written: {cause}")]
    Record {
        /// Which one.
        case: CaseName,
        /// Why.
        cause: RecordError,
    },
    /// Nothing waits for a decision.
    #[error(
        "{case}: there is no pending golden; `lobe golden check` writes one where something is to be decided"
    )]
    NotPending {
        /// Which one.
        case: CaseName,
    },
    /// What was seen is not what is pending.
    #[error(
        "{case}: the pending golden is another ({found}) than the one that was seen ({seen}): look at it again"
    )]
    Moved {
        /// Which one.
        case: CaseName,
        /// What was seen.
        seen: Hash,
        /// What is there.
        found: Hash,
    },
    /// The same golden is decided on twice.
    #[error("{case}: there are two decisions on it; give one")]
    Twice {
        /// Which one.
        case: CaseName,
    },
    /// A decision has no reason.
    #[error("{case}: a decision needs a reason: give --reason")]
    NoReason {
        /// Which one.
        case: CaseName,
    },
    /// All goldens would take too much room.
    #[error(
        "goldens would take {bytes} bytes, more than {}: make pictures smaller, or prune",
        super::MOST_BYTES
    )]
    Full {
        /// What they would take.
        bytes: u64,
    },
    /// A line of the log is none.
    #[error("{}: line {line} is no decision ({why}): restore it by git", path.display())]
    Log {
        /// The log.
        path: PathBuf,
        /// Which line, from 1.
        line: usize,
        /// Why.
        why: String,
    },
    /// There is no decision to take back.
    #[error("there is no decision that could be taken back")]
    NothingToUndo,
    /// What a decision replaced is not here.
    #[error("{case}: what the decision replaced is not on this machine ({}): restore it by git", path.display())]
    Forgotten {
        /// Which one.
        case: CaseName,
        /// Where it would be.
        path: PathBuf,
    },
}

/// Why a golden that is there cannot be used.
#[derive(Debug, thiserror::Error)]
#[error("{case}: {}: {why}", path.display())]
pub struct Unusable {
    /// Which one.
    pub case: CaseName,
    /// The file.
    pub path: PathBuf,
    /// What is wrong with it.
    pub why: Box<Why>,
}

/// What is wrong with a file.
#[derive(Debug, thiserror::Error)]
pub enum Why {
    /// The other file of the golden is there, and this is not.
    #[error("it is missing, but the other half of the golden is there: restore it by git")]
    Half,
    /// It cannot be read.
    #[error("it cannot be read: {0}")]
    Io(std::io::Error),
    /// It is too long.
    #[error("it has {found} bytes; at most {most} are read")]
    Long {
        /// Its bytes.
        found: u64,
        /// Bytes that are read.
        most: u64,
    },
    /// It leads elsewhere.
    #[error("it is a symbolic link, or in a folder that is: goldens are plain files")]
    Linked,
    /// It is no record.
    #[error("{0}")]
    Record(RecordError),
    /// It is no picture.
    #[error("{0}")]
    Image(ImageError),
    /// Its bytes are not those that were accepted.
    #[error(
        "its {bytes} bytes have the hash {found}, and those that were accepted {wanted}: restore it by git"
    )]
    Hash {
        /// Its length.
        bytes: usize,
        /// The hash of what is there.
        found: Hash,
        /// That of the record.
        wanted: Hash,
    },
    /// It has another size than its record says.
    #[error("it is {} x {}, and the record says {} x {}", found[0], found[1], wanted[0], wanted[1])]
    Size {
        /// Columns and rows.
        found: [u32; 2],
        /// Those of the record.
        wanted: [u32; 2],
    },
}
