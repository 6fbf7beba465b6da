//! The tree over rectangles, built on the host: halved along the longest of six axes, of place and of normal.

use lobe_codegen::glam::{Vec2, Vec3};
use lobe_kernels::brdf::Material;
use lobe_kernels::rect::field_tree::{FieldLobe, FieldNode};
use lobe_kernels::rect::laplace::rect_laplace_gloss;
use lobe_kernels::rect::pass::{RectProxy, light_share};
use lobe_kernels::reference::running_mean::luminance;
use lobe_kernels::scene::light::SceneLight;
use std::ops::Range;

/// How far apart normals that are a radian apart count, in diagonals of the box around all rectangles.
const TURN: f32 = 0.3;

/// A tree over rectangles, and what its nodes reflect of each light.
#[derive(Debug, Clone)]
pub struct FieldTree {
    /// The root first; children are neighbours.
    pub nodes: Vec<FieldNode>,
    /// Of each node, one for each light.
    pub lobes: Vec<FieldLobe>,
}

/// A rectangle on its way into the tree.
#[derive(Debug, Clone)]
struct Item {
    index: u32,
    low: Vec3,
    high: Vec3,
    normal: Vec3,
    lobes: Vec<FieldLobe>,
}

impl FieldTree {
    /// The tree over a range of `proxies`, which is not empty, under `lights`, of which there is one at least.
    #[must_use]
    pub fn new(
        proxies: &[RectProxy],
        range: Range<u32>,
        materials: &[Material],
        lights: &[SceneLight],
    ) -> Self {
        let item = |index: u32| {
            let proxy = proxies[index as usize];
            let material = &materials[proxy.material as usize];
            Item::new(index, proxy, lights.iter().map(|light| lobe(light, proxy, material)).collect())
        };
        let mut items: Vec<Item> = range.map(item).collect();
        let low = items.iter().fold(Vec3::INFINITY, |low, item| low.min(item.low));
        let high = items.iter().fold(Vec3::NEG_INFINITY, |high, item| high.max(item.high));
        let mut builder = Builder {
            nodes: vec![EMPTY],
            lobes: vec![Vec::new()],
            turn: TURN * (high - low).length(),
            lights: lights.len(),
        };
        builder.fill(0, &mut items);
        Self { nodes: builder.nodes, lobes: builder.lobes.concat() }
    }
}

impl Item {
    fn new(index: u32, proxy: RectProxy, lobes: Vec<FieldLobe>) -> Self {
        let rectangle = proxy.rectangle;
        let reach = rectangle.half_x * rectangle.tangent.abs()
            + rectangle.half_y * rectangle.normal.cross(rectangle.tangent).abs();
        let (low, high) = (rectangle.position - reach, rectangle.position + reach);
        Self { index, low, high, normal: rectangle.normal, lobes }
    }

    /// The place on one of the six axes.
    fn at(&self, axis: usize, turn: f32) -> f32 {
        if axis < 3 { 0.5 * (self.low[axis] + self.high[axis]) } else { turn * self.normal[axis - 3] }
    }
}

/// What a rectangle reflects of a light; its mirror direction is 0 where it is lit from behind.
fn lobe(light: &SceneLight, proxy: RectProxy, material: &Material) -> FieldLobe {
    let arriving = light_share(*light, proxy);
    let rectangle = proxy.rectangle;
    let incidence = rectangle.normal.dot(arriving.dir).max(0.0);
    let area = 4.0 * rectangle.half_x * rectangle.half_y;
    let reflected = |share: Vec3| incidence * luminance(share * arriving.irradiance);
    let both = |value: f32| Vec2::new(value, area * value);
    let square = rect_laplace_gloss(material.alpha).square;
    FieldLobe {
        mirror: if incidence > 0.0 { 2.0 * incidence * rectangle.normal - arriving.dir } else { Vec3::ZERO },
        spread: 1.0,
        glossy: both(reflected(material.f0)),
        diffuse: both(reflected(material.diffuse_albedo)),
        square: Vec2::splat(square),
    }
}

/// A node before it is filled in.
const EMPTY: FieldNode = FieldNode {
    low: Vec3::ZERO,
    first: 0,
    high: Vec3::ZERO,
    is_leaf: 0,
    axis: Vec3::Y,
    spread: -1.0,
    least: 0,
};

struct Builder {
    nodes: Vec<FieldNode>,
    lobes: Vec<Vec<FieldLobe>>,
    turn: f32,
    lights: usize,
}

impl Builder {
    /// Makes node `at` hold `items`.
    fn fill(&mut self, at: usize, items: &mut [Item]) {
        let (axis, spread) = cone(items.iter().map(|item| item.normal));
        let node = FieldNode {
            low: items.iter().fold(Vec3::INFINITY, |low, item| low.min(item.low)),
            high: items.iter().fold(Vec3::NEG_INFINITY, |high, item| high.max(item.high)),
            axis,
            spread,
            least: items.iter().map(|item| item.index).min().unwrap_or(0),
            ..EMPTY
        };
        self.lobes[at] = (0..self.lights).map(|light| joined(items, light)).collect();
        if let [item] = items {
            self.nodes[at] = FieldNode { first: item.index, is_leaf: 1, ..node };
            return;
        }
        let child = self.nodes.len();
        self.nodes.extend([EMPTY; 2]);
        self.lobes.extend([Vec::new(), Vec::new()]);
        self.nodes[at] = FieldNode { first: child as u32, ..node };
        let axis = self.longest(items);
        let (half, turn) = (items.len() / 2, self.turn);
        items.select_nth_unstable_by(half, |a, b| a.at(axis, turn).total_cmp(&b.at(axis, turn)));
        let (left, right) = items.split_at_mut(half);
        self.fill(child, left);
        self.fill(child + 1, right);
    }

    /// The axis along which items are farthest apart.
    fn longest(&self, items: &[Item]) -> usize {
        let extent = |axis: &usize| {
            let places = items.iter().map(|item| item.at(*axis, self.turn));
            let (low, high) = places.fold((f32::MAX, f32::MIN), |(low, high), x| (low.min(x), high.max(x)));
            high - low
        };
        (0..6).max_by(|a, b| extent(a).total_cmp(&extent(b))).unwrap_or(0)
    }
}

/// The middle of directions, and the cosine of the greatest angle from it, a little less.
fn cone(directions: impl Iterator<Item = Vec3> + Clone) -> (Vec3, f32) {
    let Some(axis) = directions.clone().sum::<Vec3>().try_normalize() else { return (Vec3::Y, -1.0) };
    let least = directions.map(|dir| dir.dot(axis)).fold(1.0, f32::min);
    (axis, (least - 1e-6).max(-1.0))
}

/// The most that items reflect of a light.
fn joined(items: &[Item], light: usize) -> FieldLobe {
    let lobes = || items.iter().map(|item| item.lobes[light]);
    let (mirror, spread) = cone(lobes().map(|lobe| lobe.mirror).filter(|mirror| *mirror != Vec3::ZERO));
    lobes().fold(FieldLobe { mirror, spread, ..items[0].lobes[light] }, |all, lobe| FieldLobe {
        glossy: all.glossy.max(lobe.glossy),
        diffuse: all.diffuse.max(lobe.diffuse),
        square: Vec2::new(all.square.x.min(lobe.square.x), all.square.y.max(lobe.square.y)),
        ..all
    })
}
