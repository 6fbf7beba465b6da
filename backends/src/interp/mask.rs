//! Which lanes of a batch execute.

/// One flag a lane.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Mask(Vec<bool>);

impl Mask {
    pub(super) fn none(lanes: usize) -> Self {
        Self(vec![false; lanes])
    }

    pub(super) fn all(lanes: usize) -> Self {
        Self(vec![true; lanes])
    }

    pub(super) fn any(&self) -> bool {
        self.0.contains(&true)
    }

    pub(super) fn every(&self) -> bool {
        !self.0.contains(&false)
    }

    pub(super) fn get(&self, lane: usize) -> bool {
        self.0[lane]
    }

    pub(super) fn set(&mut self, lane: usize, on: bool) {
        self.0[lane] = on;
    }

    /// The lanes that are on.
    pub(super) fn lanes(&self) -> impl Iterator<Item = usize> + '_ {
        self.0.iter().enumerate().filter(|(_, on)| **on).map(|(lane, _)| lane)
    }

    /// The lanes that are on and for which `keep` holds.
    pub(super) fn filter(&self, keep: impl Fn(usize) -> bool) -> Self {
        Self(self.0.iter().enumerate().map(|(lane, on)| *on && keep(lane)).collect())
    }

    /// Switches on what is on in `other`.
    pub(super) fn join(&mut self, other: &Self) {
        self.0.iter_mut().zip(&other.0).for_each(|(a, b)| *a |= *b);
    }

    /// All off; returns what was on.
    pub(super) fn take(&mut self) -> Self {
        let empty = Self::none(self.0.len());
        std::mem::replace(self, empty)
    }
}
