//! The document.

use crate::Row;
use lobe_kernels::registry::KERNELS;
use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

/// Languages, packages, and the kernels that all of them took.
pub(crate) fn document(languages: &[Row], packages: &[Row]) -> String {
    format!(
        "# What compilers take\n\nEvery kernel alone in every language, and the whole library in every package, by a \
         compiler of the language or by the engine itself; measured, not typed. `LOBE_BLESS=1 cargo test --release \
         --workspace --test compilers` writes this file again, and the same test without it says when the file is not \
         of today. What drivers make of kernels is another question, that of `lobe check`.\n\n## Languages\n\n{}\n## \
         Packages\n\n{}\n## Kernels\n\nEach was taken in every row above.\n\n{}",
        table(languages),
        table(packages),
        kernels()
    )
}

fn table(rows: &[Row]) -> String {
    let head = "| | what | compiler | kernels | version |\n|---|---|---|---|---|\n".to_owned();
    rows.iter().fold(head, |text, row| {
        let Row { subject, form, compiler, version, taken, .. } = row;
        text + &format!(
            "| {subject} | {form} | {compiler} | {} of {} | {version} |\n",
            taken.len(),
            KERNELS.len()
        )
    })
}

fn kernels() -> String {
    let mut families: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    for kernel in KERNELS {
        families.entry(kernel().contract.family).or_default().push(format!("`{}`", kernel().name));
    }
    let line = |(family, names): (&str, Vec<String>)| {
        format!("- {family} ({}): {}\n", names.len(), names.join(", "))
    };
    families.into_iter().map(line).collect()
}

/// The document without the last column of its tables.
pub(crate) fn without_versions(document: &str) -> String {
    let line = |line: &str| match line.trim_end_matches('|').rsplit_once('|') {
        Some((kept, _)) if line.starts_with('|') => format!("{kept}|\n"),
        _ => format!("{line}\n"),
    };
    document.lines().map(line).collect()
}

/// The version of a crate that this one is built with.
pub(crate) fn locked(name: &str) -> String {
    let lock = include_str!("../../../Cargo.lock");
    let entry = format!("name = \"{name}\"\nversion = \"");
    let version = lock.split_once(&entry).and_then(|(_, rest)| rest.split_once('"'));
    version.map_or_else(|| panic!("{name} is not locked"), |(version, _)| version.to_owned())
}

/// The first line that a program says of its version.
pub(crate) fn first_line(program: &Path) -> String {
    let output = Command::new(program).arg("--version").output().expect("it runs");
    String::from_utf8_lossy(&output.stdout).lines().next().unwrap_or_default().trim().to_owned()
}

#[test]
fn versions_are_not_compared() {
    let [a, b] = ["1.0", "2.0"].map(|version| format!("| a | b | {version} |\ntext | {version}\n"));
    assert_eq!(without_versions(&a).lines().next(), without_versions(&b).lines().next());
    assert_ne!(without_versions(&a), without_versions(&b));
    assert_ne!(without_versions("| 186 of 187 | 1 |"), without_versions("| 187 of 187 | 1 |"));
}
