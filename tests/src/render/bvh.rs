//! The tree of boxes, built on the host: binned by the surface-area heuristic.

use lobe_codegen::glam::Vec3;
use lobe_kernels::scene::bvh::BVH_DEPTH;
use lobe_kernels::scene::{BvhNode, Triangle};

/// Triangles of a leaf, at most, unless they all lie in one place.
const LEAF: usize = 4;
/// Places at which a box may be split, along its longest side.
const BINS: usize = 16;
/// Boxes deeper than this are split in the middle of their triangles, which ends before [`BVH_DEPTH`].
const HEURISTIC_DEPTH: u32 = BVH_DEPTH - 24;

/// A tree, and the triangles in its order.
#[derive(Debug, Clone)]
pub struct Bvh {
    /// The root first; children are neighbours.
    pub nodes: Vec<BvhNode>,
    /// Those of a leaf are neighbours.
    pub triangles: Vec<Triangle>,
}

/// An axis-aligned box.
#[derive(Debug, Clone, Copy)]
struct Bounds {
    low: Vec3,
    high: Vec3,
}

impl Bounds {
    const EMPTY: Self = Self { low: Vec3::INFINITY, high: Vec3::NEG_INFINITY };

    fn of(triangle: &Triangle) -> Self {
        let low = triangle.a.min(triangle.b).min(triangle.c);
        Self { low, high: triangle.a.max(triangle.b).max(triangle.c) }
    }

    fn join(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Half its surface; 0 of an empty one.
    fn area(self) -> f32 {
        let size = (self.high - self.low).max(Vec3::ZERO);
        size.x * size.y + size.y * size.z + size.z * size.x
    }
}

/// A triangle on its way into the tree.
#[derive(Debug, Clone, Copy)]
struct Item {
    bounds: Bounds,
    middle: Vec3,
    index: usize,
}

impl Bvh {
    /// The tree of `triangles`, whose boxes are wider by `slack` than what is in them.
    #[must_use]
    pub fn new(triangles: &[Triangle], slack: f32) -> Self {
        let item = |(index, triangle): (usize, &Triangle)| {
            let bounds = Bounds::of(triangle);
            Item { bounds, middle: 0.5 * (bounds.low + bounds.high), index }
        };
        let mut items: Vec<Item> = triangles.iter().enumerate().map(item).collect();
        let mut builder = Builder { nodes: vec![EMPTY], slack };
        builder.fill(0, 0, &mut items, 0);
        let sorted = items.iter().map(|item| triangles[item.index]).collect();
        Self { nodes: builder.nodes, triangles: sorted }
    }
}

/// A node before it is filled in.
const EMPTY: BvhNode = BvhNode { low: Vec3::ZERO, first: 0, high: Vec3::ZERO, count: 0 };

struct Builder {
    nodes: Vec<BvhNode>,
    slack: f32,
}

impl Builder {
    /// Makes node `at` hold `items`, which are from `first` on in the order of the tree.
    fn fill(&mut self, at: usize, first: usize, items: &mut [Item], depth: u32) {
        let bounds = items.iter().fold(Bounds::EMPTY, |all, item| all.join(item.bounds));
        let (low, high) = (bounds.low - self.slack, bounds.high + self.slack);
        let split = (items.len() > LEAF).then(|| split(items, depth)).flatten();
        let Some(split) = split else {
            self.nodes[at] = BvhNode { low, first: first as u32, high, count: items.len() as u32 };
            return;
        };
        let child = self.nodes.len();
        self.nodes.extend([EMPTY; 2]);
        self.nodes[at] = BvhNode { low, first: child as u32, high, count: 0 };
        let (left, right) = items.split_at_mut(split);
        self.fill(child, first, left, depth + 1);
        self.fill(child + 1, first + split, right, depth + 1);
    }
}

/// Sorts `items` into two parts and says how long the first is; `None` if they cannot be told apart.
fn split(items: &mut [Item], depth: u32) -> Option<usize> {
    let low = items.iter().fold(Vec3::INFINITY, |low, item| low.min(item.middle));
    let high = items.iter().fold(Vec3::NEG_INFINITY, |high, item| high.max(item.middle));
    let size = high - low;
    let axis = (0..3).max_by(|a, b| size[*a].total_cmp(&size[*b]))?;
    if size[axis] <= 0.0 || !size[axis].is_finite() {
        return None;
    }
    if depth < HEURISTIC_DEPTH {
        let bin = |item: &Item| bin_of(item, axis, low[axis], size[axis]);
        if let Some(plane) = best_plane(items, bin) {
            return Some(partition(items, |item| bin(item) < plane));
        }
    }
    let half = items.len() / 2;
    items.select_nth_unstable_by(half, |a, b| a.middle[axis].total_cmp(&b.middle[axis]));
    Some(half)
}

fn bin_of(item: &Item, axis: usize, low: f32, size: f32) -> usize {
    let share = (item.middle[axis] - low) / size;
    ((share * BINS as f32) as usize).min(BINS - 1)
}

/// The bin before which a split costs least; `None` where all are in one bin.
fn best_plane(items: &[Item], bin: impl Fn(&Item) -> usize) -> Option<usize> {
    let mut bins = [(Bounds::EMPTY, 0_usize); BINS];
    for item in items {
        let (bounds, count) = &mut bins[bin(item)];
        *bounds = bounds.join(item.bounds);
        *count += 1;
    }
    let part = |range: &[(Bounds, usize)]| {
        range.iter().fold((Bounds::EMPTY, 0), |(all, n), (bounds, count)| (all.join(*bounds), n + count))
    };
    let cost = |plane: usize| {
        let (left, right) = (part(&bins[..plane]), part(&bins[plane..]));
        (left.1 > 0 && right.1 > 0).then(|| left.0.area() * left.1 as f32 + right.0.area() * right.1 as f32)
    };
    let costs = (1..BINS).filter_map(|plane| cost(plane).map(|cost| (plane, cost)));
    costs.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(plane, _)| plane)
}

/// Moves those for which `is_first` holds to the front, and says how many they are.
fn partition(items: &mut [Item], is_first: impl Fn(&Item) -> bool) -> usize {
    let mut count = 0;
    for at in 0..items.len() {
        if is_first(&items[at]) {
            items.swap(at, count);
            count += 1;
        }
    }
    count
}
