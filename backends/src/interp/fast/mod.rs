//! The strict executor: programs on lanes.
//!
//! - [`isa`] says which instruction sets there are and picks one; every operation is compiled once for each.
//! - [`machine`] holds the registers of one batch: an array of lanes each, or one cell where lanes agree.
//! - [`shape`] turns a function of numbers into an operation on lanes, in all forms of its operands.
//! - [`ops`] are these functions, a family a file, [`memory`] loads, stores and atomics, [`control`] jumps and
//!   masks, [`together`] textures and subgroups.
//! - [`allocate`] gives registers their slots, [`link`] makes a program into [`code`](Code): a list of function
//!   pointers with their operands.
//! - [`pages`] holds large buffers.
//! - [`cache`] keeps code; [`rows`] runs code on rows of arguments, [`dispatch`] on workgroups over buffers.
//!
//! Lanes that are not active compute nonsense that nobody reads. No operation can fail, and each address
//! is clamped where it is used, so nonsense is harmless.
#![allow(unsafe_code, reason = "steps are called by pointer")]

mod allocate;
pub(super) mod cache;
mod control;
pub(super) mod dispatch;
pub(super) mod isa;
mod link;
mod machine;
mod memory;
mod ops;
pub(super) mod pages;
pub(super) mod rows;
mod shape;
mod together;

pub use isa::Isa;

use super::error::{InterpError, Res};
use super::program::{Program, Value};
use machine::Machine;
use shape::Exec;
use std::sync::Arc;

/// Lanes of a batch: measured; smaller pays more for each operation's call, larger leaves the first cache.
pub(super) const LANES: usize = 128;

/// One step: what to do and with what.
pub(super) struct Inst<const N: usize> {
    run: Exec<N>,
    /// Slot or cell that takes the result.
    d: u32,
    /// Slots or cells of operands, as `run` expects them.
    s: [u32; 4],
    /// Numbers: sizes, offsets, where to jump.
    n: [u32; 3],
}

/// A program that is ready to run.
pub(super) struct Code<const N: usize> {
    insts: Vec<Inst<N>>,
    narrow: usize,
    wide: usize,
    /// First values of the cells: constants.
    cells: Vec<u64>,
    /// Arrays whose elements steps load and store.
    arrays: Arc<[memory::Array]>,
    /// Slot or cell of each result, and whether it is a slot.
    results: Vec<(Value, u32, bool)>,
    calls: Arc<together::Calls>,
    pub(super) program: Program,
}

/// Why a batch stopped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stop {
    /// At its end.
    Done,
    /// At the barrier before this step; `function` contains it.
    Barrier { next: usize, function: u32 },
    /// Some lanes of the batch do not reach a barrier.
    Apart { next: usize, function: u32 },
    /// In a loop of this function.
    OutOfFuel { function: u32 },
}

impl<const N: usize> Code<N> {
    /// Links `program` for `isa`. `packed`: a batch may hold several workgroups.
    pub(super) fn new(mut program: Program, packed: bool, isa: Isa) -> Res<Self> {
        let masks = super::passes::for_lanes(&mut program, packed);
        link::link(program, &masks, isa)
    }

    /// Runs a batch from step `at` until it stops.
    fn run(&self, machine: &mut Machine<N>, at: usize) -> Stop {
        machine.stop = Stop::Done;
        let mut next = Some(at);
        // Most batches have asked for all that the next one needs long before their end.
        while let Some(at) = next
            && machine.ahead.step()
        {
            next = self.step(machine, at);
        }
        while let Some(at) = next {
            next = self.step(machine, at);
        }
        machine.stop
    }

    /// Runs a step and says which one is next, if there is one.
    #[inline(always)]
    fn step(&self, machine: &mut Machine<N>, at: usize) -> Option<usize> {
        let inst = self.insts.get(at)?;
        // SAFETY: `link` made the step: its slots and cells are those of a machine of this code, no result
        // shares a slot with an operand, and the instruction set is one that `Isa` found.
        Some(unsafe { (inst.run)(machine, inst, at) })
    }

    fn name(&self, function: u32) -> String {
        self.program.functions.get(function as usize).cloned().unwrap_or_default()
    }

    /// The error that a stop means, unless it is a good one.
    fn error(&self, stop: Stop) -> Option<InterpError> {
        match stop {
            Stop::Done | Stop::Barrier { .. } => None,
            Stop::Apart { function, .. } => {
                Some(InterpError::NonUniformBarrier { function: self.name(function) })
            }
            Stop::OutOfFuel { function } => Some(InterpError::OutOfFuel { function: self.name(function) }),
        }
    }
}
