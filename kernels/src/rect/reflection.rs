//! What a rectangle makes of a distant light: all that does not depend on who looks at it.
//!
//! An engine computes a [`Reflection`] once for each pair of rectangle and light, by [`rect_reflection`], and hands
//! it to the shading of every pixel: [`rect_shade`](crate::rect::shade::rect_shade).

use crate::rect::attenuation::rect_attenuation;
use crate::rect::energy::{rect_radiance, rect_radiance_paper};
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::RectGlossy;
use lobe_codegen::prelude::*;

/// A distant light.
#[kernel]
pub struct DistantLight {
    /// Unit direction to the light.
    #[domain(unit)]
    pub direction: Vec3,
    /// Irradiance on a plane that faces the light, in W m⁻².
    #[domain(0.0..=1e4)]
    pub irradiance: f32,
}

/// What a rectangle makes of a distant light, wherever it is seen from.
#[kernel]
pub struct Reflection {
    /// Unit direction from a position to its specular peak.
    #[domain(unit)]
    pub axis: Vec3,
    /// The rectangle's normal without its part along the axis; as long as the sine of incidence.
    #[domain(-1.0..=1.0)]
    pub slant: Vec3,
    /// Cosine of incidence; 0 or negative for a light that does not shine on the reflecting side.
    #[domain(-1.0..=1.0)]
    pub cos_sigma: f32,
    /// Exponent of the falloff's fit.
    #[domain(-0.673..=720.0)]
    pub attenuation: f32,
    /// Radiance at the peak, in W m⁻² sr⁻¹.
    #[domain(0.0..=1e6)]
    pub radiance: f32,
}

/// What a rectangle makes of a distant light: all that does not depend on the shaded position.
///
/// `z = i - 2 (i·n) n`, `k` of [`rect_attenuation`], `L_y` of [`rect_radiance`].
/// Source: [RectGlossy] sections 3.3, 3.4.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `normal` | unit normal of the rectangle, `n` | sphere | 1 |
/// | `alpha` | its GGX alpha | 0.02 ..= 1 | 1 |
/// | `reflectance` | its BRDF without the distribution | 0 ..= 100 | 1 |
/// | `light` | the light | irradiance 0 ..= 1e4 | W m⁻² |
///
/// Returns the reflection; its radiance is 0 for a light below the rectangle. Shading is linear in both reflectances
/// and the irradiance: for colours, take 1 and multiply.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] sections 3.3, 3.4",
    domain(normal = unit, alpha = 0.02..=1.0, reflectance = 0.0..=100.0),
    budget(
        axis = 1.5e-6,
        slant = 2e-6,
        cos_sigma = 4e-7,
        attenuation = 1e-6 * abs(result.attenuation) + 1e-6 + 1e-7 / (alpha * alpha),
        radiance = 1e-6 * result.radiance + 1e-7 * (reflectance * light.irradiance) / (alpha * alpha) + 1e-27
    ),
    measured
)]
pub fn rect_reflection(normal: Vec3, alpha: f32, reflectance: f32, light: DistantLight) -> Reflection {
    let cosine = dot(normal, light.direction);
    let radiance = rect_radiance(max(cosine, 0.0), alpha, reflectance, light.irradiance);
    rect_reflected(normal, alpha, light.direction, radiance)
}

/// What a rectangle makes of a distant light, as printed.
///
/// Source: [RectGlossy] sections 3.3, 3.4, with the radiance of [`rect_radiance_paper`]. Arguments and domain as of
/// [`rect_reflection`].
///
/// Returns the reflection, the radiance of which is `π m²` times what it ought to be.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] sections 3.3, 3.4",
    domain(normal = unit, alpha = 0.02..=1.0, reflectance = 0.0..=100.0),
    budget(
        axis = 1.5e-6,
        slant = 2e-6,
        cos_sigma = 4e-7,
        attenuation = 1e-6 * abs(result.attenuation) + 1e-6 + 1e-7 / (alpha * alpha),
        radiance = 1e-6 * result.radiance + 3e-7 * (reflectance * light.irradiance) + 1e-30
    ),
    variant_of = rect_reflection,
    measured
)]
pub fn rect_reflection_paper(normal: Vec3, alpha: f32, reflectance: f32, light: DistantLight) -> Reflection {
    let cosine = dot(normal, light.direction);
    let radiance = rect_radiance_paper(max(cosine, 0.0), reflectance, light.irradiance);
    rect_reflected(normal, alpha, light.direction, radiance)
}

/// The reflection of a known radiance; part of [`rect_reflection`].
///
/// Source: [RectGlossy] sections 3.3, 3.4.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `normal` | unit normal of the rectangle | sphere | 1 |
/// | `alpha` | its GGX alpha | 0.02 ..= 1 | 1 |
/// | `light_dir` | unit direction to the light | sphere | 1 |
/// | `radiance` | at the peak | 0 ..= 1e6 | W m⁻² sr⁻¹ |
///
/// Returns the reflection.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] sections 3.3, 3.4",
    domain(normal = unit, alpha = 0.02..=1.0, light_dir = unit, radiance = 0.0..=1e6),
    budget(
        axis = 1.5e-6,
        slant = 2e-6,
        cos_sigma = 4e-7,
        attenuation = 1e-6 * abs(result.attenuation) + 1e-6 + 1e-7 / (alpha * alpha),
        radiance = 1e-37
    ),
    measured
)]
pub fn rect_reflected(normal: Vec3, alpha: f32, light_dir: Vec3, radiance: f32) -> Reflection {
    let cos_sigma = dot(normal, light_dir);
    let axis = light_dir - 2.0 * cos_sigma * normal;
    Reflection {
        axis,
        // n - (n·z) z, since n × z is n × i.
        slant: cross(axis, cross(normal, light_dir)),
        cos_sigma,
        attenuation: rect_attenuation(max(cos_sigma, 0.0), alpha),
        radiance,
    }
}
