//! Every kernel in every language and package, by a compiler of that language: `tests/COMPILERS.md` tells it.

#[path = "../common/mod.rs"]
mod common;
mod document;
#[path = "../godot/shaders.rs"]
#[allow(dead_code, reason = "of what it finds a part is needed")]
mod godot;
mod languages;
mod packages;
#[path = "../three/pages.rs"]
#[allow(dead_code, reason = "of its pages one is needed")]
mod three;

use document::{document, without_versions};
use lobe_codegen::package::{Package, package};
use lobe_kernels::registry::KERNELS;
use std::collections::BTreeSet;
use std::path::Path;

/// What a compiler took.
struct Row {
    /// The language or package.
    subject: &'static str,
    /// What of it was compiled.
    form: &'static str,
    /// The compiler.
    compiler: &'static str,
    /// As it states it.
    version: String,
    /// The kernels that it took.
    taken: BTreeSet<&'static str>,
    /// What it said of the first that it did not.
    fault: Option<String>,
}

impl Row {
    /// A row of the kernels for which `verdicts` are good.
    fn new(
        subject: [&'static str; 3],
        version: String,
        verdicts: impl IntoIterator<Item = (&'static str, Result<(), String>)>,
    ) -> Self {
        let [subject, form, compiler] = subject;
        let mut row = Self { subject, form, compiler, version, taken: BTreeSet::new(), fault: None };
        for (name, verdict) in verdicts {
            match verdict {
                Ok(()) => _ = row.taken.insert(name),
                Err(why) => _ = row.fault.get_or_insert(format!("{name}: {why}")),
            }
        }
        row
    }
}

/// The names of all kernels.
fn names() -> impl Iterator<Item = &'static str> {
    KERNELS.iter().map(|kernel| kernel().name)
}

/// The whole library as a package.
fn files(kind: Package) -> Vec<(String, String)> {
    let module = lobe_codegen::lower(KERNELS).unwrap_or_else(|e| panic!("{e}"));
    let names: Vec<String> = names().map(str::to_owned).collect();
    let files = package(&module, &names, kind, kind.prefix()).unwrap_or_else(|e| panic!("{e}"));
    files.into_iter().map(|file| (file.path, file.text)).collect()
}

/// `LOBE_BLESS=1` writes the document again. Versions of compilers are told there, and not compared: those that a
/// system brings differ from machine to machine.
#[test]
fn every_kernel_is_taken_by_every_compiler_and_the_document_says_so() {
    let Some(languages) = languages::rows() else { return };
    let Some(packages) = packages::rows() else { return };
    for row in languages.iter().chain(&packages) {
        let n_missing = KERNELS.len() - row.taken.len();
        assert_eq!(n_missing, 0, "{} by {}: {:?}", row.subject, row.compiler, row.fault);
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("COMPILERS.md");
    let today = document(&languages, &packages);
    if std::env::var_os("LOBE_BLESS").is_some() {
        std::fs::write(&path, &today).expect("written");
    }
    let written = std::fs::read_to_string(&path).unwrap_or_default();
    let is_current = without_versions(&written) == without_versions(&today);
    assert!(is_current, "tests/COMPILERS.md is not of today (LOBE_BLESS=1 writes it again):\n{today}");
}
