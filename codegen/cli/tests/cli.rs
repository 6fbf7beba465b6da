//! The binary as its users meet it: exit codes, messages, files.

mod common;

use common::{assert_fails, assert_holds, command, lobe, lobe_with_input, text};
use std::path::Path;

#[test]
fn an_unknown_kernel_is_answered_with_the_nearest() {
    for args in [&["check", "sg_evl"][..], &["emit", "sg_evl", "--target", "wgsl"], &["list", "sg_evl"]] {
        assert_fails(&lobe(args), 2, &["no kernel `sg_evl`", "did you mean `sg_eval`?", "lobe list"]);
    }
    let output = lobe(&["eval", "zzzz", "--args", "-"]);
    assert_fails(&output, 2, &["no kernel `zzzz`; "]);
}

#[test]
fn a_method_that_cannot_is_refused_with_those_that_can() {
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/cases/scenes/plates_a010.json");
    for option in [&["--shadows"][..], &["--field", "8"]] {
        let args = [&["render", scene, "--method", "rect", "-o", "never.exr"], option].concat();
        let wanted = ["is for rect-quadrature, rect-laplace;", "not rect"];
        assert_fails(&lobe(&args), 2, &[&[option[0]], &wanted[..]].concat());
    }
    let args = ["render", scene, "--method", "vsgl2", "--visibility", "exact", "-o", "never.exr"];
    assert_fails(&lobe(&args), 2, &["--visibility is for vpl, vsl, vsl-wide, vsgl;", "not vsgl2"]);
}

#[test]
fn malformed_rows_are_named_by_line_and_column() {
    let eval = |input| lobe_with_input(&["eval", "erf", "--args", "-"], input);
    assert_fails(&eval("{\"x\": 1}\n\n{\"x\": }\n"), 2, &["standard input: line 3, column 7", "no JSON"]);
    assert_fails(&eval("{\"x\": \"one\"}"), 2, &["line 1, column 2", "`x` is a number", "not \"one\""]);
    assert_fails(&eval("{}"), 2, &["line 1, column 1", "lack `x` (f32)"]);
    assert_fails(&eval("[1]"), 2, &["an object with the members x, not an array"]);
    assert_fails(&eval("{\"x\": 1, \"y\": 2}"), 2, &["line 1, column 10", "`y` is none of erf's arguments"]);
    assert_fails(&eval(""), 2, &["no row of arguments"]);
}

#[test]
fn a_value_of_the_wrong_shape_is_named_by_its_path() {
    let row = r#"{"dir": [1, 0, 0], "sg": {"axis": [1, 0], "sharpness": 1, "log_amplitude": 0}}"#;
    let output = lobe_with_input(&["eval", "sg_eval", "--args", "-"], row);
    assert_fails(&output, 2, &["`sg.axis` (Vec3) has 3 elements, 2 are given"]);
}

#[test]
fn floats_travel_as_numbers_hexadecimals_and_words() {
    let input = "{\"x\": 0.5}\n{\"x\": \"0x1p-1\"}\n{\"x\": \"-inf\"}\n{\"x\": \"nan\"}\n";
    let lines = assert_holds(&lobe_with_input(&["eval", "erf", "--args", "-"], input));
    let lines: Vec<&str> = lines.lines().collect();
    assert_eq!(lines.len(), 4);
    assert_eq!(lines[0], lines[1]);
    assert_eq!(lines[2], "-1.0");
    let hex = assert_holds(&lobe_with_input(&["eval", "erf", "--args", "-", "--hex"], "{\"x\": 4}"));
    assert_eq!(hex, "\"0x1p0\"\n");
}

#[test]
fn routes_give_the_same_bits_and_the_shadow_its_bound() {
    let row = "{\"x\": \"0x1.8p-3\"}";
    let native = assert_holds(&lobe_with_input(&["eval", "erf", "--args", "-", "--hex"], row));
    let interp =
        assert_holds(&lobe_with_input(&["eval", "erf", "--args", "-", "--hex", "--route", "interp"], row));
    assert_eq!(native, interp);
    let shadow = assert_holds(&lobe_with_input(&["eval", "erf", "--args", "-", "--shadow"], row));
    let shadow: serde_json::Value = serde_json::from_str(&shadow).expect("JSON");
    let part = |name: &str| shadow["result"][name].as_f64().unwrap_or_else(|| panic!("{shadow}"));
    assert!((part("value") - part("exact")).abs() <= part("bound"), "{shadow}");
}

#[test]
fn a_file_that_is_not_there_and_a_folder_that_cannot_be_made_are_named() {
    assert_fails(&lobe(&["eval", "erf", "--args", "no-such.jsonl"]), 2, &["no-such.jsonl: cannot be read"]);
    assert_fails(&lobe(&["oracle", "no-such-folder"]), 2, &["no-such-folder: cannot be read"]);
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("file");
    std::fs::write(&file, "in the way").expect("writable");
    let below = file.join("out");
    let output = lobe(&["emit", "erf", "--target", "wgsl", "--out", &below.display().to_string()]);
    assert_fails(&output, 2, &["cannot be written", "file"]);
}

#[test]
fn a_failed_write_leaves_nothing_behind() {
    let folder = tempfile::tempdir().expect("a folder");
    // A folder stands where the file should go.
    std::fs::create_dir(folder.path().join("erf.wgsl")).expect("writable");
    let output = lobe(&["emit", "erf", "--target", "wgsl", "--out", &folder.path().display().to_string()]);
    assert_fails(&output, 2, &["erf.wgsl: cannot be written"]);
    assert_eq!(names(folder.path()), ["erf.wgsl"]);
}

#[test]
fn emitting_twice_gives_the_same_files_and_says_which() {
    let folders = [tempfile::tempdir().expect("a folder"), tempfile::tempdir().expect("a folder")];
    for folder in &folders {
        let out = folder.path().join("made").display().to_string();
        let said =
            assert_holds(&lobe(&["emit", "--all", "--target", "wgsl", "--target", "hlsl", "--out", &out]));
        assert!(said.lines().all(|line| line.contains("bytes")), "{said}");
        assert!(said.contains("sg_eval.hlsl"), "{said}");
    }
    let [first, second] = folders.map(|f| f.keep().join("made"));
    assert!(names(&first).len() > 20);
    for name in names(&first) {
        let read = |folder: &Path| std::fs::read(folder.join(&name)).expect("readable");
        assert_eq!(read(&first), read(&second), "{name}");
    }
    for folder in [first, second] {
        std::fs::remove_dir_all(folder.parent().expect("the folder")).expect("removable");
    }
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("readable");
    let mut names: Vec<String> =
        entries.map(|e| e.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn shells_and_man_learn_every_subcommand() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = assert_holds(&lobe(&["completions", shell]));
        assert!(script.contains("emit") && script.contains("prefix"), "{shell}: {script}");
    }
    assert_fails(&lobe(&["completions", "csh"]), 2, &["csh"]);
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("UTF-8");
    let pages = assert_holds(&lobe(&["man", "--out", out]));
    for page in ["lobe.1", "lobe-emit.1", "lobe-check.1", "lobe-man.1"] {
        assert!(pages.contains(page) && folder.path().join(page).is_file(), "{page}\n{pages}");
    }
    let page = std::fs::read_to_string(folder.path().join("lobe-emit.1")).expect("a page");
    assert!(page.contains("prefix") && page.contains(".TH lobe-emit 1"), "{page}");
}

#[test]
fn a_prefix_is_before_every_declared_name_and_in_the_command() {
    let wgsl = assert_holds(&lobe(&[
        "emit", "sg_eval", "--target", "wgsl", "--form", "entry", "--prefix", "eng_", "--out", "-",
    ]));
    for part in [
        "fn eng_sg_eval(dir: vec3<f32>, sg: eng_Sg)",
        "fn eng_sg_eval_entry(",
        "eng_row_count",
        "--prefix eng_",
    ] {
        assert!(wgsl.contains(part), "{part}\n{wgsl}");
    }
    assert_fails(
        &lobe(&["emit", "erf", "--target", "wgsl", "--prefix", "9", "--out", "-"]),
        2,
        &["--prefix 9"],
    );
}

#[test]
fn a_package_is_a_folder_for_an_engine() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("UTF-8");
    for (engine, path, part) in [
        ("plain", "glsl/lobe.glsl", "float sg_eval(vec3 dir, Sg sg)"),
        ("bevy", "assets/shaders/lobe.wgsl", "#define_import_path lobe"),
        ("unity", "ShaderLibrary/Lobe.hlsl", "float lobe_sg_eval(float3 dir, lobe_Sg sg)"),
        ("unreal", "Shaders/Lobe.ush", "#pragma once"),
        ("godot", "lobe/lobe.gdshaderinc", "float lobe_sg_eval(vec3 dir, lobe_Sg sg)"),
        (
            "three",
            "lobe.js",
            "export const sg_eval = wgslFn(`fn lobe_sg_eval(dir: vec3<f32>, sg: lobe_Sg) -> f32",
        ),
    ] {
        let written = assert_holds(&lobe(&["emit", "sg_eval", "--package", engine, "--out", out]));
        assert!(written.contains(path) && written.contains("README.md"), "{engine}: {written}");
        let text = std::fs::read_to_string(folder.path().join(path)).expect("a file");
        assert!(text.contains(part), "{engine}: {text}");
    }
    assert_fails(&lobe(&["emit", "sg_eval", "--package", "unity", "--out", "-"]), 2, &["folder"]);
    assert_fails(&lobe(&["emit", "sg_eval", "--package", "unity", "--target", "wgsl"]), 2, &["--target"]);
}

#[test]
fn one_kernel_goes_to_standard_output_and_two_do_not() {
    let wgsl = assert_holds(&lobe(&["emit", "erf", "--target", "wgsl", "--out", "-"]));
    assert!(wgsl.contains("fn erf(x: f32) -> f32"), "{wgsl}");
    let entry = assert_holds(&lobe(&["emit", "erf", "--target", "hlsl", "--form", "entry", "--out", "-"]));
    assert!(entry.contains("numthreads"), "{entry}");
    let one = assert_holds(&lobe(&["emit", "--all", "--target", "wgsl", "--one-file", "--out", "-"]));
    assert!(one.contains("fn erf(") && one.contains("fn sg_eval("), "{one}");
    assert_fails(
        &lobe(&["emit", "--all", "--target", "wgsl", "--out", "-"]),
        2,
        &["one kernel and one target"],
    );
    assert_fails(&lobe(&["emit", "erf", "--target", "spirv", "--out", "-"]), 2, &["--form entry"]);
    assert_fails(&lobe(&["emit", "erf", "--target", "dxbc"]), 2, &["dxbc"]);
    assert_fails(&lobe(&["emit", "--target", "wgsl"]), 2, &["--all"]);
}

#[test]
fn routes_that_are_none_or_missing_differ_in_their_exit_code() {
    assert_fails(&lobe(&["check", "erf", "--route", "metal@x"]), 2, &["`metal` is no target"]);
    let missing =
        ["check", "erf", "--inputs", "10", "--route", "native", "--require", "spirv@no-such-driver"];
    assert_fails(&lobe(&missing), 3, &["no Vulkan driver `no-such-driver`", "lobe doctor"]);
    assert_fails(&lobe(&["eval", "erf", "--args", "-", "--route", "spirv@nix"]), 2, &["no row of arguments"]);
    let row = "{\"x\": 1}";
    let output = lobe_with_input(&["eval", "erf", "--args", "-", "--route", "spirv@nix"], row);
    assert_fails(&output, 3, &["no Vulkan driver `nix`"]);
}

#[track_caller]
fn assert_named_when_unusable(variable: &str, path: &Path, route: &str) {
    let output = command(&["doctor"]).env(variable, path).output().expect("the binary runs");
    let said = assert_holds(&output);
    assert!(said.contains(&format!("{} cannot be used", path.display())), "{said}");
    let mut check = command(&["check", "erf", "--inputs", "10", "--require", route]);
    let output = check.env(variable, path).output().expect("the binary runs");
    assert_fails(&output, 3, &[&format!("{route} is missing"), variable]);
}

#[test]
fn a_corrupt_compiler_is_a_missing_route_that_says_why() {
    let folder = tempfile::tempdir().expect("a folder");
    for (variable, name, route) in [
        ("LOBE_DXC", "libdxcompiler.so", "hlsl+dxc@lavapipe"),
        ("LOBE_SLANG", "libslang-compiler.so", "hlsl+slang@lavapipe"),
    ] {
        let path = folder.path().join(name);
        std::fs::write(&path, "no library").expect("writable");
        assert_named_when_unusable(variable, &path, route);
    }
    assert_named_when_unusable("LOBE_GLSLANG", &folder.path().join("glslang"), "glsl+glslang@lavapipe");
}

#[test]
fn listing_is_complete_and_touches_no_driver() {
    // A loader that is pointed at nonsense would complain if it were asked.
    let output = command(&["list", "--format", "json"]).env("VK_DRIVER_FILES", "/nonsense").output();
    let listed: serde_json::Value =
        serde_json::from_str(&assert_holds(&output.expect("the binary runs"))).expect("JSON");
    let kernels = listed["kernels"].as_array().expect("kernels");
    assert_eq!(kernels.len(), lobe_kernels::registry::KERNELS.len());
    let sg_eval = kernels.iter().find(|k| k["name"] == "sg_eval").expect("sg_eval");
    assert_eq!(sg_eval["signature"], "sg_eval(dir: Vec3, sg: Sg) -> f32");
    assert!(sg_eval["domain"].as_array().expect("domains").len() >= 4, "{sg_eval}");
}

#[test]
fn operations_are_listed_with_what_each_specification_says() {
    let listed = assert_holds(&lobe(&["list", "--operations", "--format", "json"]));
    let listed: serde_json::Value = serde_json::from_str(&listed).expect("JSON");
    let models = listed["models"].as_array().expect("models");
    let names: Vec<_> = models.iter().filter_map(|m| m["name"].as_str()).collect();
    assert_eq!(names, ["portable", "wgsl", "vulkan", "hlsl"]);
    for model in models {
        let operations = model["operations"].as_array().expect("operations");
        assert!(operations.len() > 50 && operations.iter().all(|row| row["section"].is_string()), "{model}");
    }
    let human = assert_holds(&lobe(&["list", "--operations", "--model", "hlsl"]));
    assert!(human.starts_with("hlsl: ") && human.contains("D3D11.3 22.10.20, sincos"), "{human}");
    assert_fails(&lobe(&["list", "--operations", "sg_eval"]), 2, &["cannot be used with"]);
}

#[test]
fn bounds_are_derived_by_the_specification_that_is_asked_for() {
    let check = |rest: &[&str]| {
        let args = [&["check", "sg_eval", "--inputs", "200"][..], rest, &STRICT].concat();
        assert_holds(&lobe(&args))
    };
    let robust = |text: &str| text.lines().find(|line| line.contains("robust")).map(str::to_owned);
    let (default, hlsl) = (check(&[]), check(&["--model", "hlsl"]));
    assert_ne!(robust(&default), robust(&hlsl));
    assert!(hlsl.contains("accuracy model hlsl") && !default.contains("accuracy model"), "{hlsl}");
    assert_eq!(default, check(&["--model", "portable"]));
    let json: serde_json::Value =
        serde_json::from_str(&check(&["--model", "wgsl", "--format", "json"])).expect("JSON");
    assert_eq!(json["model"], "wgsl");
    assert_fails(&lobe(&["check", "--model", "metal"]), 2, &["portable, wgsl, vulkan, hlsl"]);
}

const STRICT: [&str; 4] = ["--route", "native", "--route", "interp"];

#[test]
fn a_kernel_that_holds_gives_zero_and_all_formats() {
    let check = |format: &str| {
        let args = [&["check", "sg_integral", "--inputs", "200", "--format", format], &STRICT[..]].concat();
        assert_holds(&lobe(&args))
    };
    let human = check("human");
    assert!(human.contains("conformant interp") && human.contains("all holds"), "{human}");
    assert!(!human.contains('\u{1b}'), "no colours outside a terminal");
    let json: serde_json::Value = serde_json::from_str(&check("json")).expect("JSON");
    assert_eq!(json["schema"], 1);
    assert_eq!(json["tally"]["fall_short"], 0);
    assert_eq!(json["kernels"][0]["name"], "sg_integral");
    assert!(check("junit").contains("<testsuite name=\"sg_integral\""));
}

#[test]
fn a_report_goes_to_files_too_by_their_endings() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name).display().to_string();
    let (page, data, xml) = (at("a.html"), at("a.json"), at("a.xml"));
    let args =
        ["check", "sg_integral", "--inputs", "200", "--report", &page, "--report", &data, "--report", &xml];
    let said = assert_holds(&lobe(&[&args[..], &STRICT].concat()));
    assert!(said.contains("all holds"), "people are told as ever: {said}");
    let read = |name: &str| std::fs::read_to_string(name).expect("readable");
    assert!(read(&page).starts_with("<!doctype html>") && read(&page).contains("sg_integral"));
    assert!(read(&xml).contains("<testsuite name=\"sg_integral\""));
    let json = assert_holds(&lobe(&[&args[..4], &["--format", "json"], &STRICT[..]].concat()));
    assert_eq!(read(&data), json);
    let refused = |file: &str, parts: &[&str]| {
        assert_fails(&lobe(&["check", "erf", "--report", file]), 2, parts);
    };
    refused("a.pdf", &["a.pdf", ".html, .json or .xml"]);
    refused(&at("no-such-folder/a.html"), &["no-such-folder/a.html", "there is no folder"]);
    assert_fails(&lobe(&["oracle", folder.path().to_str().expect("UTF-8"), "--report", "a"]), 2, &["ending"]);
}

#[test]
fn the_same_seed_gives_the_same_report() {
    let check = |seed: &str| {
        let args = [&["check", "sg_eval", "--inputs", "300", "--seed", seed], &STRICT[..]].concat();
        text(&lobe(&args).stdout)
    };
    assert_eq!(check("1"), check("1"));
    assert_ne!(check("1"), check("2"));
}

#[test]
fn a_missing_table_is_a_failure() {
    let folder = tempfile::tempdir().expect("a folder");
    let args = [&["check", "sg_integral", "--inputs", "100"], &STRICT[..]].concat();
    let output = command(&args).env("LOBE_CASES", folder.path()).output().expect("the binary runs");
    assert_eq!(output.status.code(), Some(1));
    let said = text(&output.stdout);
    assert!(said.contains("sg_integral.jsonl: cannot be read"), "{said}");
}

#[test]
fn a_listed_case_that_is_malformed_is_a_failure() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("sg_integral.jsonl"), "{\"sharpness\": 1}\n{}\n").expect("writable");
    let args = [&["check", "sg_integral", "--inputs", "100"], &STRICT[..]].concat();
    let output = command(&args).env("LOBE_CASES", folder.path()).output().expect("the binary runs");
    assert_eq!(output.status.code(), Some(1));
    let said = text(&output.stdout);
    assert!(said.contains("sg_integral.jsonl: line 2, column 1"), "{said}");
}

#[test]
fn a_table_with_a_wrong_value_falls_short() {
    let folder = tempfile::tempdir().expect("a folder");
    let row = r#"{"fn": "erf", "args": {"x": 1}, "kind": "formula-f64", "value": 0.8428, "df32": 2.5e-8}"#;
    let other = r#"{"fn": "gamma", "args": {"x": 1}, "kind": "formula-f64", "value": 1}"#;
    std::fs::write(folder.path().join("erf.jsonl"), format!("{row}\n{other}\n")).expect("writable");
    let output = lobe(&[&["oracle", &folder.path().display().to_string()], &STRICT[..]].concat());
    assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
    let said = text(&output.stdout);
    assert!(said.contains("1 of 1 rows are farther off"), "{said}");
    assert!(said.contains("1 rows of gamma (formula-f64): no kernel is mapped"), "{said}");
    let only_unmapped = tempfile::tempdir().expect("a folder");
    std::fs::write(only_unmapped.path().join("gamma.jsonl"), other).expect("writable");
    let output = lobe(&[&["oracle", &only_unmapped.path().display().to_string()], &STRICT[..]].concat());
    assert_eq!(output.status.code(), Some(1), "nothing judged is no success");
}

#[test]
fn a_worst_row_replays_as_printed() {
    let args =
        [&["check", "expm1_over_x_higham", "--inputs", "500", "--format", "json"], &STRICT[..]].concat();
    let json: serde_json::Value = serde_json::from_str(&text(&lobe(&args).stdout)).expect("JSON");
    let answers = json["kernels"][0]["answers"].as_array().expect("answers");
    let native = answers.iter().find(|a| a["subject"] == "native").expect("native");
    let row = native["worst"]["args"].to_string();
    let value = assert_holds(&lobe_with_input(&["eval", "expm1_over_x_higham", "--args", "-"], &row));
    let value: f64 = value.trim().parse().expect("a number");
    let found = native["worst"]["found"].as_f64().expect("a number");
    assert!((value - found).abs() <= 1e-7 * found.abs(), "{value} {found}");
}

#[test]
fn a_reflection_stands_beside_the_sources_unless_it_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().display().to_string();
    let emit = ["emit", "sg_eval", "--target", "spirv", "--form", "entry", "--out", &out];
    assert_holds(&lobe(&[&emit[..], &["--no-reflection"]].concat()));
    assert_eq!(names(folder.path()), ["sg_eval.spv"]);
    assert_holds(&lobe(&emit));
    assert_eq!(names(folder.path()), ["sg_eval.json", "sg_eval.spv"]);
    let json = std::fs::read_to_string(folder.path().join("sg_eval.json")).expect("readable");
    let reflection: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(reflection["schema"], 1);
    assert_eq!(reflection["entries"][0]["name"], "sg_eval_entry");
    assert_eq!(reflection["structs"][0]["members"][1]["offset"], 12);
}

#[test]
fn worst_rows_are_shown_when_asked_for() {
    let check = ["check", "sg_integral", "--inputs", "200", "--route", "interp"];
    assert!(!assert_holds(&lobe(&check)).contains("lobe eval"));
    let all = assert_holds(&lobe(&[&check[..], &["--worst"]].concat()));
    assert!(all.contains("| lobe eval sg_integral --args -"), "{all}");
}

#[test]
fn what_was_measured_is_written_once_and_held() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path().display().to_string();
    let run = |rest: &[&str]| {
        let args = ["measure", "erf", "--inputs", "300", "--folder", &at];
        lobe(&[&args[..], &STRICT[..], rest].concat())
    };
    let missing = run(&["--check"]);
    assert_eq!(missing.status.code(), Some(1));
    assert!(text(&missing.stdout).contains("mend: lobe measure erf --write"), "{}", text(&missing.stdout));
    assert!(assert_holds(&run(&["--write"])).contains("erf.md"));
    assert_eq!(assert_holds(&run(&["--write"])), "", "what is up to date is not written again");
    assert!(assert_holds(&run(&["--check"])).contains("all files are what would be written"));
    let path = folder.path().join("erf.md");
    let good = std::fs::read_to_string(&path).expect("readable");
    let place = good.find("| 0.").expect("a share");
    let spoilt = format!("{}| 0.0001{}", &good[..place], &good[place + 4..]);
    std::fs::write(&path, spoilt).expect("writable");
    let stale = run(&["--check"]);
    assert_eq!(stale.status.code(), Some(1));
    assert!(text(&stale.stdout).contains("file: | "), "{}", text(&stale.stdout));
    let seed = run(&["--check", "--seed", "8"]);
    assert_eq!(seed.status.code(), Some(1));
}

#[test]
fn figures_of_a_driver_that_is_not_here_are_kept_and_said_not_to_be_compared() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path().display().to_string();
    let run = |rest: &[&str]| {
        let args = ["measure", "erf", "--inputs", "300", "--folder", &at];
        lobe(&[&args[..], &STRICT[..], rest].concat())
    };
    assert_holds(&run(&["--write"]));
    let path = folder.path().join("erf.md");
    let text = std::fs::read_to_string(&path).expect("readable");
    let (table, rest) = text.split_once("\n\n<!--").expect("the last line");
    let row = "| `spirv` on nix | 0.5 | 1e-9 | 1 | |";
    let with = format!("{table}\n{row}\n\n- nix is a card\n\n<!--{rest}");
    std::fs::write(&path, &with).expect("writable");
    assert!(assert_holds(&run(&["--check"])).contains("NOT COMPARED: nix in 1 file"));
    assert_holds(&run(&["--write"]));
    assert_eq!(std::fs::read_to_string(&path).expect("readable"), with);
}

#[test]
fn figures_are_the_same_bytes_each_time_and_the_committed_ones() {
    let folders = [tempfile::tempdir().expect("a folder"), tempfile::tempdir().expect("a folder")];
    for folder in &folders {
        let said = assert_holds(&lobe(&["figures", &folder.path().display().to_string()]));
        assert!(said.contains("steepness-dark.png"), "{said}");
    }
    let committed = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../kernels/figures");
    let [first, second] = folders;
    assert_eq!(names(first.path()), names(&committed));
    for name in names(first.path()) {
        let read = |folder: &Path| std::fs::read(folder.join(&name)).expect("readable");
        assert!(read(first.path()) == read(second.path()), "{name} differs from run to run");
        // The rasteriser may round differently on another architecture.
        let is_same_everywhere = name.ends_with(".svg") || cfg!(target_arch = "x86_64");
        let is_fresh = !is_same_everywhere || read(first.path()) == read(&committed);
        assert!(is_fresh, "{name} is stale; lobe figures kernels/figures");
    }
}
