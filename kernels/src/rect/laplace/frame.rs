//! What depends on the reflector and its light alone, and on the pixel and the rectangle alone.

use crate::rect::{GlossyReceiver, Rectangle};
use lobe_codegen::prelude::*;

/// 8/π².
#[kernel]
pub const EIGHT_OVER_PI_SQUARE: f32 = 0.81056946913870217156;

/// A glossy rectangle under one directional light.
#[kernel]
pub struct Reflector {
    /// Roughness `alpha` of its GGX distribution.
    #[domain(0.02..=1.0)]
    pub alpha: f32,
    /// Value of its reflectance without the distribution.
    #[domain(0.0..=10.0)]
    pub reflectance: f32,
    /// Unit direction to the light.
    #[domain(unit)]
    pub light: Vec3,
    /// Irradiance on a plane that faces the light.
    #[domain(0.0..=1e3)]
    pub irradiance: f32,
}

/// Constants of a distribution of roughness `alpha`.
#[kernel]
pub struct Gloss {
    /// `alpha²`, with `alpha` clamped to 0.002 ..= 0.98.
    pub square: f32,
    /// `1 - alpha²`.
    pub rest: f32,
}

/// A reflector in the frame of its rectangle: computed once for each rectangle and light.
#[kernel]
pub struct LaplaceReflector {
    /// Unit direction to the light, in the frame.
    pub light: Vec3,
    /// Its distribution.
    pub gloss: Gloss,
    /// Weight of the view's mirror direction where the search begins.
    pub pull: f32,
    /// `4 alpha²/π²` times the light's cosine.
    pub peak: f32,
}

/// A receiver in the frame of a rectangle: computed once for each pixel and rectangle, for any number of
/// lights.
#[kernel]
pub struct LaplaceReceiver {
    /// The pixel, from the rectangle's middle.
    pub offset: Vec3,
    /// Square of its height above the rectangle's plane.
    pub height2: f32,
    /// Unit normal.
    pub facing: Vec3,
    /// The viewer's direction, mirrored about the normal.
    pub mirror: Vec3,
    /// Cosine of the view.
    pub cosine: f32,
    /// The viewer's direction along the pixel's surface, by its two tangents.
    pub view: Vec2,
    /// Two tangents of the pixel's surface, `(xx, xy, facing.x)` and `(xy, yy, facing.y)`: xx, yy, xy.
    pub tangents: Vec3,
    /// Weight of the light's mirror direction where the search begins; that of `mirror` is the reflector's.
    pub pull: f32,
    /// Its distribution.
    pub gloss: Gloss,
    /// Half the rectangle's extents.
    pub extent: Vec2,
    /// Where the edges of low and high x are, from the foot of the pixel's perpendicular.
    pub edges_x: Vec2,
    /// Where the edges of low and high y are.
    pub edges_y: Vec2,
    /// The corner of the rectangle that is highest above the pixel's horizon.
    pub corner: Vec2,
    /// Height of that corner above the horizon plane.
    pub top: f32,
}

/// Constants of a distribution.
#[kernel]
pub fn rect_laplace_gloss(alpha: f32) -> Gloss {
    let clamped = clamp(alpha, 2e-3, 0.98);
    let square = clamped * clamped;
    Gloss { square, rest: 1.0 - square }
}

/// The second direction along a rectangle's sides: computed once for each rectangle.
#[kernel]
pub fn rect_laplace_bitangent(rectangle: Rectangle) -> Vec3 {
    cross(rectangle.normal, rectangle.tangent)
}

/// Components of a vector in the frame of a rectangle.
#[kernel]
pub fn rect_laplace_turn(rectangle: Rectangle, bitangent: Vec3, v: Vec3) -> Vec3 {
    Vec3::new(dot(rectangle.tangent, v), dot(bitangent, v), dot(rectangle.normal, v))
}

/// What depends on a reflector and its light alone.
#[kernel]
pub fn rect_laplace_reflector(
    rectangle: Rectangle,
    bitangent: Vec3,
    reflector: Reflector,
) -> LaplaceReflector {
    let light = rect_laplace_turn(rectangle, bitangent, reflector.light);
    let gloss = rect_laplace_gloss(reflector.alpha);
    let pull = 0.5 * gloss.square * light.z;
    LaplaceReflector { light, gloss, pull, peak: EIGHT_OVER_PI_SQUARE * pull }
}

/// What depends on a receiver and a rectangle alone.
#[kernel]
pub fn rect_laplace_receiver(
    rectangle: Rectangle,
    bitangent: Vec3,
    receiver: GlossyReceiver,
) -> LaplaceReceiver {
    let offset = rect_laplace_turn(rectangle, bitangent, receiver.position - rectangle.position);
    let facing = rect_laplace_turn(rectangle, bitangent, receiver.normal);
    let view = rect_laplace_turn(rectangle, bitangent, receiver.view);
    let cosine = dot(receiver.normal, receiver.view);
    let gloss = rect_laplace_gloss(receiver.alpha);
    // The mirror image of the frame that takes the third axis to the normal. It degenerates only where the
    // pixel faces away from the rectangle's plane, and then nothing arrives.
    let fold = 1.0 / max(1.0 - facing.z, 1e-6);
    let folded = fold * facing.xy();
    let tangents = Vec3::new(1.0 - folded.x * facing.x, 1.0 - folded.y * facing.y, -folded.x * facing.y);
    // Of the sign of the normal, but for normals within 1e-4 of an axis: there a sign would be chance.
    let extent = Vec2::new(rectangle.half_x, rectangle.half_y);
    let corner = extent * clamp(1e4 * facing.xy(), Vec2::splat(-1.0), Vec2::splat(1.0));
    LaplaceReceiver {
        offset,
        height2: offset.z * offset.z,
        facing,
        mirror: (2.0 * cosine) * facing - view,
        cosine,
        view: view.xy() + (view.z - fold * (cosine - facing.z * view.z)) * facing.xy(),
        tangents,
        pull: gloss.square * cosine,
        gloss,
        extent,
        edges_x: Vec2::new(-rectangle.half_x - offset.x, rectangle.half_x - offset.x),
        edges_y: Vec2::new(-rectangle.half_y - offset.y, rectangle.half_y - offset.y),
        corner,
        top: facing.x * (corner.x - offset.x) + facing.y * (corner.y - offset.y) - facing.z * offset.z,
    }
}

/// Whether nothing can arrive: light, pixel or viewer behind a surface, or the rectangle behind the pixel.
#[kernel]
pub fn rect_laplace_is_dark(reflector: LaplaceReflector, receiver: LaplaceReceiver) -> bool {
    let least = 1e-6 * max(receiver.extent.x, receiver.extent.y);
    reflector.light.z <= 1e-3 || receiver.cosine <= 1e-3 || receiver.offset.z <= least || receiver.top <= 0.0
}
