//! SPIR-V 1.3 for Vulkan.
//!
//! Names (`OpName`) are written as declared; they are for the reader and need no scopes.
//! The flags are stated one by one, since naga's defaults depend on how naga was built and turn the
//! y axis of positions round.

use super::{EmitError, Target, guarded};
use crate::ValidModule;
use naga::back::spv;
use naga::proc::{BoundsCheckPolicies, BoundsCheckPolicy};
use std::collections::{HashMap, HashSet};

/// Writes the module as SPIR-V.
pub(super) fn write(module: &ValidModule) -> Result<Vec<u32>, EmitError> {
    if module.module().entry_points.is_empty() {
        return Err(EmitError::NoEntry);
    }
    translate(module, &settings(), None)
}

/// The compute entry point `entry` alone, whose accesses stay inside their buffers and arrays.
pub(super) fn plain(module: &ValidModule, entry: &str) -> Result<Vec<u32>, EmitError> {
    let restrict = BoundsCheckPolicy::Restrict;
    let policies = BoundsCheckPolicies {
        index: restrict,
        buffer: restrict,
        // Vulkan's robust image access, which wgpu asks for, already keeps loads inside.
        image_load: BoundsCheckPolicy::Unchecked,
        binding_array: restrict,
    };
    let settings =
        spv::Options { bounds_check_policies: policies, capabilities: Some(capabilities()), ..settings() };
    let only =
        spv::PipelineOptions { shader_stage: naga::ShaderStage::Compute, entry_point: entry.to_owned() };
    translate(module, &settings, Some(&only))
}

/// What naga may use: all but numbers of 8 bits, which it takes to pack and unpack wherever nobody forbids it, on
/// devices that lack them too.
fn capabilities() -> naga::FastHashSet<spv::Capability> {
    /// Beyond the last number that a capability has.
    const END: u32 = 0x4000;
    let all = (0..END).filter_map(spv::Capability::from_u32);
    all.filter(|capability| *capability != spv::Capability::Int8).collect()
}

fn settings() -> spv::Options<'static> {
    spv::Options {
        lang_version: (1, 3),
        flags: spv::WriterFlags::DEBUG,
        zero_initialize_workgroup_memory: spv::ZeroInitializeWorkgroupMemoryMode::Polyfill,
        force_loop_bounding: false,
        ..spv::Options::default()
    }
}

fn translate(
    module: &ValidModule,
    settings: &spv::Options,
    only: Option<&spv::PipelineOptions>,
) -> Result<Vec<u32>, EmitError> {
    let words = guarded(Target::Spirv, || spv::write_vec(module.module(), module.info(), settings, only))?;
    Ok(without_workgroup_layout(words))
}

const HEADER: usize = 5;
const OP_TYPE_ARRAY: u32 = 28;
const OP_TYPE_STRUCT: u32 = 30;
const OP_TYPE_POINTER: u32 = 32;
const OP_TYPE_RUNTIME_ARRAY: u32 = 29;
const OP_DECORATE: u32 = 71;
const OP_MEMBER_DECORATE: u32 = 72;
/// RowMajor, ColMajor, ArrayStride, MatrixStride, Offset.
const LAYOUT: [u32; 5] = [4, 5, 6, 7, 35];
const WORKGROUP: u32 = 4;
/// Uniform, PushConstant, StorageBuffer.
const LAID_OUT: [u32; 3] = [2, 9, 12];

/// Takes the explicit layout from types that only workgroup memory uses.
///
/// naga decorates them like those of buffers; Vulkan forbids that
/// (VUID-StandaloneSpirv-None-10684), and validators since 2025 say so.
/// A type that buffers use too keeps its layout: in SPIR-V 1.3 values could not go between two forms
/// of it.
fn without_workgroup_layout(words: Vec<u32>) -> Vec<u32> {
    let shared = reachable(&words, &[WORKGROUP]);
    if shared.is_empty() {
        return words;
    }
    let laid_out = reachable(&words, &LAID_OUT);
    let mut out: Vec<u32> = words.iter().take(HEADER).copied().collect();
    for instruction in Instructions::new(&words) {
        let is_layout = match *instruction {
            [op, target, decoration, ..] if op & 0xffff == OP_DECORATE => Some((target, decoration)),
            [op, target, _, decoration, ..] if op & 0xffff == OP_MEMBER_DECORATE => {
                Some((target, decoration))
            }
            _ => None,
        }
        .is_some_and(|(target, decoration)| {
            LAYOUT.contains(&decoration) && shared.contains(&target) && !laid_out.contains(&target)
        });
        if !is_layout {
            out.extend_from_slice(instruction);
        }
    }
    out
}

/// The types behind pointers into the given storage classes.
fn reachable(words: &[u32], classes: &[u32]) -> HashSet<u32> {
    let mut parts: HashMap<u32, &[u32]> = HashMap::new();
    let mut open = Vec::new();
    for instruction in Instructions::new(words) {
        match (instruction[0] & 0xffff, instruction) {
            (OP_TYPE_ARRAY | OP_TYPE_RUNTIME_ARRAY, [_, id, element, ..]) => {
                parts.insert(*id, std::slice::from_ref(element));
            }
            (OP_TYPE_STRUCT, [_, id, members @ ..]) => {
                parts.insert(*id, members);
            }
            (OP_TYPE_POINTER, [_, _, class, pointee]) if classes.contains(class) => open.push(*pointee),
            _ => {}
        }
    }
    let mut found = HashSet::new();
    while let Some(id) = open.pop() {
        if found.insert(id) {
            open.extend(parts.get(&id).copied().unwrap_or_default());
        }
    }
    found
}

/// The instructions of a module, each with its first word; ends early when the words are malformed.
struct Instructions<'a>(&'a [u32]);

impl<'a> Instructions<'a> {
    fn new(words: &'a [u32]) -> Self {
        Self(words.get(HEADER..).unwrap_or_default())
    }
}

impl<'a> Iterator for Instructions<'a> {
    type Item = &'a [u32];

    fn next(&mut self) -> Option<&'a [u32]> {
        let length = (self.0.first()? >> 16) as usize;
        if length == 0 || length > self.0.len() {
            return None;
        }
        let (instruction, rest) = self.0.split_at(length);
        self.0 = rest;
        Some(instruction)
    }
}
