//! Golden images: what `lobe golden` renders, judges and proposes. `tests/GOLDEN.md` says it for those who review.
//!
//! [`cases`] says what there are goldens of; [`Opened`] is one of them, with its hashes, its truth and what a route makes of
//! it; a [`Session`] judges it by the [store](lobe_golden::Store) and says so in a [`report`].

pub mod cases;
mod check;
pub mod decisions;
mod evidence;
pub mod human;
pub mod junit;
pub mod page;
mod picture;
mod plot;
pub mod report;
mod routes;
mod truth;

pub use cases::{Axis, Case, CasesError, Subject};
pub use check::{Choice, Session};
pub use picture::Opened;
pub use routes::Routes;

use std::path::{Path, PathBuf};

/// The folder of goldens: the one that `LOBE_GOLDEN` names, else `golden` of the source tree that this was built from.
#[must_use]
pub fn folder() -> PathBuf {
    let named = std::env::var_os("LOBE_GOLDEN").filter(|value| !value.is_empty());
    named.map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).with_file_name("golden"), PathBuf::from)
}

/// Where goldens are made: what of a machine the truth could depend on.
#[must_use]
pub fn environment() -> String {
    let (lobe, system, machine) = (env!("CARGO_PKG_VERSION"), std::env::consts::OS, std::env::consts::ARCH);
    format!("lobe {lobe}, {system} {machine}")
}
