//! What the lanes of a subgroup exchange.
//!
//! Subgroups are taken to be consecutive invocations, and drivers to agree on it. Where a decision that rounding may
//! turn came before, it is not known who takes part, and so nothing is promised.

use super::super::model::Model;
use super::super::program::subgroup::SubgroupOp;
use super::super::program::{Reg, Scalar, Subgroup};
use super::super::subgroup::{Brought, exchange, partner};
use super::column::{Column, Family, family};
use super::input::Inputs;
use super::{Machine, Res};
use naga::CollectiveOperation;

/// A subgroup at an exchange.
struct Party {
    /// Its first lane.
    first: usize,
    /// What its lanes bring.
    lanes: Vec<Option<Brought>>,
    /// Whether all drivers have the same lanes in it.
    is_certain: bool,
}

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
            let party = self.party(subgroup, first, self.lanes.min(first + size))?;
            self.watch_exchange(subgroup, first, &party.lanes);
            let results = exchange(subgroup.op, scalar, &party.lanes);
            for (lane, bits) in (first..).zip(results) {
                if !self.flow.active.get(lane) {
                    continue;
                }
                self.set(&mut to, scalar, lane, self.model.word(bits));
                if M::SHADOW && !self.agreed(subgroup, &party, lane, &mut to)? {
                    to.forget(&self.model, lane);
                    self.flags.tainted[lane] = true;
                }
            }
        }
        self.registers[at as usize] = to;
        Ok(())
    }

    fn party(&self, subgroup: &Subgroup, first: usize, end: usize) -> Res<Party> {
        let is_here = |lane| self.flow.active.get(lane) && self.flow.value.get(lane);
        let brought = |lane| is_here(lane).then(|| self.brought(subgroup, lane)).transpose();
        let lanes = (first..end).map(brought).collect::<Res<_>>()?;
        let is_certain = (first..end).all(|lane| !(self.flags.ambiguous[lane] || self.flags.lost[lane]));
        Ok(Party { first, lanes, is_certain })
    }

    fn brought(&self, subgroup: &Subgroup, lane: usize) -> Res<Brought> {
        let m = &self.model;
        let value = m.word_value(self.word(subgroup.value, lane)?);
        let index = subgroup.index.map_or(Ok(0), |i| Ok(m.word_value(self.word(i, lane)?)))?;
        Ok(Brought { value, index })
    }

    /// Puts into a lane of `to`, which holds the strict result, what drivers may have; `false` if that is anything.
    fn agreed(&self, subgroup: &Subgroup, party: &Party, lane: usize, to: &mut Column<M>) -> Res<bool> {
        let index_known = |i| self.word(i, lane).map(|index| self.model.known(index));
        if !party.is_certain || !subgroup.index.map_or(Ok(true), index_known)? {
            return Ok(false);
        }
        let at = lane - party.first;
        let (op, how) = match subgroup.op {
            SubgroupOp::Gather(gather) => {
                let Some(from) = partner(gather, at, &party.lanes) else { return Ok(false) };
                return self.gathered(subgroup, party.first + from, lane, to);
            }
            SubgroupOp::Ballot(_) => return self.are_known(subgroup, party, party.lanes.len()),
            SubgroupOp::Collect(op, how) => (op, how),
        };
        let end = match how {
            CollectiveOperation::Reduce => party.lanes.len(),
            CollectiveOperation::InclusiveScan => at + 1,
            CollectiveOperation::ExclusiveScan => at,
        };
        match to {
            Column::Float(to) => {
                let floats = self.floats(subgroup.value)?;
                let taken = active(party, end).map(|lane| floats.at(lane)).collect::<Vec<_>>();
                let scalar = self.program.scalar(subgroup.value);
                to[lane] = by_width!(self.model, scalar, m => m.collected(op, &taken, to[lane]));
                Ok(true)
            }
            Column::Word(_) | Column::Bool(_) => self.are_known(subgroup, party, end),
        }
    }

    /// Takes over what lane `from` brings.
    fn gathered(&self, subgroup: &Subgroup, from: usize, lane: usize, to: &mut Column<M>) -> Res<bool> {
        match to {
            Column::Float(to) => to[lane] = self.floats(subgroup.value)?.at(from),
            Column::Word(to) => to[lane] = self.words(subgroup.value)?.at(from),
            Column::Bool(to) => to[lane] = self.bools(subgroup.value)?.at(from),
        }
        Ok(true)
    }

    /// Whether the first lanes bring integers or booleans that all drivers have.
    fn are_known(&self, subgroup: &Subgroup, party: &Party, end: usize) -> Res<bool> {
        let scalar = self.program.scalar(subgroup.value);
        let mut all = true;
        for lane in active(party, end) {
            all &= match family::<M>(scalar) {
                Family::Bool => !self.model.ambiguous(self.bools(subgroup.value)?.at(lane)),
                Family::Word | Family::Float => self.model.known(self.word(subgroup.value, lane)?),
            };
        }
        Ok(all)
    }
}

/// The active ones among the first lanes of a subgroup.
fn active(party: &Party, end: usize) -> impl Iterator<Item = usize> {
    let lanes = party.lanes.iter().take(end).enumerate();
    lanes.filter(|(_, brought)| brought.is_some()).map(|(at, _)| party.first + at)
}
