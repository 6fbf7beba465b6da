//! MSL 2.4 for Metal.
//!
//! Nothing here compiles or runs it: there is no Metal compiler outside of Apple's systems.
//! Buffers, textures and samplers have the numbers of their bindings; there are no groups ([`super::slots`]).

use super::slots::{Kind, Slot, slots};
use super::tidy::{self, Text};
use super::{EmitError, Options, Target, guarded, mark};
use crate::ValidModule;
use naga::Module;
use naga::back::msl::{self, BindSamplerTarget, BindTarget, EntryPointResources};
use naga::proc::BoundsCheckPolicies;
use naga::valid::{FunctionInfo, ModuleInfo};

/// Writes the module as MSL.
pub(super) fn write(module: &ValidModule, options: &Options) -> Result<String, EmitError> {
    // What is refused is refused under its own name.
    settings(module.module(), module.info())?;
    let marked = mark::mark(mark::copy(module.module()));
    let settings = settings(&marked.module, module.info())?;
    let raw = guarded(Target::Msl, || {
        let mut writer = msl::Writer::new(String::new());
        writer.write(&marked.module, module.info(), &settings, &msl::PipelineOptions::default())?;
        Ok::<_, msl::Error>(writer.finish())
    })?;
    let original = (module.module(), &module.meta().definitions);
    tidy::finish(original, &marked.marks, Text::new(&lay_out(&raw)), Target::Msl, options)
}

/// The text without its remark on the version and without structures that have no members, the parameters of each
/// function on one line.
fn lay_out(raw: &str) -> String {
    let mut out = String::new();
    let mut is_inside = false;
    let raw = without_empty(raw);
    for line in raw.lines().filter(|line| !line.starts_with("// language:")) {
        let begins = line.ends_with('(') && !line.starts_with([' ', '/', '#']);
        let is_first = out.ends_with('(');
        is_inside = (is_inside || begins) && line != ") {";
        match is_inside && !begins {
            // A parameter begins with its comma, or the line before ends with it.
            true if line.starts_with(',') || is_first => out.push_str(line.trim()),
            true => out.push_str(&format!(" {}", line.trim())),
            false => out.push_str(line),
        }
        if !is_inside {
            out.push('\n');
        }
    }
    out
}

/// The structure that an entry point without interpolated inputs would read them from.
fn without_empty(raw: &str) -> String {
    let mut out = String::new();
    let mut lines = raw.lines().peekable();
    while let Some(line) = lines.next() {
        let is_empty = line.starts_with("struct ") && line.ends_with('{') && lines.peek() == Some(&"};");
        match is_empty {
            true => drop(lines.next()),
            false => out.extend([line, "\n"]),
        }
    }
    out
}

fn settings(module: &Module, info: &ModuleInfo) -> Result<msl::Options, EmitError> {
    let entries = module.entry_points.iter().enumerate();
    let resources = entries.map(|(i, e)| Ok((e.name.clone(), resources(module, info.get_entry_point(i))?)));
    Ok(msl::Options {
        lang_version: (2, 4),
        per_entry_point_map: resources.collect::<Result<_, EmitError>>()?,
        fake_missing_bindings: false,
        bounds_check_policies: BoundsCheckPolicies::default(),
        zero_initialize_workgroup_memory: true,
        force_loop_bounding: false,
        ..msl::Options::default()
    })
}

/// What an entry point uses; the sizes of its buffers, where it asks for them, come behind these.
fn resources(module: &Module, uses: &FunctionInfo) -> Result<EntryPointResources, EmitError> {
    let slots = slots(module, Target::Msl, |global| !uses[global].is_empty(), are_together)?;
    let buffers = slots.iter().filter(|slot| are_together(slot.kind, Kind::Storage));
    let last = buffers.map(|slot| slot.number).max();
    Ok(EntryPointResources {
        resources: slots.iter().map(|slot| (slot.place, target(slot))).collect(),
        immediates_buffer: None,
        sizes_buffer: last.map_or(Some(0), |last| last.checked_add(1)),
    })
}

fn target(slot: &Slot) -> BindTarget {
    let mut target = BindTarget { mutable: slot.is_written, ..BindTarget::default() };
    match slot.kind {
        Kind::Storage | Kind::Uniform => target.buffer = Some(slot.number),
        Kind::Texture | Kind::StorageTexture => target.texture = Some(slot.number),
        Kind::Sampler => target.sampler = Some(BindSamplerTarget::Resource(slot.number)),
    }
    target
}

/// Metal has a table each for buffers, textures and samplers.
fn are_together(one: Kind, other: Kind) -> bool {
    let table = |kind| match kind {
        Kind::Storage | Kind::Uniform => 0,
        Kind::Texture | Kind::StorageTexture => 1,
        Kind::Sampler => 2,
    };
    table(one) == table(other)
}
