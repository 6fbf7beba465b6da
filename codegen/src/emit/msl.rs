//! MSL 2.4 for Metal.
//!
//! Nothing here compiles or runs it: there is no Metal compiler outside of Apple's systems.
//! Buffers, textures and samplers have the numbers of their bindings; there are no groups ([`super::slots`]).

use super::scan::{Piece, PieceKind};
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
        let mut writer = msl::Writer::new(String::with_capacity(super::SIZE));
        writer.write(&marked.module, module.info(), &settings, &msl::PipelineOptions::default())?;
        Ok::<_, msl::Error>(writer.finish())
    })?;
    let original = (module.module(), &module.meta().definitions);
    let mut text = Text::new(&raw);
    lay_out(&mut text.pieces);
    tidy::finish(original, &marked.marks, text, Target::Msl, options)
}

/// Leaves out the remark on the version and structures that have no members, and puts the parameters of each function
/// on one line.
fn lay_out(pieces: &mut Vec<Piece<'_>>) {
    let (mut is_outside, mut is_inside) = (true, false);
    for at in 0..pieces.len() {
        let Piece { text, kind, .. } = pieces[at];
        if kind == PieceKind::Space && text.contains('\n') {
            let before = at.checked_sub(1).map(|before| pieces[before].text);
            let begins = is_outside && before == Some("(");
            let next = pieces.get(at + 1).map(|next| next.text);
            if begins || is_inside {
                // A parameter begins with its comma, or the line before ends with it.
                pieces[at].text = if begins || matches!(next, Some("," | ")")) { "" } else { " " };
            }
            is_inside = (begins || is_inside) && next != Some(")");
            is_outside = text.ends_with('\n');
        } else if text.starts_with("// language:") {
            pieces[at].text = "";
        } else if text == "struct" && is_empty(&pieces[at..]) {
            pieces[at..at + EMPTY.len()].iter_mut().for_each(|piece| piece.text = "");
        }
    }
    pieces.retain(|piece| !piece.text.is_empty());
}

/// The structure that an entry point without interpolated inputs would read them from; its name stands third.
const EMPTY: [&str; 8] = ["struct", " ", "", " ", "{", "\n", "}", ";"];

/// Whether pieces begin with a structure that has no members.
fn is_empty(pieces: &[Piece<'_>]) -> bool {
    let is_alike =
        |(i, text): (usize, &&str)| i == 2 || pieces.get(i).is_some_and(|piece| piece.text == *text);
    EMPTY.iter().enumerate().all(is_alike)
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
