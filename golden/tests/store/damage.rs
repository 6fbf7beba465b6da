//! Files that are not what was accepted.

use crate::cases::{accept, accepted};
use lobe_golden::{CaseName, Store};
use std::fs;
use std::path::{Path, PathBuf};

struct Damaged {
    _folder: tempfile::TempDir,
    root: PathBuf,
    exr: PathBuf,
    toml: PathBuf,
}

fn store() -> Damaged {
    let folder = tempfile::tempdir().expect("a folder");
    let root = folder.path().to_owned();
    accept(&Store::open(&root), "box/direct", 1);
    let file = |ending: &str| root.join("images/box").join(format!("direct.{ending}"));
    Damaged { exr: file("exr"), toml: file("toml"), root, _folder: folder }
}

impl Damaged {
    /// What is said of the golden.
    fn message(&self) -> String {
        let case: CaseName = "box/direct".parse().expect("a name");
        let outcome = Store::read_only(&self.root).golden(&case);
        outcome
            .map(|found| assert!(found.is_none(), "it was read"))
            .expect_err("it cannot be used")
            .to_string()
    }

    #[track_caller]
    fn check(&self, change: impl Fn(&Path, &[u8]), file: &Path, expected: &str) {
        let before = fs::read(file).expect("readable");
        change(file, &before);
        let message = self.message();
        assert!(message.contains(expected), "{message}");
        assert!(message.contains("box/direct"), "{message}");
        let _ = fs::remove_file(file);
        fs::write(file, before).expect("written");
        assert_eq!(accepted(&Store::read_only(&self.root), "box/direct"), Some(1));
    }
}

fn write(bytes: &'static [u8]) -> impl Fn(&Path, &[u8]) {
    move |path, _| fs::write(path, bytes).expect("written")
}

#[test]
fn half_a_golden_is_no_golden() {
    let store = store();
    store.check(|path, _| fs::remove_file(path).expect("removed"), &store.exr, "restore it by git");
    store.check(|path, _| fs::remove_file(path).expect("removed"), &store.toml, "restore it by git");
}

#[test]
fn no_golden_is_missing() {
    let store = store();
    fs::remove_dir_all(store.root.join("images")).expect("removed");
    assert_eq!(accepted(&Store::read_only(&store.root), "box/direct"), None);
}

#[test]
fn nothing_and_pointers_say_so() {
    let store = store();
    const POINTER: &[u8] = b"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n";
    store.check(write(b""), &store.exr, "it is empty");
    store.check(write(b""), &store.toml, "it is empty");
    store.check(write(POINTER), &store.exr, "git lfs pull");
    store.check(write(POINTER), &store.toml, "git lfs pull");
    store.check(write(b"no picture"), &store.exr, "restore it by git");
    store.check(write(b"no = 'record'"), &store.toml, "it is no record");
}

#[test]
fn what_is_cut_off_at_every_64th_byte_is_found() {
    let store = store();
    for file in [&store.exr, &store.toml] {
        let whole = fs::read(file).expect("readable");
        for end in (0..whole.len()).step_by(64).chain([whole.len() - 1]) {
            fs::write(file, &whole[..end]).expect("written");
            // The last byte of a record is a line feed, which it can do without.
            if file == &store.toml && end == whole.len() - 1 {
                continue;
            }
            assert!(!store.message().is_empty(), "{} cut at {end}", file.display());
        }
        fs::write(file, whole).expect("written");
    }
}

#[test]
fn every_flipped_bit_of_a_picture_is_found() {
    let store = store();
    let whole = fs::read(&store.exr).expect("readable");
    for at in 0..whole.len() {
        let mut flipped = whole.clone();
        flipped[at] ^= 1 << (at % 8);
        fs::write(&store.exr, flipped).expect("written");
        assert!(store.message().contains("those that were accepted"), "bit {} of byte {at}", at % 8);
    }
}

#[test]
fn another_size_is_found() {
    let store = store();
    let change = |path: &Path, bytes: &[u8]| {
        let text = std::str::from_utf8(bytes).expect("text").replace("size = [16, 16]", "size = [16, 8]");
        fs::write(path, text).expect("written");
    };
    store.check(change, &store.toml, "it is 16 x 16, and the record says 16 x 8");
}

#[test]
fn what_is_long_is_not_read() {
    let store = store();
    let long = |path: &Path, _: &[u8]| {
        let file = fs::OpenOptions::new().write(true).open(path).expect("opened");
        file.set_len(1 << 40).expect("a hole");
    };
    store.check(long, &store.exr, "1099511627776 bytes");
    store.check(long, &store.toml, "1099511627776 bytes");
}

#[test]
fn a_file_that_is_a_folder_is_no_file() {
    let store = store();
    let before = fs::read(&store.exr).expect("readable");
    fs::remove_file(&store.exr).expect("removed");
    fs::create_dir(&store.exr).expect("made");
    assert!(store.message().contains("it cannot be read"));
    fs::remove_dir(&store.exr).expect("removed");
    fs::write(&store.exr, before).expect("written");
}

#[cfg(unix)]
#[test]
fn links_lead_nowhere() {
    let store = store();
    let elsewhere = store.root.join("elsewhere");
    fs::rename(store.root.join("images"), &elsewhere).expect("moved");
    std::os::unix::fs::symlink(&elsewhere, store.root.join("images")).expect("linked");
    assert!(store.message().contains("symbolic link"));
    let writer = Store::open(&store.root);
    crate::cases::put(&writer, "box/direct", 2);
    let outcome = writer.carry_out(&[crate::cases::step("box/direct", true)], &crate::cases::somebody());
    assert!(outcome.expect_err("it is a link").to_string().contains("symbolic link"));
    assert!(fs::read(elsewhere.join("box/direct.exr")).is_ok());
}

#[test]
fn a_damaged_log_is_no_log() {
    let store = store();
    let log = store.root.join("decisions.jsonl");
    let text = fs::read_to_string(&log).expect("readable");
    fs::write(&log, format!("{text}<<<<<<< HEAD\n")).expect("written");
    let error = Store::read_only(&store.root).decisions().expect_err("a line is none");
    assert!(error.to_string().contains("line 2 is no decision"), "{error}");
}

#[test]
fn a_golden_that_cannot_be_used_can_be_replaced() {
    let store = store();
    fs::write(&store.exr, b"").expect("written");
    accept(&Store::open(&store.root), "box/direct", 2);
    assert_eq!(accepted(&Store::open(&store.root), "box/direct"), Some(2));
}
