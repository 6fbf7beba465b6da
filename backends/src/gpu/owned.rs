//! Jobs that own their parts, so that they can change threads and be remembered.

use super::{Binding, BindingKind, Job, Shader};

/// A [`Shader`] with its own text or words.
#[derive(Clone, PartialEq, Eq, Hash)]
pub(super) enum OwnedShader {
    Wgsl(String),
    Spirv(Vec<u32>),
    Glsl(String),
}

impl OwnedShader {
    pub(super) fn of(shader: Shader) -> Self {
        match shader {
            Shader::Wgsl(text) => Self::Wgsl(text.to_owned()),
            Shader::Spirv(words) => Self::Spirv(words.to_vec()),
            Shader::Glsl(text) => Self::Glsl(text.to_owned()),
        }
    }

    fn lend(&self) -> Shader<'_> {
        match self {
            Self::Wgsl(text) => Shader::Wgsl(text),
            Self::Spirv(words) => Shader::Spirv(words),
            Self::Glsl(text) => Shader::Glsl(text),
        }
    }
}

/// A [`Job`] with its own shader and buffers.
pub(super) struct OwnedJob {
    shader: OwnedShader,
    entry: String,
    workgroup_size: [u32; 3],
    groups: [u32; 3],
    bindings: Vec<OwnedBinding>,
    immediates: Vec<u8>,
}

struct OwnedBinding {
    group: u32,
    binding: u32,
    element: Option<u32>,
    kind: BindingKind,
    data: Vec<u8>,
}

impl OwnedBinding {
    fn of(&Binding { group, binding, element, kind, data }: &Binding) -> Self {
        Self { group, binding, element, kind, data: data.to_vec() }
    }

    fn lend(&self) -> Binding<'_> {
        let Self { group, binding, element, kind, ref data } = *self;
        Binding { group, binding, element, kind, data }
    }
}

impl OwnedJob {
    pub(super) fn of(job: &Job) -> Self {
        Self {
            shader: OwnedShader::of(job.shader),
            entry: job.entry.to_owned(),
            workgroup_size: job.workgroup_size,
            groups: job.groups,
            bindings: job.bindings.iter().map(OwnedBinding::of).collect(),
            immediates: job.immediates.to_vec(),
        }
    }

    /// Calls `body` with the job in borrowed form.
    pub(super) fn lend<T>(&self, body: impl FnOnce(&Job) -> T) -> T {
        let bindings: Vec<Binding> = self.bindings.iter().map(OwnedBinding::lend).collect();
        body(&Job {
            shader: self.shader.lend(),
            entry: &self.entry,
            workgroup_size: self.workgroup_size,
            groups: self.groups,
            bindings: &bindings,
            immediates: &self.immediates,
        })
    }
}
