//! Invariants of the house that the compiler does not hold: who may name what.

use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace").to_owned()
}

/// Files below `folder` with one of the extensions, build outputs left out.
fn files(folder: &Path, extensions: &[&str]) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display())) {
        let path = entry.expect("an entry").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() && !name.starts_with('.') && name != "target" {
            found.extend(files(&path, extensions));
        } else if path.extension().is_some_and(|e| extensions.iter().any(|x| e == *x)) {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// Lines of code and manifests, comments and texts left out, that hold `word` as a whole word.
fn naming(paths: &[PathBuf], word: &str) -> Vec<String> {
    let mut found = Vec::new();
    for path in paths {
        let text = fs::read_to_string(path).expect("readable");
        let comment = if path.extension().is_some_and(|e| e == "toml") { "#" } else { "//" };
        for (index, line) in text.lines().enumerate() {
            let code = line.split(comment).next().unwrap_or_default();
            let outside_texts: String = code.split('"').step_by(2).collect::<Vec<_>>().join(" ");
            let is_part = |c: char| c.is_alphanumeric() || c == '_';
            if outside_texts.split(|c| !is_part(c)).any(|w| w == word) {
                found.push(format!("{}:{}: {}", path.display(), index + 1, line.trim()));
            }
        }
    }
    found
}

#[track_caller]
fn assert_unnamed(room: &str, words: &[&str]) {
    let paths = files(&root().join(room), &["rs", "toml"]);
    assert!(!paths.is_empty(), "{room} holds no sources");
    for word in words {
        let found = naming(&paths, word);
        assert!(found.is_empty(), "{room} must not name {word}:\n{}", found.join("\n"));
    }
}

#[test]
fn kernels_know_no_compiler_and_no_backend() {
    assert_unnamed("kernels", &["naga", "wgpu", "lobe_backends", "backends"]);
}

#[test]
fn the_macro_does_not_name_naga() {
    assert_unnamed("codegen/macros", &["naga", "wgpu"]);
}

#[test]
fn golden_images_know_no_shaders() {
    assert_unnamed("golden", &["naga", "wgpu", "lobe_codegen", "lobe_backends", "lobe_kernels"]);
}

#[test]
fn only_the_gpu_folder_names_wgpu() {
    let gpu = root().join("backends/src/gpu");
    let all = files(&root(), &["rs"]);
    let others: Vec<PathBuf> =
        all.into_iter().filter(|p| !p.starts_with(&gpu) && !p.ends_with("tests/house.rs")).collect();
    // As a path; messages and doc comments may speak of it.
    let found: Vec<String> = naming(&others, "wgpu")
        .into_iter()
        .filter(|l| l.contains("wgpu::") || l.contains("use wgpu"))
        .collect();
    assert!(found.is_empty(), "only backends/src/gpu names wgpu:\n{}", found.join("\n"));
}

#[test]
fn no_test_is_ignored() {
    let attribute = ["#[", "ignore"].concat();
    for path in files(&root(), &["rs"]) {
        let text = fs::read_to_string(&path).expect("readable");
        let at = text.lines().position(|line| line.trim_start().starts_with(&attribute));
        assert_eq!(at, None, "{}: a test is ignored; assert today's behaviour instead", path.display());
    }
}

#[test]
fn files_stay_readable() {
    let is_source = |p: &PathBuf| p.components().any(|c| c.as_os_str() == "src");
    for path in files(&root(), &["rs"]).into_iter().filter(is_source) {
        let n = fs::read_to_string(&path).expect("readable").lines().count();
        assert!(n <= 700, "{}: {n} lines; split it", path.display());
    }
}

#[test]
fn a_word_is_found_only_whole_and_in_code() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.rs");
    fs::write(&path, "use wgpu::X; // wgpu\n// naga\nlet naga_like = \"naga\";\n").expect("writable");
    assert_eq!(naming(std::slice::from_ref(&path), "wgpu").len(), 1);
    assert!(naming(&[path], "naga").is_empty());
}
