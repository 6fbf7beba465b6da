//! A tree over rectangles, by which a light-field texture is made without trying each of them at each texel.
//!
//! A node has a box around its rectangles, and a cone around their normals; for each light a cone around the directions in
//! which they mirror it, and the most that one of them reflects. From these follows what no rectangle of the node exceeds at
//! a texel, and the node is passed over where that is less than the last weight of the texel's list. The lists are those of
//! [`field_pass`](super::field::field_pass), which tries all, as long as the bound holds:
//!
//! - diffuse: the form factor is at most `A cos cos / (π d²)`, and at most 1;
//! - glossy: [`rect_laplace_matt`](crate::rect::laplace::rect_laplace_matt) is `4 D(h)` at a spot of the rectangle times at
//!   most π/2, and about `D A cos cos / d²` where it is small; the half vector is at least half as far from the normal as
//!   the direction to the texel is from the mirror direction. By how much the closed form exceeds that is not proved:
//!   [`FIELD_EXCESS`] is taken for it.

use crate::brdf::Material;
use crate::constants::PI;
use crate::rect::field::{
    FIELD_LIST, FIELD_TEXEL, FieldRanks, FieldSettings, field_middle, field_ranked, field_weight,
};
use crate::rect::pass::{RectProxy, light_share};
use crate::scene::light::SceneLight;
use crate::scene::{NOWHERE, Surface};
use lobe_codegen::prelude::*;

/// Nodes that wait while another is looked into: the length of `waiting` below. A tree of depth `d` needs `d + 1`.
#[kernel]
pub const FIELD_DEPTH: u32 = 32;

/// By how much the closed form may exceed density times projected solid angle.
///
/// In a box of 1024 small squares 1 was enough; the rest is for large rectangles that the horizon cuts.
#[kernel]
pub const FIELD_EXCESS: f32 = 4.0;

/// By how much cosines are raised, so that no rounding makes dark what is lit.
#[kernel]
pub const FIELD_SLACK: f32 = 1e-3;

/// A node: a box around rectangles, and what they have in common.
#[kernel]
pub struct FieldNode {
    /// Its least corner.
    #[domain(-100.0..=100.0)]
    pub low: Vec3,
    /// The rectangle of a leaf; of an inner node, the first of its two children, which are neighbours.
    pub first: u32,
    /// Its greatest corner.
    #[domain(-100.0..=100.0)]
    pub high: Vec3,
    /// 1 for a leaf, else 0.
    pub is_leaf: u32,
    /// Middle of the normals.
    #[domain(unit)]
    pub axis: Vec3,
    /// Cosine of the greatest angle from it to a normal.
    #[domain(-1.0..=1.0)]
    pub spread: f32,
    /// The least index of a rectangle.
    pub least: u32,
}

/// What the rectangles of a node reflect of a light, at most.
#[kernel]
pub struct FieldLobe {
    /// Middle of the mirror directions.
    #[domain(unit)]
    pub mirror: Vec3,
    /// Cosine of the greatest angle from it to one of them.
    #[domain(-1.0..=1.0)]
    pub spread: f32,
    /// Luminance of what the glossy lobes reflect, and that times the area.
    #[domain(0.0..=1e4)]
    pub glossy: Vec2,
    /// The same of the radiosity of the diffuse lobes.
    #[domain(0.0..=1e4)]
    pub diffuse: Vec2,
    /// The least and the greatest squared roughness.
    #[domain(4e-6..=1.0)]
    pub square: Vec2,
}

/// A node as a texel sees it.
#[kernel]
pub struct FieldView {
    /// Unit direction from the node's middle to the texel.
    pub dir: Vec3,
    /// Cosine and sine of the angle around it in which the box is.
    pub cone: Vec2,
    /// Product of both cosines over the squared distance, at most.
    pub density: f32,
    /// 1 if some of the box may be seen, else 0.
    pub is_seen: u32,
}

/// Cosine and sine of an angle in 0 ..= π, by its cosine.
#[kernel]
pub fn field_angle(cosine: f32) -> Vec2 {
    let clamped = clamp(cosine, -1.0, 1.0);
    Vec2::new(clamped, sqrt(max(1.0 - clamped * clamped, 0.0)))
}

/// The sum of two angles by cosine and sine, at most π.
#[kernel]
pub fn field_wider(a: Vec2, b: Vec2) -> Vec2 {
    let sine = a.y * b.x + a.x * b.y;
    let sum = Vec2::new(a.x * b.x - a.y * b.y, sine);
    select(Vec2::new(-1.0, 0.0), sum, sine >= 0.0)
}

/// Cosine of the angle by which `a` exceeds `b`; 1 where it does not.
#[kernel]
pub fn field_excess(a: Vec2, b: Vec2) -> f32 {
    select(a.x * b.x + a.y * b.y, 1.0, a.x >= b.x)
}

/// A node as a texel sees it.
#[kernel]
pub fn field_view(node: FieldNode, position: Vec3, normal: Vec3) -> FieldView {
    let offset = 0.5 * (node.low + node.high) - position;
    let half = 0.5 * (node.high - node.low);
    let outside = max(abs(offset) - half, Vec3::splat(0.0));
    let near = max(dot(outside, outside), 1e-12);
    let far = max(dot(offset, offset), 1e-12);
    let dir = -(inverse_sqrt(far) * offset);
    // The box is in a ball; one that the texel is in is seen every way.
    let share = min(1.002 * dot(half, half) / far, 1.0);
    let around = Vec2::new(sqrt(1.0 - share), sqrt(share));
    let cone = select(around, Vec2::new(-1.0, 0.0), share >= 1.0);
    let top = dot(offset, normal) + dot(half, abs(normal));
    let receiving = field_excess(field_angle(-dot(dir, normal)), cone);
    let reflecting =
        field_excess(field_angle(dot(dir, node.axis)), field_wider(field_angle(node.spread), cone));
    let cosines = (max(receiving, 0.0) + FIELD_SLACK) * (max(reflecting, 0.0) + FIELD_SLACK);
    let is_above = top > -(1e-4 * sqrt(far)) && receiving > -FIELD_SLACK;
    let is_seen = select(0_u32, 1_u32, is_above && reflecting > -FIELD_SLACK);
    FieldView { dir, cone, density: cosines / near, is_seen }
}

/// What no rectangle of a node exceeds at a texel, of one light: a bound of [`field_weight`].
#[kernel]
pub fn field_bound(lobe: FieldLobe, view: FieldView) -> f32 {
    let off = field_excess(
        field_angle(dot(view.dir, lobe.mirror)),
        field_wider(field_angle(lobe.spread), view.cone),
    );
    // Squared cosine and sine of half the angle, the latter lessened by what rounding may add.
    let cosine2 = max(0.5 + 0.5 * off, 1e-6);
    let sine2 = max(0.5 - 0.5 * off - 1e-6, 0.0);
    let square = clamp(sine2 / cosine2, lobe.square.x, lobe.square.y);
    let root = square * cosine2 + sine2;
    let density = square / (PI * (root * root));
    let glossy = min(FIELD_EXCESS * view.density * lobe.glossy.y, 2.0 * PI * lobe.glossy.x) * density;
    let diffuse = min(view.density * lobe.diffuse.y / PI, lobe.diffuse.x);
    1.02 * (glossy + diffuse)
}

/// [`field_pass`](super::field::field_pass) by the tree: the same lists, as long as no bound is exceeded. A pass.
///
/// Of the two children of a node that with the higher bound is looked into first. Of equal weights the rectangle with the
/// lower index is the brighter one.
#[kernel(workgroup_size(64))]
pub fn field_tree_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] field_settings: &FieldSettings,
    #[storage(0, 1)] surfaces: &[Surface],
    #[storage(0, 2)] proxies: &[RectProxy],
    #[storage(0, 3)] materials: &[Material],
    #[storage(0, 4)] lights: &[SceneLight],
    #[storage(0, 5)] field_nodes: &[FieldNode],
    #[storage(0, 6)] field_lobes: &[FieldLobe],
    #[storage(0, 7)] field: &mut [u32],
) {
    let i = id.x + field_settings.texel;
    if i >= field.len() as u32 / FIELD_TEXEL {
        return;
    }
    let side = field_settings.side;
    let rectangle = surfaces[(i / (side * side)) as usize].rectangle;
    let position = field_middle(side, i, rectangle);
    let last = field_settings.most - 1;
    let mut ranks = FieldRanks { weights: [-1.0_f32; 8], ids: [NOWHERE; 8] };
    let mut waiting = [0_u32; 32];
    let mut bounds = [0.0_f32; 32];
    bounds[0] = 1e30;
    let mut count = 1_u32;
    while count > 0 {
        // Invocations that run together find a leaf each, and weigh them together: that is what takes time.
        let mut leaf = NOWHERE;
        let least = ranks.weights[last as usize];
        while count > 0 && leaf == NOWHERE {
            count -= 1;
            let node = field_nodes[waiting[count as usize] as usize];
            let bound = bounds[count as usize];
            if bound > least || (bound == least && node.least <= ranks.ids[last as usize]) {
                if node.is_leaf == 1 {
                    leaf = node.first;
                } else {
                    let mut found = [0.0_f32; 2];
                    for child in 0..2_u32 {
                        let at = node.first + child;
                        let view = field_view(field_nodes[at as usize], position, rectangle.normal);
                        if view.is_seen == 1 {
                            let mut sum = 0.0;
                            for l in 0..lights.len() as u32 {
                                let lobe = field_lobes[(at * lights.len() as u32 + l) as usize];
                                sum += field_bound(lobe, view);
                            }
                            found[child as usize] = sum;
                        }
                    }
                    let higher = select(0_u32, 1_u32, found[1] > found[0]);
                    for turn in 0..2_u32 {
                        let child = select(1 - higher, higher, turn == 1);
                        if found[child as usize] >= least {
                            waiting[count as usize] = node.first + child;
                            bounds[count as usize] = found[child as usize];
                            count += 1;
                        }
                    }
                }
            }
        }
        if leaf != NOWHERE {
            let proxy = proxies[leaf as usize];
            let material = materials[proxy.material as usize];
            let mut weight = 0.0;
            for l in 0..lights.len() as u32 {
                let arriving = light_share(lights[l as usize], proxy);
                weight += field_weight(proxy, material, arriving, position, rectangle.normal);
            }
            ranks = field_ranked(ranks, field_settings.most, leaf, weight);
        }
    }
    let begin = i * FIELD_TEXEL + field_settings.list;
    for place in 0..FIELD_LIST {
        field[(begin + place) as usize] = ranks.ids[place as usize];
    }
}
