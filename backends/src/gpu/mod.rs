//! Runs compute shaders, given as text or words, on whatever Vulkan and OpenGL drivers this machine has.
//!
//! ```no_run
//! use lobe_backends::gpu::{self, Binding, BindingKind, Gpu, Job, Shader};
//!
//! let driver = gpu::drivers().into_iter().next().ok_or("no Vulkan driver here")?;
//! let input = [1.0f32, 2.0].map(f32::to_le_bytes).concat();
//! let outputs = Gpu::open(&driver)?.run(&Job {
//!     shader: Shader::Wgsl(
//!         "@group(0) @binding(0) var<storage, read_write> x: array<f32>;
//!          @compute @workgroup_size(2) fn main(@builtin(global_invocation_id) id: vec3u) { x[id.x] *= 2.0; }",
//!     ),
//!     entry: "main",
//!     workgroup_size: [2, 1, 1],
//!     groups: [1, 1, 1],
//!     bindings: &[Binding { group: 0, binding: 0, element: None, kind: BindingKind::StorageReadWrite, data: &input }],
//!     immediates: &[],
//! })?;
//! assert_eq!(outputs[0], [2.0f32, 4.0].map(f32::to_le_bytes).concat());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Where drivers come from
//!
//! Those that the system's Vulkan loader lists (lavapipe and real GPUs; `VK_DRIVER_FILES` and its like work as ever), and
//! those whose manifest lies in `vulkan/icd.d/` of the [tools folder](crate::translate::tools_dir) (SwiftShader).
//! The latter are opened as libraries, without the loader: so no environment variable has to be set, and
//! SwiftShader works on a machine that has no Vulkan loader at all.
//!
//! OpenGL drivers are found through EGL ([`gl_drivers`]), without a display, where the system has it.
//!
//! # What can go wrong
//!
//! Each [`Gpu`] keeps its device on a thread of its own.
//! A driver that hangs costs that thread and a [`GpuError::Timeout`]; one that loses its device costs the device: the
//! next job gets a fresh one.
//! A driver that crashes takes the process along, and broken SPIR-V makes some drivers crash. Run
//! [`spirv_val`](crate::translate::spirv_val) first on words that you do not trust.

mod any;
mod bindings;
mod check;
mod dawn;
mod depth;
mod device;
mod driver;
mod error;
mod icd;
mod owned;
mod pipelines;
mod spirv;
mod textures;
mod worker;

pub use any::AnyGpu;
pub use dawn::DawnGpu;
pub use driver::{Api, Driver, drivers, gl_drivers};
pub use error::GpuError;
pub use worker::{DEFAULT_TIMEOUT, Gpu};

use crate::texture::{Sampler, TextureShape};

/// A compute shader, in the form in which it was emitted.
#[derive(Clone, Copy, Debug)]
pub enum Shader<'a> {
    /// WGSL text; wgpu's own copy of naga turns it into SPIR-V, bounds checks added.
    Wgsl(&'a str),
    /// SPIR-V words; they reach the driver unchanged.
    Spirv(&'a [u32]),
    /// GLSL text; it reaches an OpenGL driver unchanged. Its resources are buffers in group 0, and each kind has the
    /// numbers of the text.
    Glsl(&'a str),
}

/// How a shader uses a storage texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Access {
    /// `read`.
    Read,
    /// `write`.
    Write,
    /// `read_write`.
    ReadWrite,
    /// `atomic`.
    Atomic,
}

/// What a shader does with the bytes bound to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BindingKind {
    /// `var<uniform>`.
    Uniform,
    /// `var<storage, read>`.
    StorageRead,
    /// `var<storage, read_write>`; its final bytes are what [`Gpu::run`] returns.
    StorageReadWrite,
    /// A texture that is loaded from or sampled; its bytes are its texels.
    Texture(TextureShape),
    /// A storage texture, of one level; one that the shader may write is among what [`Gpu::run`] returns.
    StorageTexture(TextureShape, Access),
    /// A sampler, which has no bytes.
    Sampler(Sampler),
}

/// One buffer, texture or sampler, and where the shader expects it.
#[derive(Clone, Copy, Debug)]
pub struct Binding<'a> {
    /// `@group` in WGSL, descriptor set in SPIR-V.
    pub group: u32,
    /// `@binding` in both.
    pub binding: u32,
    /// Which element of a binding array it is; `None` where the variable is none.
    pub element: Option<u32>,
    /// How the shader uses it.
    pub kind: BindingKind,
    /// Its bytes when the shader starts; the length of a buffer is a multiple of 4 and not 0.
    pub data: &'a [u8],
}

/// One dispatch of one entry point.
#[derive(Clone, Copy, Debug)]
pub struct Job<'a> {
    /// The shader.
    pub shader: Shader<'a>,
    /// The name of a compute entry point in it.
    pub entry: &'a str,
    /// The workgroup size that the shader declares. (SPIR-V is not reflected upon, so the caller says it.)
    pub workgroup_size: [u32; 3],
    /// How many workgroups to start along each axis.
    pub groups: [u32; 3],
    /// Everything that the shader uses.
    pub bindings: &'a [Binding<'a>],
    /// The bytes of its immediates (push constants); none if it has no such variable.
    pub immediates: &'a [u8],
}
