//! The sum over the places.

use crate::constants::PI;
use crate::rect::laplace::{LaplaceReceiver, LaplaceReflector, rect_laplace_is_dark};
use crate::rect::quadrature::integrand::{QuadratureIntegrand, rect_quadrature_integrand};
use crate::rect::quadrature::lobe::{
    QuadratureStart, rect_quadrature_by_angle, rect_quadrature_conditional, rect_quadrature_cross,
    rect_quadrature_is_longer, rect_quadrature_marginal, rect_quadrature_start, rect_quadrature_turned_lobe,
};
use crate::rect::quadrature::view::{
    QuadratureView, rect_quadrature_inner, rect_quadrature_outer, rect_quadrature_seen,
    rect_quadrature_turned, rect_quadrature_view,
};
use crate::rect::quadrature::warp::{
    rect_quadrature_abscissa, rect_quadrature_along, rect_quadrature_line, rect_quadrature_place,
    rect_quadrature_weight,
};
use lobe_codegen::prelude::*;

/// Integrals over the rectangle, without irradiance, and apart by the powers of both Fresnel terms.
///
/// A reflectance is `f0 + (f90 - f0) s`, with `s_r` of the rectangle and `s_x` of the pixel.
#[kernel]
pub struct QuadratureIntegral {
    /// Of the pixel's glossy lobe, times 1, `s_r`, `s_x`, `s_r s_x`.
    pub glossy: Vec4,
    /// Irradiance at the pixel, times 1, `s_r`.
    pub matt: Vec2,
    /// Of the pixel's glossy lobe, of a rectangle of radiance 1, times 1, `s_x`.
    pub white: Vec2,
}

/// What arrives where nothing can.
#[kernel]
pub fn rect_quadrature_nothing() -> QuadratureIntegral {
    QuadratureIntegral { glossy: Vec4::ZERO, matt: Vec2::ZERO, white: Vec2::ZERO }
}

/// Adds a place that stands for `area`.
///
/// `side` is 0 for a place of the rectangle's lobe, 1 for one of the pixel's: each lobe takes its share of `glossy`, the
/// rectangle's all of `matt`, the pixel's all of `white`.
#[kernel]
pub fn rect_quadrature_add(
    sum: QuadratureIntegral,
    at: QuadratureIntegrand,
    area: f32,
    side: f32,
) -> QuadratureIntegral {
    let by_reflector = at.reflector_grazing;
    let by_receiver = at.receiver_grazing;
    let powers = Vec4::new(1.0, by_reflector, by_receiver, by_reflector * by_receiver);
    QuadratureIntegral {
        glossy: sum.glossy + (abs(side - at.share) * area * at.glossy) * powers,
        matt: sum.matt + ((1.0 - side) * area * at.matt) * Vec2::new(1.0, by_reflector),
        white: sum.white + (side * area * at.white) * Vec2::new(1.0, by_receiver),
    }
}

/// Adds a lobe's part by three lines of three places each.
///
/// `side` is 0 for the rectangle's lobe, whose places serve the pixel's diffuse lobe, too, and 1 for the pixel's, whose
/// places serve the rectangle's diffuse lobe.
#[kernel]
pub fn rect_quadrature_part(
    sum: QuadratureIntegral,
    seen: QuadratureView,
    start: QuadratureStart,
    side: f32,
) -> QuadratureIntegral {
    let own_lines = rect_quadrature_cross(seen.height, start.place.offset);
    let own = rect_quadrature_by_angle(start.lobe, start.place, own_lines);
    let is_turned = rect_quadrature_is_longer(seen, own, own_lines);
    let view = rect_quadrature_turned(seen, is_turned);
    let lobe = rect_quadrature_turned_lobe(own, is_turned);
    let offset = select(start.place.offset, start.place.offset.yx(), is_turned);
    let lines = rect_quadrature_cross(view.height, offset);
    let outer = rect_quadrature_outer(view);
    let marginal = rect_quadrature_marginal(view, offset, lobe, lines);
    let mut total = sum;
    for i in 0u32..3u32 {
        let way = rect_quadrature_place(marginal, rect_quadrature_abscissa(i));
        let y = rect_quadrature_along(lines.y, way, outer);
        let inner = rect_quadrature_inner(view, y.place);
        let row = rect_quadrature_line(sqrt(view.height * view.height + y.place * y.place), offset.x);
        let conditional = rect_quadrature_conditional(lobe, way.place, row, inner);
        let height = rect_quadrature_weight(i) * y.rate;
        for k in 0u32..3u32 {
            let node = rect_quadrature_place(conditional, rect_quadrature_abscissa(k));
            let x = rect_quadrature_along(row, node, inner);
            let place = rect_quadrature_seen(view, Vec2::new(x.place, y.place));
            let at = rect_quadrature_integrand(view, place);
            let area = height * (rect_quadrature_weight(k) * x.rate);
            total = rect_quadrature_add(total, at, area, side);
        }
    }
    total
}

/// The interreflection by nine places for each lobe: for each pixel, rectangle and light.
///
/// `view` is the unit direction from the pixel to the viewer in the rectangle's frame.
#[kernel]
pub fn rect_quadrature(
    reflector: LaplaceReflector,
    receiver: LaplaceReceiver,
    view: Vec3,
) -> QuadratureIntegral {
    if rect_laplace_is_dark(reflector, receiver) {
        return rect_quadrature_nothing();
    }
    let seen = rect_quadrature_view(reflector, receiver, view);
    let mut total = rect_quadrature_nothing();
    for side in 0u32..2u32 {
        let start = rect_quadrature_start(seen, receiver, side);
        total = rect_quadrature_part(total, seen, start, side as f32);
    }
    // What is the same everywhere.
    let matt = 0.5 * reflector.light.z * reflector.gloss.square / PI;
    let white = 0.5 * receiver.gloss.square / PI;
    QuadratureIntegral {
        glossy: (matt * white) * total.glossy,
        matt: matt * total.matt,
        white: white * total.white,
    }
}
