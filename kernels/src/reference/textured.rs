//! Samples over surfaces with a skin: passes between [`bounce_sample_pass`](super::pass::bounce_sample_pass) and the means.
//!
//! A sample is drawn as if the reflecting surface were flat and of its mean material. [`bounce_met_pass`] says where it meets
//! the surface, [`textured_point_pass`](crate::scene::point::textured_point_pass) what that is like there, and
//! [`bounce_textured_pass`] gives the sample what that reflects in place of the mean. They are left out where no surface has a
//! skin.

use crate::brdf::Material;
use crate::brdf::model::{glossy_part, surface_transfer};
use crate::reference::pass::{BounceRound, BounceSample};
use crate::reference::random::random_pair;
use crate::reference::reflector::{Reflector, chosen, reflector_drawn};
use crate::scene::texture::{SurfacePoint, is_behind_plane};
use crate::scene::{NOWHERE, SceneRay, Seen, Surface};
use lobe_codegen::prelude::*;

/// Where each sample of a round meets its reflecting surface, seen from its pixel: a pass.
///
/// The surface is drawn again by the same number; a sample whose rays are not asked for is nowhere.
#[kernel(workgroup_size(64))]
pub fn bounce_met_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 4)] part: &BounceRound,
    #[storage(0, 0)] surfaces: &[Surface],
    #[storage(0, 1)] reflectors: &[Reflector],
    #[storage(0, 2)] shadow_rays: &[SceneRay],
    #[storage(0, 3)] met: &mut [Seen],
) {
    let i = id.x;
    if i >= met.len() as u32 {
        return;
    }
    let sample = part.first + i % part.samples;
    let choice = random_pair(i / part.samples, sample, 0);
    let first = chosen(choice.x, reflectors.len() as u32);
    let surface = reflectors[reflector_drawn(reflectors[first as usize], first, choice.y) as usize].surface;
    let ray = shadow_rays[(2 * i + 1) as usize];
    met[i as usize] = Seen {
        position: ray.origin + ray.reach * ray.dir,
        surface: select(NOWHERE, surface, ray.reach > 0.0),
        normal: surfaces[surface as usize].rectangle.normal,
        point_index: NOWHERE,
        view: -ray.dir,
    };
}

/// The diffuse lobe of a material alone.
#[kernel]
pub fn diffuse_part(material: Material) -> Material {
    Material { diffuse_albedo: material.diffuse_albedo, f0: Vec3::ZERO, f90: 0.0, alpha: material.alpha }
}

/// How much more of one thing there is than of another, at most 1e30 times; 0 of nothing.
#[kernel]
pub fn times_as_much(one: Vec3, other: Vec3) -> Vec3 {
    min(one / max(other, Vec3::splat(1e-30)), Vec3::splat(1e30))
}

/// A sample with what its reflecting surface reflects at the point that it meets, in place of the surface's mean.
///
/// `L f(point) / f(mean)`, lobe by lobe
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `draw` | the sample, of the mean material | | |
/// | `mean` | that material | | |
/// | `plane` | unit normal of the surface's plane | sphere | 1 |
/// | `own` | what the surface is like at the point | | |
/// | `light`, `view` | unit directions to the light and to the pixel | sphere | 1 |
///
/// Returns the sample; nothing where the plane faces not both.
#[kernel]
pub fn bounce_of_point(
    draw: BounceSample,
    mean: Material,
    plane: Vec3,
    own: SurfacePoint,
    light: Vec3,
    view: Vec3,
) -> BounceSample {
    let of_mean = surface_transfer(diffuse_part(mean), plane, light, view);
    let of_point = surface_transfer(diffuse_part(own.material), own.normal, light, view);
    let glossy_of_mean = surface_transfer(glossy_part(mean), plane, light, view);
    let glossy_of_point = surface_transfer(glossy_part(own.material), own.normal, light, view);
    let is_dark = is_behind_plane(plane, own.normal, light) || is_behind_plane(plane, own.normal, view);
    let diffuse = select(times_as_much(of_point, of_mean), Vec3::ZERO, is_dark);
    let glossy = select(times_as_much(glossy_of_point, glossy_of_mean), Vec3::ZERO, is_dark);
    BounceSample {
        diffuse_of_diffuse: diffuse * draw.diffuse_of_diffuse,
        diffuse_of_glossy: glossy * draw.diffuse_of_glossy,
        glossy_of_diffuse: diffuse * draw.glossy_of_diffuse,
        glossy_of_glossy: glossy * draw.glossy_of_glossy,
    }
}

/// Gives samples over surfaces with a skin what these are like where they are met: a pass.
///
/// `met_points` has what the pass of points left of those of [`bounce_met_pass`].
#[kernel(workgroup_size(64))]
pub fn bounce_textured_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] surfaces: &[Surface],
    #[storage(0, 1)] materials: &[Material],
    #[storage(0, 2)] shadow_rays: &[SceneRay],
    #[storage(0, 3)] met: &[Seen],
    #[storage(0, 4)] met_points: &[SurfacePoint],
    #[storage(0, 5)] bounces: &mut [BounceSample],
) {
    let i = id.x;
    if i >= bounces.len() as u32 {
        return;
    }
    let place = met[i as usize];
    if place.surface != NOWHERE && place.point_index != NOWHERE {
        let mean = materials[surfaces[place.surface as usize].material as usize];
        let point = met_points[place.point_index as usize];
        let light = shadow_rays[(2 * i) as usize].dir;
        let draw = bounces[i as usize];
        bounces[i as usize] = bounce_of_point(draw, mean, place.normal, point, light, place.view);
    }
}
