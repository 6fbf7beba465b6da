//! GLSL 4.50 for Vulkan and OpenGL, and GLSL ES 3.10.
//!
//! A file has one entry point, and the language calls it `main`.
//! Binding numbers are the declared ones; there are no groups, so two resources that differ in nothing else are
//! refused ([`super::slots`]).
//! A library has no `#version` and no precisions: those are said by the file that includes it.

mod remainder;

use super::slots::{Kind, Slot, slots};
use super::tidy::{self, Text};
use super::{EmitError, Options, Target, guarded, mark, scan};
use crate::{ValidModule, validate};
use naga::back::glsl::{self, Version, WriterFlags};
use naga::proc::BoundsCheckPolicies;
use naga::valid::ModuleInfo;
use naga::{EntryPoint, Function, GlobalVariable, Handle, Module, ShaderStage, Statement};
use scan::PieceKind;

/// What the language calls its entry point.
pub(super) const ENTRY: &str = "main";

/// Extensions that the writer asks for and both versions contain.
const CORE: [&str; 2] =
    ["#extension GL_ARB_compute_shader", "#extension GL_ARB_shader_storage_buffer_object"];

/// Writes the module as GLSL.
pub(super) fn write(module: &ValidModule, target: Target, options: &Options) -> Result<String, EmitError> {
    let is_library = module.module().entry_points.is_empty();
    let whole = if is_library { &with_main(module)? } else { module };
    check_entries(whole, target)?;
    let mut named = whole.module().clone();
    named.entry_points[0].name = ENTRY.to_owned();
    let marked = mark::mark(&named);
    let entry = marked.module.entry_points[0].name.clone();
    let flags = if is_library { WriterFlags::INCLUDE_UNUSED_ITEMS } else { WriterFlags::empty() };
    let policies = BoundsCheckPolicies::default();
    // What is refused is refused under its own name.
    numbers(&named, whole.info(), target, ENTRY, flags)?;
    let raw = translate(&marked.module, whole.info(), target, &entry, flags, policies)?;
    let raw = if is_library { library(&raw) } else { raw };
    let raw = with_marks(&raw, &marked.module);
    let original = (module.module(), &module.meta().definitions);
    tidy::finish(original, &marked.marks, Text::new(&raw), target, options)
}

/// The module as naga writes it.
pub(super) fn translate(
    module: &Module,
    info: &ModuleInfo,
    target: Target,
    entry: &str,
    flags: WriterFlags,
    policies: BoundsCheckPolicies,
) -> Result<String, EmitError> {
    let numbers = numbers(module, info, target, entry, flags)?;
    let settings = glsl::Options {
        version: if target == Target::Essl { Version::new_gles(310) } else { Version::Desktop(450) },
        writer_flags: flags,
        binding_map: numbers.into_iter().map(|slot| (slot.place, slot.number)).collect(),
        zero_initialize_workgroup_memory: true,
    };
    let pipeline = glsl::PipelineOptions {
        shader_stage: ShaderStage::Compute,
        entry_point: entry.to_owned(),
        multiview: None,
    };
    let mut module = module.clone();
    let remainders = remainder::replace(&mut module, info).map_err(|message| EmitError::Writer {
        target,
        message: format!("it cannot tell {message} apart"),
    })?;
    guarded(target, || {
        let mut raw = String::new();
        let mut writer = glsl::Writer::new(&mut raw, &module, info, &settings, &pipeline, policies)?;
        writer.write()?;
        Ok::<_, glsl::Error>(remainder::define(&without(&raw, &CORE), &remainders))
    })
}

/// The numbers of the resources that are written.
fn numbers(
    module: &Module,
    info: &ModuleInfo,
    target: Target,
    entry: &str,
    flags: WriterFlags,
) -> Result<Vec<Slot>, EmitError> {
    let index = module.entry_points.iter().position(|e| e.name == entry).unwrap_or_default();
    let uses = info.get_entry_point(index);
    let is_whole = flags.contains(WriterFlags::INCLUDE_UNUSED_ITEMS);
    let is_written = |global: Handle<GlobalVariable>| is_whole || !uses[global].is_empty();
    slots(module, target, is_written, are_together)
}

/// Vulkan numbers everything together, and so does what is written here.
fn are_together(_: Kind, _: Kind) -> bool {
    true
}

fn check_entries(module: &ValidModule, target: Target) -> Result<(), EmitError> {
    match module.module().entry_points.as_slice() {
        [one] if one.stage == ShaderStage::Compute => Ok(()),
        entries => {
            let names = entries.iter().map(|e| e.name.clone()).collect();
            Err(EmitError::ManyEntries { names, target })
        }
    }
}

/// A library with the entry point that the writer asks for.
fn with_main(module: &ValidModule) -> Result<ValidModule, EmitError> {
    let mut whole = module.module().clone();
    let mut function = Function::default();
    function.body.push(Statement::Return { value: None }, naga::Span::UNDEFINED);
    whole.entry_points.push(EntryPoint {
        name: ENTRY.to_owned(),
        stage: ShaderStage::Compute,
        early_depth_test: None,
        workgroup_size: [1; 3],
        workgroup_size_overrides: None,
        function,
        mesh_info: None,
        task_payload: None,
        incoming_ray_payload: None,
    });
    validate::validate(whole, module.meta().clone())
        .map_err(|e| EmitError::Entry { function: ENTRY.to_owned(), reason: e.to_string() })
}

/// The text without what only a whole shader may say, and without the entry point.
fn library(raw: &str) -> String {
    let items = raw.split_once("void main()").map_or(raw, |(items, _)| items);
    without(items, &["#version", "precision ", "layout(local_size_x"])
}

/// The text without the lines that begin in one of these ways.
fn without(text: &str, starts: &[&str]) -> String {
    let lines = text.lines().filter(|line| !starts.iter().any(|start| line.starts_with(start)));
    lines.fold(String::new(), |text, line| text + line + "\n")
}

/// The text with a mark for each resource and for the entry point, which the writer names after their places.
///
/// The block that a buffer is in is called after the buffer.
fn with_marks(raw: &str, module: &Module) -> String {
    let pieces = scan::pieces(raw);
    let mut out = String::new();
    for (i, piece) in pieces.iter().enumerate() {
        let rest = || pieces[i..].iter().find_map(|p| global(p.text, module));
        match piece.kind {
            PieceKind::Word if piece.text == ENTRY => out.push_str(&module.entry_points[0].name),
            PieceKind::Word if is_block(piece.text) => match rest() {
                Some(name) => out.push_str(&format!("{name}_block")),
                None => out.push_str(piece.text),
            },
            PieceKind::Word => out.push_str(global(piece.text, module).unwrap_or(piece.text)),
            PieceKind::Selector | PieceKind::Opaque | PieceKind::Space | PieceKind::Mark => {
                out.push_str(piece.text);
            }
        }
    }
    out
}

/// `.._block_7Compute`
fn is_block(word: &str) -> bool {
    let number = word.strip_suffix("Compute").and_then(|rest| rest.rsplit_once("_block_"));
    number.is_some_and(|(_, number)| !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()))
}

/// The name of the global variable that the writer calls `_group_0_binding_1_cs`.
fn global<'m>(word: &str, module: &'m Module) -> Option<&'m str> {
    let place = word.strip_prefix("_group_")?.strip_suffix("_cs")?;
    let (group, binding) = place.split_once("_binding_")?;
    let place = naga::ResourceBinding { group: group.parse().ok()?, binding: binding.parse().ok()? };
    let mut globals = module.global_variables.iter();
    globals.find(|(_, g)| g.binding == Some(place)).and_then(|(_, g)| g.name.as_deref())
}
