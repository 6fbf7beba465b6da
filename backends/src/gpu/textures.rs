//! Textures and samplers of one job.

use super::{Access, Binding, depth};
use crate::texture::{Address, Compare, Dimension, Filter, Format, Kind, Sampler, TextureShape};

/// A texture of a job, with what its texels are copied back to if the shader writes it.
pub(super) struct Bound {
    texture: wgpu::Texture,
    shape: TextureShape,
    readback: Option<wgpu::Buffer>,
}

impl Bound {
    /// Makes the texture and sends its texels.
    pub(super) fn fill(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        binding: &Binding,
        shape: TextureShape,
        access: Option<Access>,
    ) -> Self {
        let texture = device.create_texture(&descriptor(&shape, access));
        let mut at = 0;
        // What is multisampled can only be zero (`check`), and textures begin so.
        let is_drawn = shape.samples == 1 && depth::is_drawn(&shape);
        if is_drawn {
            depth::fill(device, queue, &texture, &shape, binding.data);
        }
        for level in (0..shape.levels).filter(|_| shape.samples == 1 && !is_drawn) {
            let [width, height, _] = shape.level_size(level);
            let texels = &binding.data[at..at + shape.level_bytes(level)];
            at += texels.len();
            let copied = wgpu::TexelCopyTextureInfo { mip_level: level, ..texture.as_image_copy() };
            let layout = wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(width * shape.format.bytes() as u32),
                rows_per_image: Some(height),
            };
            queue.write_texture(copied, texels, layout, extent(&shape, level));
        }
        let written = matches!(access, Some(Access::Write | Access::ReadWrite | Access::Atomic));
        let readback = written.then(|| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size: (padded_row(&shape) * rows(&shape)) as u64,
                usage: wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        });
        Self { texture, shape, readback }
    }

    /// As the shader sees it.
    pub(super) fn view(&self) -> wgpu::TextureView {
        let dimension = Some(view_dimension(self.shape.dimension));
        self.texture.create_view(&wgpu::TextureViewDescriptor { dimension, ..Default::default() })
    }

    pub(super) fn copy_back(&self, encoder: &mut wgpu::CommandEncoder) {
        if let Some(buffer) = &self.readback {
            let layout = wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(padded_row(&self.shape) as u32),
                rows_per_image: Some(self.shape.size[1]),
            };
            let to = wgpu::TexelCopyBufferInfo { buffer, layout };
            encoder.copy_texture_to_buffer(self.texture.as_image_copy(), to, extent(&self.shape, 0));
        }
    }

    pub(super) fn readback(&self) -> Option<&wgpu::Buffer> {
        self.readback.as_ref()
    }

    /// The texels of copied bytes, whose rows are padded.
    pub(super) fn texels(&self, copied: &[u8]) -> Vec<u8> {
        let row = self.shape.size[0] as usize * self.shape.format.bytes();
        copied.chunks(padded_row(&self.shape)).flat_map(|padded| &padded[..row]).copied().collect()
    }
}

/// One layer of one level.
pub(super) fn view_of(texture: &wgpu::Texture, level: u32, layer: u32) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor {
        dimension: Some(wgpu::TextureViewDimension::D2),
        base_mip_level: level,
        mip_level_count: Some(1),
        base_array_layer: layer,
        array_layer_count: Some(1),
        ..Default::default()
    })
}

/// Bytes of a row in a buffer that a texture is copied to.
fn padded_row(shape: &TextureShape) -> usize {
    let row = shape.size[0] as usize * shape.format.bytes();
    row.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT as usize)
}

/// Rows of level 0.
fn rows(shape: &TextureShape) -> usize {
    shape.size[1] as usize * shape.size[2] as usize * shape.layers as usize
}

fn extent(shape: &TextureShape, level: u32) -> wgpu::Extent3d {
    let [width, height, depth] = shape.level_size(level);
    wgpu::Extent3d { width, height, depth_or_array_layers: depth * shape.layers }
}

fn descriptor(shape: &TextureShape, access: Option<Access>) -> wgpu::TextureDescriptor<'static> {
    let dimension = match shape.dimension {
        Dimension::D1 => wgpu::TextureDimension::D1,
        Dimension::D3 => wgpu::TextureDimension::D3,
        Dimension::D2 | Dimension::D2Array | Dimension::Cube | Dimension::CubeArray => {
            wgpu::TextureDimension::D2
        }
    };
    let shared = wgpu::TextureUsages::COPY_DST | wgpu::TextureUsages::COPY_SRC;
    let usage = match access {
        None if shape.samples > 1 || depth::is_drawn(shape) => {
            wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::RENDER_ATTACHMENT
        }
        None => shared | wgpu::TextureUsages::TEXTURE_BINDING,
        Some(Access::Atomic) => {
            shared | wgpu::TextureUsages::STORAGE_BINDING | wgpu::TextureUsages::STORAGE_ATOMIC
        }
        Some(Access::Read | Access::Write | Access::ReadWrite) => {
            shared | wgpu::TextureUsages::STORAGE_BINDING
        }
    };
    wgpu::TextureDescriptor {
        label: None,
        size: extent(shape, 0),
        mip_level_count: shape.levels,
        sample_count: shape.samples,
        dimension,
        format: format(shape.format),
        usage,
        view_formats: &[],
    }
}

fn view_dimension(dimension: Dimension) -> wgpu::TextureViewDimension {
    match dimension {
        Dimension::D1 => wgpu::TextureViewDimension::D1,
        Dimension::D2 => wgpu::TextureViewDimension::D2,
        Dimension::D2Array => wgpu::TextureViewDimension::D2Array,
        Dimension::D3 => wgpu::TextureViewDimension::D3,
        Dimension::Cube => wgpu::TextureViewDimension::Cube,
        Dimension::CubeArray => wgpu::TextureViewDimension::CubeArray,
    }
}

/// The layout entry of a sampled texture.
pub(super) fn sampled(shape: &TextureShape, features: wgpu::Features) -> wgpu::BindingType {
    let multisampled = shape.samples > 1;
    let filtered = format(shape.format).sample_type(None, Some(features));
    let sample_type = match shape.format.kind() {
        Kind::Depth => wgpu::TextureSampleType::Depth,
        Kind::Sint => wgpu::TextureSampleType::Sint,
        Kind::Uint => wgpu::TextureSampleType::Uint,
        Kind::Float => wgpu::TextureSampleType::Float {
            filterable: !multisampled
                && filtered == Some(wgpu::TextureSampleType::Float { filterable: true }),
        },
    };
    wgpu::BindingType::Texture { sample_type, view_dimension: view_dimension(shape.dimension), multisampled }
}

/// The layout entry of a storage texture.
pub(super) fn storage(shape: &TextureShape, access: Access) -> wgpu::BindingType {
    let access = match access {
        Access::Read => wgpu::StorageTextureAccess::ReadOnly,
        Access::Write => wgpu::StorageTextureAccess::WriteOnly,
        Access::ReadWrite => wgpu::StorageTextureAccess::ReadWrite,
        Access::Atomic => wgpu::StorageTextureAccess::Atomic,
    };
    let view_dimension = view_dimension(shape.dimension);
    wgpu::BindingType::StorageTexture { access, format: format(shape.format), view_dimension }
}

/// The layout entry of a sampler.
pub(super) fn sampling(sampler: &Sampler) -> wgpu::BindingType {
    let linear = [sampler.magnify, sampler.minify, sampler.mip].contains(&Filter::Linear);
    wgpu::BindingType::Sampler(match (sampler.compare, linear) {
        (Some(_), _) => wgpu::SamplerBindingType::Comparison,
        (None, true) => wgpu::SamplerBindingType::Filtering,
        (None, false) => wgpu::SamplerBindingType::NonFiltering,
    })
}

pub(super) fn sampler(device: &wgpu::Device, sampler: &Sampler) -> wgpu::Sampler {
    let [u, v, w] = sampler.address.map(|address| match address {
        Address::ClampToEdge => wgpu::AddressMode::ClampToEdge,
        Address::Repeat => wgpu::AddressMode::Repeat,
        Address::MirrorRepeat => wgpu::AddressMode::MirrorRepeat,
    });
    let filter = |filter| match filter {
        Filter::Nearest => wgpu::FilterMode::Nearest,
        Filter::Linear => wgpu::FilterMode::Linear,
    };
    device.create_sampler(&wgpu::SamplerDescriptor {
        address_mode_u: u,
        address_mode_v: v,
        address_mode_w: w,
        mag_filter: filter(sampler.magnify),
        min_filter: filter(sampler.minify),
        mipmap_filter: match sampler.mip {
            Filter::Nearest => wgpu::MipmapFilterMode::Nearest,
            Filter::Linear => wgpu::MipmapFilterMode::Linear,
        },
        lod_min_clamp: sampler.lod[0],
        lod_max_clamp: sampler.lod[1],
        compare: sampler.compare.map(compare),
        ..Default::default()
    })
}

fn compare(compare: Compare) -> wgpu::CompareFunction {
    match compare {
        Compare::Never => wgpu::CompareFunction::Never,
        Compare::Less => wgpu::CompareFunction::Less,
        Compare::Equal => wgpu::CompareFunction::Equal,
        Compare::LessEqual => wgpu::CompareFunction::LessEqual,
        Compare::Greater => wgpu::CompareFunction::Greater,
        Compare::NotEqual => wgpu::CompareFunction::NotEqual,
        Compare::GreaterEqual => wgpu::CompareFunction::GreaterEqual,
        Compare::Always => wgpu::CompareFunction::Always,
    }
}

/// wgpu has the formats of naga by the same names.
fn format(format: Format) -> wgpu::TextureFormat {
    macro_rules! same {
        ($($name:ident)*) => {
            match format {
                $(Format::Storage(naga::StorageFormat::$name) => wgpu::TextureFormat::$name,)*
                Format::Rgba8UnormSrgb => wgpu::TextureFormat::Rgba8UnormSrgb,
                Format::Bgra8UnormSrgb => wgpu::TextureFormat::Bgra8UnormSrgb,
                Format::Depth16Unorm => wgpu::TextureFormat::Depth16Unorm,
                Format::Depth32Float => wgpu::TextureFormat::Depth32Float,
            }
        };
    }
    same! {
        R8Unorm R8Snorm R8Uint R8Sint R16Uint R16Sint R16Float Rg8Unorm Rg8Snorm Rg8Uint Rg8Sint
        R32Uint R32Sint R32Float Rg16Uint Rg16Sint Rg16Float Rgba8Unorm Rgba8Snorm Rgba8Uint Rgba8Sint
        Bgra8Unorm Rgb10a2Uint Rgb10a2Unorm Rg11b10Ufloat R64Uint Rg32Uint Rg32Sint Rg32Float
        Rgba16Uint Rgba16Sint Rgba16Float Rgba32Uint Rgba32Sint Rgba32Float R16Unorm R16Snorm Rg16Unorm
        Rg16Snorm Rgba16Unorm Rgba16Snorm
    }
}
