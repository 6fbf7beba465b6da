//! Entry points over buffers.
//!
//! Invocations that do not depend on each other are batches of consecutive ones, whatever workgroup they are
//! in. Where a workgroup has barriers or memory of its own, its batches run in turn from barrier to barrier.
//! Batches and workgroups run on all threads as far as their order cannot show in the buffers, the rest one after
//! the other.
#![allow(unsafe_code, reason = "buffers are shared by threads")]

mod order;

use super::super::dispatch::Buffer;
use super::super::error::{InterpError, Res};
use super::super::program::{Count, Program};
use super::machine::{Bound, Machine, Position};
use super::{Code, LANES, Stop};
use rayon::prelude::*;
use std::ops::Range;

/// A dispatch of linked code.
pub(in super::super) struct Dispatch<'c> {
    pub(in super::super) code: &'c Code<LANES>,
    pub(in super::super) size: [u32; 3],
    pub(in super::super) groups: [u32; 3],
    pub(in super::super) fuel: u64,
}

/// The memory of all buffers of a program; none yet behind workgroup variables.
struct Memory(Vec<Bound>);

// SAFETY: the bytes outlive the dispatch; threads write them at the same time only if no order can show
// (`order`), by atomics or at places of their own.
unsafe impl Sync for Memory {}

impl Memory {
    /// Length of the shortest of these arrays.
    fn shortest(&self, arrays: &[order::Elements]) -> usize {
        let length = |array: &order::Elements| match array.count {
            Count::Fixed(count) => count as usize,
            Count::Runtime { buffer, begin } => {
                self.0[buffer as usize].len.saturating_sub(begin as usize) / array.stride.max(1) as usize
            }
        };
        arrays.iter().map(length).min().unwrap_or(usize::MAX)
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

impl Dispatch<'_> {
    /// Runs all workgroups.
    pub(in super::super) fn run(&self, buffers: &mut [Buffer]) -> Res<()> {
        let program = &self.code.program;
        let mut aligned = bind(program, buffers)?;
        let bound = |a: &mut Option<Aligned>| match a {
            Some(a) => a.bound(buffers),
            None => Bound { ptr: std::ptr::dangling_mut(), len: 0 },
        };
        let memory = Memory(aligned.iter_mut().map(bound).collect());
        let outcome = self.everything(&memory);
        aligned.into_iter().flatten().for_each(|a| a.write_back(buffers));
        outcome
    }

    fn everything(&self, memory: &Memory) -> Res<()> {
        let workgroups = self.groups.iter().map(|n| *n as usize).product::<usize>();
        let cooperative = self.code.program.cooperative;
        let (total, step) = if cooperative { (workgroups, 1) } else { (workgroups * self.volume(), LANES) };
        let line = self.groups[1..] == [1, 1] && self.size[1..] == [1, 1];
        let run = |range: Range<usize>| {
            if cooperative { self.workgroups(memory, range) } else { self.batches(memory, range) }
        };
        let free = order::free(&self.code.program, line).map_or(0, |arrays| memory.shortest(&arrays));
        let free = total.min(if cooperative { free / self.volume().max(1) } else { free });
        let share = free.div_ceil(rayon::current_num_threads() * 4).next_multiple_of(step).max(step);
        let chunks: Vec<_> = (0..free).step_by(share).map(|at| at..free.min(at + share)).collect();
        chunks.into_par_iter().map(run).collect::<Res<()>>()?;
        run(free..total)
    }

    /// Invocations of a workgroup.
    fn volume(&self) -> usize {
        self.size.iter().map(|n| *n as usize).product()
    }

    fn machine(&self, memory: &Memory) -> Machine<LANES> {
        let mut machine = Machine::new(self.code, self.fuel);
        machine.buffers.clone_from(&memory.0);
        machine
    }

    fn position(&self, first: usize, live: usize) -> Position {
        Position { first, live, size: self.size, groups: self.groups }
    }

    /// Independent invocations.
    fn batches(&self, memory: &Memory, range: Range<usize>) -> Res<()> {
        let mut machine = self.machine(memory);
        for first in range.clone().step_by(LANES) {
            machine.fuel = self.fuel;
            machine.place(self.position(first, LANES.min(range.end - first)));
            let stop = self.code.run(&mut machine, 0);
            self.code.error(stop).map_or(Ok(()), Err)?;
        }
        Ok(())
    }

    /// Workgroups whose invocations wait for each other.
    fn workgroups(&self, memory: &Memory, range: Range<usize>) -> Res<()> {
        let volume = self.volume();
        let mut own: Vec<(usize, Vec<u64>)> = self.own_memory();
        let mut machines: Vec<_> = (0..volume.div_ceil(LANES)).map(|_| self.machine(memory)).collect();
        for workgroup in range {
            for (buffer, words) in &mut own {
                words.fill(0);
                let bound = Bound { ptr: words.as_mut_ptr().cast(), len: words.len() * 8 };
                machines.iter_mut().for_each(|m| m.buffers[*buffer] = bound);
            }
            for (at, machine) in machines.iter_mut().enumerate() {
                let first = at * LANES;
                machine.fuel = self.fuel;
                machine.place(self.position(workgroup * volume + first, LANES.min(volume - first)));
            }
            self.together(&mut machines)?;
        }
        Ok(())
    }

    /// Zeros for the workgroup variables.
    fn own_memory(&self) -> Vec<(usize, Vec<u64>)> {
        let buffers = self.code.program.buffers.iter().enumerate();
        let own = buffers.filter(|(_, b)| b.binding.is_none());
        own.map(|(at, b)| (at, vec![0; b.bytes.div_ceil(8) as usize])).collect()
    }

    /// Runs the batches of a workgroup from barrier to barrier.
    fn together(&self, machines: &mut [Machine<LANES>]) -> Res<()> {
        let mut at = 0;
        loop {
            let mut stops = machines.iter_mut().map(|m| self.code.run(m, at)).collect::<Vec<_>>().into_iter();
            let Some(first) = stops.next() else {
                return Ok(());
            };
            for stop in std::iter::once(first).chain(stops) {
                self.code.error(stop).map_or(Ok(()), Err)?;
                if stop != first {
                    let function = [stop, first].into_iter().find_map(|s| match s {
                        Stop::Barrier { function, .. } => Some(function),
                        Stop::Done | Stop::Apart { .. } | Stop::OutOfFuel { .. } => None,
                    });
                    let stop = Stop::Apart { next: 0, function: function.unwrap_or(0) };
                    return self.code.error(stop).map_or(Ok(()), Err);
                }
            }
            match first {
                Stop::Barrier { next, .. } => at = next,
                Stop::Done | Stop::Apart { .. } | Stop::OutOfFuel { .. } => return Ok(()),
            }
        }
    }
}

/// The buffer of each resource of the program.
fn bind(program: &Program, buffers: &[Buffer]) -> Res<Vec<Option<Aligned>>> {
    let find = |wanted: &super::super::program::Buffer| {
        let Some((group, binding)) = wanted.binding else {
            return Ok(None);
        };
        let name = || wanted.name.clone();
        let index = buffers
            .iter()
            .position(|b| (b.group, b.binding) == (group, binding))
            .ok_or_else(|| InterpError::MissingBuffer { name: name(), group, binding })?;
        let (expected, found) = (wanted.bytes as usize, buffers[index].data.len());
        if found < expected {
            return Err(InterpError::BufferTooSmall { name: name(), expected, found });
        }
        Ok(Some(Aligned::new(index, &buffers[index])))
    };
    program.buffers.iter().map(find).collect()
}
