//! Rays through the texels of a light's map.

use crate::brdf::sampling::{circle_of_turn, orthonormal_frame, sine_of_turn};
use crate::constants::INVERSE_PI;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{DachsbacherStamminger05, ShirleyChiu97};
use crate::scene::light::SceneLight;
use crate::scene::{NOWHERE, SceneRay};
use lobe_codegen::prelude::*;

/// What a light's map shows.
#[kernel]
pub struct MapView {
    /// The middle of a directional light's map, before everything that it can meet; of any map, where positions are counted from.
    #[domain(-1e4..=1e4)]
    pub origin: Vec3,
    /// Texels of a row.
    #[domain(1.0..=1024.0)]
    pub width: u32,
    /// From the middle to the middle of the right side, for a directional light.
    #[domain(-1e4..=1e4)]
    pub right: Vec3,
    /// Rows.
    #[domain(1.0..=1024.0)]
    pub height: u32,
    /// From the middle to the middle of the upper side, for a directional light.
    #[domain(-1e4..=1e4)]
    pub up: Vec3,
    /// Index of the light.
    pub light: u32,
    /// Where in its texel a ray goes through, from the left and from the top: 0.5 is the middle.
    #[domain(0.0..=1.0)]
    pub place: Vec2,
}

/// A square's point on the disk of radius 1, areas in proportion.
///
/// Source: [ShirleyChiu97].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `p` | the point | -1 ..= 1 | 1 |
///
/// Returns the direction from the middle, as a turn 0 ..= 1, and the radius. Concentric squares become circles.
#[kernel]
pub fn concentric_disk(p: Vec2) -> Vec2 {
    let is_wide = abs(p.x) > abs(p.y);
    let radius = select(p.y, p.x, is_wide);
    let size = max(abs(radius), 1e-20);
    let ratio = select(p.x, p.y, is_wide) / select(size, -size, radius < 0.0);
    let eighths = 0.125 * ratio;
    let turn = select(0.25 - eighths, eighths, is_wide) + select(0.0, 0.5, radius < 0.0);
    Vec2::new(turn + select(0.0, 1.0, turn < 0.0), abs(radius))
}

/// The ray of a directional light or a cone through a point of its map.
///
/// A directional light's are parallel; a cone's directions fill it so that equal squares have equal solid angles
/// ([`concentric_disk`], with `cos = 1 - (1 - cos outer) r²`).
/// Source: [DachsbacherStamminger05] section 3.1; the cone's map is our own, since rays need no projection.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `view`, `light` | the map | | |
/// | `p` | the point, from the middle to the right and up | -1 ..= 1 | 1 |
///
/// Returns the ray, of reach 1e30.
#[kernel]
pub fn map_ray(view: MapView, light: SceneLight, p: Vec2) -> SceneRay {
    if light.is_spot == 1 {
        let disk = concentric_disk(p);
        let fall = map_cone(light) * (disk.y * disk.y);
        let circle = sqrt(fall * max(2.0 - fall, 0.0)) * circle_of_turn(disk.x);
        let frame = orthonormal_frame(light.axis);
        let towards = circle.x * frame.x + circle.y * frame.y + (1.0 - fall) * frame.z;
        let dir = towards * inverse_sqrt(dot(towards, towards));
        SceneRay { origin: light.position, reach: 1e30, dir, leaving: NOWHERE, reaching: NOWHERE }
    } else {
        let origin = view.origin + (p.x * view.right + p.y * view.up);
        SceneRay { origin, reach: 1e30, dir: -light.axis, leaving: NOWHERE, reaching: NOWHERE }
    }
}

/// Solid angle of a cone's light over 2π, `1 - cos outer`.
///
/// By the half angle, `2 sin²(outer/2)`; [`sine_of_turn`] is as good on every driver, where `sin` is not.
#[kernel]
pub fn map_cone(light: SceneLight) -> f32 {
    let half = sine_of_turn(0.25 * INVERSE_PI * light.outer);
    2.0 * (half * half)
}

/// Rays of all texels, row by row from the top: a pass.
#[kernel(workgroup_size(64))]
pub fn map_ray_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] map: &MapView,
    #[storage(0, 1)] lights: &[SceneLight],
    #[storage(0, 2)] rays: &mut [SceneRay],
) {
    let i = id.x;
    if i >= rays.len() as u32 {
        return;
    }
    let column = (i % map.width) as f32 + map.place.x;
    let row = (i / map.width) as f32 + map.place.y;
    let p = Vec2::new(2.0 * column / map.width as f32 - 1.0, 1.0 - 2.0 * row / map.height as f32);
    rays[i as usize] = map_ray(*map, lights[map.light as usize], p);
}
