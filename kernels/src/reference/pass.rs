//! Passes of the reference: one bounce by sampling, sample by sample and then pixel by pixel.
//!
//! A round is `samples` samples of every pixel: [`bounce_sample_pass`] draws them and asks for two shadow rays each,
//! [`crate::scene::bvh::shadow_pass`] answers, and [`bounce_mean_pass`] adds them to the pixels' means. Rounds may
//! follow each other without end; the standard errors say when to stop.

use crate::brdf::Material;
use crate::brdf::model::{glossy_part, surface_brdf_cosine, surface_transfer};
use crate::reference::one_bounce::{OneBounce, one_bounce_density, one_bounce_sample};
use crate::reference::random::random_pair;
use crate::reference::rectangle::{rectangle_intersect, rectangle_is_met};
use crate::reference::reflector::{
    Reflector, chosen, lit_part, mirroring_place, place_on_whole, reflector_drawn,
};
use crate::reference::running_mean::{RunningMean, luminance, running_mean_add};
use crate::scene::light::{Arriving, SceneLight, light_at, ray_to_light};
use crate::scene::texture::{SurfacePoint, is_behind_plane};
use crate::scene::{NOWHERE, SceneRay, Seen, Surface};
use lobe_codegen::prelude::*;

/// Which samples a round draws.
#[kernel]
pub struct BounceRound {
    /// The first one's index in every pixel.
    pub first: u32,
    /// How many a pixel.
    #[domain(1.0..=1024.0)]
    pub samples: u32,
}

/// What a sample contributes, by the lobe of the pixel's surface and by that of the reflecting one: linear RGB.
#[kernel]
pub struct BounceSample {
    /// Diffuse, of diffuse.
    pub diffuse_of_diffuse: Vec3,
    /// Diffuse, of glossy.
    pub diffuse_of_glossy: Vec3,
    /// Glossy, of diffuse.
    pub glossy_of_diffuse: Vec3,
    /// Glossy, of glossy.
    pub glossy_of_glossy: Vec3,
}

/// Whether a place on a surface's rectangle, in half extents from its middle, is on the surface.
///
/// A triangle has its base along the lower side of its rectangle, and its apex on the upper one.
#[kernel]
pub fn is_on_surface(surface: Surface, place: Vec2) -> bool {
    let rise = 0.5 * (place.y + 1.0);
    let left = -1.0 + rise * (surface.apex + 1.0);
    let right = 1.0 + rise * (surface.apex - 1.0);
    surface.apex > 1.5 || (place.x >= left && place.x <= right)
}

/// The integrand without the distance, by the lobes of both surfaces: the parts of
/// [`one_bounce_transfer`](super::one_bounce::one_bounce_transfer).
#[kernel]
pub fn one_bounce_parts(bounce: OneBounce, dir: Vec3) -> BounceSample {
    let normal = bounce.rectangle.normal;
    let all = surface_brdf_cosine(bounce.material, bounce.normal, dir, bounce.view);
    let glossy = surface_brdf_cosine(glossy_part(bounce.material), bounce.normal, dir, bounce.view);
    let from_all = surface_transfer(bounce.rectangle_material, normal, bounce.light, -dir);
    let from_glossy = surface_transfer(glossy_part(bounce.rectangle_material), normal, bounce.light, -dir);
    let diffuse = max(all - glossy, Vec3::ZERO);
    let from_diffuse = max(from_all - from_glossy, Vec3::ZERO);
    BounceSample {
        diffuse_of_diffuse: diffuse * from_diffuse,
        diffuse_of_glossy: diffuse * from_glossy,
        glossy_of_diffuse: glossy * from_diffuse,
        glossy_of_glossy: glossy * from_glossy,
    }
}

/// All parts of a sample times a colour.
#[kernel]
pub fn bounce_scaled(draw: BounceSample, scale: Vec3) -> BounceSample {
    BounceSample {
        diffuse_of_diffuse: scale * draw.diffuse_of_diffuse,
        diffuse_of_glossy: scale * draw.diffuse_of_glossy,
        glossy_of_diffuse: scale * draw.glossy_of_diffuse,
        glossy_of_glossy: scale * draw.glossy_of_glossy,
    }
}

/// A sample that contributes nothing.
#[kernel]
pub fn bounce_nothing() -> BounceSample {
    BounceSample {
        diffuse_of_diffuse: Vec3::ZERO,
        diffuse_of_glossy: Vec3::ZERO,
        glossy_of_diffuse: Vec3::ZERO,
        glossy_of_glossy: Vec3::ZERO,
    }
}

/// A ray that is not asked for.
#[kernel]
pub fn no_ray() -> SceneRay {
    SceneRay { origin: Vec3::ZERO, reach: 0.0, dir: Vec3::Z, leaving: NOWHERE, reaching: NOWHERE }
}

/// The samples of a round, a pixel's together, and two shadow rays for each: a pass.
///
/// Each sample is of one of `reflectors`, of what is lit of it. The reflecting surface counts as flat and of its mean
/// material; [`textured`](super::textured) puts that right.
#[kernel(workgroup_size(64))]
pub fn bounce_sample_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] seen: &[Seen],
    #[storage(0, 1)] points: &[SurfacePoint],
    #[storage(0, 2)] surfaces: &[Surface],
    #[storage(0, 3)] materials: &[Material],
    #[storage(0, 4)] lights: &[SceneLight],
    #[storage(0, 5)] reflectors: &[Reflector],
    #[storage(0, 6)] bounces: &mut [BounceSample],
    #[storage(0, 7)] shadow_rays: &mut [SceneRay],
    #[uniform(0, 8)] part: &BounceRound,
) {
    let i = id.x;
    if i >= bounces.len() as u32 {
        return;
    }
    let at = i / part.samples;
    let sample = part.first + i % part.samples;
    let pixel = seen[at as usize];
    let mut contribution = bounce_nothing();
    let mut to_light = no_ray();
    let mut to_surface = no_ray();
    let choice = random_pair(at, sample, 0);
    let met = chosen(choice.x, reflectors.len() as u32);
    let reflector = reflectors[reflector_drawn(reflectors[met as usize], met, choice.y) as usize];
    let light = lights[reflector.light as usize];
    if pixel.surface != NOWHERE && pixel.surface != reflector.surface {
        let own = surfaces[pixel.surface as usize];
        let surface = surfaces[reflector.surface as usize];
        let rectangle = lit_part(surface.rectangle, reflector.low, reflector.high);
        let aimed: Arriving = light_at(light, mirroring_place(rectangle, light, pixel.position));
        let mut point = SurfacePoint { material: materials[own.material as usize], normal: pixel.normal };
        if pixel.point_index != NOWHERE {
            point = points[pixel.point_index as usize];
        }
        let rectangle_material = materials[surface.material as usize];
        let bounce = OneBounce {
            position: pixel.position,
            normal: point.normal,
            view: pixel.view,
            material: point.material,
            rectangle,
            rectangle_material,
            light: aimed.dir,
        };
        let strategy = chosen(random_pair(at, sample, 1).x, 4);
        let dir = one_bounce_sample(bounce, strategy, random_pair(at, sample, 2));
        let meeting = rectangle_intersect(rectangle, pixel.position, dir);
        let on_whole = place_on_whole(meeting.xy(), reflector.low, reflector.high);
        let is_met = rectangle_is_met(meeting) && is_on_surface(surface, on_whole);
        if is_met && !is_behind_plane(pixel.normal, point.normal, dir) {
            let place = pixel.position + meeting.z * dir;
            let arriving = light_at(light, place);
            let lit = OneBounce {
                position: pixel.position,
                normal: point.normal,
                view: pixel.view,
                material: point.material,
                rectangle,
                rectangle_material,
                light: arriving.dir,
            };
            let density = max(one_bounce_density(bounce, dir, meeting.z), 1e-20);
            let weight = 1.0 / (reflector.share * density);
            contribution = bounce_scaled(one_bounce_parts(lit, dir), weight * arriving.irradiance);
            to_light = ray_to_light(place, surface.shape, arriving);
            to_surface = SceneRay {
                origin: pixel.position,
                reach: meeting.z,
                dir,
                leaving: own.shape,
                reaching: surface.shape,
            };
        }
    }
    bounces[i as usize] = contribution;
    shadow_rays[(2 * i) as usize] = to_light;
    shadow_rays[(2 * i + 1) as usize] = to_surface;
}

/// What of a sample counts: 1 or 0.
///
/// | `mode` | the light must reach the surface | the surface must see the pixel |
/// |---|---|---|
/// | 0 | yes | yes |
/// | 1 | no | no |
/// | 2 | yes | no |
/// | 3 | no | yes |
#[kernel]
pub fn bounce_share(mode: u32, is_lit: bool, is_seen: bool) -> f32 {
    let is_light_passing = is_lit || mode == 1 || mode == 3;
    let is_view_passing = is_seen || mode == 1 || mode == 2;
    select(0.0, 1.0, is_light_passing && is_view_passing)
}

/// Adds a round to the means, an invocation a pixel and mode of [`bounce_share`]: a pass.
///
/// `means` has for each the colours of the four parts of [`BounceSample`], `spreads` the luminance of all, of the
/// diffuse and of the glossy parts of the pixel's surface.
#[kernel(workgroup_size(64))]
pub fn bounce_mean_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] part: &BounceRound,
    #[storage(0, 1)] bounces: &[BounceSample],
    #[storage(0, 2)] visible: &[u32],
    #[storage(0, 3)] means: &mut [BounceSample],
    #[storage(0, 4)] spreads: &mut [RunningMean],
) {
    let i = id.x;
    if i >= means.len() as u32 {
        return;
    }
    let pixel = i / 4;
    let mode = i % 4;
    let mut mean = means[i as usize];
    let mut total = spreads[(3 * i) as usize];
    let mut diffuse = spreads[(3 * i + 1) as usize];
    let mut glossy = spreads[(3 * i + 2) as usize];
    for s in 0..part.samples {
        let k = pixel * part.samples + s;
        let share = bounce_share(mode, visible[(2 * k) as usize] == 1, visible[(2 * k + 1) as usize] == 1);
        let draw = bounce_scaled(bounces[k as usize], Vec3::splat(share));
        let of_diffuse = luminance(draw.diffuse_of_diffuse + draw.diffuse_of_glossy);
        let of_glossy = luminance(draw.glossy_of_diffuse + draw.glossy_of_glossy);
        total = running_mean_add(total, of_diffuse + of_glossy);
        diffuse = running_mean_add(diffuse, of_diffuse);
        glossy = running_mean_add(glossy, of_glossy);
        let weight = 1.0 / total.count as f32;
        mean = BounceSample {
            diffuse_of_diffuse: mean.diffuse_of_diffuse
                + weight * (draw.diffuse_of_diffuse - mean.diffuse_of_diffuse),
            diffuse_of_glossy: mean.diffuse_of_glossy
                + weight * (draw.diffuse_of_glossy - mean.diffuse_of_glossy),
            glossy_of_diffuse: mean.glossy_of_diffuse
                + weight * (draw.glossy_of_diffuse - mean.glossy_of_diffuse),
            glossy_of_glossy: mean.glossy_of_glossy
                + weight * (draw.glossy_of_glossy - mean.glossy_of_glossy),
        };
    }
    means[i as usize] = mean;
    spreads[(3 * i) as usize] = total;
    spreads[(3 * i + 1) as usize] = diffuse;
    spreads[(3 * i + 2) as usize] = glossy;
}
