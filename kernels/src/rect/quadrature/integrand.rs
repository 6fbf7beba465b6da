//! The integrand at a place.

use crate::rect::laplace::rect_laplace_masked_root;
use crate::rect::quadrature::view::{QuadraturePlace, QuadratureView};
use lobe_codegen::prelude::*;

/// The integrand at a place, by area, without what is the same everywhere.
#[kernel]
pub struct QuadratureIntegrand {
    /// Of the pixel's glossy lobe.
    pub glossy: f32,
    /// Of the pixel's diffuse lobe.
    pub matt: f32,
    /// Of the pixel's glossy lobe, of light that leaves the rectangle alike everywhere and in all directions.
    pub white: f32,
    /// How far the rectangle's Fresnel reflectance is from normal to grazing incidence, 0 ..= 1.
    pub reflector_grazing: f32,
    /// The same of the pixel's.
    pub receiver_grazing: f32,
    /// Share of the place that is the rectangle's lobe's.
    pub share: f32,
}

/// `(1 + q)/(α² + q)` and the lobe's density in the partition, `q` being the squared slope.
#[kernel]
pub struct QuadratureFall {
    /// Root of the distribution over `α²/π`.
    pub root: f32,
    /// `(root scale²/(1 + q)²)^1.5`.
    pub density: f32,
}

/// How a distribution falls off; `along` is the squared part of the half vector along the surface,
/// `reciprocal` the inverse of its part along the normal.
#[kernel]
pub fn rect_quadrature_fall(square: f32, along: f32, reciprocal: f32) -> QuadratureFall {
    let slope2 = along * (reciprocal * reciprocal);
    let secant2 = 1.0 + slope2;
    let root = secant2 / (square + slope2);
    let scale = reciprocal / secant2;
    let weight = root * (scale * scale);
    QuadratureFall { root, density: weight * sqrt(weight) }
}

/// Schlick's `(1 - c)^5`, of half the length of a half vector that is the sum of two unit vectors.
#[kernel]
pub fn rect_quadrature_grazing(square: f32) -> f32 {
    let down = max(1.0 - 0.5 * sqrt(square), 0.0);
    let down2 = down * down;
    down2 * down2 * down
}

/// The integrand at a place.
///
/// `glossy = (r_r r_x)² (n_x·w)⁺ v / (d² g_r g_x)`, `g = c S(c') + c' S(c)` of both cosines of a surface, `r` the roots of
/// [`QuadratureFall`]; `matt` is without `r_x` and `g_x`, `white` without `r_r` and `g_r`.
#[kernel]
pub fn rect_quadrature_integrand(view: QuadratureView, place: QuadraturePlace) -> QuadratureIntegrand {
    let w = Vec3::new(place.along.x, place.along.y, -place.down);
    let own = view.light - w;
    let own_along = dot(own.xy(), own.xy());
    let reflector = rect_quadrature_fall(view.reflector.square, own_along, 1.0 / own.z);

    let cosine = max(place.cosine, 0.0);
    let other = view.view + w;
    let turned = cross(view.facing, other);
    let receiver =
        rect_quadrature_fall(view.receiver.square, dot(turned, turned), 1.0 / (cosine + view.cosine));

    let leaving = rect_laplace_masked_root(view.reflector.square, view.reflector.rest, place.down);
    let arriving = rect_laplace_masked_root(view.receiver.square, view.receiver.rest, cosine);
    let own_masking = view.light.z * leaving + place.down * view.light_root;
    let other_masking = cosine * view.view_root + view.cosine * arriving;
    let seen = cosine * place.down * (place.nearness * place.nearness);
    let matt = reflector.root * reflector.root * seen / own_masking;
    let reflected = receiver.root * receiver.root / other_masking;
    QuadratureIntegrand {
        glossy: matt * reflected,
        matt,
        white: seen * reflected,
        reflector_grazing: rect_quadrature_grazing(own_along + own.z * own.z),
        receiver_grazing: rect_quadrature_grazing(dot(other, other)),
        share: reflector.density / (reflector.density + receiver.density),
    }
}
