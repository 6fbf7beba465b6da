//! Entry points over buffers.
//!
//! The invocations of a workgroup are the lanes of one batch, so a barrier needs nothing but all of them;
//! workgroups run one after the other.

use super::super::buffer::Buffer;
use super::super::error::InterpError;
use super::super::model::Model;
use super::super::shadow::Shadow;
use super::super::{ShadowBuffer, ShadowWord};
use super::atomic::Order;
use super::input::Inputs;
use super::memory::{Cell, Shared};
use super::{Code, Machine, Res};

/// A dispatch of a program.
pub(in super::super) struct Dispatch<'a> {
    pub(in super::super) code: &'a Code,
    pub(in super::super) size: [u32; 3],
    pub(in super::super) groups: [u32; 3],
    pub(in super::super) fuel: u64,
    /// Invocations of a subgroup.
    pub(in super::super) subgroup: u32,
}

impl Dispatch<'_> {
    /// Runs all workgroups; storage buffers are updated in place.
    pub(in super::super) fn run<M: Model>(
        &self,
        buffers: &mut [Buffer],
        model: impl Fn(usize) -> M,
    ) -> Res<()> {
        let bound = self.bind(buffers)?;
        let (m, memory) = self.everything(&bound, buffers, model, |_, _, _| {})?;
        for (index, shared) in bound.iter().zip(&memory) {
            let Some(index) = index else { continue };
            for (chunk, cell) in buffers[*index].data.chunks_exact_mut(4).zip(&shared.cells) {
                let word = match cell {
                    Cell::Bits(bits) => *bits,
                    Cell::Float(a) => m.value(*a).to_bits(),
                    Cell::Word(a) => m.word_value(*a) as u32,
                };
                chunk.copy_from_slice(&word.to_le_bytes());
            }
        }
        Ok(())
    }

    /// The words that the program may write, with their bounds.
    pub(in super::super) fn shadow(&self, buffers: &[Buffer]) -> Res<Vec<ShadowBuffer>> {
        let bound = self.bind(buffers)?;
        let (m, memory) = self.everything(&bound, buffers, |_| Shadow::default(), detach)?;
        let program = &self.code.program;
        let written = program.buffers.iter().zip(&memory).filter(|(b, _)| b.written);
        Ok(written
            .filter_map(|(buffer, shared)| {
                let (group, binding) = buffer.binding?;
                let words = (0..shared.cells.len()).map(|at| told(&m, shared.get(&m, at))).collect();
                Some(ShadowBuffer { group, binding, words })
            })
            .collect())
    }

    /// The buffer of each resource of the program; none of workgroup memory.
    fn bind(&self, buffers: &[Buffer]) -> Res<Vec<Option<usize>>> {
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
            Ok(Some(index))
        };
        self.code.program.buffers.iter().map(find).collect()
    }

    /// Runs all workgroups, each with a model of its own; `after` sees each one's memory once it is done.
    fn everything<M: Model>(
        &self,
        bound: &[Option<usize>],
        buffers: &[Buffer],
        model: impl Fn(usize) -> M,
        after: impl Fn(&M, &mut [Shared<M>], &Order),
    ) -> Res<(M, Vec<Shared<M>>)> {
        let mut memory = bound.iter().map(|b| found(b.map(|at| &buffers[at].data[..]))).collect();
        let mut order = Order::new(M::SHADOW);
        let mut last = model(0);
        for (index, group) in self.each_group().enumerate() {
            let lanes = self.size.iter().map(|n| *n as usize).product();
            let (groups, size, subgroup) = (self.groups, self.size, self.subgroup.max(1));
            let inputs = Inputs::Group { group, groups, size, subgroup };
            let mut machine = Machine::new(self.code, model(index), inputs, lanes, self.fuel);
            (machine.shared, machine.order) = (memory, order);
            self.clear_own(&mut machine.shared);
            machine.run()?;
            (memory, order, last) = (machine.shared, machine.order, machine.model);
            after(&last, &mut memory, &order);
            order.leave_group(|buffer| self.code.program.buffers[buffer as usize].binding.is_none());
        }
        Ok((last, memory))
    }

    fn each_group(&self) -> impl Iterator<Item = [u32; 3]> + use<> {
        let [w, h, d] = self.groups;
        (0..d).flat_map(move |z| (0..h).flat_map(move |y| (0..w).map(move |x| [x, y, z])))
    }

    /// Workgroup variables are zero.
    fn clear_own<M: Model>(&self, memory: &mut [Shared<M>]) {
        for (buffer, shared) in self.code.program.buffers.iter().zip(memory) {
            if buffer.binding.is_none() {
                let words = buffer.bytes.div_ceil(4) as usize;
                *shared = Shared { cells: vec![Cell::Bits(0); words], spoiled: false };
            }
        }
    }
}

fn found<M: Model>(bytes: Option<&[u8]>) -> Shared<M> {
    let words = bytes.unwrap_or(&[]).as_chunks().0.iter();
    Shared { cells: words.map(|c| Cell::Bits(u32::from_le_bytes(*c))).collect(), spoiled: false }
}

/// Floats as they are without the tape of the workgroup that wrote them.
fn detach(m: &Shadow, memory: &mut [Shared<Shadow>], order: &Order) {
    for (buffer, at) in &order.written {
        if let Some(Cell::Float(a)) = memory[*buffer as usize].cells.get_mut(*at) {
            *a = m.detached(*a);
        }
    }
}

fn told(m: &Shadow, cell: Cell<Shadow>) -> ShadowWord {
    match cell {
        Cell::Bits(value) => ShadowWord::Word { value, known: true },
        Cell::Float(a) => ShadowWord::Float { value: a.value, exact: a.exact, bound: m.bound(a) },
        Cell::Word(a) => ShadowWord::Word { value: a.value as u32, known: a.known },
    }
}
