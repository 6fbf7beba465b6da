//! `lobe run` as its users meet it, with shaders that mean well and shaders that do not.

mod common;

use common::{assert_fails, assert_holds, command, lobe, text};
use serde_json::Value;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

const OUT: &str = "@group(0) @binding(0) var<storage, read_write> out: array<u32>;\n";
const MAIN: &str = "@compute @workgroup_size(1) fn main() {";

/// A folder with these files.
fn folder(files: &[(&str, &[u8])]) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, bytes) in files {
        std::fs::write(folder.path().join(name), bytes).expect("writable");
    }
    folder
}

fn at(folder: &TempDir, name: &str) -> String {
    folder.path().join(name).display().to_string()
}

/// The reports of a batch without GPU routes, and its summary.
fn batch(folder: &Path, rest: &[&str]) -> (Vec<Value>, Value, Option<i32>) {
    let list = folder.display().to_string();
    let args = [&["run", "--batch", &list, "--format", "json", "--route", "interp"], rest].concat();
    let output = lobe(&args);
    let said = text(&output.stdout);
    let mut lines: Vec<Value> = said.lines().map(|l| serde_json::from_str(l).expect("JSON")).collect();
    let summary = lines.pop().unwrap_or_else(|| panic!("no summary: {}", text(&output.stderr)));
    (lines, summary["summary"].clone(), output.status.code())
}

/// Runs `bytes` as a file of this name, and wants `status` with a message that holds `part`.
#[track_caller]
fn assert_ends(name: &str, bytes: &[u8], status: &str, part: &str) {
    let folder = folder(&[(name, bytes)]);
    let (reports, _, _) = batch(folder.path(), &["--timeout", "60", "--fuel", "10000"]);
    let report = reports.first().unwrap_or_else(|| panic!("{name}: no report"));
    assert_eq!(report["status"], status, "{name}: {report}");
    let message = report["message"].as_str().unwrap_or_default();
    assert!(message.contains(part), "{name}: no `{part}` in: {message}");
    let path: PathBuf = folder.path().join(name);
    assert_eq!(report["file"], path.display().to_string(), "the file is named");
}

#[test]
fn drivers_drawn_by_a_specification_are_judged_by_it() {
    let wgsl = "@group(0) @binding(0) var<storage, read_write> x: array<f32>;
        @compute @workgroup_size(64) fn main(@builtin(local_invocation_index) i: u32) {
            x[i] = exp(x[i]) * sin(3.0 * x[i]) / (2.0 + x[i]);
        }";
    let folder = folder(&[("a.wgsl", wgsl.as_bytes())]);
    for model in ["portable", "wgsl", "vulkan", "hlsl"] {
        let (reports, _, _) = batch(folder.path(), &["--model", model, "--route", "perturbed:1"]);
        let expected = (model != "portable").then_some(model);
        assert_eq!((reports[0]["status"].as_str(), reports[0]["model"].as_str()), (Some("ok"), expected));
        let permitted = &reports[0]["routes"].to_string();
        assert!(permitted.contains("perturbed:1"), "{permitted}");
    }
    let refused = lobe(&["run", &at(&folder, "a.wgsl"), "--model", "metal"]);
    assert_fails(&refused, 2, &["portable, wgsl, vulkan, hlsl"]);
}

#[test]
fn a_shader_runs_on_its_data_and_leaves_its_results() {
    let wgsl = "
        struct Item { flag: i32, color: vec3<f32> }
        @group(0) @binding(0) var<storage, read_write> items: array<Item>;
        @group(0) @binding(1) var<uniform> scale: vec2<f32>;
        override more: i32 = 1;
        @compute @workgroup_size(2) fn main(@builtin(global_invocation_id) id: vec3<u32>) {
            items[id.x].color.y = items[id.x].color.x * scale.x + scale.y;
            items[id.x].flag += more;
        }";
    let items = r#"[{"flag": 1, "color": ["0x1.8p1", 0, "inf"]}, {"flag": -9, "color": [-1, 0, 0.5]}]"#;
    let scale: Vec<u8> = [2.0_f32, 0.5].iter().flat_map(|x| x.to_le_bytes()).collect();
    let folder =
        folder(&[("a.wgsl", wgsl.as_bytes()), ("items.json", items.as_bytes()), ("scale.bin", &scale)]);
    let (input, scale) =
        (format!("items={}", at(&folder, "items.json")), format!("0:1={}", at(&folder, "scale.bin")));
    let outputs = ["json", "bin"].map(|e| format!("items={}", at(&folder, &format!("out.{e}"))));
    let shader = at(&folder, "a.wgsl");
    let args =
        ["run", &shader, "--input", &input, "--input", &scale, "--override", "more=10", "--route", "interp"];
    let said =
        assert_holds(&lobe(&[&args[..], &["--output", &outputs[0], "--output", &outputs[1]]].concat()));
    assert!(said.contains("items (0:0) 64 bytes") && said.ends_with("ok\n"), "{said}");
    let json = std::fs::read_to_string(folder.path().join("out.json")).expect("readable");
    let expected = r#"[{"flag":11,"color":[3.0,6.5,"inf"]},{"flag":1,"color":[-1.0,-1.5,0.5]}]"#;
    assert_eq!(json.trim(), expected);
    let bytes = std::fs::read(folder.path().join("out.bin")).expect("readable");
    assert_eq!((bytes.len(), &bytes[20..24]), (64, &6.5_f32.to_le_bytes()[..]));
}

#[test]
fn directives_that_naga_does_not_know_are_no_hindrance_and_move_nothing() {
    let main = "out[0] = subgroupAdd(1u); }";
    let good = format!("// A module.\nenable f16, subgroups;\nrequires subgroup_id;\n{OUT}{MAIN} {main}");
    let bad = good.replace("1u", "x");
    let folder = folder(&[("good.wgsl", good.as_bytes()), ("bad.wgsl", bad.as_bytes())]);
    assert_holds(&lobe(&["run", &at(&folder, "good.wgsl"), "--route", "interp"]));
    let said = lobe(&["run", &at(&folder, "bad.wgsl"), "--route", "interp"]);
    let column = MAIN.len() + " out[0] = subgroupAdd(".len() + 1;
    assert!(text(&said.stdout).contains(&format!("bad.wgsl:5:{column}")), "{}", text(&said.stdout));
}

#[test]
fn what_does_not_fit_the_shader_is_named() {
    let wgsl = format!("{OUT}{MAIN} out[0] = 1u; }} {} out[1] = 1u; }}", MAIN.replace("main", "other"));
    let folder = folder(&[("two.wgsl", wgsl.as_bytes()), ("odd.bin", &[1, 2, 3]), ("bad.json", b"[1, -1]")]);
    let shader = at(&folder, "two.wgsl");
    let (odd, bad) = (format!("out={}", at(&folder, "odd.bin")), format!("out={}", at(&folder, "bad.json")));
    let run = |rest: &[&str]| lobe(&[&["run", &shader, "--route", "interp"], rest].concat());
    let told = |rest: &[&str], part: &str| {
        let output = run(rest);
        let said = text(&output.stdout);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(part), "no `{part}` in: {said}");
    };
    assert_eq!(run(&["--entry", "other"]).status.code(), Some(0));
    told(&[], "several compute entry points: `main`, `other`; choose one with --entry");
    told(&["--entry", "third"], "no compute entry point `third`; there is `main`, `other`");
    told(&["--entry", "main", "--input", "in=zeros"], "no resource `in`; it has `out` (0:0)");
    told(&["--entry", "main", "--input", &odd], "a multiple of 4; it has 3");
    told(&["--entry", "main", "--input", &bad], "`out[1]` is a non-negative integer of 32 bits, not -1");
    told(&["--entry", "main", "--input", "out=no-such-file"], "no-such-file: cannot be read");
    told(&["--entry", "main", "--size", "out=2147483648"], "more than the 1073741824 that a buffer may have");
    told(&["--entry", "main", "--override", "n=1"], "'n'");
}

#[test]
fn options_that_are_none_are_bad_usage() {
    for (args, part) in [
        (&["run"][..], "name a shader, or a list of shaders with --batch"),
        (&["run", "a.wgsl", "--workgroups", "0,1,1"], "at least 1"),
        (&["run", "a.wgsl", "--workgroups", "1,1,1,1"], "one to three numbers"),
        (&["run", "a.wgsl", "--input", "out"], "no `=`"),
        (&["run", "a.wgsl", "--input", "out=random:x"], "`x` is no seed"),
        (&["run", "a.wgsl", "--route", "metal@x"], "`metal` is no target"),
        (&["run", "--batch", "no-such-list"], "no-such-list: cannot be read"),
    ] {
        assert_fails(&lobe(args), 2, &[part]);
    }
    assert_fails(&lobe(&["run", "a.wgsl", "--route", "spirv@nix"]), 3, &["no Vulkan driver `nix`"]);
    assert_eq!(lobe(&["run", "no-such.wgsl"]).status.code(), Some(2));
    assert_eq!(lobe(&["run", "no-shader.txt"]).status.code(), Some(2));
}

#[test]
fn errors_of_the_front_end_show_file_line_and_column() {
    let folder = folder(&[("bad.wgsl", b"fn f() -> u32 {\n    return 1.5;\n}")]);
    let output = lobe(&["run", &at(&folder, "bad.wgsl")]);
    let said = text(&output.stdout);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("bad.wgsl:2:12") && said.contains("^^^"), "{said}");
}

#[test]
fn hostile_files_end_in_a_word_about_them() {
    let wgsl = |body: &str| format!("{OUT}{MAIN}{body}}}").into_bytes();
    let glsl = |body: &str| {
        let head = "#version 450\nlayout(local_size_x = 1) in;\nlayout(std430, binding = 0) buffer B { uint data[]; };\n";
        format!("{head}void main() {{ {body} }}").into_bytes()
    };
    let deep = |open: &str, inner: &str, close: &str| open.repeat(20_000) + inner + &close.repeat(20_000);
    let random: Vec<u8> = (0_u32..4096).map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
    let magic = |rest: &[u32]| {
        [&[0x0723_0203, 0x0001_0300], rest].concat().iter().flat_map(|w| w.to_le_bytes()).collect()
    };
    let truncated: Vec<u8> = magic(&[0, 8, 0, (5 << 16) | 15, 5]);
    for (name, bytes, status, part) in [
        ("empty.wgsl", Vec::new(), "refused", "no compute entry point"),
        ("empty.spv", Vec::new(), "invalid", "empty.spv"),
        ("empty.glsl", Vec::new(), "invalid", "entry point"),
        ("random.spv", random, "invalid", "random.spv"),
        ("truncated.spv", truncated, "invalid", "truncated.spv"),
        ("odd.spv", vec![3, 2, 0x23], "invalid", "odd.spv"),
        ("nul.wgsl", vec![0; 100], "invalid", "nul.wgsl:1:1"),
        ("nul.glsl", vec![0; 100], "invalid", "nul.glsl: error: UnexpectedCharacter"),
        ("latin.wgsl", vec![b'/', b'/', 0xe9], "invalid", "byte 2 is not UTF-8"),
        ("braces.wgsl", wgsl(&deep("{", "", "}")), "invalid", "nesting limit"),
        ("parens.wgsl", wgsl(&format!("out[0] = {};", deep("(", "1u", ")"))), "invalid", "error"),
        ("parens.glsl", glsl(&format!("data[0] = {};", deep("(", "1u", ")"))), "ok", ""),
        ("minus.glsl", glsl(&format!("data[0] = uint({}1);", "- ".repeat(20_000))), "ok", ""),
        ("array.wgsl", b"var<private> a: array<u32, 4000000000>;".to_vec(), "invalid", "array.wgsl"),
        (
            "large.wgsl",
            wgsl("var a: array<u32, 100000000>; a[out[0]] = 1u; out[1] = a[5];"),
            "refused",
            "scalars",
        ),
        ("divided.wgsl", wgsl("let x = 1 / 0;"), "invalid", "ivision by zero"),
        ("endless.wgsl", wgsl("loop {}"), "timeout", "runs too long"),
        ("fragment.wgsl", b"@fragment fn f() {}".to_vec(), "refused", "only `f`"),
        ("size.wgsl", b"@compute @workgroup_size(0) fn main() {}".to_vec(), "invalid", "size.wgsl"),
        (
            "override.wgsl",
            format!("override n: u32; {OUT}{MAIN} out[0] = n; }}").into_bytes(),
            "error",
            "are `n`",
        ),
        (
            "itself.wgsl",
            b"fn f() { f(); } @compute @workgroup_size(1) fn main() { f(); }".to_vec(),
            "invalid",
            "",
        ),
    ] {
        assert_ends(name, &bytes, status, part);
    }
}

#[test]
fn what_would_take_too_long_is_refused_at_once_and_at_its_place() {
    let doubled = |first: &str, level: &dyn Fn(u32) -> String, levels: u32| {
        (1..levels).fold(first.to_owned(), |text, n| text + &level(n))
    };
    let calls = doubled("fn f0() {}", &|n| format!("fn f{n}() {{ f{m}(); f{m}(); }}", m = n - 1), 63);
    let wide = doubled(
        "struct S0 { a: u32, b: u32 }",
        &|n| format!("struct S{n} {{ a: S{m}, b: S{m} }}", m = n - 1),
        25,
    );
    let first = ".a".repeat(25);
    let glsl = format!(
        "#version 450\nlayout(local_size_x = 1) in;\nvoid main() {{ {} {} }}",
        "{".repeat(20_000),
        "}".repeat(20_000)
    );
    let external = "@group(0) @binding(0) var image: texture_external;
        @compute @workgroup_size(1) fn main() {
            let size = textureDimensions(image);
        }";
    for (name, text, part) in [
        ("calls.wgsl", format!("{calls} {MAIN} f62(); }}"), "calls that inline to more than"),
        ("wide.wgsl", format!("{wide} {OUT}{MAIN} var s: S24; out[0] = s{first}; }}"), "scalars"),
        (
            "members.wgsl",
            format!("{wide} @group(0) @binding(0) var<storage> s: S24; {MAIN} let x = s{first}; }}"),
            "more than 65536 members",
        ),
        ("blocks.glsl", glsl, "blocks nested deeper than 512 (in `main`)"),
        (
            "external.wgsl",
            external.to_owned(),
            "external.wgsl:3:24: the interpreter does not execute external",
        ),
    ] {
        assert_ends(name, text.as_bytes(), "refused", part);
    }
}

#[test]
fn a_batch_has_a_line_each_in_order_and_a_summary() {
    let good = format!("{OUT}{MAIN} out[0] = 1u; }} {} out[1] = 1u; }}", MAIN.replace("main", "other"));
    let folder = folder(&[
        ("a good one.wgsl", good.as_bytes()),
        ("b.wgsl", b"fn"),
        ("c.wgsl", b"fn f() {}"),
        ("not-a-shader.txt", b""),
    ]);
    let (reports, summary, code) = batch(folder.path(), &["--jobs", "3"]);
    let statuses: Vec<_> = reports.iter().map(|r| r["status"].as_str().unwrap_or_default()).collect();
    assert_eq!(statuses, ["ok", "ok", "invalid", "refused"]);
    assert_eq!((&reports[0]["entry"], &reports[1]["entry"]), (&"main".into(), &"other".into()));
    assert_eq!((&summary["runs"], &summary["counts"]["ok"], code), (&4.into(), &2.into(), Some(1)));
    let list = folder.path().join("list");
    let lines = format!("# one\n\n'{}' --entry other --input out=zeros\n", at(&folder, "a good one.wgsl"));
    std::fs::write(&list, lines).expect("writable");
    let (reports, _, code) = batch(&list, &["--size", "out=64"]);
    assert_eq!((reports.len(), code), (1, Some(0)));
    assert_eq!((&reports[0]["entry"], &reports[0]["inputs"][0]["bytes"]), (&"other".into(), &64.into()));
    std::fs::write(&list, "a.wgsl --no-such-option\n").expect("writable");
    let output = lobe(&["run", "--batch", &list.display().to_string()]);
    assert_fails(&output, 2, &["list:1:", "--no-such-option"]);
}

#[test]
fn a_worker_that_does_not_answer_in_time_costs_a_line() {
    // Each invocation keeps within the fuel, all of them do not keep within the time.
    let wgsl = "
        @group(0) @binding(0) var<storage, read_write> out: array<atomic<u32>>;
        @compute @workgroup_size(1) fn main() {
            for (var i = 0u; i < 4000000u; i++) { atomicAdd(&out[i % 7u], i); }
        }";
    let slow = format!("{OUT}{MAIN} out[0] = 1u; }}");
    let folder = folder(&[("a.wgsl", wgsl.as_bytes()), ("b.wgsl", slow.as_bytes())]);
    let (reports, _, code) = batch(folder.path(), &["--timeout", "1", "--workgroups", "65535,65535"]);
    assert_eq!(reports[0]["status"], "timeout", "{}", reports[0]);
    assert_eq!(reports[0]["message"], "interp: not done after 1 s");
    assert_eq!(code, Some(1));
}

#[test]
fn a_process_that_is_no_worker_is_told_apart() {
    let mut serve = command(&["run", "--serve"]);
    let output = serve.output().expect("the binary runs");
    assert!(text(&output.stdout).contains("@lobe \"ready\""));
    assert_eq!(output.status.code(), Some(0), "it ends with its input");
}

#[test]
fn a_shader_may_say_itself_how_it_is_run() {
    let wgsl = format!(
        "// lobe: --workgroups 2,1,1 --size out=16\n// lobe: --input out=zeros\n{OUT}{MAIN} out[0] = 1u; }}"
    );
    let files = "// lobe: --output out=/tmp/stolen\n".to_owned() + &wgsl;
    let folder = folder(&[("a.wgsl", wgsl.as_bytes()), ("b.wgsl", files.as_bytes())]);
    let run = |name: &str, rest: &[&str]| {
        let shader = at(&folder, name);
        lobe(&[&["run", &shader, "--format", "json", "--route", "interp"], rest].concat())
    };
    let report: Value =
        serde_json::from_str(&assert_holds(&run("a.wgsl", &["--size", "out=32"]))).expect("JSON");
    assert_eq!(report["workgroups"], serde_json::json!([2, 1, 1]));
    let input = &report["inputs"][0];
    assert_eq!((&input["bytes"], &input["from"]), (&32.into(), &"zeros".into()), "the command line wins");
    assert_fails(&run("b.wgsl", &[]), 2, &["b.wgsl:1: a shader's own options may name no files"]);
}

#[test]
fn textures_have_a_shape_and_texels() {
    let wgsl = "
        @group(0) @binding(0) var image: texture_2d<u32>;
        @group(0) @binding(1) var result: texture_storage_2d<r32uint, write>;
        @group(0) @binding(2) var how: sampler;
        @compute @workgroup_size(1) fn main(@builtin(global_invocation_id) id: vec3<u32>) {
            textureStore(result, id.xy, textureLoad(image, id.xy, 0) * 2u);
        }";
    let folder = folder(&[("a.wgsl", wgsl.as_bytes()), ("image.bin", &[1, 2, 3, 4, 5, 6])]);
    let (shader, image) = (at(&folder, "a.wgsl"), format!("image={}", at(&folder, "image.bin")));
    let output = format!("result={}", at(&folder, "result.json"));
    let run = |rest: &[&str]| {
        let args = ["run", &shader, "--workgroups", "3,2", "--route", "interp", "--input", &image];
        lobe(&[&args[..], &["--texture", "result=r32uint:3x2x1"], rest].concat())
    };
    let fits = ["--texture", "image=r8uint:3x2x1", "--sampler", "how=linear,repeat", "--output", &output];
    assert_holds(&run(&fits));
    let written = std::fs::read_to_string(folder.path().join("result.json")).expect("readable");
    assert_eq!(written.trim(), "[[[2,4,6],[8,10,12]]]");
    let output = run(&["--texture", "image=r8uint:4x4x1"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stdout).contains("has 16 bytes, but 6 were given"), "{}", text(&output.stdout));
    assert_fails(&run(&["--texture", "image=r8:1x1x1"]), 2, &["`r8` is no texture format"]);
}

/// Two arrays of buffers, one of them as long as is said, and one of textures.
const ARRAYS: &str = "
    enable wgpu_binding_array;
    struct Row { tag: u32, items: array<u32> }
    @group(0) @binding(0) var<storage, read_write> rows: binding_array<Row>;
    @group(0) @binding(1) var<storage> three: binding_array<Row, 3>;
    @group(0) @binding(2) var images: binding_array<texture_2d<u32>>;
    @compute @workgroup_size(1) fn main(@builtin(workgroup_id) group: vec3<u32>) {
        rows[group.x].tag += arrayLength(&rows[group.x].items) + three[2].tag;
        rows[group.x].items[0] = textureLoad(images[1], vec2<u32>(1u, 0u), 0).x;
    }";

#[test]
fn elements_of_binding_arrays_are_given_and_kept_one_by_one() {
    let folder = folder(&[("a.wgsl", ARRAYS.as_bytes()), ("row.json", br#"{"tag": 7, "items": [1, 2, 3]}"#)]);
    let (shader, file) = (at(&folder, "a.wgsl"), at(&folder, "row.json"));
    let (input, output) = (format!("rows[1]={file}"), format!("0:0[1]={}", at(&folder, "out.json")));
    let common = ["run", &shader, "--workgroups", "2", "--route", "judge"];
    let given = [
        "--input",
        &input,
        "--input",
        "0:1[2]=words:100,0",
        "--size",
        "rows[5]=12",
        "--elements",
        "images=2",
        "--texture",
        "images=r32uint:2x1x1",
        "--input",
        "images[1]=words:8,9",
        "--output",
        &output,
    ];
    let said = assert_holds(&lobe(&[&common[..], &given].concat()));
    for part in ["rows[0] (0:0[0]) 260 bytes", "rows[1] (0:0[1]) 16 bytes", "rows[5] (0:0[5]) 12 bytes"] {
        assert!(said.contains(part), "no `{part}` in {said}");
    }
    assert!(!said.contains("rows[6]") && !said.contains("images[2]") && said.contains("three[2]"), "{said}");
    let json = std::fs::read_to_string(folder.path().join("out.json")).expect("readable");
    assert_eq!(json.trim(), r#"{"tag":110,"items":[9,2,3]}"#);

    let lines = |rest: &[&str]| text(&lobe(&[&common[..], rest].concat()).stdout).matches("rows[").count();
    // Four of which nobody says anything, each as an input and as a result.
    assert_eq!(lines(&[]), 2 * 4);
    assert_eq!(lines(&["--elements", "rows=2", "--size", "rows=16"]), 2 * 2);
}

#[test]
fn elements_that_a_binding_array_has_not_are_named() {
    let folder = folder(&[("a.wgsl", ARRAYS.as_bytes())]);
    for (option, value, part) in [
        ("--size", "three[3]=16", "`three` has 3 elements, there is no three[3]"),
        ("--elements", "three=4", "`three` has 3 elements, not 4"),
        ("--elements", "rows=0", "`rows` would have 0 elements"),
        ("--elements", "rows=1000000", "`rows` would have 1000000 elements"),
        ("--input", "rows[4000000000]=zeros", "`rows` would have 4000000001 elements"),
        ("--input", "rows[x]=zeros", "the shader has no resource `rows[x]`"),
        ("--output", "rows=out.bin", "`rows` has several elements; name one, as rows[0]"),
        ("--size", "rows[0]=4", "`rows[0]` needs 8 bytes or more"),
    ] {
        let said = lobe(&["run", &at(&folder, "a.wgsl"), "--route", "interp", option, value]);
        assert!(text(&said.stdout).contains(part), "{value}: {}", text(&said.stdout));
        assert_eq!(said.status.code(), Some(2), "{value}");
    }
    let scalar = format!("{OUT}{MAIN} out[0] = 1u; }}");
    let folder = self::folder(&[("a.wgsl", scalar.as_bytes())]);
    let said = lobe(&["run", &at(&folder, "a.wgsl"), "--route", "interp", "--elements", "out=2"]);
    assert!(text(&said.stdout).contains("`out` is no binding array"), "{}", text(&said.stdout));
    let said = lobe(&["run", &at(&folder, "a.wgsl"), "--route", "interp", "--size", "out[0]=16"]);
    assert!(text(&said.stdout).contains("the shader has no resource `out[0]`"), "{}", text(&said.stdout));
}

#[test]
fn routes_agree_on_integers_and_say_what_is_not_judged() {
    if !lobe_backends::gpu::drivers().iter().any(|d| d.name == "lavapipe") {
        assert!(std::env::var_os("LOBE_REQUIRE_TOOLS").is_none(), "lavapipe is missing");
        eprintln!("SKIPPED: no lavapipe here");
        return;
    }
    let wgsl = format!("{OUT}{MAIN} out[0] = out[1] * 7u; out[2] ^= out[3]; }}");
    let spirv = {
        let module = lobe_codegen::validate::foreign_wgsl(&wgsl).expect("valid");
        lobe_codegen::emit::plain(&module, lobe_codegen::emit::Target::Spirv, "main", [1; 3])
            .expect("SPIR-V")
            .content
            .bytes()
    };
    let folder = folder(&[("a.wgsl", wgsl.as_bytes()), ("b.spv", &spirv)]);
    let run = |name: &str, rest: &[&str]| {
        let shader = at(&folder, name);
        let output = lobe(&[&["run", &shader, "--format", "json"], rest].concat());
        let report: Value = serde_json::from_str(&assert_holds(&output)).expect("JSON");
        report["routes"].as_array().expect("routes").clone()
    };
    let routes = run("a.wgsl", &["--route", "spirv@lavapipe", "--route", "wgsl+naga@lavapipe"]);
    assert!(routes.iter().all(|r| r["status"] == "equal") && routes.len() == 2, "{routes:?}");
    let routes = run("b.spv", &["--route", "original@lavapipe", "--route", "wgsl+naga@lavapipe"]);
    assert!(routes.iter().all(|r| r["status"] == "equal") && routes.len() == 2, "{routes:?}");
}

/// Two buffers; one value depends on a uniform.
const SCALED: &str = "
    @group(0) @binding(0) var<storage, read_write> out: array<f32>;
    @group(0) @binding(1) var<uniform> scale: f32;
    @compute @workgroup_size(64) fn main(@builtin(local_invocation_index) i: u32) {
        out[i] = sin(out[i]) * scale + exp2(-abs(out[i]));
    }";

#[test]
fn a_check_asks_many_inputs_and_keeps_the_worst() {
    let files = folder(&[("a.wgsl", SCALED.as_bytes()), ("scale.bin", &2.0_f32.to_le_bytes())]);
    let scale = format!("scale={}", at(&files, "scale.bin"));
    let common =
        ["run", &at(&files, "a.wgsl"), "--input", &scale, "--check", "--inputs", "5", "--route", "interp"];
    let said = assert_holds(&lobe(&[&common[..], &["--worst"]].concat()));
    for part in [
        "a.wgsl main   5 inputs",
        "ok robust     sanitized",
        "ok conformant perturbed",
        "1 entry points, seed 0: all holds",
    ] {
        assert!(said.contains(part), "no `{part}` in {said}");
    }
    // The command that stands there runs that input again.
    let command =
        said.split_once("   lobe run ").and_then(|(_, rest)| rest.lines().next()).expect("a command");
    assert!(command.contains(" --fill ") && command.contains("--route perturbed:"), "{command}");
    let words = shlex::split(command).expect("words");
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let again = assert_holds(&lobe(&[&["run"], &words[..]].concat()));
    assert!(again.contains(" within\n") && again.contains("a.wgsl main"), "{again}");

    let json = assert_holds(&lobe(&[&common[..], &["--format", "json"]].concat()));
    let report: Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!((report["command"].as_str(), report["kernels"][0]["inputs"].as_u64()), (Some("run"), Some(5)));
    assert_eq!(report["kernels"][0]["answers"][0]["cases"], 5 * 64);
    assert_eq!(json, assert_holds(&lobe(&[&common[..], &["--format", "json"]].concat())), "the same again");
    let other = lobe(&[&common[..], &["--format", "json", "--seed", "1"]].concat());
    assert_ne!(json, assert_holds(&other));
}

#[test]
fn a_check_finds_what_one_input_does_not_show() {
    // Only where the float is subnormal does it write beyond the end.
    let wgsl = "
        @group(0) @binding(0) var<storage, read_write> out: array<u32>;
        @group(0) @binding(1) var<storage, read> x: array<f32>;
        @compute @workgroup_size(64) fn main(@builtin(local_invocation_index) i: u32) {
            if abs(x[i]) < 1e-30 && x[i] != 0.0 { out[i + 100000u] = 1u; }
        }";
    let files = folder(&[("a.wgsl", wgsl.as_bytes()), ("b.wgsl", b"no shader")]);
    let path = at(&files, "a.wgsl");
    let plain = ["run", &path, "--sanitize", "--route", "interp"];
    assert_holds(&lobe(&plain));
    let check = ["--check", "--drivers", "0", "--route", "interp"];
    let output = lobe(&[&plain[..2], &check].concat());
    let said = text(&output.stdout);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(
        said.contains("NO robust     sanitized   OutOfBounds at 5:") && said.contains("--fill edges:1"),
        "{said}"
    );
    let batch = ["run", "--batch", &files.path().display().to_string(), "--format", "junit"];
    let output = lobe(&[&batch[..], &check].concat());
    let xml = text(&output.stdout);
    for part in ["a.wgsl main", "conformant interp", "invalid on 16 of 16 inputs", "OutOfBounds"] {
        assert!(xml.contains(part), "no `{part}` in {xml}");
    }
}

#[test]
fn a_batch_is_a_suite_each_for_ci_servers() {
    let files = folder(&[("a.wgsl", SCALED.as_bytes()), ("b.wgsl", b"no shader")]);
    let batch =
        ["run", "--batch", &files.path().display().to_string(), "--format", "junit", "--route", "judge"];
    let output = lobe(&batch);
    let xml = text(&output.stdout);
    assert_eq!(output.status.code(), Some(2), "{xml}");
    for part in [
        "<testsuites name=\"lobe run\" tests=\"3\" skipped=\"0\" failures=\"1\"",
        "a.wgsl main",
        "name=\"judge\"",
        "invalid: ",
    ] {
        assert!(xml.contains(part), "no `{part}` in {xml}");
    }
}

#[test]
fn options_of_a_check_are_refused_without_it() {
    let files = folder(&[("a.wgsl", SCALED.as_bytes())]);
    let path = at(&files, "a.wgsl");
    assert_fails(&lobe(&["run", &path, "--inputs", "5"]), 2, &["--check"]);
    assert_fails(
        &lobe(&["run", &path, "--fill", "x.bin"]),
        2,
        &["zeros, random:SEED or edges:SEED is wanted"],
    );
}
