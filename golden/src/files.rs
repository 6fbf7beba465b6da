//! What the store does to files, so that tests can have each step fail.

use std::fs::{self, File, OpenOptions};
use std::io::{ErrorKind, Write};
use std::path::Path;

/// Changes to a file system, in the order in which the store asks for them.
pub trait Files: std::fmt::Debug + Send + Sync {
    /// Makes a folder, and those that it is in.
    ///
    /// # Errors
    /// Those of the file system.
    fn make_folder(&self, path: &Path) -> std::io::Result<()>;

    /// Writes a file anew and waits until it is on the disk.
    ///
    /// # Errors
    /// Those of the file system.
    fn write(&self, path: &Path, bytes: &[u8]) -> std::io::Result<()>;

    /// Puts a file in the place of another.
    ///
    /// # Errors
    /// Those of the file system.
    fn rename(&self, from: &Path, to: &Path) -> std::io::Result<()>;

    /// Removes a file; one that is not there is removed.
    ///
    /// # Errors
    /// Those of the file system.
    fn remove(&self, path: &Path) -> std::io::Result<()>;

    /// Waits until what was renamed and removed in a folder is on the disk.
    ///
    /// # Errors
    /// Those of the file system.
    fn sync_folder(&self, path: &Path) -> std::io::Result<()>;
}

/// The file system.
#[derive(Debug, Clone, Copy, Default)]
pub struct Disk;

impl Files for Disk {
    fn make_folder(&self, path: &Path) -> std::io::Result<()> {
        fs::create_dir_all(path)
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> std::io::Result<()> {
        let mut file = OpenOptions::new().create(true).truncate(true).write(true).open(path)?;
        file.write_all(bytes)?;
        file.sync_all()
    }

    fn rename(&self, from: &Path, to: &Path) -> std::io::Result<()> {
        fs::rename(from, to)
    }

    fn remove(&self, path: &Path) -> std::io::Result<()> {
        match fs::remove_file(path) {
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(()),
            outcome => outcome,
        }
    }

    #[cfg(unix)]
    fn sync_folder(&self, path: &Path) -> std::io::Result<()> {
        File::open(path)?.sync_all()
    }

    /// Elsewhere a folder cannot be opened as a file, and renaming is as durable as it gets.
    #[cfg(not(unix))]
    fn sync_folder(&self, _: &Path) -> std::io::Result<()> {
        Ok(())
    }
}
