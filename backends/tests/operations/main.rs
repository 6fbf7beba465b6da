//! Every operation of naga's IR has a state on the interpreter, and `backends/OPERATIONS.md` tells it.
//!
//! What is said to run is in a module of `tests/cases/corpus`, which `lobe run` is tested with; what is said to be refused is in
//! a module of `tests/cases/corpus/refused`.

mod rows;
mod walk;

use lobe_backends::interp::{InterpError, Interpreter};
use lobe_codegen::ValidModule;
use lobe_codegen::foreign::{self, Language, Source};
use rows::{Key, State, TABLE};
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::{Path, PathBuf};

fn corpus(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/cases").join(folder);
    let entries = std::fs::read_dir(&folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let mut files: Vec<_> =
        entries.map(|e| e.unwrap().path()).filter(|p| Language::of(p).is_some()).collect();
    files.sort();
    files
}

fn file_name(file: &Path) -> String {
    file.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

fn parsed(file: &Path) -> Result<ValidModule, String> {
    let language = Language::of(file).ok_or(format!("{} is no shader", file.display()))?;
    let bytes = std::fs::read(file).map_err(|e| e.to_string())?;
    foreign::read(&Source { name: file_name(file), language, bytes }).map_err(|e| e.to_string())
}

fn keys_of(folder: &str) -> BTreeSet<Key> {
    let modules = corpus(folder).into_iter().filter_map(|file| parsed(&file).ok());
    modules.flat_map(|module| walk::keys(module.module())).collect()
}

#[test]
fn every_module_is_valid() {
    let files = [corpus("corpus"), corpus("corpus/refused")].concat();
    let wrong: Vec<_> = files.iter().filter_map(|file| parsed(file).err()).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn rows() -> impl Iterator<Item = (Key, State)> {
    TABLE.iter().flat_map(|section| section.rows.iter().map(|(name, state)| ((section.title, *name), *state)))
}

#[test]
fn what_runs_is_in_the_corpus() {
    let found = keys_of("corpus");
    let missing: Vec<_> = rows()
        .filter(|(key, state)| *state == State::Runs && !found.contains(key))
        .map(|(key, _)| key)
        .collect();
    assert!(missing.is_empty(), "no module of the corpus has {missing:?}");
}

#[test]
fn what_is_refused_is_not_in_the_corpus() {
    let found = keys_of("corpus");
    let wrong: Vec<_> = rows().filter(|(key, state)| *state != State::Runs && found.contains(key)).collect();
    assert!(wrong.is_empty(), "the corpus has {wrong:?}");
}

#[test]
fn what_is_refused_has_a_module_that_is() {
    let found = keys_of("corpus/refused");
    let missing: Vec<_> = rows()
        .filter(|(key, state)| matches!(state, State::Refused(_)) && !found.contains(key))
        .map(|(key, _)| key)
        .collect();
    assert!(missing.is_empty(), "no refused module has {missing:?}");
}

/// What each refused module's message has to say.
const REFUSALS: &[(&str, &str)] = &[
    ("cooperative_matrix.wgsl", "cooperative matrices"),
    ("external_texture.wgsl", "external textures"),
    ("ray_query.wgsl", "ray queries"),
];

#[test]
fn refusals_say_what_and_where() {
    let names: Vec<_> = corpus("corpus/refused").iter().map(|f| file_name(f)).collect();
    assert_eq!(names, REFUSALS.iter().map(|(name, _)| *name).collect::<Vec<_>>());
    for (file, (_, what)) in corpus("corpus/refused").iter().zip(REFUSALS) {
        let module = parsed(file).unwrap_or_else(|e| panic!("{e}"));
        let error = Interpreter::new(&module).and_then(|i| i.run(0, [1; 3], &mut [])).expect_err("refused");
        let said = matches!(error, InterpError::Unsupported { .. }) && error.to_string().contains(what);
        assert!(said, "{}: {error} does not say {what}", file.display());
    }
}

fn document() -> String {
    let mut text = String::from(
        "# What the interpreter runs\n\n\
         Every operation of naga 30's IR that a compute entry point could have. The tests in `tests/operations` make this \
         file and keep it true: what runs is in a module of `tests/cases/corpus`, which gives the same results on the \
         interpreter and on lavapipe; what is refused is refused with a message that names it.\n",
    );
    for section in TABLE {
        let _ = writeln!(text, "\n## {}\n", section.title);
        let of = |wanted: fn(&State) -> bool| {
            let rows = section.rows.iter().filter(move |(_, state)| wanted(state));
            rows.map(|(name, _)| format!("`{name}`")).collect::<Vec<_>>().join(", ")
        };
        let runs = of(|state| *state == State::Runs);
        let _ = writeln!(text, "Runs: {}.", if runs.is_empty() { "none" } else { &runs });
        text += &exceptions(section.rows);
    }
    text
}

/// The rows that do not run, by reason.
fn exceptions(rows: &[(&'static str, State)]) -> String {
    let mut reasons: Vec<(&str, &str, Vec<String>)> = Vec::new();
    for (name, state) in rows {
        let (what, why) = match state {
            State::Runs => continue,
            State::Refused(why) => ("Refused", *why),
            State::Outside(why) => ("Never in a compute shader", *why),
        };
        match reasons.iter_mut().find(|known| (known.0, known.1) == (what, why)) {
            Some((.., names)) => names.push(format!("`{name}`")),
            None => reasons.push((what, why, vec![format!("`{name}`")])),
        }
    }
    let line =
        |(what, why, names): &(&str, &str, Vec<String>)| format!("\n{what} ({why}): {}.\n", names.join(", "));
    reasons.iter().map(line).collect()
}

#[test]
fn the_document_tells_it() {
    expect_test::expect_file!["../../OPERATIONS.md"].assert_eq(&document());
}
