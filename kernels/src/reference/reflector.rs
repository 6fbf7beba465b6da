//! Which light of which surface a sample is of, and where on it.

use crate::rect::Rectangle;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Pharr23, Vose91};
use crate::scene::light::SceneLight;
use lobe_codegen::prelude::*;

/// A surface and a light that shines on it, and how often samples are of them.
///
/// All of them together are the table of Vose: each is as likely as all others to be met, and then gives way to its
/// `stand_in` with the probability `1 - keep`.
#[kernel]
pub struct Reflector {
    /// Corner of what is lit of the surface's rectangle, in half extents from its middle.
    #[domain(-1.0..=1.0)]
    pub low: Vec2,
    /// The opposite corner.
    #[domain(-1.0..=1.0)]
    pub high: Vec2,
    /// Which surface.
    pub surface: u32,
    /// Which light.
    pub light: u32,
    /// Which reflector stands in for this one.
    pub stand_in: u32,
    /// Probability of staying with this one.
    #[domain(0.0..=1.0)]
    pub keep: f32,
    /// Share of all samples that are of this one.
    #[domain(1e-8..=1.0)]
    pub share: f32,
}

/// Which of several things a uniform number chooses.
#[kernel]
pub fn chosen(u: f32, count: u32) -> u32 {
    min((u * count as f32) as u32, count - 1)
}

/// Which reflector is drawn, where the `met`-th is met.
///
/// Source: [Vose91].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `reflector` | the one that is met | | |
/// | `met` | its index | | 1 |
/// | `u` | a uniform number | 0 ..= 1 - 2^-24 | 1 |
///
/// Returns the index of the one that is drawn.
#[kernel]
pub fn reflector_drawn(reflector: Reflector, met: u32, u: f32) -> u32 {
    select(reflector.stand_in, met, u < reflector.keep)
}

/// What is lit of a surface's rectangle.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `rectangle` | all of it | | m |
/// | `low`, `high` | corners of what is lit, in half extents from the middle | -1 ..= 1 | 1 |
///
/// Returns that part, a rectangle in the same plane.
#[kernel]
pub fn lit_part(rectangle: Rectangle, low: Vec2, high: Vec2) -> Rectangle {
    let middle = 0.5 * (low + high);
    let across = cross(rectangle.normal, rectangle.tangent);
    let x = middle.x * rectangle.half_x;
    let y = middle.y * rectangle.half_y;
    Rectangle {
        position: rectangle.position + x * rectangle.tangent + y * across,
        normal: rectangle.normal,
        tangent: rectangle.tangent,
        half_x: 0.5 * (high.x - low.x) * rectangle.half_x,
        half_y: 0.5 * (high.y - low.y) * rectangle.half_y,
    }
}

/// Where on all of a rectangle a place is that lies on its lit part, both in half extents from their middles.
#[kernel]
pub fn place_on_whole(place: Vec2, low: Vec2, high: Vec2) -> Vec2 {
    0.5 * (low + high) + 0.5 * (high - low) * place
}

/// Where a rectangle mirrors a near light to a position, or what of the rectangle is nearest to there.
///
/// `y = (h_x f_l + h_l f_x)/(h_x + h_l)`, of position and light the heights `h` over the plane and the feet `f` on it
/// Source: [Pharr23] section 9.3.1, the reflection's law.
///
/// Most light of a glossy rectangle comes from about there, so samples that take the light's direction from it are densest
/// where the light is. Of a distant light the direction is the same everywhere: the middle will do.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `rectangle` | the rectangle | | m |
/// | `light` | the light | | |
/// | `position` | the position | -100 ..= 100 | m |
///
/// Returns a point of the rectangle.
#[kernel]
pub fn mirroring_place(rectangle: Rectangle, light: SceneLight, position: Vec3) -> Vec3 {
    if light.is_spot == 1 {
        let across = cross(rectangle.normal, rectangle.tangent);
        let to_position = position - rectangle.position;
        let to_light = light.position - rectangle.position;
        let height = max(dot(to_position, rectangle.normal), 0.0);
        let light_height = max(dot(to_light, rectangle.normal), 0.0);
        let place = (height * to_light + light_height * to_position) / max(height + light_height, 1e-6);
        let x = clamp(dot(place, rectangle.tangent), -rectangle.half_x, rectangle.half_x);
        let y = clamp(dot(place, across), -rectangle.half_y, rectangle.half_y);
        rectangle.position + x * rectangle.tangent + y * across
    } else {
        rectangle.position
    }
}
