//! One pixel in colour: what a surface reflects of one light's reflection on one rectangle, lobe by lobe.
//!
//! The methods' kernels are of one wavelength and of reflectances of 1. Here the reflectances come in: each where the
//! method says that the light passes, the peak of a lobe or a spot of
//! [`laplace`](crate::rect::laplace).

use crate::brdf::Material;
use crate::brdf::model::{lambert_brdf, microfacet_m};
use crate::constants::PI;
use crate::rect::diffuse::{rect_diffuse_glossy, rect_form_factor};
use crate::rect::disk::rect_disk_radius;
use crate::rect::laplace::{
    LaplaceIntegral, LaplaceReflector, Reflector, rect_laplace_bitangent, rect_laplace_fast_integral,
    rect_laplace_integral, rect_laplace_matt, rect_laplace_receiver, rect_laplace_reflector,
    rect_laplace_split, rect_laplace_turn,
};
use crate::rect::quadrature::{
    QuadratureFree, QuadratureIntegral, rect_quadrature, rect_quadrature_cover, rect_quadrature_of_free,
};
use crate::rect::reflection::{DistantLight, Reflection, rect_reflection, rect_reflection_paper};
use crate::rect::shade::{RectShade, ShadeForm, rect_shade, rect_shade_within};
use crate::rect::{GlossyReceiver, Rectangle};
use crate::scene::Seen;
use crate::scene::light::Arriving;
use crate::sg::{Sg, sg_integral, sg_sg_product_integral};
use lobe_codegen::prelude::*;

/// Radiance of a pixel, of light that a rectangle reflected once, by the lobes of both: linear RGB.
#[kernel]
pub struct RectPixel {
    /// The pixel's glossy lobe, of the rectangle's glossy lobe.
    pub specular: Vec3,
    /// The pixel's diffuse lobe, of the rectangle's glossy lobe.
    pub diffuse: Vec3,
    /// The pixel's diffuse lobe, of the rectangle's diffuse lobe.
    pub diffuse_of_diffuse: Vec3,
    /// The pixel's glossy lobe, of the rectangle's diffuse lobe; by [`rect_pixel_quadrature`] alone, else 0.
    pub specular_of_diffuse: Vec3,
}

/// A rectangle, its material and the light on it, and the pixel with its material.
#[kernel]
pub struct RectBounce {
    /// The rectangle.
    pub rectangle: Rectangle,
    /// Its surface.
    pub reflector: Material,
    /// What arrives at the rectangle's middle.
    pub arriving: Arriving,
    /// The pixel.
    pub seen: Seen,
    /// Its surface.
    pub receiver: Material,
}

/// The pixel as the methods want it, of reflectance 1.
#[kernel]
pub fn rect_receiver(bounce: RectBounce) -> GlossyReceiver {
    GlossyReceiver {
        position: bounce.seen.position,
        normal: bounce.seen.normal,
        view: bounce.seen.view,
        alpha: bounce.receiver.alpha,
        reflectance: 1.0,
    }
}

/// The light as the methods want it, of irradiance 1.
#[kernel]
pub fn rect_distant_light(bounce: RectBounce) -> DistantLight {
    DistantLight { direction: bounce.arriving.dir, irradiance: 1.0 }
}

/// The radius of the sampling disk about the peak of `reflection`.
#[kernel]
pub fn rect_pixel_radius(bounce: RectBounce, reflection: Reflection, factor: f32) -> f32 {
    let rectangle = bounce.rectangle;
    let height = dot(bounce.seen.position - rectangle.position, rectangle.normal);
    let dist = max(height, 0.0) / max(reflection.cos_sigma, 1e-3);
    max(rect_disk_radius(factor, bounce.reflector.alpha, dist, rectangle.half_x, rectangle.half_y), 1e-3)
}

/// Irradiance times the rectangle's reflectance but its distribution, for light that leaves it against `towards`.
#[kernel]
pub fn rect_reflector_colour(bounce: RectBounce, towards: Vec3) -> Vec3 {
    let material = bounce.reflector;
    let normal = bounce.rectangle.normal;
    let light = bounce.arriving.dir;
    bounce.arriving.irradiance
        * microfacet_m(material.f0, material.f90, material.alpha, normal, light, -towards)
}

/// The pixel's reflectance but its distribution, for light from `towards`.
#[kernel]
pub fn rect_receiver_colour(bounce: RectBounce, towards: Vec3) -> Vec3 {
    let material = bounce.receiver;
    microfacet_m(material.f0, material.f90, material.alpha, bounce.seen.normal, towards, bounce.seen.view)
}

/// What the rectangle's diffuse lobe reflects, by area: `ρ_r E (n·i)⁺`.
#[kernel]
pub fn rect_radiosity(bounce: RectBounce) -> Vec3 {
    let incidence = max(dot(bounce.rectangle.normal, bounce.arriving.dir), 0.0);
    incidence * (bounce.reflector.diffuse_albedo * bounce.arriving.irradiance)
}

/// What the pixel's diffuse lobe reflects of the rectangle's diffuse lobe.
///
/// `ρ_x/π F ρ_r E (n·i)⁺`, with the form factor of [`rect_form_factor`]: exact but for the light's distance.
#[kernel]
pub fn rect_pixel_matt(bounce: RectBounce) -> Vec3 {
    let factor = rect_form_factor(bounce.rectangle, bounce.seen.position, bounce.seen.normal);
    factor * (lambert_brdf(bounce.receiver.diffuse_albedo) * rect_radiosity(bounce))
}

/// What the pixel's diffuse lobe reflects of a disk's lobe about `axis`.
#[kernel]
pub fn rect_pixel_diffuse(bounce: RectBounce, axis: Vec3, shade: RectShade) -> Vec3 {
    let lambda = max(shade.lambda, 0.0);
    let mu = max(shade.mu, 0.0);
    let value = rect_diffuse_glossy(axis, lambda, mu, shade.energy, bounce.seen.normal, 1.0);
    value * (bounce.receiver.diffuse_albedo * rect_reflector_colour(bounce, axis))
}

/// The pixel, out of the steps of [`rect_shade`].
#[kernel]
pub fn rect_pixel_of_shade(bounce: RectBounce, axis: Vec3, shade: RectShade) -> RectPixel {
    let colour = rect_reflector_colour(bounce, axis) * rect_receiver_colour(bounce, axis);
    // As printed, the bandwidths of a disk that is wide against its distance are negative: there is no lobe.
    let radiance = select(0.0, shade.radiance, min(shade.lambda, shade.mu) >= 0.0);
    RectPixel {
        specular: radiance * colour,
        diffuse: rect_pixel_diffuse(bounce, axis, shade),
        diffuse_of_diffuse: rect_pixel_matt(bounce),
        specular_of_diffuse: Vec3::ZERO,
    }
}

/// The pixel by the corrected method of the disk: [`rect_shade`].
#[kernel]
pub fn rect_pixel(bounce: RectBounce, factor: f32) -> RectPixel {
    let light = rect_distant_light(bounce);
    let reflection = rect_reflection(bounce.rectangle.normal, bounce.reflector.alpha, 1.0, light);
    let radius = rect_pixel_radius(bounce, reflection, factor);
    let shade = rect_shade(bounce.rectangle, reflection, rect_receiver(bounce), radius);
    rect_pixel_of_shade(bounce, reflection.axis, shade)
}

/// The pixel by the method as printed: [`crate::rect::chain::rect_shade_light_paper`].
#[kernel]
pub fn rect_pixel_paper(bounce: RectBounce, factor: f32) -> RectPixel {
    let light = rect_distant_light(bounce);
    let reflection = rect_reflection_paper(bounce.rectangle.normal, bounce.reflector.alpha, 1.0, light);
    let radius = rect_pixel_radius(bounce, reflection, factor);
    let form = ShadeForm { widest: 1e9, fullest: 2.0, share: 1.0 };
    let shade = rect_shade_within(bounce.rectangle, reflection, rect_receiver(bounce), radius, form);
    rect_pixel_of_shade(bounce, reflection.axis, shade)
}

/// The pixel by an isotropic lobe in place of the disk's anisotropic one.
///
/// The lobe of [`crate::asg::asg_to_sg`], of sharpness `2 √(λ μ)` and of the disk's energy; its product integral with
/// the pixel's lobe is [`sg_sg_product_integral`].
#[kernel]
pub fn rect_pixel_sg(bounce: RectBounce, factor: f32) -> RectPixel {
    let light = rect_distant_light(bounce);
    let reflection = rect_reflection(bounce.rectangle.normal, bounce.reflector.alpha, 1.0, light);
    let radius = rect_pixel_radius(bounce, reflection, factor);
    let receiver = rect_receiver(bounce);
    let shade = rect_shade(bounce.rectangle, reflection, receiver, radius);
    let axis = reflection.axis;
    let sharpness = min(2.0 * (sqrt(max(shade.lambda, 0.0)) * sqrt(max(shade.mu, 0.0))), 1e6);
    let lobe = Sg { axis, sharpness, log_amplitude: 0.0 };
    let surface = Sg { axis: shade.mirror, sharpness: shade.sharpness, log_amplitude: 0.0 };
    let product = sg_sg_product_integral(lobe, surface) / sg_integral(sharpness);
    let facing = saturate(1e3 * dot(receiver.normal, receiver.view));
    let cosine = max(dot(axis, receiver.normal), 0.0) * facing;
    let density = 1.0 / (PI * (receiver.alpha * receiver.alpha));
    let radiance = select(0.0, cosine * density * (shade.energy * product), shade.height > 0.0);
    let colour = rect_reflector_colour(bounce, axis) * rect_receiver_colour(bounce, axis);
    RectPixel {
        specular: radiance * colour,
        diffuse: rect_pixel_diffuse(bounce, axis, shade),
        diffuse_of_diffuse: rect_pixel_matt(bounce),
        specular_of_diffuse: Vec3::ZERO,
    }
}

/// A direction out of a rectangle's frame.
#[kernel]
pub fn rect_laplace_direction(rectangle: Rectangle, bitangent: Vec3, local: Vec3) -> Vec3 {
    local.x * rectangle.tangent + (local.y * bitangent + local.z * rectangle.normal)
}

/// The pixel's glossy lobe out of an integral of [`laplace`](crate::rect::laplace), with both reflectances at its spot.
#[kernel]
pub fn rect_laplace_colour(bounce: RectBounce, bitangent: Vec3, integral: LaplaceIntegral) -> Vec3 {
    let towards = rect_laplace_direction(bounce.rectangle, bitangent, integral.dir);
    let colour = rect_reflector_colour(bounce, towards) * rect_receiver_colour(bounce, towards);
    integral.value * colour
}

/// The light's reflection on the rectangle in its frame, for [`laplace`](crate::rect::laplace).
#[kernel]
pub fn rect_laplace_lit(bounce: RectBounce, bitangent: Vec3) -> LaplaceReflector {
    let reflector = Reflector {
        alpha: bounce.reflector.alpha,
        reflectance: 1.0,
        light: bounce.arriving.dir,
        irradiance: 1.0,
    };
    rect_laplace_reflector(bounce.rectangle, bitangent, reflector)
}

/// The pixel's diffuse lobe out of an irradiance of [`rect_laplace_matt`], with the rectangle's reflectance at its spot.
#[kernel]
pub fn rect_laplace_matt_colour(bounce: RectBounce, bitangent: Vec3, integral: LaplaceIntegral) -> Vec3 {
    let towards = rect_laplace_direction(bounce.rectangle, bitangent, integral.dir);
    let reflected = integral.value * rect_reflector_colour(bounce, towards);
    lambert_brdf(bounce.receiver.diffuse_albedo) * reflected
}

/// The pixel by our closed form with a spot for each lobe, [`rect_laplace_split`] and [`rect_laplace_matt`].
#[kernel]
pub fn rect_pixel_laplace(bounce: RectBounce) -> RectPixel {
    let bitangent = rect_laplace_bitangent(bounce.rectangle);
    let receiver = rect_laplace_receiver(bounce.rectangle, bitangent, rect_receiver(bounce));
    let reflector = rect_laplace_lit(bounce, bitangent);
    let split = rect_laplace_split(reflector, receiver);
    let matt = rect_laplace_matt(reflector, receiver);
    RectPixel {
        specular: rect_laplace_colour(bounce, bitangent, split.by_reflector)
            + rect_laplace_colour(bounce, bitangent, split.by_receiver),
        diffuse: rect_laplace_matt_colour(bounce, bitangent, matt),
        diffuse_of_diffuse: rect_pixel_matt(bounce),
        specular_of_diffuse: Vec3::ZERO,
    }
}

/// The same by one spot for both lobes, without masking: [`crate::rect::laplace::rect_laplace`].
#[kernel]
pub fn rect_pixel_laplace_single(bounce: RectBounce) -> RectPixel {
    let bitangent = rect_laplace_bitangent(bounce.rectangle);
    let receiver = rect_laplace_receiver(bounce.rectangle, bitangent, rect_receiver(bounce));
    let reflector = rect_laplace_lit(bounce, bitangent);
    let matt = rect_laplace_matt(reflector, receiver);
    RectPixel {
        specular: rect_laplace_colour(bounce, bitangent, rect_laplace_integral(reflector, receiver)),
        diffuse: rect_laplace_matt_colour(bounce, bitangent, matt),
        diffuse_of_diffuse: rect_pixel_matt(bounce),
        specular_of_diffuse: Vec3::ZERO,
    }
}

/// The same with one evaluation: [`crate::rect::laplace::rect_laplace_fast`].
#[kernel]
pub fn rect_pixel_laplace_fast(bounce: RectBounce) -> RectPixel {
    let bitangent = rect_laplace_bitangent(bounce.rectangle);
    let receiver = rect_laplace_receiver(bounce.rectangle, bitangent, rect_receiver(bounce));
    let reflector = rect_laplace_lit(bounce, bitangent);
    let matt = rect_laplace_matt(reflector, receiver);
    RectPixel {
        specular: rect_laplace_colour(bounce, bitangent, rect_laplace_fast_integral(reflector, receiver)),
        diffuse: rect_laplace_matt_colour(bounce, bitangent, matt),
        diffuse_of_diffuse: rect_pixel_matt(bounce),
        specular_of_diffuse: Vec3::ZERO,
    }
}

/// A pixel out of the integrals of [`quadrature`](crate::rect::quadrature), with the reflectances of both materials.
#[kernel]
pub fn rect_quadrature_colour(bounce: RectBounce, integral: QuadratureIntegral) -> RectPixel {
    let reflector = bounce.reflector;
    let receiver = bounce.receiver;
    let rise = Vec3::splat(reflector.f90) - reflector.f0;
    let other_rise = Vec3::splat(receiver.f90) - receiver.f0;
    let parts = integral.glossy;
    let by_normal = parts.x * reflector.f0 + parts.y * rise;
    let by_grazing = parts.z * reflector.f0 + parts.w * rise;
    let irradiance = integral.matt.x * reflector.f0 + integral.matt.y * rise;
    RectPixel {
        specular: bounce.arriving.irradiance * (by_normal * receiver.f0 + by_grazing * other_rise),
        diffuse: lambert_brdf(receiver.diffuse_albedo) * (bounce.arriving.irradiance * irradiance),
        diffuse_of_diffuse: rect_pixel_matt(bounce),
        specular_of_diffuse: (rect_radiosity(bounce) / PI)
            * (integral.white.x * receiver.f0 + integral.white.y * other_rise),
    }
}

/// The pixel by nine places for each lobe: [`rect_quadrature`].
#[kernel]
pub fn rect_pixel_quadrature(bounce: RectBounce) -> RectPixel {
    let bitangent = rect_laplace_bitangent(bounce.rectangle);
    let receiver = rect_laplace_receiver(bounce.rectangle, bitangent, rect_receiver(bounce));
    let reflector = rect_laplace_lit(bounce, bitangent);
    let view = rect_laplace_turn(bounce.rectangle, bitangent, bounce.seen.view);
    rect_quadrature_colour(bounce, rect_quadrature(reflector, receiver, view))
}

/// The same of those places alone that are free.
#[kernel]
pub fn rect_pixel_of_free(bounce: RectBounce, free: QuadratureFree) -> RectPixel {
    let bitangent = rect_laplace_bitangent(bounce.rectangle);
    let receiver = rect_laplace_receiver(bounce.rectangle, bitangent, rect_receiver(bounce));
    let reflector = rect_laplace_lit(bounce, bitangent);
    let view = rect_laplace_turn(bounce.rectangle, bitangent, bounce.seen.view);
    let found = rect_quadrature_colour(bounce, rect_quadrature_of_free(reflector, receiver, view, free));
    let cover = rect_quadrature_cover(reflector, receiver, view, free.by_normal);
    RectPixel {
        specular: found.specular,
        diffuse: found.diffuse,
        diffuse_of_diffuse: cover * found.diffuse_of_diffuse,
        specular_of_diffuse: found.specular_of_diffuse,
    }
}

/// The sum of two pixels.
#[kernel]
pub fn rect_pixel_add(a: RectPixel, b: RectPixel) -> RectPixel {
    RectPixel {
        specular: a.specular + b.specular,
        diffuse: a.diffuse + b.diffuse,
        diffuse_of_diffuse: a.diffuse_of_diffuse + b.diffuse_of_diffuse,
        specular_of_diffuse: a.specular_of_diffuse + b.specular_of_diffuse,
    }
}

/// A pixel without light.
#[kernel]
pub fn rect_pixel_dark() -> RectPixel {
    RectPixel {
        specular: Vec3::ZERO,
        diffuse: Vec3::ZERO,
        diffuse_of_diffuse: Vec3::ZERO,
        specular_of_diffuse: Vec3::ZERO,
    }
}
