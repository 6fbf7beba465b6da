//! What a resource holds, for every executor.

use super::resource;
use super::shape::Shape;
use lobe_backends::gpu::{Access, Binding, BindingKind};
use lobe_backends::interp::{BoundSampler, BoundTexture, Buffer, IMMEDIATES, Resources};
use lobe_backends::texture::{Format, Texture, TextureError};

/// A resource with its bytes.
#[derive(Debug, Clone)]
pub struct Given {
    /// The resource's name.
    pub name: String,
    /// Bind group.
    pub group: u32,
    /// Binding within the group.
    pub binding: u32,
    /// Which element of a binding array it is.
    pub element: Option<u32>,
    /// What the shader does with it.
    pub kind: BindingKind,
    /// Its bytes or texels; none of a sampler.
    pub data: Vec<u8>,
    /// The scalars in them.
    pub shape: Shape,
    /// Whether the scalars are codes of numbers, as texels have them, which executors may round either way.
    pub is_coded: bool,
}

impl Given {
    /// Whether a user means it by `name`, which may be its place.
    #[must_use]
    pub fn is_called(&self, name: &str) -> bool {
        resource::is_called(name, &self.name, (self.group, self.binding), self.element)
    }

    /// What a report calls it.
    #[must_use]
    pub fn title(&self) -> String {
        resource::spelt(self.name.clone(), self.element)
    }

    /// Whether it is the module's immediates.
    #[must_use]
    pub fn is_immediate(&self) -> bool {
        (self.group, self.binding) == IMMEDIATES
    }

    /// Whether it is a buffer.
    #[must_use]
    pub fn is_buffer(&self) -> bool {
        match self.kind {
            BindingKind::Uniform | BindingKind::StorageRead | BindingKind::StorageReadWrite => true,
            BindingKind::Texture(_) | BindingKind::StorageTexture(..) | BindingKind::Sampler(_) => false,
        }
    }

    /// The format of its texels, if it is a texture.
    #[must_use]
    pub fn format(&self) -> Option<Format> {
        match self.kind {
            BindingKind::Texture(shape) | BindingKind::StorageTexture(shape, _) => Some(shape.format),
            BindingKind::Uniform
            | BindingKind::StorageRead
            | BindingKind::StorageReadWrite
            | BindingKind::Sampler(_) => None,
        }
    }

    /// Whether the shader may write it.
    #[must_use]
    pub fn is_written(&self) -> bool {
        match self.kind {
            BindingKind::StorageReadWrite => true,
            BindingKind::StorageTexture(_, access) => access != Access::Read,
            BindingKind::Uniform
            | BindingKind::StorageRead
            | BindingKind::Texture(_)
            | BindingKind::Sampler(_) => false,
        }
    }

    /// The same for a driver.
    #[must_use]
    pub fn lend(&self) -> Binding<'_> {
        let Self { group, binding, element, kind, ref data, .. } = *self;
        Binding { group, binding, element, kind, data }
    }
}

/// Resources for the interpreter, which updates them in place.
#[derive(Debug, Default)]
pub struct Owned {
    /// Buffers.
    pub buffers: Vec<Buffer>,
    textures: Vec<BoundTexture>,
    samplers: Vec<BoundSampler>,
}

impl Owned {
    /// Copies of what is given.
    ///
    /// # Errors
    /// When there is no such texture.
    pub fn of(given: &[Given]) -> Result<Self, TextureError> {
        let mut owned = Self::default();
        for &Given { group, binding, kind, ref data, .. } in given {
            match kind {
                BindingKind::Texture(shape) | BindingKind::StorageTexture(shape, _) => {
                    let texture = Texture::new(shape, data.clone())?;
                    owned.textures.push(BoundTexture { group, binding, texture });
                }
                BindingKind::Sampler(sampler) => {
                    owned.samplers.push(BoundSampler { group, binding, sampler });
                }
                BindingKind::Uniform | BindingKind::StorageRead | BindingKind::StorageReadWrite => {
                    owned.buffers.push(Buffer::copied(group, binding, data));
                }
            }
        }
        Ok(owned)
    }

    /// All of them, to run with.
    pub fn lend(&mut self) -> Resources<'_> {
        Resources { buffers: &mut self.buffers, textures: &mut self.textures, samplers: &self.samplers }
    }

    /// What now lies at the place of `given`.
    #[must_use]
    pub fn bytes(&self, given: &Given) -> &[u8] {
        let place = (given.group, given.binding);
        let element = given.element.unwrap_or(0) as usize;
        let mut buffers = self.buffers.iter().filter(|b| (b.group, b.binding) == place);
        let mut textures = self.textures.iter().filter(|t| (t.group, t.binding) == place);
        let buffer = buffers.nth(element).map(|b| b.data.as_slice());
        buffer.or_else(|| textures.nth(element).map(|t| t.texture.bytes())).unwrap_or_default()
    }
}
