//! What is seen in a texel of a map.

use crate::brdf::Material;
use crate::constants::TWO_PI;
use crate::reference::light::spot_irradiance;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::DachsbacherStamminger05;
use crate::rsm::view::{MapView, map_cone};
use crate::scene::light::SceneLight;
use crate::scene::texture::SurfacePoint;
use crate::scene::{NOWHERE, Seen, Surface};
use lobe_codegen::prelude::*;

/// A texel of a map: a virtual point light.
#[kernel]
pub struct MapPoint {
    /// Where it is.
    pub position: Vec3,
    /// Its surface; [`NOWHERE`] if it has none.
    pub surface: u32,
    /// Unit normal.
    #[domain(unit)]
    pub normal: Vec3,
    /// How much of the surface the texel shows, in m².
    #[domain(0.0..=1e6)]
    pub area: f32,
    /// Unit direction to whom the map is of.
    #[domain(unit)]
    pub dir: Vec3,
    /// Linear RGB power that falls through the texel, in W.
    #[domain(0.0..=1e6)]
    pub flux: Vec3,
    /// What it is of.
    pub material: Material,
}

/// A texel that shows nothing.
#[kernel]
pub fn map_nothing() -> MapPoint {
    MapPoint {
        position: Vec3::ZERO,
        surface: NOWHERE,
        normal: Vec3::Z,
        area: 0.0,
        dir: Vec3::Z,
        flux: Vec3::ZERO,
        material: Material { diffuse_albedo: Vec3::ZERO, f0: Vec3::ZERO, f90: 0.0, alpha: 1.0 },
    }
}

/// How much of a surface is behind a texel, from its area across the view; the cosine counts as 0.01 at least.
#[kernel]
pub fn area_behind(across: f32, normal: Vec3, dir: Vec3) -> f32 {
    across / max(abs(dot(normal, dir)), 0.01)
}

/// Power and area of a light's texel.
#[kernel]
pub struct MapBeam {
    /// Linear RGB power, in W.
    pub flux: Vec3,
    /// Area across the light's direction, in m².
    pub across: f32,
}

/// What falls through a texel of a light's map.
///
/// Of a directional light irradiance times area; of a cone intensity times solid angle.
/// Source: [DachsbacherStamminger05] section 3.1.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `view`, `light` | the map | | |
/// | `dir` | unit direction to the light | sphere | 1 |
/// | `square` | squared distance to it; of a cone | 0 ..= 1e8 | m² |
///
/// Returns power, and the area of the texel at this distance.
#[kernel]
pub fn map_beam(view: MapView, light: SceneLight, dir: Vec3, square: f32) -> MapBeam {
    let texels = view.width as f32 * view.height as f32;
    if light.is_spot == 1 {
        let solid_angle = TWO_PI * map_cone(light) / texels;
        let share = spot_irradiance(light.axis, light.outer, light.blend, dir, 1.0);
        MapBeam { flux: solid_angle * share * light.strength, across: solid_angle * square }
    } else {
        let across = 4.0 * sqrt(dot(view.right, view.right) * dot(view.up, view.up)) / texels;
        MapBeam { flux: across * light.strength, across }
    }
}

/// The point of what is seen in a texel.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `seen` | what is seen | | |
/// | `skin` | what its surface is like there | | |
/// | `beam` | what falls through the texel | | |
#[kernel]
pub fn point_of_seen(seen: Seen, skin: SurfacePoint, beam: MapBeam) -> MapPoint {
    MapPoint {
        position: seen.position,
        surface: seen.surface,
        normal: skin.normal,
        area: area_behind(beam.across, seen.normal, seen.view),
        dir: seen.view,
        flux: beam.flux,
        material: skin.material,
    }
}

/// The points of what a light sees: a pass.
///
/// `seen` and `points` are of the light's rays, not of the camera's.
#[kernel(workgroup_size(64))]
pub fn map_point_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] map: &MapView,
    #[storage(0, 1)] seen: &[Seen],
    #[storage(0, 2)] surfaces: &[Surface],
    #[storage(0, 3)] materials: &[Material],
    #[storage(0, 4)] points: &[SurfacePoint],
    #[storage(0, 5)] lights: &[SceneLight],
    #[storage(0, 6)] map_points: &mut [MapPoint],
) {
    let i = id.x;
    if i >= map_points.len() as u32 {
        return;
    }
    let texel = seen[i as usize];
    let mut found = map_nothing();
    if texel.surface != NOWHERE {
        let material = materials[surfaces[texel.surface as usize].material as usize];
        let mut skin = SurfacePoint { material, normal: texel.normal };
        if texel.point_index != NOWHERE {
            skin = points[texel.point_index as usize];
        }
        let light = lights[map.light as usize];
        let offset = light.position - texel.position;
        found = point_of_seen(texel, skin, map_beam(*map, light, texel.view, dot(offset, offset)));
    }
    map_points[i as usize] = found;
}

/// What of a picture is taken for a map of the camera.
#[kernel]
pub struct SeenMap {
    /// Where the camera is.
    #[domain(-1e4..=1e4)]
    pub origin: Vec3,
    /// Solid angle of a pixel in the middle, in sr.
    #[domain(1e-8..=1.0)]
    pub solid_angle: f32,
}

/// The points that pixels make, each of power 1: a pass.
#[kernel(workgroup_size(64))]
pub fn seen_point_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] camera_map: &SeenMap,
    #[storage(0, 1)] seen: &[Seen],
    #[storage(0, 2)] surfaces: &[Surface],
    #[storage(0, 3)] materials: &[Material],
    #[storage(0, 4)] points: &[SurfacePoint],
    #[storage(0, 5)] map_points: &mut [MapPoint],
) {
    let i = id.x;
    if i >= map_points.len() as u32 {
        return;
    }
    let pixel = seen[i as usize];
    let mut found = map_nothing();
    if pixel.surface != NOWHERE {
        let material = materials[surfaces[pixel.surface as usize].material as usize];
        let mut skin = SurfacePoint { material, normal: pixel.normal };
        if pixel.point_index != NOWHERE {
            skin = points[pixel.point_index as usize];
        }
        let offset = pixel.position - camera_map.origin;
        let across = camera_map.solid_angle * dot(offset, offset);
        found = point_of_seen(pixel, skin, MapBeam { flux: Vec3::ONE, across });
    }
    map_points[i as usize] = found;
}
