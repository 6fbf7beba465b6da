//! The buffers of one job, taken over from the job before where they fit.

use super::{Binding, BindingKind};

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

/// One job's buffers: one for each binding, in order, and one to read back for each that the shader writes.
pub(super) struct Buffers {
    bound: Vec<wgpu::Buffer>,
    readback: Vec<(usize, wgpu::Buffer)>,
}

impl Buffers {
    /// Takes or makes the buffers, and sends each binding's bytes.
    pub(super) fn fill(
        spare: &mut Spare,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        bindings: &[Binding],
    ) -> Self {
        let mut bound = Vec::new();
        let mut readback = Vec::new();
        for (index, binding) in bindings.iter().enumerate() {
            let size = binding.data.len() as u64;
            let buffer = spare.take(device, size, usage(binding.kind));
            queue.write_buffer(&buffer, 0, binding.data);
            bound.push(buffer);
            if binding.kind == BindingKind::StorageReadWrite {
                let usage = wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST;
                readback.push((index, spare.take(device, size, usage)));
            }
        }
        Self { bound, readback }
    }

    /// The buffer of the binding at `index` of the job.
    pub(super) fn bound(&self, index: usize) -> &wgpu::Buffer {
        &self.bound[index]
    }

    /// Copies what the shader wrote to where it can be read.
    pub(super) fn copy_back(&self, encoder: &mut wgpu::CommandEncoder) {
        for (index, target) in &self.readback {
            encoder.copy_buffer_to_buffer(&self.bound[*index], 0, target, 0, target.size());
        }
    }

    /// Asks for the copies to be mapped; they are once the device has been waited for.
    pub(super) fn map(&self) {
        for (_, buffer) in &self.readback {
            // A failure shows again, with its reason, when the mapped bytes are asked for.
            buffer.map_async(wgpu::MapMode::Read, .., |_| {});
        }
    }

    /// The copied bytes, in the order of the bindings.
    pub(super) fn read(&self) -> Result<Vec<Vec<u8>>, String> {
        let read = |(_, buffer): &(usize, wgpu::Buffer)| {
            let bytes = buffer.get_mapped_range(..).map_err(|error| error.to_string())?.to_vec();
            buffer.unmap();
            Ok(bytes)
        };
        self.readback.iter().map(read).collect()
    }

    /// Gives the buffers up for reuse.
    pub(super) fn into_spare(self) -> Spare {
        Spare(self.bound.into_iter().chain(self.readback.into_iter().map(|(_, buffer)| buffer)).collect())
    }
}

fn usage(kind: BindingKind) -> wgpu::BufferUsages {
    match kind {
        BindingKind::Uniform => wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        BindingKind::StorageRead => wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST,
        BindingKind::StorageReadWrite => {
            wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::COPY_SRC
        }
    }
}
