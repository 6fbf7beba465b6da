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
use scan::{Piece, PieceKind};

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
    let mut named = mark::copy(whole.module());
    named.entry_points[0].name = ENTRY.to_owned();
    let flags = if is_library { WriterFlags::INCLUDE_UNUSED_ITEMS } else { WriterFlags::empty() };
    let policies = BoundsCheckPolicies::default();
    // What is refused is refused under its own name.
    numbers(&named, whole.info(), target, ENTRY, flags)?;
    let mut marked = mark::mark(named);
    let entry = marked.module.entry_points[0].name.clone();
    let raw = translate(&mut marked.module, whole.info(), target, &entry, flags, policies)?;
    let raw = if is_library { library(&raw) } else { raw };
    let is_core = |text: &str| CORE.iter().any(|core| text.starts_with(core));
    let resources = Resource::all(&marked.module);
    let mut text = Text::new(&raw);
    text.pieces.retain(|piece| piece.kind != PieceKind::Opaque || !is_core(piece.text));
    give_marks(&mut text.pieces, &entry, &resources);
    let original = (module.module(), &module.meta().definitions);
    tidy::finish(original, &marked.marks, text, target, options)
}

/// The module as naga writes it; signed remainders are taken out of it.
pub(super) fn translate(
    module: &mut Module,
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
    let remainders = remainder::replace(module, info).map_err(|message| EmitError::Writer {
        target,
        message: format!("it cannot tell {message} apart"),
    })?;
    guarded(target, || {
        let mut raw = String::with_capacity(super::SIZE);
        let mut writer = glsl::Writer::new(&mut raw, module, info, &settings, &pipeline, policies)?;
        writer.write()?;
        Ok::<_, glsl::Error>(remainder::define(raw, &remainders))
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

/// The text without extensions that its version contains.
pub(super) fn without_core(raw: &str) -> String {
    without(raw, &CORE)
}

/// The text without what only a whole shader may say, and without the entry point.
fn library(raw: &str) -> String {
    let items = raw.split_once("void main()").map_or(raw, |(items, _)| items);
    without(items, &["#version", "precision ", "layout(local_size_x"])
}

/// The text without the lines that begin in one of these ways.
fn without(text: &str, starts: &[&str]) -> String {
    let mut out = String::with_capacity(text.len());
    let lines = text.lines().filter(|line| !starts.iter().any(|start| line.starts_with(start)));
    lines.for_each(|line| out.extend([line, "\n"]));
    out
}

/// A resource, which the writer names after its place.
struct Resource<'m> {
    place: naga::ResourceBinding,
    mark: &'m str,
    /// What the block is called that a buffer is in: after the buffer.
    block: String,
}

impl<'m> Resource<'m> {
    fn all(module: &'m Module) -> Vec<Self> {
        let named = |(_, global): (_, &'m GlobalVariable)| {
            let mark = global.name.as_deref()?;
            Some(Self { place: global.binding?, mark, block: format!("{mark}_block") })
        };
        module.global_variables.iter().filter_map(named).collect()
    }
}

/// Gives each resource and the entry point its mark.
fn give_marks<'a>(pieces: &mut [Piece<'a>], entry: &'a str, resources: &'a [Resource<'_>]) {
    for i in 0..pieces.len() {
        let Piece { text, kind: PieceKind::Word, .. } = pieces[i] else { continue };
        let found = if text == ENTRY {
            Some(entry)
        } else if is_block(text) {
            let next = pieces[i..].iter().find_map(|piece| resource(piece.text, resources));
            next.map(|resource| resource.block.as_str())
        } else {
            resource(text, resources).map(|resource| resource.mark)
        };
        pieces[i].text = found.unwrap_or(text);
    }
}

/// `.._block_7Compute`
fn is_block(word: &str) -> bool {
    let number = word.strip_suffix("Compute").and_then(|rest| rest.rsplit_once("_block_"));
    number.is_some_and(|(_, number)| !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()))
}

/// The resource that the writer calls `_group_0_binding_1_cs`.
fn resource<'r, 'm>(word: &str, resources: &'r [Resource<'m>]) -> Option<&'r Resource<'m>> {
    let place = word.strip_prefix("_group_")?.strip_suffix("_cs")?;
    let (group, binding) = place.split_once("_binding_")?;
    let place = naga::ResourceBinding { group: group.parse().ok()?, binding: binding.parse().ok()? };
    resources.iter().find(|resource| resource.place == place)
}
