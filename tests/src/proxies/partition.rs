//! Partition of space, for surfaces of which each piece is small: leaves, statues.
//!
//! A cell of space holds the regions whose middles are in it, sorted into classes: of one kind, with mean normals nearest to
//! one axis. A class that one rectangle stands for within the limits is a region; what is left is halved, at its middle along
//! the cell's longer sides, down to a depth. There each class is a region, whatever its deviation.

use super::Limits;
use super::moments::{Moments, Plane, area};
use super::rectangle::around;
use super::regions::kind;
use crate::scene::Triangle;
use lobe_codegen::glam::DVec3;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// The least fill of a rectangle that stands for a class before the last cells.
const FULL: f64 = 0.5;

/// What the regions of a class have in common: material, sides, the axis nearest to their normals and its sign.
type Class = (usize, bool, usize, bool);

/// The triangles, two-sided ones turned so that normals of one class are on one side.
pub(super) fn turned(triangles: &[Triangle]) -> Cow<'_, [Triangle]> {
    if !triangles.iter().any(|triangle| triangle.two_sided) {
        return Cow::Borrowed(triangles);
    }
    let turn = |triangle: &Triangle| {
        let (_, is_back) = nearest_axis(triangle.normal.as_dvec3());
        let normal = if triangle.two_sided && is_back { -triangle.normal } else { triangle.normal };
        Triangle { normal, ..*triangle }
    };
    triangles.iter().map(turn).collect()
}

/// The axis nearest to a normal, and whether the normal is against it.
fn nearest_axis(normal: DVec3) -> (usize, bool) {
    let size = normal.abs();
    let axis = if size.x >= size.y.max(size.z) {
        0
    } else if size.y >= size.z {
        1
    } else {
        2
    };
    (axis, normal[axis] < 0.0)
}

/// A box.
#[derive(Debug, Clone, Copy)]
struct Bounds {
    low: DVec3,
    high: DVec3,
}

impl Bounds {
    fn of(points: impl Iterator<Item = DVec3>) -> Self {
        let empty = Self { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };
        points.fold(empty, |b, point| Self { low: b.low.min(point), high: b.high.max(point) })
    }

    fn size(&self) -> DVec3 {
        self.high - self.low
    }

    /// Both parts of it, before and behind a place along an axis.
    fn cut(self, axis: usize, at: f64) -> [Self; 2] {
        let (mut before, mut behind) = (self, self);
        before.high[axis] = at;
        behind.low[axis] = at;
        [before, behind]
    }
}

/// A region on its way into the cells.
struct Piece {
    members: Vec<u32>,
    moments: Moments,
    class: Class,
    /// The diagonal of its box, m.
    extent: f64,
}

impl Piece {
    fn new(triangles: &[Triangle], members: Vec<u32>) -> Option<Self> {
        let all = || members.iter().map(|&i| &triangles[i as usize]);
        let (material, two_sided) = kind(all().next()?);
        let moments: Moments = all().map(Moments::of).sum();
        let (axis, is_back) = nearest_axis(moments.plane().normal);
        let extent = Bounds::of(all().flat_map(corners)).size().length();
        Some(Self { class: (material, two_sided, axis, is_back), moments, extent, members })
    }

    fn middle(&self) -> DVec3 {
        self.moments.plane().point
    }
}

fn corners(triangle: &Triangle) -> [DVec3; 3] {
    triangle.vertices.map(|vertex| vertex.as_dvec3())
}

/// Puts regions together that share a cell and a class, in cells at most `depth` times halved.
pub(super) fn partition(triangles: &[Triangle], region_of: &mut [u32], depth: u32, limits: &Limits) {
    let pieces = super::members(region_of).into_iter().filter_map(|members| Piece::new(triangles, members));
    let whole = Bounds::of(triangles.iter().flat_map(corners));
    let mut partition = Partition { triangles, limits, region_of, count: 0 };
    partition.divide(pieces.collect(), whole, depth);
}

struct Partition<'a> {
    triangles: &'a [Triangle],
    limits: &'a Limits,
    region_of: &'a mut [u32],
    /// Regions so far.
    count: u32,
}

impl Partition<'_> {
    /// Makes regions of what is in a cell.
    fn divide(&mut self, pieces: Vec<Piece>, cell: Bounds, depth: u32) {
        let mut left = Vec::new();
        for (_, class) in classes(pieces) {
            match self.fits(&class) {
                true => self.emit(&class),
                false => left.extend(class),
            }
        }
        match place(&left, cell).filter(|_| depth > 0) {
            Some((axis, at)) => {
                let (before, behind) = left.into_iter().partition(|piece| piece.middle()[axis] < at);
                let [low, high] = cell.cut(axis, at);
                self.divide(before, low, depth - 1);
                self.divide(behind, high, depth - 1);
            }
            None => self.settle(left, cell),
        }
    }

    /// Makes a region of each class of a cell that is not divided. What is larger than the cell stays by itself.
    fn settle(&mut self, pieces: Vec<Piece>, cell: Bounds) {
        for (_, class) in classes(pieces) {
            let (large, small): (Vec<Piece>, Vec<Piece>) =
                class.into_iter().partition(|piece| piece.extent > cell.size().length());
            large.chunks(1).chain([small.as_slice()]).for_each(|region| self.emit(region));
        }
    }

    fn emit(&mut self, pieces: &[Piece]) {
        for &member in pieces.iter().flat_map(|piece| &piece.members) {
            self.region_of[member as usize] = self.count;
        }
        self.count += u32::from(!pieces.is_empty());
    }

    /// Whether one rectangle stands for them within the limits, and is not mostly empty.
    fn fits(&self, pieces: &[Piece]) -> bool {
        let moments: Moments = pieces.iter().map(|piece| piece.moments).sum();
        let plane = moments.plane();
        pieces.len() == 1 || (self.is_flat(pieces, &plane) && self.fill(pieces, &plane) >= FULL)
    }

    fn members<'a>(&'a self, pieces: &'a [Piece]) -> impl Iterator<Item = &'a Triangle> {
        pieces.iter().flat_map(|piece| &piece.members).map(|&i| &self.triangles[i as usize])
    }

    fn is_flat(&self, pieces: &[Piece], plane: &Plane) -> bool {
        self.members(pieces).all(|triangle| {
            triangle.normal.as_dvec3().dot(plane.normal) >= self.limits.least_cosine
                && corners(triangle).iter().all(|corner| plane.height(*corner).abs() <= self.limits.distance)
        })
    }

    fn fill(&self, pieces: &[Piece], plane: &Plane) -> f64 {
        let points: Vec<DVec3> = self.members(pieces).flat_map(corners).collect();
        self.members(pieces).map(area).sum::<f64>() / around(&points, plane).area()
    }
}

fn classes(pieces: Vec<Piece>) -> BTreeMap<Class, Vec<Piece>> {
    let mut classes: BTreeMap<Class, Vec<Piece>> = BTreeMap::new();
    for piece in pieces {
        classes.entry(piece.class).or_default().push(piece);
    }
    classes
}

/// Where pieces are halved: an axis, and their mean by area along it; `None` where all are in one place.
fn place(pieces: &[Piece], cell: Bounds) -> Option<(usize, f64)> {
    let spread = Bounds::of(pieces.iter().map(Piece::middle));
    let size = cell.size();
    let is_spread = |axis: &usize| spread.low[*axis] < spread.high[*axis];
    let axis = (0..3).filter(is_spread).max_by(|a, b| size[*a].total_cmp(&size[*b]))?;
    let area: f64 = pieces.iter().map(|piece| piece.moments.area).sum();
    let mean = pieces.iter().map(|piece| piece.moments.area * piece.middle()[axis]).sum::<f64>() / area;
    // Rounding may bring the mean of two that are near each other onto the first.
    Some((axis, mean.clamp(spread.low[axis].next_up(), spread.high[axis])))
}
