//! Variables and buffers.
//!
//! A variable of a function, or a private one, belongs to each lane alone and is kept as lanes.
//! Workgroup memory and buffers are shared by all lanes and kept as words.
//! Indices out of bounds are clamped (the last element is meant), as naga's `Restrict` policy has it, so
//! every pointer leads somewhere; only an empty runtime-sized array leads nowhere: it reads as zero.

use super::error::{InterpError, Res};
use super::layout::{Kind, Packing, Pointee, Types};
use super::leaf::Leaf;
use super::mask::Mask;
use super::model::Model;
use std::rc::Rc;

/// What a pointer leads into.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Root {
    /// A variable of each lane.
    Lane(usize),
    /// Memory that the lanes share.
    Shared(usize),
}

/// Units from the root.
#[derive(Debug, Clone)]
pub(super) enum Offset {
    /// The same in all lanes.
    Uniform(u32),
    /// One for each lane.
    Lanes(Rc<Vec<u32>>),
}

impl Offset {
    fn at(&self, lane: usize) -> u32 {
        match self {
            Self::Uniform(at) => *at,
            Self::Lanes(at) => at[lane],
        }
    }

    /// Adds a constant.
    pub(super) fn plus(&self, units: u32) -> Self {
        match self {
            Self::Uniform(at) => Self::Uniform(at.saturating_add(units)),
            Self::Lanes(at) => Self::Lanes(Rc::new(at.iter().map(|a| a.saturating_add(units)).collect())),
        }
    }

    /// Adds one number a lane.
    pub(super) fn plus_lanes(&self, units: &[u32]) -> Self {
        let sum = units.iter().enumerate().map(|(lane, u)| self.at(lane).saturating_add(*u)).collect();
        Self::Lanes(Rc::new(sum))
    }
}

/// A pointer in every lane; all lead into the same root.
#[derive(Debug, Clone)]
pub(super) struct Pointer {
    pub(super) root: Root,
    pub(super) offset: Offset,
    pub(super) pointee: Pointee,
}

/// Memory of a workgroup or a buffer.
#[derive(Debug, Clone)]
pub(super) struct Shared {
    pub(super) words: Vec<u32>,
    pub(super) packing: Packing,
}

/// All memory that a batch reaches.
pub(super) struct Memory<M: Model> {
    pub(super) lane: Vec<Vec<Leaf<M>>>,
    pub(super) shared: Vec<Shared>,
}

const OUTSIDE: InterpError = InterpError::Malformed("a pointer leads out of its variable");

impl<M: Model> Memory<M> {
    pub(super) fn new() -> Self {
        Self { lane: Vec::new(), shared: Vec::new() }
    }

    /// How the memory behind `root` is laid out.
    pub(super) fn packing(&self, root: Root) -> Packing {
        match root {
            Root::Lane(_) => Packing::Packed,
            Root::Shared(id) => self.shared[id].packing,
        }
    }

    /// Units behind `root`.
    pub(super) fn units(&self, root: Root) -> u32 {
        match root {
            Root::Lane(id) => self.lane[id].len() as u32,
            Root::Shared(id) => self.shared[id].words.len() as u32,
        }
    }

    /// Reads what `pointer` leads to, in all lanes.
    pub(super) fn load(&self, m: &M, types: Types<'_>, pointer: &Pointer, lanes: usize) -> Res<Vec<Leaf<M>>> {
        let scalars = types.scalars(pointer.pointee, self.packing(pointer.root))?;
        match pointer.root {
            Root::Lane(id) => {
                let variable = &self.lane[id];
                scalars
                    .into_iter()
                    .map(|(_, at)| load_lane(variable, &pointer.offset.plus(at), lanes))
                    .collect()
            }
            Root::Shared(id) => {
                let words = &self.shared[id].words;
                let load = |(kind, at): (Kind, u32)| {
                    let word = |lane| words.get((pointer.offset.at(lane).saturating_add(at)) as usize);
                    Leaf::from_value_bits(m, kind, (0..lanes).map(|lane| word(lane).copied().unwrap_or(0)))
                };
                Ok(scalars.into_iter().map(load).collect())
            }
        }
    }

    /// Writes `value` where `pointer` leads, in the lanes of `mask`, one after the other.
    pub(super) fn store(
        &mut self,
        m: &M,
        types: Types<'_>,
        pointer: &Pointer,
        value: &[Leaf<M>],
        mask: &Mask,
    ) -> Res<()> {
        let scalars = types.scalars(pointer.pointee, self.packing(pointer.root))?;
        for ((_, at), leaf) in scalars.into_iter().zip(value) {
            match (pointer.root, pointer.offset.plus(at)) {
                (Root::Lane(id), Offset::Uniform(at)) => {
                    self.lane[id].get_mut(at as usize).ok_or(OUTSIDE)?.blend(leaf, mask)?;
                }
                (Root::Lane(id), Offset::Lanes(at)) => {
                    for lane in mask.lanes() {
                        let target = self.lane[id].get_mut(at[lane] as usize).ok_or(OUTSIDE)?;
                        target.set_lane(leaf, lane)?;
                    }
                }
                (Root::Shared(id), offset) => {
                    let bits = leaf.value_bits(m);
                    for lane in mask.lanes() {
                        if let Some(word) = self.shared[id].words.get_mut(offset.at(lane) as usize) {
                            *word = bits[lane];
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// Replaces the word behind an atomic pointer by `f(lane, word)`, lane after lane; returns the former words.
    pub(super) fn update(
        &mut self,
        pointer: &Pointer,
        mask: &Mask,
        lanes: usize,
        f: impl Fn(usize, u32) -> u32,
    ) -> Res<Vec<u32>> {
        let Root::Shared(id) = pointer.root else {
            return Err(InterpError::Malformed("an atomic lies in workgroup or storage memory"));
        };
        let mut former = vec![0; lanes];
        for lane in mask.lanes() {
            if let Some(word) = self.shared[id].words.get_mut(pointer.offset.at(lane) as usize) {
                former[lane] = std::mem::replace(word, f(lane, *word));
            }
        }
        Ok(former)
    }
}

fn load_lane<M: Model>(variable: &[Leaf<M>], offset: &Offset, lanes: usize) -> Res<Leaf<M>> {
    match offset {
        Offset::Uniform(at) => variable.get(*at as usize).cloned().ok_or(OUTSIDE),
        Offset::Lanes(at) => {
            let last = variable.len().checked_sub(1).ok_or(OUTSIDE)?;
            // Only the stretch that some lane reads is looked at.
            let (low, high) = at.iter().fold((last, 0), |(l, h), a| (l.min(*a as usize), h.max(*a as usize)));
            let sources: Vec<_> = variable[low..=high.min(last)].iter().collect();
            gather_same(&sources, lanes, |lane| (at[lane] as usize).min(last) - low)
        }
    }
}

/// A gather from a stretch of a variable: scalars of other kinds may lie between those that are meant.
fn gather_same<M: Model>(sources: &[&Leaf<M>], lanes: usize, index: impl Fn(usize) -> usize) -> Res<Leaf<M>> {
    let wanted = sources.get(if lanes == 0 { 0 } else { index(0) }).ok_or(OUTSIDE)?;
    let fitting: Vec<_> = sources
        .iter()
        .map(|s| if std::mem::discriminant(*s) == std::mem::discriminant(*wanted) { *s } else { *wanted })
        .collect();
    Leaf::gather(&fitting, lanes, index)
}
