//! Loops over lanes: the only places where an operation meets its numbers.

use super::super::error::Res;
use super::super::leaf::Leaf;
use super::super::model::Model;
use super::Machine;

impl<M: Model> Machine<'_, M> {
    pub(super) fn map_f(&self, a: &Leaf<M>, f: impl Fn(M::F) -> M::F) -> Res<Leaf<M>> {
        Ok(Leaf::from_floats(a.floats()?.iter().map(|a| f(*a)).collect()))
    }

    pub(super) fn zip_f(&self, a: &Leaf<M>, b: &Leaf<M>, f: impl Fn(M::F, M::F) -> M::F) -> Res<Leaf<M>> {
        let (a, b) = (a.floats()?, b.floats()?);
        Ok(Leaf::from_floats(a.iter().zip(b).map(|(a, b)| f(*a, *b)).collect()))
    }

    pub(super) fn zip3_f(
        &self,
        [a, b, c]: [&Leaf<M>; 3],
        f: impl Fn(M::F, M::F, M::F) -> M::F,
    ) -> Res<Leaf<M>> {
        let (a, b, c) = (a.floats()?, b.floats()?, c.floats()?);
        Ok(Leaf::from_floats(a.iter().zip(b).zip(c).map(|((a, b), c)| f(*a, *b, *c)).collect()))
    }

    pub(super) fn compare_f(&self, a: &Leaf<M>, b: &Leaf<M>, f: impl Fn(M::F, M::F) -> M::B) -> Res<Leaf<M>> {
        let (a, b) = (a.floats()?, b.floats()?);
        Ok(Leaf::from_bools(a.iter().zip(b).map(|(a, b)| f(*a, *b)).collect()))
    }

    pub(super) fn map_w(&self, a: &Leaf<M>, f: impl Fn(u32) -> u32) -> Res<Leaf<M>> {
        Ok(Leaf::from_words(a.words()?.iter().map(|a| self.model.map_w(*a, &f)).collect()))
    }

    pub(super) fn zip_w(&self, a: &Leaf<M>, b: &Leaf<M>, f: impl Fn(u32, u32) -> u32) -> Res<Leaf<M>> {
        let (a, b) = (a.words()?, b.words()?);
        Ok(Leaf::from_words(a.iter().zip(b).map(|(a, b)| self.model.zip_w(*a, *b, &f)).collect()))
    }

    pub(super) fn compare_w(&self, a: &Leaf<M>, b: &Leaf<M>, f: impl Fn(u32, u32) -> bool) -> Res<Leaf<M>> {
        let (a, b) = (a.words()?, b.words()?);
        Ok(Leaf::from_bools(a.iter().zip(b).map(|(a, b)| self.model.compare_w(*a, *b, &f)).collect()))
    }

    pub(super) fn map_b(&self, a: &Leaf<M>, f: impl Fn(M::B) -> M::B) -> Res<Leaf<M>> {
        Ok(Leaf::from_bools(a.bools()?.iter().map(|a| f(*a)).collect()))
    }

    pub(super) fn zip_b(&self, a: &Leaf<M>, b: &Leaf<M>, f: impl Fn(M::B, M::B) -> M::B) -> Res<Leaf<M>> {
        let (a, b) = (a.bools()?, b.bools()?);
        Ok(Leaf::from_bools(a.iter().zip(b).map(|(a, b)| f(*a, *b)).collect()))
    }

    /// `f` of each pair of columns; a lone column goes with all columns of the other side.
    pub(super) fn columns(
        &self,
        a: &[Leaf<M>],
        b: &[Leaf<M>],
        f: impl Fn(&Leaf<M>, &Leaf<M>) -> Res<Leaf<M>>,
    ) -> Res<Vec<Leaf<M>>> {
        match (a, b) {
            ([a], b) => b.iter().map(|b| f(a, b)).collect(),
            (a, [b]) => a.iter().map(|a| f(a, b)).collect(),
            (a, b) => a.iter().zip(b).map(|(a, b)| f(a, b)).collect(),
        }
    }
}
