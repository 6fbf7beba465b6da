//! Loads and stores of array elements.

use super::super::super::program::{Op, Place, Program, Stmt, Value};
use super::super::{Inst, memory};
use super::{COPIES, Linker};

/// A load: its place, the epoch and the register that takes the word.
fn load(stmt: &Stmt) -> Option<(Place, u32, Value)> {
    match stmt {
        Stmt::Eval(eval) => match eval.op {
            Op::Load { place, epoch, scalar } if scalar.is_word() => {
                Some((place, epoch, Value::Reg(eval.to)))
            }
            _ => None,
        },
        _ => None,
    }
}

/// How many loads a block begins with that one step, or a few, can do: words of one element, or up to four neighbours
/// that all lanes share.
pub(super) fn together(program: &Program, block: &[Stmt]) -> usize {
    let Some((first, epoch, to)) = block.first().and_then(load) else {
        return 0;
    };
    let loads = block.iter().map_while(load).take_while(|(_, e, _)| *e == epoch);
    match first {
        Place::Element { .. } => loads.take_while(|(place, ..)| place.same_element(&first)).count(),
        Place::Buffer { buffer, offset, index } if !program.varying(to) => {
            let next = |rank: u32| Place::Buffer { buffer, offset: offset.saturating_add(4 * rank), index };
            loads.zip(0..4).take_while(|((place, ..), rank)| *place == next(*rank)).count()
        }
        Place::Buffer { .. } | Place::Lane { .. } => 0,
    }
}

impl<const N: usize> Linker<'_, N> {
    /// The array of a place, by its rank, the slot of the index, and the offset in the element.
    fn element(&mut self, place: Place) -> Option<[u32; 3]> {
        let Place::Element { buffer, offset, index, count, stride } = place else {
            return None;
        };
        let (by_number, once) = (self.numbers.contains(&index), self.once.contains(&buffer));
        let array = memory::Array { buffer, count, stride, by_number, once };
        let at = self.elements.iter().position(|a| *a == array).unwrap_or(self.elements.len());
        if at == self.elements.len() {
            self.elements.push(array);
        }
        Some([at as u32, self.slot(index, 0), offset])
    }

    /// A load that all lanes share: the address takes the cell of its result first.
    fn load_same(&mut self, place: Place, d: u32) {
        if let Place::Element { buffer, offset, index, count, stride } = place {
            let run = memory::index(false, false, self.isa);
            let n = super::evals::bounds(count, stride);
            self.insts.push(Inst { run, d, s: [self.place(index), self.zero, 0, 0], n });
            let run = memory::load_word(self.isa);
            self.insts.push(Inst { run, d, s: [d, 0, 0, 0], n: [buffer, offset, 0] });
        }
    }

    /// Loads what [`together`] has found.
    pub(super) fn load_together(&mut self, loads: &[Stmt]) {
        let Some((Place::Buffer { buffer, offset, index }, ..)) = loads.first().and_then(load) else {
            return self.load_elements(loads);
        };
        let mut to = loads.iter().filter_map(load).map(|(_, _, to)| self.place(to));
        let mut next = || to.next().unwrap_or(0);
        let (d, s) = (next(), [self.index(index).0, next(), next(), next()]);
        let run = memory::load_words(self.isa);
        self.insts.push(Inst { run, d, s, n: [buffer, offset, loads.len() as u32] });
    }

    /// Loads words of one element, neighbours at once.
    pub(super) fn load_elements(&mut self, loads: &[Stmt]) {
        let mut words: Vec<[u32; 4]> = Vec::new();
        for (place, _, to) in loads.iter().filter_map(load) {
            if !self.program.varying(to) {
                self.load_same(place, self.place(to));
            } else if let Some([array, index, offset]) = self.element(place) {
                words.push([offset, array, index, self.place(to)]);
            }
        }
        words.sort_unstable();
        // A place for words that nobody asked for.
        let mut rest = &words[..];
        while let [[begin, array, index, first], ..] = rest {
            let mut to = [*first, COPIES, COPIES, COPIES];
            let mut count = 1;
            for [offset, _, _, slot] in &rest[1..] {
                let rank = (offset - begin) / 4;
                if rank == 0 || rank > 3 || to[rank as usize] != COPIES {
                    break;
                }
                to[rank as usize] = *slot;
                count += 1;
            }
            let n = [*array, *begin, 0];
            let run = match count {
                1 => memory::load_element(self.isa),
                _ => memory::load_four(self.isa),
            };
            self.insts.push(Inst { run, d: to[0], s: [*index, to[1], to[2], to[3]], n });
            rest = &rest[count..];
        }
    }

    /// Stores a word of an element; `None` where the place is none.
    pub(super) fn store_element(&mut self, place: Place, value: (u32, bool), mask: u32) -> Option<()> {
        let [array, index, offset] = self.element(place)?;
        let run = memory::store_element(value.1, self.isa);
        self.insts.push(Inst { run, d: 0, s: [index, value.0, mask, 0], n: [array, offset, 0] });
        Some(())
    }
}
