//! One pixel: what a glossy surface reflects of one reflection of a light on a rectangle.
//!
//! [`rect_shade`] is what an engine calls for each pixel; [`rect_shade_within`] has its steps, and the limits in which
//! the corrected and the printed forms differ as an argument, [`ShadeForm`]. [`RectShade`] holds every step's result,
//! of which a shader uses the last, the radiance.

use crate::asg::asg_sg_peak;
use crate::constants::PI;
use crate::rect::budget::rect_shade_error;
#[allow(unused_imports, reason = "the documentation links to it")]
use crate::rect::chain::rect_shade_light_paper;
#[allow(unused_imports, reason = "the documentation links to it")]
use crate::rect::disk::rect_coverage_bounds;
use crate::rect::disk::{rect_coverage_paper, rect_disk_bounds};
use crate::rect::energy::{rect_aperture, rect_energy};
use crate::rect::light::{rect_bandwidth_paper, rect_bandwidth_slope};
use crate::rect::peak::LEAST_COSINE;
use crate::rect::reflection::Reflection;
#[allow(unused_imports, reason = "the documentation links to it")]
use crate::rect::reflection::rect_reflection;
use crate::rect::{GlossyReceiver, Rectangle};
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::RectGlossy;
use lobe_codegen::prelude::*;

/// In what the forms of the shading differ.
#[kernel]
pub struct ShadeForm {
    /// The largest half extent of the disk over its distance.
    #[domain([4.0])]
    pub widest: f32,
    /// The largest share of the disk.
    #[domain([1.0])]
    pub fullest: f32,
    /// What the product with the surface's lobe takes of its sharpness.
    #[domain([0.5])]
    pub share: f32,
}

/// The shading of one position, step by step.
#[kernel]
pub struct RectShade {
    /// Height of the position over the rectangle's plane, in m.
    #[domain(-2e4..=2e4)]
    pub height: f32,
    /// The specular peak.
    #[domain(-1e4..=1e4)]
    pub peak: Vec3,
    /// Its distance, in m.
    #[domain(0.0..=1e7)]
    pub dist: f32,
    /// Square of the sine of the angle under which the disk is seen.
    #[domain(0.0..=1.0)]
    pub aperture: f32,
    /// Area of the rectangle around what disk and rectangle share, in m².
    #[domain(0.0..=4e4)]
    pub bounds: f32,
    /// Share of the disk that the rectangle covers.
    #[domain(0.0..=1.274)]
    pub coverage: f32,
    /// Energy that the disk sends, in W m⁻².
    #[domain(0.0..=1e6)]
    pub energy: f32,
    /// Bandwidths of its lobe, across the plane of incidence and in it.
    #[domain(0.0..=1e6)]
    pub lambda: f32,
    /// The other one.
    #[domain(0.0..=1e6)]
    pub mu: f32,
    /// Value of the lobe at its peak, in W m⁻² sr⁻¹.
    #[domain(0.0..=1e6)]
    pub amplitude: f32,
    /// Mirror direction of the viewer.
    #[domain(unit)]
    pub mirror: Vec3,
    /// Sharpness of the surface's lobe about it.
    #[domain(0.0..=1e6)]
    pub sharpness: f32,
    /// Product integral of both lobes, for amplitudes of 1, in sr.
    #[domain(0.0..=10.0)]
    pub product: f32,
    /// Reflected radiance, in W m⁻² sr⁻¹.
    #[domain(0.0..=1e6)]
    pub radiance: f32,
}

/// The shading of one position by one reflection.
///
/// The recipe: the specular peak `y` ([`crate::rect::peak::rect_specular_peak`]); the share `A` that the rectangle has
/// of the disk about it ([`rect_coverage_bounds`]); the energy `C` of the disk ([`rect_energy`]); the anisotropic
/// lobe that stands for it ([`crate::rect::light::rect_asg_from_disk`]); its product integral `H` with the lobe of the
/// surface, `k = 1/(2 (o·n) m²)` about the mirror direction `2 (o·n) n - o`; and
/// `L = M (z·n) a/(π m²) H`, `a` the lobe's amplitude.
/// Source: [RectGlossy] section 3, corrected: [`rect_shade_light_paper`] says in what.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `rectangle` | the rectangle | positions -100 ..= 100, half sides 1e-3 ..= 100 | m |
/// | `reflection` | what it makes of the light: [`rect_reflection`] | | |
/// | `receiver` | the shaded surface | positions -1e4 ..= 1e4 | m |
/// | `radius` | of the sampling disk: [`crate::rect::disk::rect_disk_radius`] | 1e-3 ..= 100 | m |
///
/// Returns the steps and the reflected radiance. It is 0 for a light or a position below the rectangle and for a
/// viewer below the surface, and fades for one within 0.001 of its horizon. Reflections of several lights and
/// rectangles add. Nothing is shadowed.
///
/// Numerics: the exponent is `λ' |p|² + (μ' - λ') (p·u)²/|u|²` with `u` the rectangle's normal without its part along
/// `z`; the difference of the bandwidths has the factor `|u|²` ([`rect_bandwidth_slope`]), so that light along the
/// normal needs no frame and no case of its own. The error is stated against the radiance in the mirror direction of
/// the whole disk: it grows for positions near the plane and for a disk that is small against its distance.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] section 3",
    domain(radius = 1e-3..=100.0),
    budget(
        height = 6e-7 * length(receiver.position - rectangle.position) + 1e-30,
        sharpness = (2e-6 + 4e-7 / max(dot(receiver.normal, receiver.view), 1e-3)) * result.sharpness,
        mirror = 2e-6,
        radiance = rect_shade_error(rectangle, reflection, receiver, radius, result) + 1e-20
    ),
    measured
)]
pub fn rect_shade(
    rectangle: Rectangle,
    reflection: Reflection,
    receiver: GlossyReceiver,
    radius: f32,
) -> RectShade {
    let form = ShadeForm { widest: 4.0, fullest: 1.0, share: 0.5 };
    rect_shade_within(rectangle, reflection, receiver, radius, form)
}

/// The shading of one position by one reflection, with the limits of the several forms as arguments.
///
/// The steps of [`rect_shade`]. Source: [RectGlossy] section 3.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `rectangle` | the rectangle | positions -100 ..= 100, half sides 1e-3 ..= 100 | m |
/// | `reflection` | what it makes of the light | | |
/// | `receiver` | the shaded surface | positions -1e4 ..= 1e4 | m |
/// | `radius` | of the sampling disk | 1e-3 ..= 100 | m |
/// | `form` | the limits: the disk's half extent, its share, the share of a sharpness | 4, 1, 0.5 | 1 |
///
/// Returns the steps and the reflected radiance.
///
/// Numerics: as of [`rect_shade`].
#[kernel(
    family = "rect",
    cite = "[RectGlossy] section 3",
    domain(radius = 1e-3..=100.0),
    budget(
        height = 6e-7 * length(receiver.position - rectangle.position) + 1e-30,
        sharpness = (2e-6 + 4e-7 / max(dot(receiver.normal, receiver.view), 1e-3)) * result.sharpness,
        mirror = 2e-6,
        radiance = rect_shade_error(rectangle, reflection, receiver, radius, result) + 1e-20
    ),
    measured
)]
pub fn rect_shade_within(
    rectangle: Rectangle,
    reflection: Reflection,
    receiver: GlossyReceiver,
    radius: f32,
    form: ShadeForm,
) -> RectShade {
    let offset = receiver.position - rectangle.position;
    let height = dot(offset, rectangle.normal);
    let cos_sigma = max(reflection.cos_sigma, LEAST_COSINE);
    let dist = max(height, 0.0) / cos_sigma;
    // The way from the rectangle's middle to the peak, within its plane.
    let level = (offset - height * rectangle.normal)
        + dist * (reflection.axis + reflection.cos_sigma * rectangle.normal);
    let x = dot(level, rectangle.tangent);
    let y = dot(level, cross(rectangle.normal, rectangle.tangent));
    let bounds = rect_disk_bounds(rectangle.half_x, rectangle.half_y, x, y, radius);
    let coverage = min(rect_coverage_paper(rectangle.half_x, rectangle.half_y, x, y, radius), form.fullest);

    // The disk: its energy and its lobe.
    let ratio = radius / max(dist, 1e-12);
    let aperture = rect_aperture(ratio, cos_sigma);
    let energy = rect_energy(coverage, reflection.radiance, reflection.attenuation, aperture);
    let extent = clamp(ratio, 1e-3, form.widest);
    let lambda = rect_bandwidth_paper(extent);
    let mu = rect_bandwidth_paper(extent * cos_sigma);
    let amplitude = sqrt(max(lambda, 0.0)) * sqrt(max(mu, 0.0)) * (energy / PI);

    // The surface's lobe, and the product of both.
    let facing = dot(receiver.normal, receiver.view);
    let mirror = 2.0 * facing * receiver.normal - receiver.view;
    let alpha_squared = receiver.alpha * receiver.alpha;
    let sharpness = 0.5 / (max(facing, 1e-3) * alpha_squared);
    let nu = form.share * sharpness;
    let chord = mirror - reflection.axis;
    let chord_squared = dot(chord, chord);
    let apart = chord_squared * max(1.0 - 0.25 * chord_squared, 0.0);
    let along = dot(chord, reflection.slant);
    let wide = nu / max(lambda + nu, 1e-10);
    let narrow = nu / max(mu + nu, 1e-10);
    let slope = rect_bandwidth_slope(extent, cos_sigma) * narrow * wide;
    let falloff = exp(-(lambda * wide) * apart - slope * (along * along));
    let seen = max(dot(mirror, reflection.axis), 0.0) * falloff;

    let cosine = max(dot(reflection.axis, receiver.normal), 0.0) * saturate(1e3 * facing);
    let peak_density = 1.0 / (PI * alpha_squared);
    // The amplitude times the product: a share of the energy, in which each bandwidth enters once.
    let share = inverse_sqrt(1.0 + nu / max(lambda, 1e-6)) * inverse_sqrt(1.0 + nu / max(mu, 1e-6));
    let lit = receiver.reflectance * cosine * peak_density * (energy * share * seen);
    RectShade {
        height,
        peak: rectangle.position + level,
        dist,
        aperture,
        bounds,
        coverage,
        energy,
        lambda,
        mu,
        amplitude,
        mirror,
        sharpness,
        product: asg_sg_peak(lambda, mu, nu) * seen,
        radiance: select(0.0, lit, height > 0.0),
    }
}
