//! Each kernel alone, as the functions to include and as a compute shader.

use crate::Row;
use crate::common::tool;
use lobe_backends::executor::Program;
use lobe_backends::translate::{Dawn, Dxc, DxcOutput, Glslang, Slang, Tint, spirv_val};
use lobe_codegen::emit::{Content, Options, Target, emit};
use lobe_codegen::validate::from_wgsl;
use lobe_kernels::registry::KERNELS;
use rayon::prelude::*;
use std::collections::BTreeMap;

/// A kernel as users get it.
struct Texts {
    name: &'static str,
    entry: String,
    libraries: BTreeMap<Target, String>,
    shaders: BTreeMap<Target, String>,
    words: Vec<u32>,
}

impl Texts {
    fn new(program: &Program) -> Self {
        let (_, layout) = program.entry().unwrap_or_else(|e| panic!("{e}"));
        let shader = |target| program.artifact(target).unwrap_or_else(|e| panic!("{e}")).content;
        let library = |target| {
            emit(program.module(), target, &Options::default()).unwrap_or_else(|e| panic!("{e}")).content
        };
        let text = |content: Content| content.text().expect("a text").to_owned();
        let Content::Words(words) = shader(Target::Spirv) else { panic!("{}: no words", program.name()) };
        Self {
            name: program.name(),
            entry: layout.entry_name.clone(),
            libraries: Target::TEXTS.into_iter().map(|target| (target, text(library(target)))).collect(),
            shaders: Target::TEXTS.into_iter().map(|target| (target, text(shader(target)))).collect(),
            words,
        }
    }
}

type Verdicts = Vec<(&'static str, Result<(), String>)>;

/// What `judge` says of each kernel, on all threads.
fn each(texts: &[Texts], judge: impl Fn(&Texts) -> Result<(), String> + Sync) -> Verdicts {
    texts.par_iter().map(|texts| (texts.name, judge(texts))).collect()
}

fn text<T, E: std::fmt::Display>(result: Result<T, E>) -> Result<(), String> {
    result.map(|_| ()).map_err(|e| e.to_string())
}

/// A row for each language and compiler; `None` where one is not here.
pub(crate) fn rows() -> Option<Vec<Row>> {
    let texts: Vec<Texts> = KERNELS
        .par_iter()
        .map(|kernel| Texts::new(&Program::new(*kernel).unwrap_or_else(|e| panic!("{e}"))))
        .collect();
    let mut rows = wgsl_and_spirv(&texts)?;
    rows.extend(hlsl(&texts)?);
    rows.extend(glsl(&texts)?);
    let emitted = texts.iter().map(|texts| (texts.name, Ok(())));
    rows.push(Row::new(["MSL", "functions, shader", "none: emitted alone"], String::new(), emitted));
    Some(rows)
}

fn wgsl_and_spirv(texts: &[Texts]) -> Option<Vec<Row>> {
    const FORM: &str = "functions, shader";
    let both = |texts: &Texts| [texts.libraries[&Target::Wgsl].clone(), texts.shaders[&Target::Wgsl].clone()];
    let naga = each(texts, |texts| both(texts).iter().try_for_each(|wgsl| text(from_wgsl(wgsl))));
    let dawn = tool(Dawn::find())?;
    let mut tint = tool(Tint::start(&dawn))?;
    let mut by_tint = |texts: &Texts| both(texts).iter().try_for_each(|wgsl| text(tint.validate(wgsl)));
    let tint: Verdicts = texts.iter().map(|texts| (texts.name, by_tint(texts))).collect();
    let val = tool(spirv_val::find())?;
    let spirv = each(texts, |texts| text(spirv_val::validate(&texts.words)));
    Some(vec![
        Row::new(["WGSL", FORM, "naga"], crate::document::locked("naga"), naga),
        Row::new(["WGSL", FORM, "Tint"], format!("of Dawn, npm's webgpu {}", dawn.version()), tint),
        Row::new(["SPIR-V", "shader", "spirv-val"], crate::document::first_line(&val), spirv),
    ])
}

fn hlsl(texts: &[Texts]) -> Option<Vec<Row>> {
    let dxc = tool(Dxc::find())?;
    let slang = tool(Slang::find())?;
    let shader = |output| {
        each(texts, |texts| {
            text(dxc.compile(&texts.shaders[&Target::Hlsl], "cs_6_0", Some(&texts.entry), output))
        })
    };
    // A function that is not exported is dropped without a word; an exported one leaves its name.
    let library = each(texts, |texts| {
        let object = dxc.compile(&texts.libraries[&Target::Hlsl], "lib_6_3", None, DxcOutput::Dxil);
        let object = object.map_err(|e| e.to_string())?;
        let is_there = object.windows(texts.name.len()).any(|bytes| bytes == texts.name.as_bytes());
        if is_there { Ok(()) } else { Err("it is not in its library".to_owned()) }
    });
    let by_slang = each(texts, |texts| text(slang.compile(&texts.shaders[&Target::Hlsl], &texts.entry)));
    let (major, minor) = dxc.version();
    let version = format!("{major}.{minor}");
    Some(vec![
        Row::new(["HLSL", "shader, to SPIR-V", "DXC"], version.clone(), shader(DxcOutput::Spirv)),
        Row::new(["HLSL", "shader, to DXIL (cs_6_0)", "DXC"], version.clone(), shader(DxcOutput::Dxil)),
        Row::new(["HLSL", "functions, to DXIL (lib_6_3)", "DXC"], version, library),
        Row::new(["HLSL", "shader, to SPIR-V", "slang"], slang.version().to_owned(), by_slang),
    ])
}

/// Shaders alone: each is a process, and the functions are those of the package `plain`, which is compiled whole.
fn glsl(texts: &[Texts]) -> Option<Vec<Row>> {
    let glslang = tool(Glslang::find())?;
    let version = glslang.version().unwrap_or_else(|e| panic!("{e}"));
    let vulkan = each(texts, |texts| text(glslang.compile(&texts.shaders[&Target::Glsl])));
    let es = each(texts, |texts| text(glslang.validate(&texts.shaders[&Target::Essl])));
    Some(vec![
        Row::new(["GLSL 4.50", "shader, to SPIR-V", "glslang"], version.clone(), vulkan),
        Row::new(["GLSL ES 3.10", "shader", "glslang"], version, es),
    ])
}
