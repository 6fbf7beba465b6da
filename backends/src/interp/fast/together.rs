//! Steps that go through plain functions, lane by lane or subgroup by subgroup: textures and subgroups.
#![allow(unsafe_code, reason = "texels that other threads may use are reached by pointers")]

use super::super::program::texture::{Operands, TextureOp};
use super::super::program::{Scalar, subgroup::SubgroupOp};
use super::super::subgroup::{Brought, exchange};
use super::super::texture::{Texels, TexelsMut, perform};
use super::Inst;
use super::machine::Machine;
use super::shape::Body;
use crate::texture::TextureShape;
use std::sync::Arc;

/// Where an operand is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Operand {
    /// Its slot, or its cell if lanes agree in it.
    pub(super) place: u32,
    pub(super) varying: bool,
    pub(super) scalar: Scalar,
}

/// A texture operation with its operands.
#[derive(Debug)]
pub(super) struct TextureCall {
    pub(super) image: u32,
    pub(super) op: TextureOp,
    pub(super) operands: Operands<Operand>,
    /// Slots that take the result, and whether they are wide.
    pub(super) to: [Option<(u32, bool)>; 4],
}

/// A subgroup operation with its operands.
#[derive(Debug)]
pub(super) struct SubgroupCall {
    pub(super) op: SubgroupOp,
    pub(super) value: Operand,
    pub(super) index: Option<Operand>,
    pub(super) to: (u32, bool),
}

/// All such operations of a program.
#[derive(Debug, Default)]
pub(super) struct Calls {
    pub(super) textures: Vec<TextureCall>,
    pub(super) subgroups: Vec<SubgroupCall>,
}

/// The texels of a bound texture.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BoundImage {
    pub(super) shape: TextureShape,
    pub(super) ptr: *mut u8,
    pub(super) len: usize,
}

impl BoundImage {
    /// Whether a texel begins at a byte.
    fn holds(&self, at: usize) -> bool {
        at.checked_add(self.shape.format.bytes()).is_some_and(|end| end <= self.len)
    }
}

impl Texels for BoundImage {
    fn shape(&self) -> TextureShape {
        self.shape
    }
    fn texel(&self, at: usize) -> u128 {
        let mut bytes = [0; 16];
        if self.holds(at) {
            // SAFETY: the texel lies in the texture, which outlives the dispatch, and is at most 16 bytes.
            unsafe { self.ptr.add(at).copy_to(bytes.as_mut_ptr(), self.shape.format.bytes()) };
        }
        u128::from_le_bytes(bytes)
    }
}

impl TexelsMut for BoundImage {
    fn set_texel(&mut self, at: usize, texel: u128) {
        if self.holds(at) {
            let bytes = texel.to_le_bytes();
            // SAFETY: as above; other threads write it at the same time only if no order can show (`order`).
            unsafe { self.ptr.add(at).copy_from(bytes.as_ptr(), self.shape.format.bytes()) };
        }
    }
}

/// Texture operation `n[0]` in the lanes of mask `s[0]`.
pub(super) struct Texture;
/// Subgroup operation `n[0]` in the lanes of mask `s[0]`.
pub(super) struct Together;

impl<const N: usize> Body<N> for Texture {
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let calls = Arc::clone(&m.calls);
        let call = &calls.textures[i.n[0] as usize];
        let own = match call.op {
            TextureOp::Sample(sampling) => m.samplers.get(sampling.sampler as usize).copied(),
            _ => None,
        };
        let (mut sampler, mut image) = (own, m.images[call.image as usize]);
        for lane in 0..N {
            if m.active(i.s[0], lane) {
                let operands = call.operands.map(|operand| m.operand(operand, lane));
                // Elements of binding arrays.
                if let Some(number) = operands.texture {
                    image = m.images[number as usize];
                }
                if let Some(number) = operands.sampler {
                    sampler = m.samplers.get(number as usize).copied();
                }
                let result = perform(&mut image, sampler.as_ref(), call.op, &operands);
                for (to, bits) in call.to.iter().zip(result) {
                    to.iter().for_each(|to| m.set_result(*to, lane, bits));
                }
            }
        }
        at + 1
    }
}

impl<const N: usize> Body<N> for Together {
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let calls = Arc::clone(&m.calls);
        let call = &calls.subgroups[i.n[0] as usize];
        let size = (m.position.subgroup as usize).clamp(1, N);
        for first in (0..N).step_by(size) {
            let brought = |lane| {
                m.active(i.s[0], lane).then(|| Brought {
                    value: m.operand(call.value, lane),
                    index: call.index.map_or(0, |index| m.operand(index, lane)),
                })
            };
            let lanes: Vec<_> = (first..N.min(first + size)).map(brought).collect();
            if lanes.iter().any(Option::is_some) {
                let results = exchange(call.op, call.value.scalar, &lanes);
                for (lane, bits) in (first..).zip(results) {
                    if m.active(i.s[0], lane) {
                        m.set_result(call.to, lane, bits);
                    }
                }
            }
        }
        at + 1
    }
}
