//! Entry points over buffers.
//!
//! Invocations that do not depend on each other are batches of consecutive ones, whatever workgroup they are
//! in. Where a workgroup has barriers or memory of its own, its batches run in turn from barrier to barrier.
//! Batches and workgroups run on all threads as far as their order cannot show in the buffers, the rest one after
//! the other.

mod bind;
mod order;
mod own;

use super::super::error::Res;
use super::super::resources::Resources;
use super::machine::{Bound, Machine, Position};
use super::memory::settle;
use super::{Code, LANES, Stop};
use bind::Memory;
use rayon::prelude::*;
use std::ops::Range;

/// A dispatch of linked code.
pub(in super::super) struct Dispatch<'c> {
    pub(in super::super) code: &'c Code<LANES>,
    pub(in super::super) size: [u32; 3],
    pub(in super::super) groups: [u32; 3],
    pub(in super::super) fuel: u64,
    pub(in super::super) subgroup: u32,
}

impl Dispatch<'_> {
    /// Runs all workgroups.
    pub(in super::super) fn run(&self, mut resources: Resources<'_>) -> Res<()> {
        bind::bound(&self.code.program, &mut resources, |memory| self.everything(memory))
    }

    fn everything(&self, memory: &Memory) -> Res<()> {
        let workgroups = self.groups.iter().map(|n| *n as usize).product::<usize>();
        let cooperative = self.code.program.cooperative;
        let (total, step) = if cooperative { (workgroups, 1) } else { (workgroups * self.volume(), LANES) };
        let run = |range: Range<usize>| {
            let outcome =
                if cooperative { self.workgroups(memory, range) } else { self.batches(memory, range) };
            settle();
            outcome
        };
        let launch = own::Launch { groups: self.groups, size: self.size, memory };
        let free = order::free(&self.code.program, &launch);
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

    /// Whether invocations are numbered along one axis.
    fn line(&self) -> bool {
        self.groups[1..] == [1, 1] && self.size[1..] == [1, 1]
    }

    fn machine(&self, memory: &Memory) -> Machine<LANES> {
        let mut machine = Machine::new(self.code, self.fuel);
        machine.buffers.clone_from(&memory.buffers);
        machine.images.clone_from(&memory.images);
        machine.samplers.clone_from(&memory.samplers);
        machine
    }

    fn position(&self, first: usize, live: usize) -> Position {
        Position {
            first,
            live,
            line: self.line(),
            size: self.size,
            groups: self.groups,
            subgroup: self.subgroup,
        }
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
