//! Virtual spherical lights whose GGX lobes are as much wider as the light's cone is wide.
//!
//! Our own. A spherical Gaussian has no tail, and of GGX most light at some distance from the mirror direction is in the tail:
//! lights with lobes of that form lose it. Here both surfaces keep GGX, the light's as wide as its filtered lobe, and
//! each gets the variance of the cone besides. Without extent this is the point light, so no threshold decides.

use crate::brdf::Material;
use crate::brdf::model::{glossy_part, lambert_brdf, microfacet_reflectance, surface_brdf_cosine};
use crate::reference::pass::BounceSample;
use crate::rsm::light::{Receiver, VirtualLight, apart};
use crate::rsm::point::MapPoint;
use crate::vsgl::vsl_cone;
use lobe_codegen::prelude::*;

/// A virtual spherical light with a GGX lobe.
#[kernel]
pub struct WideLight {
    /// Its middle.
    #[domain(-1e4..=1e4)]
    pub position: Vec3,
    /// Its radius, in m.
    #[domain(0.0..=1e4)]
    pub radius: f32,
    /// Mean normal.
    #[domain(unit)]
    pub normal: Vec3,
    /// Unit direction that the light comes from.
    #[domain(unit)]
    pub dir: Vec3,
    /// Unit normal about which that is mirrored to the glossy lobe's axis.
    #[domain(unit)]
    pub facing: Vec3,
    /// Intensity of the diffuse lobe without the cosine, linear RGB, in W/sr.
    #[domain(0.0..=1e6)]
    pub diffuse: Vec3,
    /// Power that the glossy lobe is of, linear RGB, in W.
    #[domain(0.0..=1e6)]
    pub flux: Vec3,
    /// The glossy lobe; the diffuse one of this is black.
    pub material: Material,
}

/// The light with a GGX lobe that has the peak and the sharpness of a filtered one.
///
/// Its alpha is that whose [`sg_ndf_warp`](crate::brdf::lobe::sg_ndf_warp) has the sharpness, `α² = 1/(2 k (n·i))`, its power
/// such that the peak is the filtered lobe's.
/// Source: our own.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `light` | the light | | |
/// | `vpl` | the texel that was drawn: reflectances of its facets | | |
///
/// Returns the light. Unfiltered it is the texel.
#[kernel]
pub fn wide_light(light: VirtualLight, vpl: MapPoint) -> WideLight {
    let dir = vpl.dir;
    let middle = dir + light.axis;
    let facing = middle * inverse_sqrt(max(dot(middle, middle), 1e-12));
    let cosine = dot(facing, dir);
    let alpha = clamp(inverse_sqrt(max(2.0 * light.sharpness * max(cosine, 1e-5), 1e-6)), 0.02, 1.0);
    let facets = glossy_part(vpl.material);
    let material = Material { alpha, ..facets };
    let peak = microfacet_reflectance(facets.f0, facets.f90, alpha, facing, dir, light.axis);
    WideLight {
        position: light.position,
        radius: light.radius,
        normal: light.normal,
        dir,
        facing,
        diffuse: light.diffuse,
        flux: light.specular / max(peak, Vec3::splat(1e-20)),
        material,
    }
}

/// Alpha of a lobe that is averaged over a cone.
///
/// A disk of angular radius `ρ` has variance `ρ²/4` along each axis, over half vectors `ρ²/16` in the plane of incidence and
/// `ρ²/(16 cos²)` across; `α²/2` is the variance of the Gaussian with a lobe's curvature. Of both axes the geometric mean:
/// `α² + ρ²/(8 cos)`. A third of that is taken: both surfaces' lobes are widened for one cone, and a wider GGX has more of
/// its light in the tail, so that with all of it 2 to 3 % more of the light is lost and the error is up to 10 % larger.
/// Source: our own.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `alpha` | the lobe's | 0.02 ..= 1 | 1 |
/// | `square` | `ρ²`, squared sine of the cone's half angle | 0 ..= 1 | 1 |
/// | `cosine` | of the direction to the normal; counts as 0.1 at least | -1 ..= 1 | 1 |
///
/// Returns alpha, 1 at most.
#[kernel]
pub fn widened(alpha: f32, square: f32, cosine: f32) -> f32 {
    min(sqrt(alpha * alpha + 0.041666667 * (square / max(cosine, 0.1))), 1.0)
}

/// Radiance of a receiver out of a virtual spherical light, by the lobes of both.
///
/// Source: our own; the cone's density as in [Tokuyoshi15](crate::references::Tokuyoshi15) section 3.3.
#[kernel]
pub fn wide_parts(receiver: Receiver, light: WideLight) -> BounceSample {
    let between = apart(light.position, receiver.position);
    let dir = between.dir;
    let towards = max(dot(receiver.normal, dir), 0.0);
    let away = max(-dot(light.normal, dir), 0.0);
    let area = light.radius * light.radius;
    let square = area / max(between.dist * between.dist + area, 1e-24);
    let own = glossy_part(receiver.material);
    let reflecting = Material { alpha: widened(own.alpha, square, towards), ..own };
    let leaving = -dot(light.facing, dir);
    let sending = Material { alpha: widened(light.material.alpha, square, leaving), ..light.material };
    let density = vsl_cone(between.dist, light.radius).density;
    let glossy = density * surface_brdf_cosine(reflecting, receiver.normal, dir, receiver.view);
    let sent = light.flux * surface_brdf_cosine(sending, light.facing, -dir, light.dir);
    let diffuse = (density * towards) * lambert_brdf(receiver.material.diffuse_albedo);
    let spread = away * light.diffuse;
    BounceSample {
        diffuse_of_diffuse: diffuse * spread,
        diffuse_of_glossy: diffuse * sent,
        glossy_of_diffuse: glossy * spread,
        glossy_of_glossy: glossy * sent,
    }
}

/// The lights with GGX lobes that virtual lights make: a pass.
#[kernel(workgroup_size(64))]
pub fn wide_light_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] map_points: &[MapPoint],
    #[storage(0, 1)] virtual_lights: &[VirtualLight],
    #[storage(0, 2)] wide_lights: &mut [WideLight],
) {
    let i = id.x;
    if i < wide_lights.len() as u32 {
        let light = virtual_lights[i as usize];
        wide_lights[i as usize] = wide_light(light, map_points[light.texel as usize]);
    }
}
