//! Merging regions, the pair first that adds least error.

use super::Limits;
use super::adjacency::Neighbours;
use super::moments::Moments;
use super::rectangle::{around, extremes};
use super::regions::kind;
use crate::scene::Triangle;
use lobe_codegen::glam::DVec3;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// So many regions are compared each with each; of more, each with those near it.
const FEW: usize = 512;
/// How many of the next ones along each axis are near.
const NEAR: usize = 8;

/// A region as far as merging goes.
struct Region {
    moments: Moments,
    /// Corners that span its rectangle.
    outline: Vec<DVec3>,
    kind: (usize, bool),
    /// Area that its rectangle misrepresents, m².
    error: f64,
}

impl Region {
    fn new(moments: Moments, points: &[DVec3], kind: (usize, bool), limits: &Limits) -> Self {
        let plane = moments.plane();
        let outline = extremes(points, &plane);
        let empty = (around(&outline, &plane).area() - moments.seen()).max(0.0);
        Self { moments, outline, kind, error: moments.error(limits) + empty }
    }

    fn of(triangles: &[Triangle], members: &[u32], limits: &Limits) -> Option<Self> {
        let all = || members.iter().map(|&i| &triangles[i as usize]);
        let points: Vec<DVec3> = all().flat_map(|t| t.vertices.map(|v| v.as_dvec3())).collect();
        let kind = kind(all().next()?);
        Some(Self::new(all().map(Moments::of).sum(), &points, kind, limits))
    }

    fn with(&self, other: &Self, limits: &Limits) -> Self {
        let points = [&self.outline[..], &other.outline].concat();
        let kind = if self.moments.area >= other.moments.area { self.kind } else { other.kind };
        Self::new(self.moments + other.moments, &points, kind, limits)
    }
}

/// Merges down to `count` regions, of one material each unless `across`; returns how many are left.
pub(super) fn merge(
    triangles: &[Triangle],
    neighbours: &Neighbours,
    region_of: &mut [u32],
    count: usize,
    limits: &Limits,
    across: bool,
) -> usize {
    let members = super::members(region_of);
    let mut merger = Merger {
        regions: members.iter().map(|members| Region::of(triangles, members, limits)).collect(),
        parents: (0..members.len() as u32).collect(),
        pairs: BinaryHeap::new(),
        left: members.len(),
        limits,
        across,
    };
    merger.offer(&touching(neighbours, region_of));
    merger.run(count);
    while merger.left > count && merger.look_around() {
        merger.run(count);
    }
    region_of.iter_mut().for_each(|region| *region = merger.root(*region));
    merger.left
}

/// Pairs of regions with a common edge.
fn touching(neighbours: &Neighbours, region_of: &[u32]) -> Vec<[u32; 2]> {
    let mut pairs: Vec<[u32; 2]> = (0..region_of.len())
        .flat_map(|i| neighbours.of(i).iter().map(move |&j| [region_of[i], region_of[j as usize]]))
        .filter(|[a, b]| a < b)
        .collect();
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

struct Merger<'a> {
    /// `None` of one that is part of another.
    regions: Vec<Option<Region>>,
    /// What a region became part of; itself where it did not.
    parents: Vec<u32>,
    /// Pairs by the bits of what they add, which is not negative, so that bits are in the order of numbers.
    pairs: BinaryHeap<Reverse<(u64, u32, u32)>>,
    left: usize,
    limits: &'a Limits,
    across: bool,
}

impl Merger<'_> {
    /// Takes up those of some pairs that may be merged.
    fn offer(&mut self, pairs: &[[u32; 2]]) {
        for &[a, b] in pairs {
            self.push(a, b);
        }
    }

    /// Takes up pairs that do not touch; whether there are any.
    fn look_around(&mut self) -> bool {
        self.offer(&self.near());
        !self.pairs.is_empty()
    }

    fn push(&mut self, a: u32, b: u32) {
        let [Some(one), Some(other)] = [a, b].map(|i| self.regions[i as usize].as_ref()) else { return };
        if self.across || one.kind == other.kind {
            let added = one.with(other, self.limits).error - one.error - other.error;
            self.pairs.push(Reverse((added.max(0.0).to_bits(), a, b)));
        }
    }

    /// Merges until `count` are left or no pair is. A pair of which one has grown is weighed again.
    fn run(&mut self, count: usize) {
        while self.left > count
            && let Some(Reverse((_, a, b))) = self.pairs.pop()
        {
            let (one, other) = (self.root(a), self.root(b));
            if (one, other) == (a, b) {
                self.join(a, b);
            } else if one != other {
                self.push(one, other);
            }
        }
    }

    /// A region that is new, so that pairs of the two are known to be old.
    fn join(&mut self, a: u32, b: u32) {
        let [Some(one), Some(other)] = [a, b].map(|i| self.regions[i as usize].take()) else { return };
        let new = self.regions.len() as u32;
        self.regions.push(Some(one.with(&other, self.limits)));
        self.parents.push(new);
        self.parents[a as usize] = new;
        self.parents[b as usize] = new;
        self.left -= 1;
    }

    fn root(&mut self, region: u32) -> u32 {
        let mut root = region;
        while self.parents[root as usize] != root {
            root = self.parents[root as usize];
        }
        let mut next = region;
        while next != root {
            next = std::mem::replace(&mut self.parents[next as usize], root);
        }
        root
    }

    /// Pairs of regions that are not far from each other.
    fn near(&self) -> Vec<[u32; 2]> {
        let mut left: Vec<(u32, &Region)> = self
            .regions
            .iter()
            .enumerate()
            .filter_map(|(i, region)| Some((i as u32, region.as_ref()?)))
            .collect();
        let reach = if left.len() <= FEW { FEW } else { NEAR };
        let mut pairs = Vec::new();
        for axis in 0..3 {
            let place = |region: &Region| region.moments.plane().point[axis];
            let kind = |region: &Region| if self.across { (0, false) } else { region.kind };
            left.sort_by(|(_, a), (_, b)| kind(a).cmp(&kind(b)).then(place(a).total_cmp(&place(b))));
            for (i, (a, _)) in left.iter().enumerate() {
                pairs.extend(left[i + 1..].iter().take(reach).map(|(b, _)| [*a.min(b), *a.max(b)]));
            }
        }
        pairs.sort_unstable();
        pairs.dedup();
        pairs
    }
}
