//! Buffers, textures and samplers for a module's variables.

use crate::options::{Fill, Options};
use lobe_backends::gpu::{Access, Binding, BindingKind};
use lobe_backends::interp::{BoundSampler, BoundTexture, Buffer, Resources};
use lobe_backends::texture::{Dimension, Format, Texture, TextureShape};
use naga::{AddressSpace, ImageClass, ImageDimension, Module, ScalarKind, StorageAccess, TypeInner};

/// What one variable is given.
pub(crate) struct Given {
    pub(crate) name: String,
    pub(crate) group: u32,
    pub(crate) binding: u32,
    pub(crate) kind: BindingKind,
    pub(crate) data: Vec<u8>,
}

impl Given {
    /// Whether the shader may write it.
    pub(crate) fn written(&self) -> bool {
        match self.kind {
            BindingKind::StorageReadWrite => true,
            BindingKind::StorageTexture(_, access) => access != Access::Read,
            BindingKind::Uniform
            | BindingKind::StorageRead
            | BindingKind::Texture(_)
            | BindingKind::Sampler(_) => false,
        }
    }

    pub(crate) fn lend(&self) -> Binding<'_> {
        Binding { group: self.group, binding: self.binding, kind: self.kind, data: &self.data }
    }
}

/// A sequence of numbers by chance, the same for a seed.
struct Chance(u64);

impl Chance {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// From -1 to 1.
    fn float(&mut self) -> f64 {
        (self.bits() >> 40) as f64 / f64::from(1 << 23) - 1.0
    }
}

/// What each variable with a binding is given.
pub(crate) fn given(module: &Module, options: &Options) -> Result<Vec<Given>, String> {
    let mut out = Vec::new();
    for (_, variable) in module.global_variables.iter() {
        let Some(place) = &variable.binding else {
            continue;
        };
        let name = variable.name.clone().unwrap_or_default();
        let fill = options.inputs.get(&name).copied().unwrap_or(Fill::Random(0));
        let (kind, data) = match module.types[variable.ty].inner {
            TypeInner::Image { dim, arrayed, class } => {
                let sketch = options.textures.get(&name).ok_or_else(|| format!("no --texture for {name}"))?;
                let shape = sketch.shape(dimension(dim, arrayed));
                (image(class, shape), texels(shape, class, fill))
            }
            TypeInner::Sampler { .. } => {
                let sampler =
                    options.samplers.get(&name).ok_or_else(|| format!("no --sampler for {name}"))?;
                (BindingKind::Sampler(*sampler), Vec::new())
            }
            ref inner => {
                let least = inner.try_size(module.to_ctx()).ok_or("a size that overflows")? as usize;
                let size = options.sizes.get(&name).copied().unwrap_or(least).next_multiple_of(4);
                let mut data = vec![0; size];
                if let Fill::Random(seed) = fill {
                    numbers(module, variable.ty, 0, &mut data, &mut Chance(seed));
                }
                let kind = match variable.space {
                    AddressSpace::Uniform => BindingKind::Uniform,
                    AddressSpace::Storage { access } if access.contains(StorageAccess::STORE) => {
                        BindingKind::StorageReadWrite
                    }
                    _ => BindingKind::StorageRead,
                };
                (kind, data)
            }
        };
        out.push(Given { name, group: place.group, binding: place.binding, kind, data });
    }
    Ok(out)
}

fn dimension(dim: ImageDimension, arrayed: bool) -> Dimension {
    match (dim, arrayed) {
        (ImageDimension::D1, _) => Dimension::D1,
        (ImageDimension::D2, false) => Dimension::D2,
        (ImageDimension::D2, true) => Dimension::D2Array,
        (ImageDimension::D3, _) => Dimension::D3,
        (ImageDimension::Cube, false) => Dimension::Cube,
        (ImageDimension::Cube, true) => Dimension::CubeArray,
    }
}

fn image(class: ImageClass, shape: TextureShape) -> BindingKind {
    match class {
        ImageClass::Storage { access, .. } => {
            let (load, store) = (access.contains(StorageAccess::LOAD), access.contains(StorageAccess::STORE));
            let access = match (load, store) {
                _ if access.contains(StorageAccess::ATOMIC) => Access::Atomic,
                (true, true) => Access::ReadWrite,
                (false, true) => Access::Write,
                (_, false) => Access::Read,
            };
            BindingKind::StorageTexture(shape, access)
        }
        ImageClass::Sampled { multi, .. } | ImageClass::Depth { multi } => {
            BindingKind::Texture(TextureShape { samples: if multi { 4 } else { 1 }, ..shape })
        }
        ImageClass::External => BindingKind::Texture(shape),
    }
}

/// Texels by chance: any codes, but of floats numbers from -1 to 1.
fn texels(shape: TextureShape, class: ImageClass, fill: Fill) -> Vec<u8> {
    let multi = matches!(class, ImageClass::Sampled { multi: true, .. } | ImageClass::Depth { multi: true });
    let shape = TextureShape { samples: if multi { 4 } else { 1 }, ..shape };
    let mut chance = match fill {
        // What is multisampled can only begin as zeros.
        Fill::Random(seed) if !multi => Chance(seed),
        Fill::Random(_) | Fill::Zeros => return vec![0; shape.bytes()],
    };
    let size = shape.format.bytes();
    let floats = shape.format.to_string().ends_with("float");
    let mut texel = || {
        if shape.format == Format::Depth32Float {
            return u128::from((chance.float().abs() as f32).to_bits());
        }
        if floats {
            return shape.format.encode([(); 4].map(|()| (chance.float() as f32).to_bits().into()));
        }
        u128::from(chance.bits()) << 64 | u128::from(chance.bits())
    };
    (0..shape.bytes() / size).flat_map(|_| texel().to_le_bytes().into_iter().take(size)).collect()
}

/// Numbers by chance for all scalars of a type: floats from -1 to 1, integers from 0 to 63 or -32 to 31; atomics are 0.
fn numbers(module: &Module, ty: naga::Handle<naga::Type>, at: usize, data: &mut [u8], chance: &mut Chance) {
    match module.types[ty].inner {
        TypeInner::Scalar(scalar) => number(scalar, at, data, chance),
        TypeInner::Vector { size, scalar } => {
            (0..size as usize).for_each(|i| number(scalar, at + i * usize::from(scalar.width), data, chance));
        }
        TypeInner::Matrix { columns, rows, scalar } => {
            let stride = if rows == naga::VectorSize::Bi { 2 } else { 4 } * usize::from(scalar.width);
            for column in 0..columns as usize {
                for row in 0..rows as usize {
                    number(scalar, at + column * stride + row * usize::from(scalar.width), data, chance);
                }
            }
        }
        TypeInner::Array { base, size, stride } => {
            let count = match size {
                naga::ArraySize::Constant(count) => count.get() as usize,
                _ => data.len().saturating_sub(at) / stride as usize,
            };
            (0..count).for_each(|i| numbers(module, base, at + i * stride as usize, data, chance));
        }
        TypeInner::Struct { ref members, .. } => {
            members.iter().for_each(|m| numbers(module, m.ty, at + m.offset as usize, data, chance));
        }
        _ => {}
    }
}

fn number(scalar: naga::Scalar, at: usize, data: &mut [u8], chance: &mut Chance) {
    let bytes = match (scalar.kind, scalar.width) {
        (ScalarKind::Float, 8) => chance.float().to_le_bytes().to_vec(),
        (ScalarKind::Float, 2) => half::f16::from_f64(chance.float()).to_le_bytes().to_vec(),
        (ScalarKind::Float, _) => (chance.float() as f32).to_le_bytes().to_vec(),
        (ScalarKind::Sint, width) => (chance.bits() as i64 % 32).to_le_bytes()[..usize::from(width)].to_vec(),
        (_, width) => (chance.bits() % 64).to_le_bytes()[..usize::from(width)].to_vec(),
    };
    if let Some(to) = data.get_mut(at..at + bytes.len()) {
        to.copy_from_slice(&bytes);
    }
}

/// The same for the interpreter.
pub(crate) struct Owned {
    buffers: Vec<Buffer>,
    textures: Vec<BoundTexture>,
    samplers: Vec<BoundSampler>,
}

impl Owned {
    pub(crate) fn of(given: &[Given]) -> Result<Self, String> {
        let mut owned = Self { buffers: Vec::new(), textures: Vec::new(), samplers: Vec::new() };
        for &Given { group, binding, kind, ref data, .. } in given {
            match kind {
                BindingKind::Texture(shape) | BindingKind::StorageTexture(shape, _) => {
                    let texture = Texture::new(shape, data.clone()).map_err(|error| error.to_string())?;
                    owned.textures.push(BoundTexture { group, binding, texture });
                }
                BindingKind::Sampler(sampler) => {
                    owned.samplers.push(BoundSampler { group, binding, sampler })
                }
                BindingKind::Uniform | BindingKind::StorageRead | BindingKind::StorageReadWrite => {
                    owned.buffers.push(Buffer { group, binding, data: data.clone() });
                }
            }
        }
        Ok(owned)
    }

    pub(crate) fn lend(&mut self) -> Resources<'_> {
        Resources { buffers: &mut self.buffers, textures: &mut self.textures, samplers: &self.samplers }
    }

    /// What a variable holds.
    pub(crate) fn bytes(&self, given: &Given) -> &[u8] {
        let place = (given.group, given.binding);
        let buffer = self.buffers.iter().find(|b| (b.group, b.binding) == place).map(|b| b.data.as_slice());
        let texture =
            || self.textures.iter().find(|t| (t.group, t.binding) == place).map(|t| t.texture.bytes());
        buffer.or_else(texture).unwrap_or_default()
    }
}
