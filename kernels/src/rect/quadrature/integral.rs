//! The sum over the places.

use crate::constants::PI;
use crate::rect::laplace::{LaplaceReceiver, LaplaceReflector, rect_laplace_is_dark};
use crate::rect::quadrature::grid::{
    QuadratureGrid, rect_quadrature_grid, rect_quadrature_row, rect_quadrature_spot,
};
use crate::rect::quadrature::integrand::{QuadratureIntegrand, rect_quadrature_integrand};
use crate::rect::quadrature::lobe::rect_quadrature_upright;
use crate::rect::quadrature::view::rect_quadrature_view;
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

/// Which places count, a bit for each: that of the `k`-th place on the `i`-th line is `3 i + k`.
#[kernel]
pub struct QuadratureFree {
    /// Of the rectangle's lobe.
    pub by_reflector: u32,
    /// Of the pixel's.
    pub by_receiver: u32,
    /// Of those about the pixel's normal, for two diffuse lobes.
    pub by_normal: u32,
}

/// All bits of a part of [`QuadratureFree`].
#[kernel]
pub const EVERYWHERE: u32 = 511;

/// Whether the `k`-th place on the `i`-th line counts.
#[kernel]
pub fn rect_quadrature_is_free(free: u32, i: u32, k: u32) -> bool {
    ((free >> (3 * i + k)) & 1) == 1
}

/// Adds a lobe's part by three lines of three places each, of those that are `free`.
///
/// `side` is 0 for the rectangle's lobe, whose places serve the pixel's diffuse lobe, too, and 1 for the pixel's, whose
/// places serve the rectangle's diffuse lobe.
#[kernel]
pub fn rect_quadrature_part(
    sum: QuadratureIntegral,
    grid: QuadratureGrid,
    side: f32,
    free: u32,
) -> QuadratureIntegral {
    let mut total = sum;
    for i in 0u32..3u32 {
        let row = rect_quadrature_row(grid, i);
        for k in 0u32..3u32 {
            let spot = rect_quadrature_spot(grid, row, k);
            let at = rect_quadrature_integrand(grid.view, spot.place);
            let area = select(0.0, spot.area, rect_quadrature_is_free(free, i, k));
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
    let free = QuadratureFree { by_reflector: EVERYWHERE, by_receiver: EVERYWHERE, by_normal: EVERYWHERE };
    rect_quadrature_of_free(reflector, receiver, view, free)
}

/// The same by those places alone that are free.
#[kernel]
pub fn rect_quadrature_of_free(
    reflector: LaplaceReflector,
    receiver: LaplaceReceiver,
    view: Vec3,
    free: QuadratureFree,
) -> QuadratureIntegral {
    if rect_laplace_is_dark(reflector, receiver) {
        return rect_quadrature_nothing();
    }
    let seen = rect_quadrature_view(reflector, receiver, view);
    let mut total = rect_quadrature_nothing();
    for side in 0u32..2u32 {
        let grid = rect_quadrature_grid(seen, receiver, side);
        let own = select(free.by_reflector, free.by_receiver, side == 1);
        total = rect_quadrature_part(total, grid, side as f32, own);
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

/// Share of the form factor that comes from places which are `free`, of [`QuadratureFree::by_normal`].
#[kernel]
pub fn rect_quadrature_cover(
    reflector: LaplaceReflector,
    receiver: LaplaceReceiver,
    view: Vec3,
    free: u32,
) -> f32 {
    let upright = rect_quadrature_upright(receiver);
    if rect_laplace_is_dark(reflector, upright) {
        return 0.0;
    }
    let grid = rect_quadrature_grid(rect_quadrature_view(reflector, upright, view), upright, 1);
    let mut all = 0.0;
    let mut open = 0.0;
    for i in 0u32..3u32 {
        let row = rect_quadrature_row(grid, i);
        for k in 0u32..3u32 {
            let spot = rect_quadrature_spot(grid, row, k);
            let place = spot.place;
            let weight =
                spot.area * (max(place.cosine, 0.0) * place.down * (place.nearness * place.nearness));
            all += weight;
            open += select(0.0, weight, rect_quadrature_is_free(free, i, k));
        }
    }
    min(open / max(all, 1e-30), 1.0)
}
