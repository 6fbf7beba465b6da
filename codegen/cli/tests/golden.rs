//! `lobe golden`: what it writes and returns, in folders of its own.

mod common;

use common::{assert_fails, assert_holds, command, text};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use std::process::Output;

const CASES: &str = r#"
[[plot]]
name = "ggx"
kernel = "ggx_ndf_cosine"
columns = { argument = "cosine", from = 0.0, to = 1.0 }
rows = { argument = "alpha", from = 0.1, to = 1.0 }
size = [8, 8]

[[render]]
scene = "plates"
file = "plates_a010.json"
methods = ["direct"]
size = [8, 8]
"#;

struct Goldens(tempfile::TempDir);

impl Goldens {
    fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join("cases.toml"), CASES).expect("written");
        Self(folder)
    }

    fn path(&self, within: &str) -> std::path::PathBuf {
        self.0.path().join(within)
    }

    fn run(&self, args: &[&str]) -> Output {
        self.run_in(args, "")
    }

    fn run_in(&self, args: &[&str], ci: &str) -> Output {
        let mut command = command(&[&["golden"], args].concat());
        command.env("LOBE_GOLDEN", self.0.path()).env("CI", ci).env("USER", "somebody");
        command.output().expect("the binary runs")
    }

    fn check(&self) -> Output {
        self.run(&["check", "--route", "interp"])
    }

    fn accept_all(&self) {
        self.check();
        assert_holds(&self.run(&["accept", "--all", "--reason", "a test"]));
    }

    /// All files but the lock, with what they hold.
    fn files(&self) -> Vec<(String, Vec<u8>)> {
        fn below(folder: &Path, into: &mut Vec<(String, Vec<u8>)>) {
            for entry in fs::read_dir(folder).expect("a folder") {
                let path = entry.expect("an entry").path();
                match path.is_dir() {
                    true => below(&path, into),
                    false => into.push((path.display().to_string(), fs::read(&path).expect("readable"))),
                }
            }
        }
        let mut found = Vec::new();
        below(self.0.path(), &mut found);
        found.retain(|(name, _)| !name.ends_with(".lock"));
        found.sort();
        found
    }
}

fn report(output: &Output) -> Value {
    let value = serde_json::from_slice(&output.stdout).unwrap_or_else(|e| {
        panic!("{e} in {}{}", text(&output.stdout), text(&output.stderr));
    });
    follows("golden-1", &value);
    value
}

#[track_caller]
fn follows(name: &str, value: &Value) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/schema").join(format!("{name}.json"));
    let schema = serde_json::from_str(&fs::read_to_string(path).expect("a schema")).expect("JSON");
    let schema = jsonschema::validator_for(&schema).expect("a schema");
    let errors: Vec<String> =
        schema.iter_errors(value).map(|error| format!("{}: {error}", error.instance_path())).collect();
    assert!(errors.is_empty(), "{}\nin {value:#}", errors.join("\n"));
}

#[test]
fn a_missing_golden_never_passes() {
    let goldens = Goldens::new();
    for _ in 0..2 {
        let output = goldens.check();
        assert_eq!(output.status.code(), Some(1));
        assert!(text(&output.stdout).contains("0 hold, 2 do not"), "{}", text(&output.stdout));
    }
    assert!(goldens.path("pending/plots/ggx.exr").exists());
    assert!(!goldens.path("images").exists());
    goldens.accept_all();
    assert!(assert_holds(&goldens.check()).contains("2 hold, 0 do not"));
    assert!(!goldens.path("pending/plots/ggx.exr").exists());
}

#[test]
fn where_ci_is_set_nothing_is_written() {
    let goldens = Goldens::new();
    let before = goldens.files();
    for (args, ci) in
        [(&["check", "--route", "interp"][..], "true"), (&["check", "--route", "interp", "--no-write"], "")]
    {
        assert_eq!(goldens.run_in(args, ci).status.code(), Some(1));
        assert_eq!(goldens.files(), before);
    }
    goldens.accept_all();
    let before = goldens.files();
    assert_holds(&goldens.run_in(&["check", "--route", "interp"], "1"));
    for args in [
        &["accept", "--all", "--reason", "x"][..],
        &["undo", "--reason", "x"],
        &["reject", "plots/ggx", "--reason", "x"],
    ] {
        assert_eq!(goldens.run_in(args, "true").status.code(), Some(2), "{args:?}");
    }
    assert_eq!(goldens.files(), before);
}

#[test]
fn nothing_is_accepted_unseen_without_saying_so() {
    let goldens = Goldens::new();
    goldens.check();
    assert_fails(&goldens.run(&["accept", "--reason", "x"]), 2, &["SCENE/METHOD"]);
    assert_fails(&goldens.run(&["accept", "--all"]), 2, &["--reason"]);
    assert_fails(&goldens.run(&["accept", "plots/ggx"]), 2, &["--reason"]);
    assert_fails(&goldens.run(&["accept", "plots/ggx", "--reason", " "]), 2, &["needs a reason"]);
    assert_fails(
        &goldens.run(&["accept", "plots/other", "--reason", "x"]),
        2,
        &["plots/other: there is no pending"],
    );
    let long = format!("plots/{}", "x".repeat(300));
    for name in ["../../etc/passwd", "plots/../x", "plots/\"><script>", "plots", &long] {
        assert_fails(&goldens.run(&["accept", name, "--reason", "x"]), 2, &["is no name"]);
    }
    assert!(!goldens.path("images").exists());
}

#[test]
fn a_rejection_is_remembered() {
    let goldens = Goldens::new();
    goldens.check();
    assert_holds(&goldens.run(&["reject", "plots/ggx", "--reason", "too dark", "--by", "ann"]));
    let again = text(&goldens.check().stdout);
    assert!(again.contains("ann rejected this picture: too dark"), "{again}");
    assert_holds(&goldens.run(&["undo", "--reason", "a mistake"]));
    assert!(!text(&goldens.check().stdout).contains("rejected"));
    let log = fs::read_to_string(goldens.path("decisions.jsonl")).expect("a log");
    assert_eq!(log.lines().count(), 2);
    assert_fails(&goldens.run(&["undo", "--reason", "once more"]), 2, &["no decision"]);
}

#[test]
fn decisions_of_a_file_are_carried_out_together() {
    let goldens = Goldens::new();
    let found = report(&goldens.run(&["check", "--route", "interp", "--format", "json"]));
    let decisions = |chain: &Value| {
        let one = |at: usize, chain: &Value| {
            let item = &found["items"][at];
            json!({"scene": item["scene"], "method": item["method"], "action": "accept", "reason": "seen", "chain": chain})
        };
        json!({"schema": 1, "by": "page", "decisions": [one(0, &found["items"][0]["chain"]["hash"]), one(1, chain)]})
    };
    let file = goldens.path("decisions.json");
    let name = file.display().to_string();
    let other = json!("0".repeat(64));
    fs::write(&file, decisions(&other).to_string()).expect("written");
    assert_fails(&goldens.run(&["apply", &name]), 2, &["look at it again"]);
    assert!(!goldens.path("images").exists());
    let good = decisions(&found["items"][1]["chain"]["hash"]);
    follows("golden-decisions-1", &good);
    fs::write(&file, good.to_string()).expect("written");
    assert!(assert_holds(&goldens.run(&["apply", &name])).contains("by page: seen"));
    assert_holds(&goldens.check());
    fs::write(&file, "{}").expect("written");
    assert_fails(&goldens.run(&["apply", &name]), 2, &["missing field"]);
}

#[test]
fn damage_is_found_and_not_repaired() {
    let goldens = Goldens::new();
    goldens.accept_all();
    let exr = goldens.path("images/plots/ggx.exr");
    let whole = fs::read(&exr).expect("readable");
    fs::write(&exr, &whole[..whole.len() / 2]).expect("written");
    let output = goldens.check();
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stdout).contains("damaged"), "{}", text(&output.stdout));
    assert_eq!(fs::read(&exr).expect("readable").len(), whole.len() / 2);
    fs::remove_dir_all(goldens.path("images/plots")).expect("removed");
    assert!(text(&goldens.check().stdout).contains("there is no golden"));
}

#[test]
fn dead_goldens_are_found_and_pruned() {
    let goldens = Goldens::new();
    goldens.accept_all();
    let cases = CASES.replace("name = \"ggx\"", "name = \"other\"");
    fs::write(goldens.path("cases.toml"), cases).expect("written");
    let output = goldens.check();
    assert!(text(&output.stdout).contains("dead         plots/ggx"), "{}", text(&output.stdout));
    assert_holds(&goldens.run(&["accept", "plots/other", "--reason", "renamed"]));
    assert_eq!(goldens.check().status.code(), Some(1), "a dead golden is no pass");
    assert_holds(&goldens.run(&["prune", "--reason", "renamed"]));
    assert_holds(&goldens.check());
}

#[test]
fn reports_say_the_same_in_all_forms() {
    let goldens = Goldens::new();
    goldens.accept_all();
    let found = report(&goldens.run(&["check", "--route", "interp", "--format", "json"]));
    assert_eq!(found["tally"]["holds"], 2);
    assert!(
        found["items"][0]["proof"].as_str().is_some_and(|proof| proof.starts_with("unaffected: kernels ggx"))
    );
    let (page, xml) = (goldens.path("report"), goldens.path("report.xml"));
    let (page, xml) = (page.display().to_string(), xml.display().to_string());
    assert_holds(&goldens.run(&["report", &page, "--route", "interp"]));
    let written: Value =
        serde_json::from_str(&fs::read_to_string(Path::new(&page).join("report.json")).expect("a report"))
            .expect("JSON");
    follows("golden-1", &written);
    for item in written["items"].as_array().expect("items") {
        let files = [&item["files"]["accepted"], &item["routes"][0]["picture"]];
        for file in files {
            assert!(Path::new(&page).join(file.as_str().expect("a file")).exists(), "{file}");
        }
    }
    fs::write(goldens.path("images/plots/ggx.exr"), b"").expect("written");
    let output =
        goldens.run(&["check", "--route", "interp", "--report", &xml, "--affected", "--format", "json"]);
    let found = report(&output);
    assert_eq!((&found["tally"]["damaged"], &found["tally"]["holds"]), (&json!(1), &json!(1)));
    let xml = fs::read_to_string(xml).expect("a report");
    assert!(xml.contains("damaged: plots/ggx") && xml.contains("failures=\"1\""), "{xml}");
}

#[test]
fn what_is_not_there_is_not_judged() {
    let goldens = Goldens::new();
    assert_fails(&goldens.run(&["check", "plots/none"]), 2, &["there is no golden `plots/none`"]);
    assert_fails(&goldens.run(&["check", "--route", "spirv@no-such-driver"]), 3, &["no-such-driver"]);
    assert_fails(&goldens.run(&["check", "--require", "spirv@no-such-driver"]), 3, &["no-such-driver"]);
    assert_fails(&goldens.run(&["check", "--report", "x.html"]), 2, &[".json or .xml"]);
    fs::write(goldens.path("cases.toml"), "").expect("written");
    assert_fails(&goldens.check(), 2, &["it states no case"]);
    fs::remove_file(goldens.path("cases.toml")).expect("removed");
    assert_fails(&goldens.check(), 2, &["cannot be read"]);
}

#[test]
fn two_checks_at_once_agree() {
    let goldens = Goldens::new();
    std::thread::scope(|scope| {
        let all: Vec<_> = (0..2).map(|_| scope.spawn(|| goldens.check())).collect();
        for one in all {
            assert_eq!(one.join().expect("it ends").status.code(), Some(1));
        }
    });
    assert_holds(&goldens.run(&["accept", "--all", "--reason", "x"]));
    assert_holds(&goldens.check());
}
