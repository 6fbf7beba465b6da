//! The memory behind a program's variables.
#![allow(unsafe_code, reason = "buffers and textures are shared by threads")]

use super::super::super::error::Res;
use super::super::super::program::{Count, Program};
use super::super::super::resources::elements::Elements;
use super::super::super::resources::{BoundTexture, Found, FoundBuffer, FoundImage, Resources};
use super::super::machine::Bound;
use super::super::together::BoundImage;
use crate::interp::Buffer;
use crate::texture::Sampler;

/// The memory of all buffers and textures of a program; none yet behind workgroup variables.
pub(super) struct Memory {
    pub(super) buffers: Vec<Bound>,
    pub(super) images: Vec<BoundImage>,
    pub(super) samplers: Vec<Sampler>,
}

// SAFETY: the bytes outlive the dispatch; threads write them at the same time only if no order can show
// (`order`), by atomics or at places of their own.
unsafe impl Sync for Memory {}

impl Memory {
    /// Elements of an array.
    pub(super) fn length(&self, count: Count, stride: u32) -> usize {
        match count {
            Count::Fixed(count) => count as usize,
            Count::Runtime { buffer, begin } => {
                self.buffers[buffer as usize].len.saturating_sub(begin as usize) / stride.max(1) as usize
            }
        }
    }

    /// A word of a buffer, before the dispatch begins; `None` past its end.
    pub(super) fn word(&self, buffer: u32, offset: u32) -> Option<u32> {
        let Bound { ptr, len } = self.buffers[buffer as usize];
        let at = offset as usize;
        // SAFETY: the word lies in memory, which nobody writes yet.
        (at + 4 <= len).then(|| unsafe { ptr.add(at).cast::<u32>().read_unaligned() })
    }
}

/// Bytes where atomics can use them.
struct Copied {
    words: Vec<u64>,
    len: usize,
}

impl Copied {
    fn new(bytes: &[u8]) -> Self {
        let (whole, rest) = bytes.as_chunks();
        let mut last = [0; 8];
        last[..rest.len()].copy_from_slice(rest);
        let words = whole.iter().chain([&last]).map(|c| u64::from_ne_bytes(*c)).collect();
        Self { words, len: bytes.len() }
    }

    fn bound(&mut self) -> Bound {
        Bound { ptr: self.words.as_mut_ptr().cast(), len: self.len }
    }

    fn bytes(&self) -> Vec<u8> {
        self.words.iter().flat_map(|w| w.to_ne_bytes()).take(self.len).collect()
    }
}

/// The memory of one of a program's buffers.
enum Lent {
    /// A buffer where it lies.
    There(usize),
    /// A buffer that atomics could not use there.
    Moved(usize, Copied),
    /// The elements of a binding array, and whether they are written.
    Elements(Elements, Copied, bool),
    /// What is only read.
    Directory(Copied),
    /// Nothing yet.
    Own,
}

impl Lent {
    fn new(found: FoundBuffer, is_written: bool, buffers: &[Buffer]) -> Self {
        match found {
            FoundBuffer::Own => Self::Own,
            FoundBuffer::One(at) => {
                let data = &buffers[at].data;
                let is_aligned = data.as_ptr().addr().is_multiple_of(align_of::<u64>());
                if is_aligned { Self::There(at) } else { Self::Moved(at, Copied::new(data)) }
            }
            FoundBuffer::Elements(elements) => {
                let bytes = Copied::new(&elements.gather(buffers));
                Self::Elements(elements, bytes, is_written)
            }
            FoundBuffer::Directory(words) => {
                let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
                Self::Directory(Copied::new(&bytes))
            }
        }
    }

    fn bound(&mut self, buffers: &mut [Buffer]) -> Bound {
        match self {
            Self::There(at) => {
                let data = &mut buffers[*at].data;
                Bound { ptr: data.as_mut_ptr(), len: data.len() }
            }
            Self::Moved(_, bytes) | Self::Elements(_, bytes, _) | Self::Directory(bytes) => bytes.bound(),
            Self::Own => Bound { ptr: std::ptr::dangling_mut(), len: 0 },
        }
    }

    fn write_back(self, buffers: &mut [Buffer]) {
        match self {
            Self::Moved(at, bytes) => buffers[at].data.copy_from_slice(&bytes.bytes()),
            Self::Elements(elements, bytes, true) => elements.scatter(&bytes.bytes(), buffers),
            Self::There(_) | Self::Elements(_, _, false) | Self::Directory(_) | Self::Own => {}
        }
    }
}

/// Lends `body` the memory that `resources` are for `program`.
pub(super) fn bound(
    program: &Program,
    resources: &mut Resources<'_>,
    body: impl FnOnce(&Memory) -> Res<()>,
) -> Res<()> {
    let found = Found::of(program, resources)?;
    let Found { buffers, images: found, samplers } = found;
    let lent = buffers.into_iter().zip(&program.buffers);
    let mut lent: Vec<_> = lent.map(|(f, b)| Lent::new(f, b.written, resources.buffers)).collect();
    let images = images(resources.textures, &found);
    let buffers = lent.iter_mut().map(|lent| lent.bound(resources.buffers)).collect();
    let outcome = body(&Memory { buffers, images, samplers });
    lent.into_iter().for_each(|lent| lent.write_back(resources.buffers));
    outcome
}

/// The texels of textures, by index.
fn images(textures: &mut [BoundTexture], found: &[FoundImage]) -> Vec<BoundImage> {
    let image = |found: &FoundImage| {
        let texture = &mut textures[found.at].texture;
        let shape = texture.shape();
        let bytes = texture.bytes_mut();
        BoundImage { shape, ptr: bytes.as_mut_ptr(), len: bytes.len() }
    };
    found.iter().map(image).collect()
}
