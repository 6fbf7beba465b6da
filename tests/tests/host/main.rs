//! Structures of hosts have the layout of shaders: what C writes, lavapipe reads, member by member.

#[path = "../common/mod.rs"]
mod common;
#[rustfmt::skip]
#[allow(unused_qualifications, unreachable_pub, missing_docs, dead_code, reason = "as a user's crate gets it")]
mod generated;

use lobe_backends::gpu::{self, Binding, BindingKind, Gpu, Job, Shader};
use lobe_codegen::ValidModule;
use lobe_codegen::emit::{Host, Options, Target, emit, host};
use lobe_kernels::registry::KERNELS;
use naga::{ArraySize, Handle, Module, Type, TypeInner};
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

fn library() -> ValidModule {
    lobe_codegen::lower(KERNELS).unwrap_or_else(|e| panic!("{e}"))
}

/// A scalar of a structure: how WGSL and how C call it.
struct Leaf {
    wgsl: String,
    c: String,
}

/// The structures of the library that buffers can hold, with their scalars.
fn structures(module: &Module, header: &str) -> Vec<(String, Vec<Leaf>)> {
    let is_there = |name: &str| header.contains(&format!("typedef struct {name} {{"));
    let named = module.types.iter().filter_map(|(handle, ty)| Some((handle, ty.name.clone()?)));
    let held = named.filter(|(_, name)| is_there(name));
    held.map(|(handle, name)| (name, leaves(module, handle, Leaf { wgsl: String::new(), c: String::new() })))
        .collect()
}

fn leaves(module: &Module, ty: Handle<Type>, at: Leaf) -> Vec<Leaf> {
    let step = |wgsl: &str, c: String| Leaf { wgsl: at.wgsl.clone() + wgsl, c: at.c.clone() + &c };
    let indexed = |i: u32| step(&format!("[{i}]"), format!("[{i}]"));
    match &module.types[ty].inner {
        TypeInner::Vector { size, .. } => (0..*size as u32).map(indexed).collect(),
        TypeInner::Matrix { columns, rows, .. } => {
            let cells = (0..*columns as u32).flat_map(|c| (0..*rows as u32).map(move |r| (c, r)));
            cells.map(|(c, r)| step(&format!("[{c}][{r}]"), format!("[{c}][{r}]"))).collect()
        }
        TypeInner::Array { base, size: ArraySize::Constant(n), .. } => {
            (0..n.get()).flat_map(|i| leaves(module, *base, indexed(i))).collect()
        }
        TypeInner::Struct { members, .. } => members
            .iter()
            .flat_map(|member| {
                let name = format!(".{}", member.name.as_deref().unwrap_or_default());
                leaves(module, member.ty, step(&name, name.clone()))
            })
            .collect(),
        _ => vec![at],
    }
}

/// A program that writes each structure with the bits 1, 2, 3, .. in its scalars.
fn program(structures: &[(String, Vec<Leaf>)]) -> String {
    let mut text = "#include <stdio.h>\n#include <string.h>\n#include \"lobe.h\"\n\
        #define PUT(place) do { ++bits; memcpy(&(place), &bits, 4); } while (0)\nint main(void) {\n"
        .to_owned();
    for (name, leaves) in structures {
        let _ = writeln!(text, "    {{\n        {name} value;\n        uint32_t bits = 0;");
        let _ = writeln!(text, "        memset(&value, 0xff, sizeof value);");
        leaves.iter().for_each(|leaf| {
            let _ = writeln!(text, "        PUT(value{});", leaf.c);
        });
        let _ = writeln!(text, "        fwrite(&value, sizeof value, 1, stdout);\n    }}");
    }
    text + "    return 0;\n}\n"
}

/// Compiles and runs the program beside the header.
fn written(folder: &Path, header: &str, program: &str) -> Vec<u8> {
    std::fs::write(folder.join("lobe.h"), header).expect("written");
    std::fs::write(folder.join("main.c"), program).expect("written");
    let run = |command: &mut Command| {
        let output = command.current_dir(folder).output().expect("starts");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        output.stdout
    };
    let strict = ["-Wall", "-Wextra", "-Werror", "-pedantic"];
    run(Command::new("cc").args(["-std=c11", "main.c", "-o", "main"]).args(strict));
    run(&mut Command::new(folder.join("main")))
}

/// A shader that copies each scalar of a structure into a word.
fn reader(library: &str, name: &str, leaves: &[Leaf]) -> String {
    let mut text = format!(
        "{library}\n@group(0) @binding(0) var<storage, read> given: {name};\n\
         @group(0) @binding(1) var<storage, read_write> found: array<u32>;\n\
         @compute @workgroup_size(1) fn read_back() {{\n"
    );
    for (i, leaf) in leaves.iter().enumerate() {
        let _ = writeln!(text, "    found[{i}] = bitcast<u32>(given{});", leaf.wgsl);
    }
    text + "}\n"
}

fn read(gpu: &mut Gpu, shader: &str, given: &[u8], count: usize) -> Vec<u32> {
    let found = vec![0u8; 4 * count];
    let bind = |binding, kind, data| Binding { group: 0, binding, element: None, kind, data };
    let bindings = [bind(0, BindingKind::StorageRead, given), bind(1, BindingKind::StorageReadWrite, &found)];
    let job = Job {
        shader: Shader::Wgsl(shader),
        entry: "read_back",
        workgroup_size: [1; 3],
        groups: [1; 3],
        bindings: &bindings,
        immediates: &[],
    };
    let outputs = gpu.run(&job).unwrap_or_else(|e| panic!("{e}"));
    outputs[0].as_chunks::<4>().0.iter().map(|word| u32::from_le_bytes(*word)).collect()
}

#[test]
fn lavapipe_reads_every_member_that_c_wrote() {
    let Some(driver) = gpu::drivers().into_iter().find(|d| d.name == "lavapipe") else {
        return common::skip("lavapipe", "run tests/setup.sh");
    };
    let mut gpu = Gpu::open(&driver).unwrap_or_else(|e| panic!("{e}"));
    let module = library();
    let header = host(&module, Host::C);
    let structures = structures(module.module(), &header);
    assert!(structures.len() > 20, "{}", structures.len());
    let folder = tempfile::tempdir().expect("a folder");
    let bytes = written(folder.path(), &header, &program(&structures));
    let options = Options { docs: false, ..Options::default() };
    let library = emit(&module, Target::Wgsl, &options).unwrap_or_else(|e| panic!("{e}")).content;
    let mut rest = bytes.as_slice();
    for (name, leaves) in &structures {
        let ty = module.module().types.iter().find(|(_, t)| t.name.as_deref() == Some(name)).expect("it");
        let (given, after) = rest.split_at(ty.1.inner.size(module.module().to_ctx()) as usize);
        rest = after;
        let shader = reader(library.text().expect("text"), name, leaves);
        let expected: Vec<u32> = (1..=leaves.len() as u32).collect();
        assert_eq!(read(&mut gpu, &shader, given, leaves.len()), expected, "{name}");
    }
    assert!(rest.is_empty());
}

/// Its assertions hold where it compiles; `LOBE_BLESS=1` writes it again.
#[test]
fn the_rust_structures_of_this_test_are_those_of_today() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/host/generated.rs");
    let expected = host(&library(), Host::Rust);
    if std::env::var_os("LOBE_BLESS").is_some() {
        std::fs::write(&path, &expected).expect("written");
    }
    assert_eq!(std::fs::read_to_string(&path).expect("the file"), expected);
}

#[test]
fn rust_writes_the_bytes_that_c_does() {
    let sg = generated::Sg { axis: [1.0, 2.0, 3.0], sharpness: 4.0, log_amplitude: 5.0, _pad0: [0; 3] };
    let words: Vec<f32> = bytemuck::cast_slice(bytemuck::bytes_of(&sg)).to_vec();
    assert_eq!(words, [1.0, 2.0, 3.0, 4.0, 5.0, 0.0, 0.0, 0.0]);
}
