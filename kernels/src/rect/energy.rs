//! Radiance at the specular peak, and the energy that the sampling disk sends to a position.

use crate::constants::PI;
use crate::rect::attenuation::rect_attenuation;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::RectGlossy;
use crate::special::expm1_over_x;
use lobe_codegen::prelude::*;

/// Radiance that the specular peak reflects, of one directional light.
///
/// `L_y = M cos σ E/(π m²)`
/// Source: [RectGlossy] eq. 4, 5 at the peak, where the GGX distribution is `1/(π m²)`; its eq. 17 is
/// [`rect_radiance_paper`].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `cos_sigma` | cosine of the light's angle of incidence | 0 ..= 1 | 1 |
/// | `alpha` | GGX alpha `m` of the rectangle | 0.001 ..= 1 | 1 |
/// | `reflectance` | BRDF without its distribution, `M` | 0 ..= 100 | 1 |
/// | `irradiance` | of the light, on a plane that faces it, `E` | 0 ..= 1e4 | W m⁻² |
///
/// Returns the radiance in W m⁻² sr⁻¹. Lights add.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 4, 5",
    domain(cos_sigma = 0.0..=1.0, alpha = 0.001..=1.0, reflectance = 0.0..=100.0, irradiance = 0.0..=1e4),
    budget(1e-6 * result + 1e-27),
    measured
)]
pub fn rect_radiance(cos_sigma: f32, alpha: f32, reflectance: f32, irradiance: f32) -> f32 {
    reflectance * irradiance * cos_sigma / (PI * max(alpha * alpha, 1e-12))
}

/// Radiance that the specular peak reflects, as printed.
///
/// `L_y = π m² f_r (i·n) = M cos σ`, times the light.
/// Source: [RectGlossy] eq. 15, 17. Arguments and domain as of [`rect_radiance`].
///
/// Returns `π m²` times what it ought to be (0.008 at `m = 0.05`): it takes a directional light for one that was
/// sampled with the density of the distribution, which so cancels. Eq. 15 also averages the lights.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 17",
    domain(cos_sigma = 0.0..=1.0, reflectance = 0.0..=100.0, irradiance = 0.0..=1e4),
    budget(5e-7 * result + 1e-30),
    variant_of = rect_radiance,
    measured
)]
pub fn rect_radiance_paper(cos_sigma: f32, reflectance: f32, irradiance: f32) -> f32 {
    reflectance * irradiance * cos_sigma
}

/// Square of the sine of the angle under which the disk is seen.
///
/// `t = sin² α ≈ 1 - 1/(1 + q)`, `q = (l cos σ)²`, `l` the disk's radius over its distance.
/// Source: [RectGlossy] section 3.4, where the distance is taken for 1.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `ratio` | radius of the disk over the distance of its middle, `l` | 0 ..= 1e6 | 1 |
/// | `cos_sigma` | cosine of the light's angle of incidence | 0 ..= 1 | 1 |
///
/// Returns the square, in 0 ..= 1. The angle is that of the ellipse's short axis.
///
/// Numerics: `1/(1 + 1/q)`, so that `q` enters once; the printed difference has no digit left at `q = 1e-8`.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 27",
    domain(ratio = 0.0..=1e6, cos_sigma = 0.0..=1.0),
    budget(1.2e-6 * result + 2e-30),
    measured
)]
pub fn rect_aperture(ratio: f32, cos_sigma: f32) -> f32 {
    let slope = ratio * cos_sigma;
    1.0 / (1.0 + 1.0 / max(slope * slope, 1e-30))
}

/// Square of the sine of the angle under which the disk is seen, as printed.
///
/// `t = 1 - 1/(1 + q)`. Source: [RectGlossy] eq. 27. Arguments, domain and result as of [`rect_aperture`].
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 27",
    domain(ratio = 0.0..=1e6, cos_sigma = 0.0..=1.0),
    budget(1e-6 * result + 1e-30),
    variant_of = rect_aperture,
    not_robust = "the difference of two numbers near 1 loses the digits of a small disk",
    measured
)]
pub fn rect_aperture_paper(ratio: f32, cos_sigma: f32) -> f32 {
    let slope = ratio * cos_sigma;
    1.0 - 1.0 / (1.0 + slope * slope)
}

/// Energy that the disk sends to a position, by the fit of the falloff.
///
/// `C = A π/k (1 - e^(-k t)) L_y`
/// Source: [RectGlossy] eq. 27, as `A π t L_y expm1_over_x(-k t)`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `coverage` | share of the disk that the rectangle covers, `A` | 0 ..= 1.274 | 1 |
/// | `radiance` | at the peak, `L_y` | 0 ..= 1e9 | W m⁻² sr⁻¹ |
/// | `attenuation` | `k` of [`crate::rect::attenuation::rect_attenuation`] | -0.673 ..= 3e5 | 1 |
/// | `aperture` | `t` of [`rect_aperture`] | 0 ..= 1 | 1 |
///
/// Returns the energy in W m⁻², at least 0; finite where `k` is zero or below.
///
/// Against the GGX lobe integrated over an unbounded plane it is 0.88 to 0.90 for light along the normal and
/// `m <= 0.1`, 1.17 to 1.20 at 30°, 1.8 at 45°, 3.5 at 60° and 9 to 10 at 72°.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 27",
    domain(coverage = 0.0..=1.274, radiance = 0.0..=1e9, attenuation = -0.673..=3e5, aperture = 0.0..=1.0),
    budget(4e-6 * result + 1e-28),
    measured
)]
pub fn rect_energy(coverage: f32, radiance: f32, attenuation: f32, aperture: f32) -> f32 {
    // The limits bind nobody; they hold for a driver that may not know on which side of 1 the exponent is.
    let mean = clamp(expm1_over_x(-attenuation * aperture), 0.0, 1.5);
    PI * coverage * aperture * mean * radiance
}

/// Energy that the disk sends to a position, as printed.
///
/// `C = A π/k (1 - e^(-k t)) L_y`. Source: [RectGlossy] eq. 27.
/// Arguments, domain and result as of [`rect_energy`].
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 27",
    domain(coverage = 0.0..=1.274, radiance = 0.0..=1e9, attenuation = -0.673..=3e5, aperture = 0.0..=1.0),
    budget(4e-6 * result + 1e-28),
    variant_of = rect_energy,
    not_robust = "0/0 where the fitted exponent is zero, and 1 - exp(-k t) cancels beside it",
    measured
)]
pub fn rect_energy_paper(coverage: f32, radiance: f32, attenuation: f32, aperture: f32) -> f32 {
    coverage * (PI / attenuation) * (1.0 - exp(-attenuation * aperture)) * radiance
}

/// Energy that a disk sends to a position, out of its size and slant.
///
/// [`rect_energy`] with [`rect_attenuation`] and [`rect_aperture`]. Source: [RectGlossy] eq. 27.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `coverage` | share of the disk that the rectangle covers | 0 ..= 1.274 | 1 |
/// | `radiance` | at the peak | 0 ..= 1e9 | W m⁻² sr⁻¹ |
/// | `cos_sigma` | cosine of the light's angle of incidence | 1e-3 ..= 1 | 1 |
/// | `ratio` | radius of the disk over the distance of its middle | 0 ..= 1e6 | 1 |
/// | `alpha` | GGX alpha of the rectangle | 0.001 ..= 1 | 1 |
///
/// Returns the energy in W m⁻², at least 0.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 27",
    domain(
        coverage = 0.0..=1.274, radiance = 0.0..=1e9, cos_sigma = 1e-3..=1.0, ratio = 0.0..=1e6,
        alpha = 0.001..=1.0
    ),
    budget(7e-6 * result + 1e-26),
    measured
)]
pub fn rect_disk_energy(coverage: f32, radiance: f32, cos_sigma: f32, ratio: f32, alpha: f32) -> f32 {
    rect_energy(coverage, radiance, rect_attenuation(cos_sigma, alpha), rect_aperture(ratio, cos_sigma))
}

/// Energy that the disk sends to a position, without a fit.
///
/// `C = A M cos σ E 4 cos σ Q/(1 + Q)`, `Q = l²/(4 m²)`, `l` the disk's radius over its distance.
/// Source: our own: the GGX distribution integrated over the ellipse of half vectors, of equal area, that the disk
/// spans.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `coverage` | share of the disk that the rectangle covers, `A` | 0 ..= 1.274 | 1 |
/// | `reflected` | `M cos σ E`: [`rect_radiance`] times `π m²` | 0 ..= 1e6 | W m⁻² |
/// | `cos_sigma` | cosine of the light's angle of incidence | 0 ..= 1 | 1 |
/// | `ratio` | radius of the disk over the distance of its middle, `l` | 0 ..= 1e6 | 1 |
/// | `alpha` | GGX alpha `m` of the rectangle | 0.001 ..= 1 | 1 |
///
/// Returns the energy in W m⁻², at least 0.
///
/// Against the integrated GGX lobe it is 0.73 to 0.97 for angles of incidence up to 75° and `m <= 0.3`, where
/// [`rect_energy`] is 0.86 to 1.55, and far more for large disks.
#[kernel(
    family = "rect",
    cite = "our own",
    domain(
        coverage = 0.0..=1.274, reflected = 0.0..=1e6, cos_sigma = 0.0..=1.0, ratio = 0.0..=1e6,
        alpha = 0.001..=1.0
    ),
    budget(3e-6 * result + 1e-23),
    measured
)]
pub fn rect_energy_ggx(coverage: f32, reflected: f32, cos_sigma: f32, ratio: f32, alpha: f32) -> f32 {
    let slope = 0.5 * ratio / max(alpha, 1e-6);
    let share = 1.0 / (1.0 + 1.0 / max(slope * slope, 1e-30));
    4.0 * coverage * cos_sigma * share * reflected
}
