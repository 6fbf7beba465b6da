//! The memory behind a program's variables.
#![allow(unsafe_code, reason = "buffers and textures are shared by threads")]

use super::super::super::error::Res;
use super::super::super::program::{Count, Program};
use super::super::super::resources::{BoundTexture, Found, Resources};
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

/// The bytes of a buffer where atomics can use them.
struct Aligned {
    index: usize,
    words: Option<Vec<u64>>,
}

impl Aligned {
    fn new(index: usize, buffer: &Buffer) -> Self {
        let aligned = buffer.data.as_ptr().addr().is_multiple_of(align_of::<u64>());
        let words = (!aligned).then(|| {
            let mut padded = buffer.data.clone();
            padded.resize(buffer.data.len().next_multiple_of(8), 0);
            padded.as_chunks().0.iter().map(|c| u64::from_ne_bytes(*c)).collect()
        });
        Self { index, words }
    }

    fn bound(&mut self, buffers: &mut [Buffer]) -> Bound {
        let data = &mut buffers[self.index].data;
        let ptr = self.words.as_mut().map_or(data.as_mut_ptr(), |w| w.as_mut_ptr().cast());
        Bound { ptr, len: data.len() }
    }

    fn write_back(self, buffers: &mut [Buffer]) {
        if let Some(words) = self.words {
            let bytes = words.iter().flat_map(|w| w.to_ne_bytes());
            buffers[self.index].data.iter_mut().zip(bytes).for_each(|(to, byte)| *to = byte);
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
    let aligned = |at: &Option<usize>| at.map(|at| Aligned::new(at, &resources.buffers[at]));
    let mut aligned: Vec<_> = found.buffers.iter().map(aligned).collect();
    let images = images(resources.textures, &found.images);
    let bound = |a: &mut Option<Aligned>| match a {
        Some(a) => a.bound(resources.buffers),
        None => Bound { ptr: std::ptr::dangling_mut(), len: 0 },
    };
    let outcome =
        body(&Memory { buffers: aligned.iter_mut().map(bound).collect(), images, samplers: found.samplers });
    aligned.into_iter().flatten().for_each(|a| a.write_back(resources.buffers));
    outcome
}

/// The texels of textures, by index.
fn images(textures: &mut [BoundTexture], found: &[usize]) -> Vec<BoundImage> {
    let image = |at: &usize| {
        let texture = &mut textures[*at].texture;
        let shape = texture.shape();
        let bytes = texture.bytes_mut();
        BoundImage { shape, ptr: bytes.as_mut_ptr(), len: bytes.len() }
    };
    found.iter().map(image).collect()
}
