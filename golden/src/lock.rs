//! One writer at a time, or many readers: an advisory lock on a file.

use std::fs::{File, OpenOptions};
use std::io::ErrorKind;
use std::path::Path;

/// A lock, until it is dropped.
#[derive(Debug)]
pub(crate) struct Lock(#[expect(dead_code, reason = "it is held")] Option<File>);

/// Waits until nobody else writes or reads.
pub(crate) fn exclusive(path: &Path) -> std::io::Result<Lock> {
    let file = OpenOptions::new().create(true).truncate(false).write(true).open(path)?;
    file.lock()?;
    Ok(Lock(Some(file)))
}

/// Waits until nobody writes. Where there is no file, nobody ever did, and readers make none.
pub(crate) fn shared(path: &Path) -> std::io::Result<Lock> {
    match File::open(path) {
        Ok(file) => {
            file.lock_shared()?;
            Ok(Lock(Some(file)))
        }
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(Lock(None)),
        Err(error) => Err(error),
    }
}
