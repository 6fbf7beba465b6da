//! A virtual light, and what it sends to the camera by way of a surface.

use crate::asg::Asg;
use crate::brdf::Material;
use crate::brdf::lobe::asg_ndf_warp;
use crate::brdf::model::{glossy_part, lambert_brdf, microfacet_reflectance, surface_brdf_cosine};
use crate::filter::moments_to_lobe;
use crate::reference::pass::{BounceSample, bounce_nothing, bounce_scaled};
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Hasan09, Keller97, Tokuyoshi15};
use crate::rsm::mean::MapMean;
use crate::rsm::point::MapPoint;
use crate::scene::Seen;
use crate::scene::texture::SurfacePoint;
use crate::sg::{Sg, sg_integral};
use crate::vsgl::{
    vsgl_pair_radiance, vsgl_pair_radiance_diffuse, vsgl_smoothness, vsgl_transfer_sharpness, vsl_cone,
    vsl_radius,
};
use lobe_codegen::prelude::*;

/// A virtual spherical light whose lobes are spherical Gaussians.
#[kernel]
pub struct VirtualLight {
    /// Its middle.
    #[domain(-1e4..=1e4)]
    pub position: Vec3,
    /// Its radius, in m.
    #[domain(0.0..=1e4)]
    pub radius: f32,
    /// Mean normal of what it stands for, of length 1 at most.
    #[domain(unit)]
    pub normal: Vec3,
    /// Sharpness of the glossy lobe.
    #[domain(0.0..=1e6)]
    pub sharpness: f32,
    /// Unit axis of the glossy lobe, the way that it sends.
    #[domain(unit)]
    pub axis: Vec3,
    /// Index of the texel that was drawn.
    pub texel: u32,
    /// Intensity of the diffuse lobe without the cosine, linear RGB, in W/sr.
    #[domain(0.0..=1e6)]
    pub diffuse: Vec3,
    /// By how much what the texel sends is to be multiplied.
    #[domain(0.0..=1e30)]
    pub weight: f32,
    /// That of the glossy lobe along its axis.
    #[domain(0.0..=1e6)]
    pub specular: Vec3,
}

/// The surface that a virtual light shines on, and how it is seen.
#[kernel]
pub struct Receiver {
    /// Where it is.
    #[domain(-1e4..=1e4)]
    pub position: Vec3,
    /// Unit normal.
    #[domain(unit)]
    pub normal: Vec3,
    /// Unit direction to the camera.
    #[domain(unit)]
    pub view: Vec3,
    /// Its surface.
    pub material: Material,
}

/// The receiver that is seen in a pixel.
#[kernel]
pub fn receiver_of_seen(seen: Seen, skin: SurfacePoint) -> Receiver {
    Receiver { position: seen.position, normal: skin.normal, view: seen.view, material: skin.material }
}

/// The light that stands for the texels of a mean.
///
/// Source: [Tokuyoshi15] section 3.2: radius of the positions' variance, lobe of the mean direction.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `mean` | the texels | | |
/// | `origin` | where positions are counted from | -1e4 ..= 1e4 | m |
/// | `texel` | index of the one that was drawn | | |
/// | `weight` | by how much it counts | 0 ..= 1e30 | 1 |
///
/// Returns the light; one of nothing sends nothing.
#[kernel]
pub fn light_of_mean(mean: MapMean, origin: Vec3, texel: u32, weight: f32) -> VirtualLight {
    let lobe = moments_to_lobe(mean.lobes, Vec3::ZERO);
    let share = weight / max(mean.cover, 1e-6);
    VirtualLight {
        position: origin + mean.positions.mean,
        radius: vsl_radius(mean.positions.spread),
        normal: mean.normal / max(length(mean.normal), 1e-25),
        sharpness: min(lobe.sharpness, 1e6),
        axis: lobe.axis,
        texel,
        diffuse: share * mean.diffuse,
        weight,
        specular: (share / sg_integral(min(lobe.sharpness, 1e6))) * mean.specular,
    }
}

/// Where a virtual light is from a point.
#[kernel]
pub struct Apart {
    /// Unit direction to it.
    pub dir: Vec3,
    /// How far away it is, in m.
    pub dist: f32,
}

/// Where a virtual light is from a point; nearer than 1e-12 m counts as that far.
#[kernel]
pub fn apart(place: Vec3, position: Vec3) -> Apart {
    let offset = place - position;
    let square = max(dot(offset, offset), 1e-24);
    let reciprocal = inverse_sqrt(square);
    Apart { dir: offset * reciprocal, dist: square * reciprocal }
}

/// What a point's texel sends in a direction and a receiver reflects out of it, without the distance, by the lobes of
/// both.
///
/// `Φ f_s (w·n_s) f_i (-w·n_i)`
/// Source: [Tokuyoshi15] eq. 1 ([Keller97]).
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `receiver` | the surface | | |
/// | `vpl` | the light | | |
/// | `dir` | unit direction from the surface to the light | sphere | 1 |
///
/// Returns linear RGB, in W/sr²; 0 from behind.
#[kernel]
pub fn point_parts(receiver: Receiver, vpl: MapPoint, dir: Vec3) -> BounceSample {
    let towards = max(dot(receiver.normal, dir), 0.0);
    let away = max(-dot(vpl.normal, dir), 0.0);
    let glossy = surface_brdf_cosine(glossy_part(receiver.material), receiver.normal, dir, receiver.view);
    let from_glossy = surface_brdf_cosine(glossy_part(vpl.material), vpl.normal, -dir, vpl.dir);
    let diffuse = towards * lambert_brdf(receiver.material.diffuse_albedo);
    let from_diffuse = away * lambert_brdf(vpl.material.diffuse_albedo);
    BounceSample {
        diffuse_of_diffuse: diffuse * (vpl.flux * from_diffuse),
        diffuse_of_glossy: diffuse * (vpl.flux * from_glossy),
        glossy_of_diffuse: glossy * (vpl.flux * from_diffuse),
        glossy_of_glossy: glossy * (vpl.flux * from_glossy),
    }
}

/// Radiance of a receiver out of a virtual point light.
///
/// Source: [Tokuyoshi15] eq. 1 ([Keller97]); a light nearer than `least` counts as that far, which takes the spots of
/// light in corners away, and light with them.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `receiver`, `vpl` | the pair | | |
/// | `weight` | of the light | 0 ..= 1e30 | 1 |
/// | `least` | least distance | 0 ..= 1e4 | m |
///
/// Returns linear RGB radiance by the lobes of both.
#[kernel]
pub fn vpl_light(receiver: Receiver, vpl: MapPoint, weight: f32, least: f32) -> BounceSample {
    let between = apart(vpl.position, receiver.position);
    let dist = max(between.dist, max(least, 1e-12));
    bounce_scaled(point_parts(receiver, vpl, between.dir), Vec3::splat(weight / (dist * dist)))
}

/// The lobe over directions of incidence that a receiver's glossy reflection is taken for, of amplitude 1.
#[kernel]
pub fn receiver_lobe(receiver: Receiver) -> Asg {
    let lobe = asg_ndf_warp(receiver.normal, receiver.view, receiver.material.alpha);
    Asg { lambda: min(lobe.lambda, 1e6), mu: min(lobe.mu, 1e6), amplitude: 1.0, ..lobe }
}

/// Radiance of a receiver out of a virtual light, by the lobes of both.
///
/// Four products: of the diffuse lobes exactly over the light's cone, the others by [`vsgl_pair_radiance_diffuse`] and
/// [`vsgl_pair_radiance`]. The peaks of glossy lobes, [`microfacet_reflectance`], have their cosine in them.
/// Source: [Tokuyoshi15] eq. 3, with two lobes each.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `receiver` | the surface | | |
/// | `lobe` | its own: [`receiver_lobe`] | | |
/// | `light` | the light | | |
///
/// Returns linear RGB radiance by the lobes of both.
#[kernel]
pub fn vsgl_light_parts(receiver: Receiver, lobe: Asg, light: VirtualLight) -> BounceSample {
    let between = apart(light.position, receiver.position);
    let dir = between.dir;
    let towards = max(dot(receiver.normal, dir), 0.0);
    let away = max(-dot(light.normal, dir), 0.0);
    let mut parts = bounce_nothing();
    if towards * away > 0.0 {
        let dist = between.dist;
        let radius = light.radius;
        let sent = Sg { axis: -light.axis, sharpness: light.sharpness, log_amplitude: 0.0 };
        let all = Sg { axis: dir, sharpness: 0.0, log_amplitude: 0.0 };
        let albedo = lambert_brdf(receiver.material.diffuse_albedo);
        let own = receiver.material;
        let peak = microfacet_reflectance(own.f0, own.f90, own.alpha, receiver.normal, dir, receiver.view);
        let constant = towards * away * vsl_cone(dist, radius).density;
        let of_sent = vsgl_pair_radiance_diffuse(sent, dir, dist, radius, towards);
        let by_lobe = vsgl_pair_radiance(lobe, all, dir, dist, radius, away);
        let by_both = vsgl_pair_radiance(lobe, sent, dir, dist, radius, 1.0);
        parts = BounceSample {
            diffuse_of_diffuse: constant * (albedo * light.diffuse),
            diffuse_of_glossy: of_sent * (albedo * light.specular),
            glossy_of_diffuse: by_lobe * (peak * light.diffuse),
            glossy_of_glossy: by_both * (peak * light.specular),
        };
    }
    parts
}

/// Radiance of a receiver out of a virtual spherical light over whose cone the reflection is smooth: what
/// [`point_parts`] has in the direction of its middle, times the cone.
///
/// Source: [Tokuyoshi15] section 3.3.
#[kernel]
pub fn vsl_smooth_parts(receiver: Receiver, light: VirtualLight, vpl: MapPoint) -> BounceSample {
    let between = apart(light.position, receiver.position);
    let density = vsl_cone(between.dist, light.radius).density;
    bounce_scaled(point_parts(receiver, vpl, between.dir), Vec3::splat(light.weight * density))
}

/// How sharp the reflection of a light by a receiver is, over the light's cone.
///
/// Source: [Tokuyoshi15] section 3.3, by [`vsgl_smoothness`].
#[kernel]
pub fn light_smoothness(receiver: Receiver, lobe: Asg, light: VirtualLight) -> f32 {
    let sharpness = vsgl_transfer_sharpness(lobe.lambda, lobe.mu, light.sharpness);
    vsgl_smoothness(sharpness, apart(light.position, receiver.position).dist, light.radius)
}

/// A direction in the cone of a virtual spherical light.
///
/// Uniform in solid angle: `cos = 1 - u (1 - cos_max)`.
/// Source: [Hasan09] section 4.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `between` | where the light is | | |
/// | `radius` | its radius | 0 ..= 1e4 | m |
/// | `u` | uniform numbers | 0 ..= 1 - 2^-24 | 1 |
///
/// Returns the unit direction.
#[kernel]
pub fn direction_in_cone(between: Apart, radius: f32, u: Vec2) -> Vec3 {
    let fall = u.y * (vsl_cone(between.dist, radius).solid_angle / crate::constants::TWO_PI);
    let frame = crate::brdf::sampling::orthonormal_frame(between.dir);
    let circle = sqrt(fall * max(2.0 - fall, 0.0)) * crate::brdf::sampling::circle_of_turn(u.x);
    circle.x * frame.x + circle.y * frame.y + (1.0 - fall) * frame.z
}
