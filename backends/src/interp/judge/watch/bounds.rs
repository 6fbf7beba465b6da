//! Looks for what is not there: elements of arrays, texels of textures, lanes of subgroups.

use super::super::super::error::Res;
use super::super::super::finding::Fault;
use super::super::super::model::Model;
use super::super::super::program::subgroup::SubgroupOp;
use super::super::super::program::{Access, Count, Subgroup, Value};
use super::super::super::subgroup::{Brought, partner};
use super::super::super::texture::astray;
use super::super::{Machine, integer};
use super::Watch;
use naga::Span;

impl Watch {
    pub(super) fn index<M: Model>(
        &mut self,
        m: &Machine<'_, M>,
        at: Span,
        (count, stride): (Count, u32),
        index: Value,
    ) -> Res<()> {
        let count = m.count(count, stride);
        self.number(m, at, index, |_| count)
    }

    /// The same in an array that has `count` elements.
    pub(super) fn index_within<M: Model>(
        &mut self,
        m: &Machine<'_, M>,
        at: Span,
        index: Value,
        count: Value,
    ) -> Res<()> {
        let count = m.words(count)?;
        self.number(m, at, index, |lane| m.model.word_value(count.at(lane)))
    }

    /// Looks at an index that leads into so many elements in each lane.
    fn number<M: Model>(
        &mut self,
        m: &Machine<'_, M>,
        at: Span,
        index: Value,
        count: impl Fn(usize) -> u64,
    ) -> Res<()> {
        let (scalar, words) = (m.program.scalar(index), m.words(index)?);
        for lane in m.flow.active.lanes() {
            let (number, count) = (integer::number(m.model.word_value(words.at(lane)), scalar), count(lane));
            if !(0..i128::from(count)).contains(&number) {
                let message = || format!("index {number} of {count} elements");
                self.report(m, (Fault::OutOfBounds, at), lane, message);
            }
        }
        Ok(())
    }

    /// The place of a texel in each lane.
    pub(super) fn texels<M: Model>(&mut self, m: &Machine<'_, M>, access: &Access) -> Res<()> {
        for lane in m.flow.active.lanes() {
            let operands = m.texture_operands(access, lane)?;
            let shape = m.image(access, &operands)?.texture.shape();
            if let Some(at) = astray(shape, access.op, &operands) {
                let message = || format!("{at} of {shape}");
                self.report(m, (Fault::OutOfBounds, access.at), lane, message);
            }
        }
        Ok(())
    }

    /// What the lanes of the subgroup that begins with lane `first` gather from each other.
    pub(super) fn gathered<M: Model>(
        &mut self,
        m: &Machine<'_, M>,
        subgroup: &Subgroup,
        first: usize,
        lanes: &[Option<Brought>],
    ) {
        let SubgroupOp::Gather(gather) = subgroup.op else { return };
        let alone = |at: &usize| lanes[*at].is_some() && partner(gather, *at, lanes).is_none();
        if let Some(at) = (0..lanes.len()).find(alone) {
            let message = || format!("lane {at} of a subgroup takes a value of a lane that is not active");
            self.report(m, (Fault::AbsentLane, subgroup.at), first + at, message);
        }
    }
}
