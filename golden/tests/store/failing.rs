//! A file system of which a step fails.

use lobe_golden::files::{Disk, Files};
use std::io::{Error, ErrorKind};
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

/// What happens at the step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Fault {
    /// The disk is full at this step, and not after it.
    Full,
    /// The disk is full from this step on.
    StaysFull,
    /// The process is killed in this step: nothing that it does afterwards happens.
    Killed,
}

/// The disk, of which nothing waits: tests that end no process lose nothing by that, and gain minutes.
#[derive(Debug)]
pub(crate) struct Quick;

impl Files for Quick {
    fn make_folder(&self, path: &Path) -> std::io::Result<()> {
        Disk.make_folder(path)
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> std::io::Result<()> {
        std::fs::write(path, bytes)
    }

    fn rename(&self, from: &Path, to: &Path) -> std::io::Result<()> {
        Disk.rename(from, to)
    }

    fn remove(&self, path: &Path) -> std::io::Result<()> {
        Disk.remove(path)
    }

    fn sync_folder(&self, _: &Path) -> std::io::Result<()> {
        Ok(())
    }
}

/// A disk of which a step fails; a write leaves half of what it was to write.
#[derive(Debug)]
pub(crate) struct Failing {
    fault: Fault,
    at: usize,
    steps: AtomicUsize,
}

impl Failing {
    pub(crate) fn new(fault: Fault, at: usize) -> Self {
        Self { fault, at, steps: AtomicUsize::new(0) }
    }

    fn fails(&self, takes_room: bool) -> bool {
        let step = self.steps.fetch_add(1, Ordering::Relaxed);
        match self.fault {
            Fault::Full => step == self.at && takes_room,
            Fault::StaysFull => step >= self.at && takes_room,
            Fault::Killed => step >= self.at,
        }
    }

    fn is_dead(&self) -> bool {
        self.fault == Fault::Killed && self.steps.load(Ordering::Relaxed) > self.at + 1
    }

    fn step(&self, takes_room: bool, done: impl FnOnce() -> std::io::Result<()>) -> std::io::Result<()> {
        if self.fails(takes_room) { Err(Error::from(ErrorKind::StorageFull)) } else { done() }
    }
}

impl Files for Failing {
    fn make_folder(&self, path: &Path) -> std::io::Result<()> {
        self.step(!path.exists(), || Quick.make_folder(path))
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> std::io::Result<()> {
        self.step(true, || Quick.write(path, bytes)).inspect_err(|_| {
            if !self.is_dead() {
                Quick.write(path, &bytes[..bytes.len() / 2]).expect("half of it");
            }
        })
    }

    fn rename(&self, from: &Path, to: &Path) -> std::io::Result<()> {
        self.step(true, || Quick.rename(from, to))
    }

    fn remove(&self, path: &Path) -> std::io::Result<()> {
        self.step(false, || Quick.remove(path))
    }

    fn sync_folder(&self, path: &Path) -> std::io::Result<()> {
        self.step(false, || Quick.sync_folder(path))
    }
}
