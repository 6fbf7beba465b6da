//! The registers of one batch.
#![allow(unsafe_code, reason = "slots are reached by pointers, so that results and operands are known apart")]

use super::super::program::Program;
use super::memory::{self, Ahead, Array};
use super::together::{BoundImage, Calls, Operand};
use super::{Code, Stop};
use crate::texture::Sampler;
use std::sync::Arc;

/// The lanes of a slot, where vector loads like them.
#[derive(Clone, Copy)]
#[repr(C, align(64))]
struct Slot<T: Copy, const N: usize>([T; N]);

/// Memory that lanes share: bytes of a buffer or of a workgroup variable.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bound {
    pub(super) ptr: *mut u8,
    pub(super) len: usize,
}

/// Where a batch lies among the invocations.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Position {
    /// Rows: the first row. Workgroups: the first invocation, counted workgroup after workgroup.
    pub(super) first: usize,
    /// Lanes that exist.
    pub(super) live: usize,
    /// Whether invocations are numbered along one axis.
    pub(super) line: bool,
    /// Size of a workgroup and number of workgroups.
    pub(super) size: [u32; 3],
    pub(super) groups: [u32; 3],
    /// Lanes of a subgroup: a power of two, at most a batch.
    pub(super) subgroup: u32,
}

/// A batch on its way through code.
pub(crate) struct Machine<const N: usize> {
    narrow: Vec<Slot<u32, N>>,
    wide: Vec<Slot<u64, N>>,
    cells: Vec<u64>,
    pub(super) buffers: Vec<Bound>,
    pub(super) images: Vec<BoundImage>,
    pub(super) samplers: Vec<Sampler>,
    pub(super) calls: Arc<Calls>,
    pub(super) arrays: Arc<[Array]>,
    /// What the next batch needs, asked for while this one runs.
    pub(super) ahead: Ahead,
    pub(super) columns: Vec<*const u32>,
    pub(super) position: Position,
    /// Rounds of loops left.
    pub(super) fuel: u64,
    pub(super) stop: Stop,
}

impl<const N: usize> Machine<N> {
    pub(super) fn new(code: &Code<N>, fuel: u64) -> Self {
        Self {
            narrow: vec![Slot([0; N]); code.narrow],
            wide: vec![Slot([0; N]); code.wide],
            cells: code.cells.clone(),
            buffers: Vec::new(),
            images: Vec::new(),
            samplers: Vec::new(),
            calls: Arc::clone(&code.calls),
            arrays: code.arrays.clone(),
            ahead: Ahead::NOTHING,
            columns: Vec::new(),
            position: Position::default(),
            fuel,
            stop: Stop::Done,
        }
    }

    /// Places the batch and makes its lanes active.
    pub(super) fn place(&mut self, position: Position) {
        let same = self.position.live == position.live;
        self.position = position;
        self.ahead = memory::ahead(self);
        if same {
            return;
        }
        for (lane, mask) in self.narrow[0].0.iter_mut().enumerate() {
            *mask = if lane < position.live { u32::MAX } else { 0 };
        }
    }

    /// Where the slots begin.
    #[inline(always)]
    pub(super) fn narrow(&mut self) -> *mut [u32; N] {
        self.narrow.as_mut_ptr().cast()
    }

    #[inline(always)]
    pub(super) fn wide(&mut self) -> *mut [u64; N] {
        self.wide.as_mut_ptr().cast()
    }

    #[inline(always)]
    pub(super) fn cells(&mut self) -> *mut u64 {
        self.cells.as_mut_ptr()
    }

    /// Whether a lane is on in a mask.
    pub(super) fn active(&self, mask: u32, lane: usize) -> bool {
        self.narrow[mask as usize].0[lane] != 0
    }

    /// The bits of an operand in a lane; a signed integer fills all 64.
    pub(super) fn operand(&self, operand: Operand, lane: usize) -> u64 {
        let place = operand.place as usize;
        let bits = match (operand.varying, operand.scalar.wide()) {
            (false, _) => self.cells[place],
            (true, true) => self.wide[place].0[lane],
            (true, false) => self.narrow[place].0[lane].into(),
        };
        let narrow = operand.scalar.signed() && !operand.scalar.wide();
        if narrow { i64::from(bits as u32 as i32) as u64 } else { bits }
    }

    /// Sets a lane of a slot, which is wide or not.
    pub(super) fn set_result(&mut self, (slot, wide): (u32, bool), lane: usize, bits: u64) {
        if wide {
            self.wide[slot as usize].0[lane] = bits;
        } else {
            self.narrow[slot as usize].0[lane] = bits as u32;
        }
    }

    /// The bits of a result in the first lanes; a boolean is 0 or 1 outside.
    pub(super) fn read(&self, place: u32, varying: bool, boolean: bool, to: &mut [u32]) {
        if varying {
            to.copy_from_slice(&self.narrow[place as usize].0[..to.len()]);
        } else {
            to.fill(self.cells[place as usize] as u32);
        }
        if boolean {
            to.iter_mut().for_each(|word| *word &= 1);
        }
    }
}

/// First values of the cells: each constant's bits, then nothing.
pub(super) fn cells(program: &Program) -> Vec<u64> {
    program.constants.iter().map(|c| c.bits).collect()
}

/// What a lane can hold.
///
/// # Safety
/// `slots` and `cell` must lead to memory of this type's size.
pub(crate) unsafe trait Lane: Copy + 'static {
    fn slots<const N: usize>(machine: &mut Machine<N>) -> *mut [Self; N];
    fn from_cell(cell: u64) -> Self;
    fn to_cell(self) -> u64;
}

macro_rules! lanes {
    ($($ty:ident $file:ident |$cell:ident| $from:expr, |$value:ident| $to:expr;)*) => {
        $(
            // SAFETY: the file's slots have as many bytes a lane as the type, and any bits are a value.
            unsafe impl Lane for $ty {
                #[inline(always)]
                fn slots<const N: usize>(machine: &mut Machine<N>) -> *mut [Self; N] {
                    machine.$file().cast()
                }
                #[inline(always)]
                fn from_cell($cell: u64) -> Self {
                    $from
                }
                #[inline(always)]
                fn to_cell(self) -> u64 {
                    let $value = self;
                    $to
                }
            }
        )*
    };
}

lanes! {
    u32 narrow |cell| cell as u32, |value| value.into();
    i32 narrow |cell| cell as u32 as i32, |value| (value as u32).into();
    f32 narrow |cell| f32::from_bits(cell as u32), |value| value.to_bits().into();
    u64 wide |cell| cell, |value| value;
    i64 wide |cell| cell as i64, |value| value as u64;
    f64 wide |cell| f64::from_bits(cell), |value| value.to_bits();
}
