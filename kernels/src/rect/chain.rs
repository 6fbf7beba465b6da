//! The whole chain from light to pixel, for those who take no step by themselves.
//!
//! [`rect_shade_light`] is the corrected method; [`rect_shade_light_unlimited`] lacks the limit on the disk, and
//! [`rect_shade_light_paper`] is the method as printed.

use crate::rect::budget::rect_shade_error;
use crate::rect::reflection::{DistantLight, rect_reflection, rect_reflection_paper};
use crate::rect::shade::{RectShade, ShadeForm, rect_shade, rect_shade_within};
use crate::rect::{GlossyReceiver, Rectangle};
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::RectGlossy;
use lobe_codegen::prelude::*;

/// The shading of one position by one rectangle and one light.
///
/// [`rect_shade`] of [`rect_reflection`]. Source: [RectGlossy] section 3, corrected.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `rectangle` | the rectangle | positions -100 ..= 100, half sides 1e-3 ..= 100 | m |
/// | `alpha`, `reflectance` | its GGX alpha and its BRDF without the distribution | 0.02 ..= 1, 0 ..= 100 | 1 |
/// | `light` | the light | irradiance 0 ..= 1e4 | W m⁻² |
/// | `receiver` | the shaded surface | positions -1e4 ..= 1e4 | m |
/// | `radius` | of the sampling disk: [`crate::rect::disk::rect_disk_radius`] | 1e-3 ..= 100 | m |
///
/// Returns the steps and the reflected radiance, in W m⁻² sr⁻¹.
///
/// Over the 197 lit scenes of the oracle's table, disks of 1.5 to 5 lobes, the radiance over the integral with the same
/// surface's lobe has the median 0.96 and the quartiles 0.57 and 1.35. For a peak inside a rectangle larger than the
/// disk it is 0.97 to 1.39 of it for light along the normal, 1.23 to 1.57 at 30° and 1.7 to 1.8 at 60°
/// (`m` of 0.05 to 0.3). It is 0 for a peak farther than the disk's radius from the rectangle.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] section 3",
    domain(alpha = 0.02..=1.0, reflectance = 0.0..=100.0, radius = 1e-3..=100.0),
    budget(
        height = 6e-7 * length(receiver.position - rectangle.position) + 1e-30,
        sharpness = (2e-6 + 4e-7 / max(dot(receiver.normal, receiver.view), 1e-3)) * result.sharpness,
        mirror = 2e-6,
        radiance = rect_shade_error(rectangle, rect_reflection(rectangle.normal, alpha, reflectance, light), receiver, radius, result)
            + 1e-7 * (light.irradiance * reflectance / (alpha * alpha))
                * (receiver.reflectance / (receiver.alpha * receiver.alpha)) + 1e-20
    ),
    measured
)]
pub fn rect_shade_light(
    rectangle: Rectangle,
    alpha: f32,
    reflectance: f32,
    light: DistantLight,
    receiver: GlossyReceiver,
    radius: f32,
) -> RectShade {
    rect_shade(rectangle, rect_reflection(rectangle.normal, alpha, reflectance, light), receiver, radius)
}

/// The shading of one position by one rectangle and one light, for disks of any size.
///
/// Source: [RectGlossy] section 3, corrected but for the limit on the disk's half extent. Arguments and domain as of
/// [`rect_shade_light`].
///
/// Returns the steps and the reflected radiance: that of [`rect_shade_light`] for disks of radius up to four times
/// their distance. For more than 19.98 times the bandwidths are negative, and the radiance 0.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] section 3",
    domain(alpha = 0.02..=1.0, reflectance = 0.0..=100.0, radius = 1e-3..=100.0),
    budget(
        height = 6e-7 * length(receiver.position - rectangle.position) + 1e-30,
        sharpness = (2e-6 + 4e-7 / max(dot(receiver.normal, receiver.view), 1e-3)) * result.sharpness,
        mirror = 2e-6,
        radiance = rect_shade_error(rectangle, rect_reflection(rectangle.normal, alpha, reflectance, light), receiver, radius, result)
            + 1e-7 * (light.irradiance * reflectance / (alpha * alpha))
                * (receiver.reflectance / (receiver.alpha * receiver.alpha)) + 1e-20
    ),
    variant_of = rect_shade_light,
    not_robust = "bandwidths pass zero for a disk of 19.98 times its distance",
    measured
)]
pub fn rect_shade_light_unlimited(
    rectangle: Rectangle,
    alpha: f32,
    reflectance: f32,
    light: DistantLight,
    receiver: GlossyReceiver,
    radius: f32,
) -> RectShade {
    let reflection = rect_reflection(rectangle.normal, alpha, reflectance, light);
    let form = ShadeForm { widest: 1e9, fullest: 1.0, share: 0.5 };
    rect_shade_within(rectangle, reflection, receiver, radius, form)
}

/// The shading of one position by one rectangle and one light, as printed.
///
/// Source: [RectGlossy] section 3. Arguments and domain as of [`rect_shade_light`].
///
/// Returns the steps and the reflected radiance, for which the median over the same scenes is 0.048 of the integral.
/// What differs from [`rect_shade_light`]: the radiance of eq. 17 lacks the factor `1/(π m²)`; eq. 11 takes the whole
/// sharpness of the surface's lobe where half is meant; eq. 36 lets the share of the disk exceed 1; eq. 32 has no
/// limit. Kept from the corrections, without which nothing fits: the disk's radius is taken over its distance, the
/// mirror direction is about the normal (eq. 8 has a half vector), cosines are clamped (eq. 30), lights add (eq. 15
/// has their mean).
#[kernel(
    family = "rect",
    cite = "[RectGlossy] section 3",
    domain(alpha = 0.02..=1.0, reflectance = 0.0..=100.0, radius = 1e-3..=100.0),
    budget(
        height = 6e-7 * length(receiver.position - rectangle.position) + 1e-30,
        sharpness = (2e-6 + 4e-7 / max(dot(receiver.normal, receiver.view), 1e-3)) * result.sharpness,
        mirror = 2e-6,
        radiance = rect_shade_error(rectangle, rect_reflection_paper(rectangle.normal, alpha, reflectance, light), receiver, radius, result)
            + 1e-7 * (light.irradiance * reflectance / (alpha * alpha))
                * (receiver.reflectance / (receiver.alpha * receiver.alpha)) + 1e-20
    ),
    variant_of = rect_shade_light,
    not_robust = "bandwidths pass zero for a disk of 19.98 times its distance",
    measured
)]
pub fn rect_shade_light_paper(
    rectangle: Rectangle,
    alpha: f32,
    reflectance: f32,
    light: DistantLight,
    receiver: GlossyReceiver,
    radius: f32,
) -> RectShade {
    let reflection = rect_reflection_paper(rectangle.normal, alpha, reflectance, light);
    let form = ShadeForm { widest: 1e9, fullest: 2.0, share: 1.0 };
    rect_shade_within(rectangle, reflection, receiver, radius, form)
}
