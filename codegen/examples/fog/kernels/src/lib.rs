//! Fog that thins out with height, lit by a spherical Gaussian.
//!
//! Single scattering: light of the lobe is scattered once, and reaches the fog as if there were none on its way.
//! Directions are unit vectors that point away from the eye, `z` is up, lengths are in metres.

use lobe_codegen::prelude::*;
pub use lobe_kernels::sg::Sg;
use lobe_kernels::sg::{sg_integral, sg_sg_product_integral};
use lobe_kernels::special::expm1_over_x;

/// Fog whose density falls off exponentially with height.
#[kernel]
pub struct Fog {
    /// Share of light that each channel loses by scattering rather than absorption.
    #[domain(0.0..=1.0)]
    pub albedo: Vec3,
    /// Extinction at height 0, in 1/m.
    #[domain(0.0..=0.1)]
    pub extinction: f32,
    /// What the density's logarithm loses with height, in 1/m.
    #[domain(0.0..=0.01)]
    pub falloff: f32,
    /// Sharpness of the lobe that light is scattered into; 0 scatters everywhere alike.
    #[domain(0.0..=100.0)]
    pub phase_sharpness: f32,
}

/// What a pixel shows, were there no fog.
#[kernel]
pub struct Sight {
    /// Unit vector from the eye.
    #[domain(unit)]
    pub view: Vec3,
    /// Distance of the surface, in m.
    #[domain(0.0..=2000.0)]
    pub dist: f32,
    /// Radiance of the surface.
    #[domain(0.0..=10.0)]
    pub radiance: Vec3,
    /// Height of the eye, in m.
    #[domain(-100.0..=1000.0)]
    pub height: f32,
}

/// Optical depth of fog along a segment.
///
/// `∫ s e^(-f h) dt = s e^(-f h0) d expm1_over_x(-f r)` over the distance `d`, for extinction `s`, falloff `f`, the
/// height `h0` of its beginning and its rise `r`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `fog` | the fog | extinction 0 ..= 0.1, falloff 0 ..= 0.01 | 1/m |
/// | `height` | height where the segment begins | -100 ..= 1000 | m |
/// | `rise` | height of its end above that | -2000 ..= 2000 | m |
/// | `dist` | its length | 0 ..= 2000 | m |
///
/// Returns the depth, at least 0; light is attenuated by `e^-depth`.
///
/// Numerics: the usual form `(1 - e^(-f r)) / (f r)` is 0/0 along the horizon and cancels near it, hence the branch on
/// `r` in so many shaders; [`expm1_over_x`] needs none. The budget grows with the exponents, since the languages let
/// `exp(x)` err by `3 + 2|x|` ULP.
#[kernel(
    family = "fog",
    domain(height = -100.0..=1000.0, rise = -2000.0..=2000.0, dist = 0.0..=2000.0),
    budget((4e-6 + 3e-7 * fog.falloff * (abs(height) + abs(rise))) * result + 1e-30)
)]
pub fn fog_optical_depth(fog: Fog, height: f32, rise: f32, dist: f32) -> f32 {
    fog.extinction * exp(-fog.falloff * height) * dist * expm1_over_x(-fog.falloff * rise)
}

/// Radiance of a lobe of light that fog scatters towards the eye.
///
/// `a (1 - e^-t) ∫ G(w; light) p(w) dw` for albedo `a`, optical depth `t`, and the phase function
/// `p = G(w; view, k) / ∫ G(w; view, k) dw`, a spherical Gaussian of integral 1 around the view: fog scatters forward.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `fog` | the fog | sharpness of the phase function 0 ..= 100 | 1 |
/// | `light` | radiance that comes in, as a lobe | sharpness 0 ..= 1e4, log amplitude -10 ..= 10 | 1 |
/// | `view` | unit direction from the eye | sphere | 1 |
/// | `depth` | optical depth | 0 ..= 100 | 1 |
///
/// Returns radiance, of the light's unit, at least 0.
///
/// Numerics: `1 - e^-t` cancels in thin fog, `t expm1_over_x(-t)` does not.
#[kernel(
    family = "fog",
    domain(light.sharpness = 0.0..=1e4, view = unit, depth = 0.0..=100.0),
    budget(1e-5 * exp(light.log_amplitude) + 1e-30)
)]
pub fn fog_in_scattering(fog: Fog, light: Sg, view: Vec3, depth: f32) -> Vec3 {
    let phase = Sg { axis: view, sharpness: fog.phase_sharpness, log_amplitude: 0.0 };
    let scattered = sg_sg_product_integral(light, phase) / sg_integral(fog.phase_sharpness);
    fog.albedo * (depth * expm1_over_x(-depth) * scattered)
}

/// What a pixel shows through fog.
///
/// The surface's radiance times `e^-t`, plus what the fog scatters in between.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `fog` | the fog | as of [`fog_optical_depth`] and [`fog_in_scattering`] | |
/// | `light` | radiance that comes in, as a lobe | sharpness 0 ..= 1e4, log amplitude -10 ..= 10 | 1 |
/// | `sight` | the surface and the way to it | distance 0 ..= 2000, height -100 ..= 1000 | m |
///
/// Returns radiance, of the light's and the surface's unit.
#[kernel(
    family = "fog",
    domain(light.sharpness = 0.0..=1e4),
    budget(1e-5 * exp(light.log_amplitude) + 1e-5 * max(sight.radiance.x, max(sight.radiance.y, sight.radiance.z)))
)]
pub fn fog_apply(fog: Fog, light: Sg, sight: Sight) -> Vec3 {
    let rise = sight.view.z * sight.dist;
    let depth = fog_optical_depth(fog, sight.height, rise, sight.dist);
    exp(-depth) * sight.radiance + fog_in_scattering(fog, light, sight.view, depth)
}

/// [`fog_apply`] for every pixel.
#[kernel(workgroup_size(64))]
pub fn fog_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] fog: &Fog,
    #[uniform(0, 1)] light: &Sg,
    #[storage(0, 2)] sights: &[Sight],
    #[storage(0, 3)] radiances: &mut [Vec3],
) {
    let i = id.x;
    if i < sights.len() as u32 {
        radiances[i as usize] = fog_apply(*fog, *light, sights[i as usize]);
    }
}
