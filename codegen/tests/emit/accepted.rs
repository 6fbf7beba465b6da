//! Other tools take what is emitted: naga's front end and, when they are here, `spirv-val` and DXC.

use crate::common::{artifact, module, rich, text};
use lobe_codegen::emit::{Content, Target, with_entry};
use lobe_codegen::validate::from_wgsl;
use std::path::{Path, PathBuf};
use std::process::Command;

const SHARED: &str = "
struct Cell { a: vec3<f32>, n: u32 }
struct Held { a: vec3<f32>, n: u32 }
@group(0) @binding(0) var<storage, read_write> sums: array<f32>;
@group(0) @binding(1) var<storage> cells: array<Cell>;
var<workgroup> scratch: array<f32, 64>;
var<workgroup> held: array<Held, 4>;
@compute @workgroup_size(64)
fn reduce(@builtin(local_invocation_index) local_invocation_index: u32, @builtin(global_invocation_id) id: vec3<u32>) {
    scratch[local_invocation_index] = sums[id.x];
    held[local_invocation_index % 4u] = Held(cells[id.x].a, cells[id.x].n);
    workgroupBarrier();
    sums[id.x] = scratch[63u - local_invocation_index] + held[id.x % 4u].a.y;
}
";

/// A tool from the folder that `LOBE_TOOLS` names, or else from PATH.
fn tool(name: &str) -> Option<PathBuf> {
    let folders = std::env::var_os("LOBE_TOOLS").into_iter().chain(std::env::var_os("PATH"));
    let found = folders.flat_map(|list| std::env::split_paths(&list).collect::<Vec<_>>());
    let found = found.map(|folder| folder.join(name)).find(|path| path.is_file());
    if found.is_none() {
        assert!(
            std::env::var("LOBE_REQUIRE_TOOLS").as_deref() != Ok("1"),
            "{name} is required and not found"
        );
        println!("SKIPPED: {name} is neither on PATH nor in the folder LOBE_TOOLS");
    }
    found
}

fn accepts(tool: &Path, words: &[u8], name: &str) -> Result<(), String> {
    let file = std::env::temp_dir().join(format!("lobe-emit-{}-{name}.spv", std::process::id()));
    std::fs::write(&file, words).map_err(|e| e.to_string())?;
    let run = Command::new(tool).args(["--target-env", "vulkan1.1"]).arg(&file).output();
    let _ = std::fs::remove_file(&file);
    let run = run.map_err(|e| e.to_string())?;
    if run.status.success() { Ok(()) } else { Err(String::from_utf8_lossy(&run.stderr).into_owned()) }
}

#[test]
fn emitted_wgsl_is_read_back_and_comes_out_the_same() {
    for source in [rich(), module(SHARED)] {
        let first = text(&source, Target::Wgsl);
        let again = from_wgsl(&first).unwrap_or_else(|error| panic!("{error}\n{first}"));
        let second = text(&again, Target::Wgsl);
        // The front end loses the doc comment behind the header; all else is as it was.
        let code =
            |text: &str| text.lines().filter(|l| !l.starts_with("//")).map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(code(&first), code(&second));
        from_wgsl(&second).unwrap_or_else(|error| panic!("{error}\n{second}"));
    }
}

#[test]
fn spirv_val_accepts_the_spirv() {
    let Some(validator) = tool("spirv-val") else { return };
    let library = rich();
    for name in ["square", "f1", "product", "total", "framed", "parts", "flags"] {
        let (entry, _) = with_entry(&library, library.function(name).unwrap(), 64).unwrap();
        let words = artifact(&entry, Target::Spirv).content.bytes();
        accepts(&validator, &words, name).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
    let words = artifact(&module(SHARED), Target::Spirv).content.bytes();
    accepts(&validator, &words, "shared").unwrap_or_else(|error| panic!("shared: {error}"));
    // The check can fail: the same words without their last instruction are no module.
    assert!(accepts(&validator, &words[..words.len() - 4], "cut").is_err());
}

#[test]
fn spirv_names_are_the_declared_ones() {
    let library = rich();
    let (entry, _) = with_entry(&library, library.function("f1").unwrap(), 64).unwrap();
    let Content::Words(words) = artifact(&entry, Target::Spirv).content else { panic!("words") };
    assert_eq!((words[0], words[1]), (0x0723_0203, 0x0001_0300));
    let names = op_names(&words);
    for name in ["f1", "square", "x", "x2", "x_values", "x2_values", "results", "row_count", "Sg", "half"] {
        assert!(names.iter().any(|n| n == name), "{name} is not in {names:?}");
    }
}

#[test]
fn workgroup_memory_has_no_layout_of_buffers() {
    let Content::Words(words) = artifact(&module(SHARED), Target::Spirv).content else { panic!("words") };
    let strides = instructions(&words).filter(|i| i[0] & 0xffff == 71 && i.get(2) == Some(&6)).count();
    // Of `sums` and of `cells`; `scratch` and `held` have none.
    assert_eq!(strides, 2);
}

fn instructions(words: &[u32]) -> impl Iterator<Item = &[u32]> {
    let mut rest = &words[5..];
    std::iter::from_fn(move || {
        let (instruction, after) = rest.split_at_checked((rest.first()? >> 16) as usize)?;
        rest = after;
        Some(instruction)
    })
}

fn op_names(words: &[u32]) -> Vec<String> {
    let names = instructions(words).filter(|i| matches!(i[0] & 0xffff, 5 | 6));
    let text = |i: &[u32]| {
        let skip = if i[0] & 0xffff == 5 { 2 } else { 3 };
        let bytes = i[skip..].iter().flat_map(|w| w.to_le_bytes()).take_while(|b| *b != 0).collect();
        String::from_utf8(bytes).unwrap_or_default()
    };
    names.map(text).collect()
}
