//! What the lanes of a subgroup exchange. Drivers form subgroups as they like, so nothing is promised of it.

use super::super::model::Model;
use super::super::program::{Reg, Subgroup};
use super::super::subgroup::{Brought, exchange};
use super::input::Inputs;
use super::{Machine, Res};

impl<M: Model> Machine<'_, M> {
    pub(super) fn exchange(&mut self, subgroup: &Subgroup) -> Res<()> {
        let size = match self.inputs {
            Inputs::Group { subgroup, .. } => subgroup as usize,
            Inputs::Rows { .. } => 1,
        };
        let Reg(at) = subgroup.to;
        let mut to = std::mem::take(&mut self.registers[at as usize]);
        let scalar = self.program.scalar(subgroup.value);
        for first in (0..self.lanes).step_by(size) {
            let mut lanes = Vec::new();
            for lane in first..self.lanes.min(first + size) {
                lanes.push(if self.flow.active.get(lane) {
                    Some(self.brought(subgroup, lane)?)
                } else {
                    None
                });
            }
            self.watch_exchange(subgroup, first, &lanes);
            let results = exchange(subgroup.op, scalar, &lanes);
            for (lane, bits) in (first..).zip(results) {
                if self.flow.active.get(lane) {
                    let word = self.model.word(bits);
                    self.set(&mut to, lane, if M::SHADOW { self.model.forget(word) } else { word });
                    self.flags.tainted[lane] = true;
                }
            }
        }
        self.registers[at as usize] = to;
        Ok(())
    }

    fn brought(&self, subgroup: &Subgroup, lane: usize) -> Res<Brought> {
        let m = &self.model;
        let value = m.word_value(self.word(subgroup.value, lane)?);
        let index = subgroup.index.map_or(Ok(0), |i| Ok(m.word_value(self.word(i, lane)?)))?;
        Ok(Brought { value, index })
    }
}
