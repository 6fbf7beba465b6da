//! What depends on the reflector and its light alone, and on the pixel and the rectangle alone.

use crate::rect::Rectangle;
use lobe_codegen::prelude::*;

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
    pub light_dir: Vec3,
    /// Irradiance on a plane that faces the light.
    #[domain(0.0..=1e3)]
    pub irradiance: f32,
}

/// A glossy pixel that sees the rectangle.
#[kernel]
pub struct Receiver {
    /// Where it is.
    #[domain(-100.0..=100.0)]
    pub position: Vec3,
    /// Unit normal.
    #[domain(unit)]
    pub normal: Vec3,
    /// Unit direction to the viewer.
    #[domain(unit)]
    pub view_dir: Vec3,
    /// Roughness `alpha` of its distribution.
    #[domain(0.02..=1.0)]
    pub alpha: f32,
    /// Value of its reflectance without the distribution.
    #[domain(0.0..=10.0)]
    pub reflectance: f32,
}

/// Constants of a GGX distribution.
#[kernel]
pub struct Gloss {
    /// `alpha²`, clamped.
    pub square: f32,
    /// `4 (1 - alpha²)`.
    pub weight: f32,
}

/// The reflector in the frame of its rectangle; once for each rectangle and light.
#[kernel]
pub struct LaplaceReflector {
    /// Unit direction to the light in the frame.
    pub light: Vec3,
    /// Its distribution.
    pub gloss: Gloss,
    /// Strength with which the mirror direction of the light attracts the start.
    pub pull: f32,
}

/// The pixel in the frame of a rectangle; once for each pixel and rectangle.
#[kernel]
pub struct LaplaceReceiver {
    /// The pixel from the middle of the rectangle.
    pub offset: Vec3,
    /// Unit normal.
    pub facing: Vec3,
    /// Unit direction to the viewer.
    pub view: Vec3,
    /// Cosine between them.
    pub cosine: f32,
    /// Its distribution.
    pub gloss: Gloss,
    /// Half extents, signed towards the corner that is highest above the pixel's horizon.
    pub corner: Vec2,
    /// Half extents.
    pub extent: Vec2,
}

/// Constants of the GGX distribution of roughness `alpha`, which is clamped to 0.002 ..= 0.98.
#[kernel]
pub fn rect_laplace_gloss(alpha: f32) -> Gloss {
    let m = clamp(alpha, 2e-3, 0.98);
    let square = m * m;
    Gloss { square, weight: 4.0 - 4.0 * square }
}

/// A direction in the frame of a rectangle.
#[kernel]
pub fn rect_laplace_turn(rectangle: Rectangle, bitangent: Vec3, dir: Vec3) -> Vec3 {
    Vec3::new(dot(rectangle.tangent, dir), dot(bitangent, dir), dot(rectangle.normal, dir))
}

/// What depends on the reflector and its light alone.
#[kernel]
pub fn rect_laplace_reflector(
    rectangle: Rectangle,
    bitangent: Vec3,
    alpha: f32,
    light_dir: Vec3,
) -> LaplaceReflector {
    let light = rect_laplace_turn(rectangle, bitangent, light_dir);
    let gloss = rect_laplace_gloss(alpha);
    LaplaceReflector { light, gloss, pull: 0.5 * gloss.square * light.z }
}

/// What depends on the pixel and the rectangle alone.
#[kernel]
pub fn rect_laplace_receiver(rectangle: Rectangle, bitangent: Vec3, receiver: Receiver) -> LaplaceReceiver {
    let facing = rect_laplace_turn(rectangle, bitangent, receiver.normal);
    LaplaceReceiver {
        offset: rect_laplace_turn(rectangle, bitangent, receiver.position - rectangle.position),
        facing,
        view: rect_laplace_turn(rectangle, bitangent, receiver.view_dir),
        cosine: dot(receiver.normal, receiver.view_dir),
        gloss: rect_laplace_gloss(receiver.alpha),
        corner: Vec2::new(
            select(-rectangle.half_x, rectangle.half_x, facing.x > 0.0),
            select(-rectangle.half_y, rectangle.half_y, facing.y > 0.0),
        ),
        extent: Vec2::new(rectangle.half_x, rectangle.half_y),
    }
}
