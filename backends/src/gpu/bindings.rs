//! What one job binds, its buffers taken over from the job before where they fit.

use super::textures::{self, Bound as BoundTexture};
use super::{Binding, BindingKind, Job};

/// Buffers of the last job, for the next one to reuse.
///
/// Only the last job's are kept, so a long run holds no more memory than its largest job.
#[derive(Default)]
pub(super) struct Spare(Vec<wgpu::Buffer>);

impl Spare {
    fn take(&mut self, device: &wgpu::Device, size: u64, usage: wgpu::BufferUsages) -> wgpu::Buffer {
        match self.0.iter().position(|buffer| buffer.size() == size && buffer.usage() == usage) {
            Some(at) => self.0.swap_remove(at),
            None => device.create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size,
                usage,
                mapped_at_creation: false,
            }),
        }
    }
}

/// What is bound to one place.
enum Bound {
    /// A buffer, and one to read back if the shader writes it.
    Buffer(wgpu::Buffer, Option<wgpu::Buffer>),
    Texture(BoundTexture, wgpu::TextureView),
    Sampler(wgpu::Sampler),
}

impl Bound {
    fn readback(&self) -> Option<&wgpu::Buffer> {
        match self {
            Self::Buffer(_, readback) => readback.as_ref(),
            Self::Texture(texture, _) => texture.readback(),
            Self::Sampler(_) => None,
        }
    }
}

/// What is bound to the place of a binding array, in the form that wgpu takes.
pub(super) enum Array<'b> {
    Buffers(Vec<wgpu::BufferBinding<'b>>),
    Textures(Vec<&'b wgpu::TextureView>),
    Samplers(Vec<&'b wgpu::Sampler>),
}

impl Array<'_> {
    pub(super) fn lend(&self) -> wgpu::BindingResource<'_> {
        match self {
            Self::Buffers(buffers) => wgpu::BindingResource::BufferArray(buffers),
            Self::Textures(views) => wgpu::BindingResource::TextureViewArray(views),
            Self::Samplers(samplers) => wgpu::BindingResource::SamplerArray(samplers),
        }
    }
}

/// One job's buffers, textures and samplers: one for each binding, in order.
pub(super) struct Bindings(Vec<Bound>);

impl Bindings {
    /// Takes or makes them, and sends each binding's bytes.
    pub(super) fn fill(
        spare: &mut Spare,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        bindings: &[Binding],
    ) -> Self {
        let bind = |binding: &Binding| match binding.kind {
            BindingKind::Uniform | BindingKind::StorageRead | BindingKind::StorageReadWrite => {
                let size = binding.data.len() as u64;
                let buffer = spare.take(device, size, usage(binding.kind));
                queue.write_buffer(&buffer, 0, binding.data);
                let readback = (binding.kind == BindingKind::StorageReadWrite).then(|| {
                    let usage = wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST;
                    spare.take(device, size, usage)
                });
                Bound::Buffer(buffer, readback)
            }
            BindingKind::Texture(shape) => texture(device, queue, binding, shape, None),
            BindingKind::StorageTexture(shape, access) => {
                texture(device, queue, binding, shape, Some(access))
            }
            BindingKind::Sampler(ref sampler) => Bound::Sampler(textures::sampler(device, sampler)),
        };
        Self(bindings.iter().map(bind).collect())
    }

    /// What is bound for the binding at `index` of the job.
    pub(super) fn bound(&self, index: usize) -> wgpu::BindingResource<'_> {
        match &self.0[index] {
            Bound::Buffer(buffer, _) => buffer.as_entire_binding(),
            Bound::Texture(_, view) => wgpu::BindingResource::TextureView(view),
            Bound::Sampler(sampler) => wgpu::BindingResource::Sampler(sampler),
        }
    }

    /// The elements of the binding array at a place, which are of one kind (`check`).
    pub(super) fn array(&self, job: &Job, place: (u32, u32)) -> Array<'_> {
        let (mut buffers, mut views, mut samplers) = (Vec::new(), Vec::new(), Vec::new());
        let here = job.bindings.iter().zip(&self.0).filter(|(b, _)| (b.group, b.binding) == place);
        for (_, bound) in here {
            match bound {
                Bound::Buffer(buffer, _) => buffers.push(buffer.as_entire_buffer_binding()),
                Bound::Texture(_, view) => views.push(view),
                Bound::Sampler(sampler) => samplers.push(sampler),
            }
        }
        match (views.is_empty(), samplers.is_empty()) {
            (false, _) => Array::Textures(views),
            (true, false) => Array::Samplers(samplers),
            (true, true) => Array::Buffers(buffers),
        }
    }

    /// Copies what the shader wrote to where it can be read.
    pub(super) fn copy_back(&self, encoder: &mut wgpu::CommandEncoder) {
        for bound in &self.0 {
            match bound {
                Bound::Buffer(buffer, Some(target)) => {
                    encoder.copy_buffer_to_buffer(buffer, 0, target, 0, target.size());
                }
                Bound::Texture(texture, _) => texture.copy_back(encoder),
                Bound::Buffer(_, None) | Bound::Sampler(_) => {}
            }
        }
    }

    /// Asks for the copies to be mapped; they are once the device has been waited for.
    pub(super) fn map(&self) {
        for buffer in self.0.iter().filter_map(Bound::readback) {
            // A failure shows again, with its reason, when the mapped bytes are asked for.
            buffer.map_async(wgpu::MapMode::Read, .., |_| {});
        }
    }

    /// The copied bytes, in the order of the bindings.
    pub(super) fn read(&self) -> Result<Vec<Vec<u8>>, String> {
        let read = |bound: &Bound| {
            let buffer = bound.readback()?;
            let mapped = buffer.get_mapped_range(..).map_err(|error| error.to_string());
            let bytes = mapped.map(|mapped| match bound {
                Bound::Texture(texture, _) => texture.texels(&mapped),
                Bound::Buffer(..) | Bound::Sampler(_) => mapped.to_vec(),
            });
            buffer.unmap();
            Some(bytes)
        };
        self.0.iter().filter_map(read).collect()
    }

    /// Gives the buffers up for reuse.
    pub(super) fn into_spare(self) -> Spare {
        let buffers = self.0.into_iter().filter_map(|bound| match bound {
            Bound::Buffer(buffer, readback) => Some([Some(buffer), readback]),
            Bound::Texture(..) | Bound::Sampler(_) => None,
        });
        Spare(buffers.flatten().flatten().collect())
    }
}

fn texture(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    binding: &Binding,
    shape: crate::texture::TextureShape,
    access: Option<super::Access>,
) -> Bound {
    let texture = BoundTexture::fill(device, queue, binding, shape, access);
    let view = texture.view();
    Bound::Texture(texture, view)
}

fn usage(kind: BindingKind) -> wgpu::BufferUsages {
    let read = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST;
    match kind {
        BindingKind::Uniform => wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        BindingKind::StorageReadWrite => read | wgpu::BufferUsages::COPY_SRC,
        BindingKind::StorageRead
        | BindingKind::Texture(_)
        | BindingKind::StorageTexture(..)
        | BindingKind::Sampler(_) => read,
    }
}
