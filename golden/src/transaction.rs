//! Changes of many files, all or none, whatever happens meanwhile.
//!
//! New files are written beside, into `.staging`, and flushed; then a journal that lists them gets its name, in one step.
//! Before that step nothing has happened; after it everything will: whoever opens the store next goes on where the
//! journal ends. Every step may be done again.

use crate::files::Files;
use crate::hash::Hash;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::io::{Error, ErrorKind};
use std::path::{Component, Path, PathBuf};

const STAGING: &str = ".staging";
const JOURNAL: &str = "journal.json";
const DRAFT: &str = "journal.draft";

/// A file that changes: its path within the store, and what it will hold; nothing of one that is removed.
#[derive(Debug, Clone)]
pub(crate) struct Change {
    pub(crate) path: PathBuf,
    pub(crate) bytes: Option<Vec<u8>>,
}

/// What is left to do.
#[derive(Debug, Serialize, Deserialize)]
struct Journal {
    changes: Vec<Planned>,
}

#[derive(Debug, Serialize, Deserialize)]
struct Planned {
    path: PathBuf,
    /// What the staged file of this change's number holds; none if the path is removed.
    holds: Option<Hash>,
}

/// How far a commit came.
#[derive(Debug)]
pub(crate) enum Failed {
    /// Nothing has happened.
    Before(Error),
    /// It is decided, and the next one to open the store completes it.
    After(Error),
}

/// Carries out all changes.
pub(crate) fn commit(files: &dyn Files, root: &Path, changes: &[Change]) -> Result<(), Failed> {
    let journal = stage(files, root, changes).map_err(|cause| {
        // What lies there is nothing, and the next commit writes over it; but a full disk wants the room.
        let _ = clear(files, root);
        Failed::Before(cause)
    })?;
    finish(files, root, &journal).map_err(Failed::After)
}

fn stage(files: &dyn Files, root: &Path, changes: &[Change]) -> Result<Journal, Error> {
    let staging = root.join(STAGING);
    files.make_folder(&staging)?;
    for (at, change) in changes.iter().enumerate() {
        if let Some(bytes) = &change.bytes {
            files.write(&staging.join(at.to_string()), bytes)?;
        }
    }
    let planned =
        |change: &Change| Planned { path: change.path.clone(), holds: change.bytes.as_deref().map(Hash::of) };
    let journal = Journal { changes: changes.iter().map(planned).collect() };
    files.write(&staging.join(DRAFT), &serde_json::to_vec(&journal)?)?;
    files.sync_folder(&staging)?;
    files.rename(&staging.join(DRAFT), &staging.join(JOURNAL))?;
    files.sync_folder(&staging).map(|()| journal)
}

/// Whether a commit is decided and not complete.
pub(crate) fn is_interrupted(root: &Path) -> bool {
    root.join(STAGING).join(JOURNAL).exists()
}

/// Completes a commit that is decided; removes what one has left that is not.
pub(crate) fn recover(files: &dyn Files, root: &Path) -> Result<(), Error> {
    let staging = root.join(STAGING);
    if !staging.exists() {
        return Ok(());
    }
    if is_interrupted(root) {
        let damaged = |cause: String| {
            let path = staging.join(JOURNAL);
            Error::new(
                ErrorKind::InvalidData,
                format!("{} is damaged ({cause}): restore the folder by git, and remove it", path.display()),
            )
        };
        let bytes = std::fs::read(staging.join(JOURNAL))?;
        let journal: Journal = serde_json::from_slice(&bytes).map_err(|cause| damaged(cause.to_string()))?;
        finish(files, root, &journal)?;
    }
    clear(files, root)
}

fn finish(files: &dyn Files, root: &Path, journal: &Journal) -> Result<(), Error> {
    let staging = root.join(STAGING);
    let mut folders = BTreeSet::new();
    for (at, Planned { path, holds }) in journal.changes.iter().enumerate() {
        if !path.components().all(|part| matches!(part, Component::Normal(_))) {
            return Err(Error::new(
                ErrorKind::InvalidData,
                format!("the journal leads to {}", path.display()),
            ));
        }
        let (target, staged) = (root.join(path), staging.join(at.to_string()));
        let folder = target.parent().unwrap_or(root).to_owned();
        match holds {
            // Once it is renamed it is not there any more.
            Some(hash) if staged.exists() => {
                if Hash::of(&std::fs::read(&staged)?) != *hash {
                    return Err(Error::new(
                        ErrorKind::InvalidData,
                        format!("{} is damaged", staged.display()),
                    ));
                }
                files.make_folder(&folder)?;
                files.rename(&staged, &target)?;
            }
            Some(_) => {}
            None => files.remove(&target)?,
        }
        if folder.exists() {
            folders.insert(folder);
        }
    }
    folders.iter().try_for_each(|folder| files.sync_folder(folder))?;
    files.remove(&staging.join(JOURNAL))?;
    files.sync_folder(&staging)
}

/// Removes files that are no part of anything.
fn clear(files: &dyn Files, root: &Path) -> Result<(), Error> {
    let staging = root.join(STAGING);
    // A journal that is there was decided on, even if the step after it failed.
    if is_interrupted(root) {
        return Ok(());
    }
    for entry in std::fs::read_dir(&staging)? {
        files.remove(&entry?.path())?;
    }
    Ok(())
}
