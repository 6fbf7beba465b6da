//! Shaders made into pipelines, each once.
#![allow(
    unsafe_code,
    reason = "SPIR-V and GLSL are handed to the driver unchanged, which wgpu cannot vouch for"
)]

use std::borrow::Cow;
use std::collections::HashMap;
use std::num::NonZeroU32;

use super::owned::OwnedShader;
use super::{Binding, BindingKind, Job, Shader, textures};

/// Past this many pipelines all are dropped: a run over thousands of shaders must not keep them all.
const CAPACITY: usize = 64;

/// Pipelines by all that goes into them. Keys are compared whole, so no two shaders can be mistaken for each other.
#[derive(Default)]
pub(super) struct Pipelines(HashMap<Key, Pipeline>);

#[derive(PartialEq, Eq, Hash)]
pub(super) struct Key {
    shader: OwnedShader,
    entry: String,
    workgroup_size: [u32; 3],
    places: Vec<(u32, u32, Option<u32>, wgpu::BindingType)>,
    immediate_size: u32,
}

/// A pipeline with the layout of each of its groups; `None` where a group's number is skipped.
#[derive(Clone)]
pub(super) struct Pipeline {
    pub(super) pipeline: wgpu::ComputePipeline,
    pub(super) groups: Vec<Option<wgpu::BindGroupLayout>>,
}

impl Key {
    pub(super) fn of(job: &Job, features: wgpu::Features) -> Self {
        let shader = OwnedShader::of(job.shader);
        let places = job.bindings.iter();
        let places =
            places.map(|b| (b.group, b.binding, b.element, binding_type(b.kind, features))).collect();
        let (entry, workgroup_size) = (job.entry.to_owned(), job.workgroup_size);
        Self { shader, entry, workgroup_size, places, immediate_size: job.immediates.len() as u32 }
    }
}

impl Pipelines {
    pub(super) fn get(&self, key: &Key) -> Option<Pipeline> {
        self.0.get(key).cloned()
    }

    pub(super) fn keep(&mut self, key: Key, pipeline: Pipeline) {
        if self.0.len() >= CAPACITY {
            self.0.clear();
        }
        self.0.insert(key, pipeline);
    }
}

/// Makes the pipeline for `job`. Errors go to the device's error scopes.
pub(super) fn build(device: &wgpu::Device, job: &Job) -> Pipeline {
    let groups = group_layouts(device, job);
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: None,
        bind_group_layouts: &groups.iter().map(Option::as_ref).collect::<Vec<_>>(),
        immediate_size: job.immediates.len() as u32,
    });
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: None,
        layout: Some(&layout),
        module: &module(device, job),
        entry_point: Some(job.entry),
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        cache: None,
    });
    Pipeline { pipeline, groups }
}

fn module(device: &wgpu::Device, job: &Job) -> wgpu::ShaderModule {
    match job.shader {
        Shader::Wgsl(text) => device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(job.entry),
            source: wgpu::ShaderSource::Wgsl(Cow::Borrowed(text)),
        }),
        Shader::Spirv(words) => {
            let descriptor = wgpu::ShaderModuleDescriptorPassthrough {
                entry_points: Cow::Owned(vec![entry(job)]),
                spirv: Some(Cow::Borrowed(words)),
                ..Default::default()
            };
            // SAFETY: the words form a module with this entry point and size (spirv::check). What the instructions do
            // is between the caller and the driver; `Gpu::run` documents it.
            unsafe { device.create_shader_module_passthrough(descriptor) }
        }
        Shader::Glsl(text) => {
            let descriptor = wgpu::ShaderModuleDescriptorPassthrough {
                entry_points: Cow::Owned(vec![entry(job)]),
                glsl: Some(Cow::Borrowed(text)),
                ..Default::default()
            };
            // SAFETY: the driver's own compiler reads the text, and refuses what is no shader. What the shader does
            // is between the caller and the driver; `Gpu::run` documents it.
            unsafe { device.create_shader_module_passthrough(descriptor) }
        }
    }
}

fn entry<'a>(job: &Job<'a>) -> wgpu::PassthroughShaderEntryPoint<'a> {
    let [x, y, z] = job.workgroup_size;
    wgpu::PassthroughShaderEntryPoint { name: Cow::Borrowed(job.entry), workgroup_size: (x, y, z) }
}

fn group_layouts(device: &wgpu::Device, job: &Job) -> Vec<Option<wgpu::BindGroupLayout>> {
    let count = job.bindings.iter().map(|b| b.group + 1).max().unwrap_or(0);
    (0..count).map(|group| group_layout(device, job, group)).collect()
}

fn group_layout(device: &wgpu::Device, job: &Job, group: u32) -> Option<wgpu::BindGroupLayout> {
    let features = device.features();
    let firsts = job.bindings.iter().filter(|b| b.group == group && b.element.is_none_or(|n| n == 0));
    let bound = firsts.map(|first| {
        let elements = job.bindings.iter().filter(|b| (b.group, b.binding) == (group, first.binding));
        let count = first.element.and_then(|_| NonZeroU32::new(elements.clone().count() as u32));
        let types = elements.map(|b| binding_type(b.kind, features));
        let ty = types.reduce(common_type).unwrap_or_else(|| binding_type(first.kind, features));
        layout_entry(place(job.shader, first), ty, count)
    });
    let fillers = fillers(job, group)
        .into_iter()
        .map(|filler| layout_entry(filler.place, binding_type(filler.kind, features), None));
    let entries: Vec<_> = bound.chain(fillers).collect();
    let descriptor = wgpu::BindGroupLayoutDescriptor { label: None, entries: &entries };
    (!entries.is_empty()).then(|| device.create_bind_group_layout(&descriptor))
}

/// Where the uniform buffers of GLSL begin in a layout.
const UNIFORMS: u32 = 256;

/// The number in a layout of what `shader` binds.
///
/// OpenGL numbers uniform and storage buffers apart from each other, and wgpu counts each kind from 0 in the order of
/// the layout. It does not read GLSL that is passed through, so a layout need not have the numbers of the text: the two
/// kinds each have a range, in which the fillers see to it that wgpu counts as the text does.
pub(super) fn place(shader: Shader, binding: &Binding) -> u32 {
    match (shader, binding.kind) {
        (Shader::Glsl(_), BindingKind::Uniform) => UNIFORMS + binding.binding,
        (Shader::Glsl(_) | Shader::Wgsl(_) | Shader::Spirv(_), _) => binding.binding,
    }
}

/// Something bound where a job has nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Filler {
    /// Its number in the layout.
    pub(super) place: u32,
    /// A uniform or storage buffer.
    pub(super) kind: BindingKind,
}

/// The binding numbers that `job` skips in `group` and that need something bound all the same.
///
/// wgpu numbers the bindings of a group anew, without gaps, and rewrites WGSL to match. SPIR-V that is passed through
/// keeps its numbers, so there wgpu must find no gap to close: a skipped number would make every later buffer arrive
/// in its neighbour's place, without any error.
pub(super) fn fillers(job: &Job, group: u32) -> Vec<Filler> {
    let of_group = job.bindings.iter().filter(|b| b.group == group);
    let taken: Vec<u32> = of_group.map(|b| place(job.shader, b)).collect();
    let storage = BindingKind::StorageRead;
    match job.shader {
        Shader::Wgsl(_) => Vec::new(),
        Shader::Spirv(_) => gaps(&taken, 0..u32::MAX, storage),
        Shader::Glsl(_) => {
            let uniforms = gaps(&taken, UNIFORMS..u32::MAX, BindingKind::Uniform);
            gaps(&taken, 0..UNIFORMS, storage).into_iter().chain(uniforms).collect()
        }
    }
}

/// The numbers of `range` that are not taken, up to the last that is.
fn gaps(taken: &[u32], range: std::ops::Range<u32>, kind: BindingKind) -> Vec<Filler> {
    let end = taken.iter().filter(|n| range.contains(n)).max().copied().unwrap_or(range.start);
    let free = (range.start..end).filter(|number| !taken.contains(number));
    free.map(|place| Filler { place, kind }).collect()
}

fn layout_entry(
    binding: u32,
    ty: wgpu::BindingType,
    count: Option<NonZeroU32>,
) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::COMPUTE, ty, count }
}

/// The type that elements of two types have in common; the first where they have none.
pub(super) fn common_type(a: wgpu::BindingType, b: wgpu::BindingType) -> wgpu::BindingType {
    use wgpu::SamplerBindingType::{Filtering, NonFiltering};
    use wgpu::{BindingType, TextureSampleType::Float};
    match (a, b) {
        (BindingType::Sampler(NonFiltering), BindingType::Sampler(Filtering)) => b,
        (
            BindingType::Texture { sample_type: Float { filterable: true }, .. },
            BindingType::Texture { sample_type: Float { filterable: false }, .. },
        ) => b,
        _ => a,
    }
}

/// What a pipeline has to know of a binding, and no more.
pub(super) fn binding_type(kind: BindingKind, features: wgpu::Features) -> wgpu::BindingType {
    let ty = match kind {
        BindingKind::Uniform => wgpu::BufferBindingType::Uniform,
        BindingKind::StorageRead => wgpu::BufferBindingType::Storage { read_only: true },
        BindingKind::StorageReadWrite => wgpu::BufferBindingType::Storage { read_only: false },
        BindingKind::Texture(shape) => return textures::sampled(&shape, features),
        BindingKind::StorageTexture(shape, access) => return textures::storage(&shape, access),
        BindingKind::Sampler(sampler) => return textures::sampling(&sampler),
    };
    wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_passed_through_shaders_have_their_gaps_filled() {
        let at = |group, binding| Binding {
            group,
            binding,
            element: None,
            kind: BindingKind::StorageRead,
            data: &[],
        };
        let bindings = [at(0, 4), at(0, 1), at(1, 0)];
        let (workgroup_size, groups) = ([1; 3], [1; 3]);
        let job =
            |shader| Job { shader, entry: "", workgroup_size, groups, bindings: &bindings, immediates: &[] };
        let places = |shader, group| fillers(&job(shader), group).iter().map(|f| f.place).collect::<Vec<_>>();
        assert_eq!(places(Shader::Spirv(&[]), 0), [0, 2, 3]);
        assert!(places(Shader::Spirv(&[]), 1).is_empty());
        assert!(places(Shader::Wgsl(""), 0).is_empty());
    }

    #[test]
    fn glsl_has_the_gaps_of_each_kind_filled() {
        let at = |binding, kind| Binding { group: 0, binding, element: None, kind, data: &[] };
        let bindings = [at(1, BindingKind::StorageRead), at(2, BindingKind::Uniform)];
        let (workgroup_size, groups) = ([1; 3], [1; 3]);
        let shader = Shader::Glsl("");
        let job = Job { shader, entry: "", workgroup_size, groups, bindings: &bindings, immediates: &[] };
        let filler = |place, kind| Filler { place, kind };
        assert_eq!(
            fillers(&job, 0),
            [
                filler(0, BindingKind::StorageRead),
                filler(UNIFORMS, BindingKind::Uniform),
                filler(UNIFORMS + 1, BindingKind::Uniform),
            ]
        );
        assert_eq!(bindings.map(|b| place(shader, &b)), [1, UNIFORMS + 2]);
    }
}
