//! The geometric part of the interreflection, for each pixel, rectangle and light.

use crate::constants::HALF_PI;
use crate::rect::laplace::evaluate::{
    LaplaceForm, LaplaceSpot, rect_laplace_fall, rect_laplace_fall_sg, rect_laplace_form, rect_laplace_pair,
    rect_laplace_spot,
};
use crate::rect::laplace::frame::{LaplaceReceiver, LaplaceReflector, rect_laplace_is_dark};
use crate::rect::laplace::search::{rect_laplace_lift, rect_laplace_start, rect_laplace_step};
use crate::rect::laplace::width::{
    rect_laplace_angles, rect_laplace_area, rect_laplace_area_fast, rect_laplace_extent,
};
use lobe_codegen::prelude::*;

/// The geometric part of the interreflection, and where it comes from.
#[kernel]
pub struct LaplaceIntegral {
    /// `cos ∫ D_r D_x cos cos dA/distance²`, without irradiance and reflectances.
    pub value: f32,
    /// Unit direction from the pixel to the spot that stands for the rectangle, in the rectangle's frame.
    pub dir: Vec3,
}

/// A spot that is evaluated in full.
#[kernel]
pub struct LaplacePoint {
    /// The spot.
    pub spot: LaplaceSpot,
    /// Minus the logarithm of the integrand around it.
    pub local: LaplaceForm,
    /// Product of both distributions, without the constant factors of the reflector's.
    pub density: f32,
    /// Root of the determinant of the reflector's distribution alone.
    pub own: f32,
}

/// The integral out of its factors: the densities at the spot, both cosines, and the effective area.
#[kernel]
pub fn rect_laplace_result(
    reflector: LaplaceReflector,
    peak: LaplacePoint,
    secant: Vec2,
    quarter: f32,
) -> LaplaceIntegral {
    let spot = peak.spot;
    // No area, of which this is a quarter, makes a projected solid angle above 2π.
    let seen = min(max(spot.cosine, 0.0) * spot.down * (secant.x * secant.y * quarter), HALF_PI);
    LaplaceIntegral {
        value: reflector.peak * peak.density * seen,
        dir: Vec3::new(spot.along.x, spot.along.y, -spot.down),
    }
}

/// What arrives where nothing can.
#[kernel]
pub fn rect_laplace_nothing() -> LaplaceIntegral {
    LaplaceIntegral { value: 0.0, dir: Vec3::new(0.0, 0.0, -1.0) }
}

/// The integrand's form around a spot, for the search.
#[kernel]
pub fn rect_laplace_local(
    reflector: LaplaceReflector,
    receiver: LaplaceReceiver,
    spot: LaplaceSpot,
) -> LaplaceForm {
    let pair = rect_laplace_pair(reflector, receiver, spot);
    let fall = rect_laplace_fall(pair.receiver.square, receiver.gloss);
    rect_laplace_form(receiver, spot, pair, fall.weight)
}

/// The integrand's form around a spot, for the search, the receiver's distribution being a spherical Gaussian.
#[kernel]
pub fn rect_laplace_local_sg(
    reflector: LaplaceReflector,
    receiver: LaplaceReceiver,
    spot: LaplaceSpot,
) -> LaplaceForm {
    let pair = rect_laplace_pair(reflector, receiver, spot);
    let fall = rect_laplace_fall_sg(pair.receiver.square, receiver.gloss);
    rect_laplace_form(receiver, spot, pair, fall.weight)
}

/// Everything at a spot.
#[kernel]
pub fn rect_laplace_point(reflector: LaplaceReflector, receiver: LaplaceReceiver, at: Vec2) -> LaplacePoint {
    let spot = rect_laplace_spot(receiver, at);
    let pair = rect_laplace_pair(reflector, receiver, spot);
    let fall = rect_laplace_fall(pair.receiver.square, receiver.gloss);
    let roots = (1.0 + pair.reflector_fall.value) * (1.0 + fall.value);
    LaplacePoint {
        spot,
        local: rect_laplace_form(receiver, spot, pair, fall.weight),
        density: receiver.gloss.square * (roots * roots),
        own: (2.0 * spot.down) * pair.reflector.scale * pair.reflector_fall.value,
    }
}

/// Everything at a spot, the receiver's distribution being a spherical Gaussian.
#[kernel]
pub fn rect_laplace_point_sg(
    reflector: LaplaceReflector,
    receiver: LaplaceReceiver,
    at: Vec2,
) -> LaplacePoint {
    let spot = rect_laplace_spot(receiver, at);
    let pair = rect_laplace_pair(reflector, receiver, spot);
    let fall = rect_laplace_fall_sg(pair.receiver.square, receiver.gloss);
    let root = 1.0 + pair.reflector_fall.value;
    LaplacePoint {
        spot,
        local: rect_laplace_form(receiver, spot, pair, fall.weight),
        density: root * root * fall.value / receiver.gloss.square,
        own: (2.0 * spot.down) * pair.reflector.scale * pair.reflector_fall.value,
    }
}

/// How far the profile's `S` slides, as `(1 + more, more)`, for a GGX receiver: 0.03 where the reflector has no part in the
/// peak, 0.33 where both have half.
///
/// The energy-exact values are -0.05 for one GGX lobe and 0.4 for the product of two equal ones; the polynomial was fitted.
#[kernel]
pub fn rect_laplace_sharpening(share: f32) -> Vec2 {
    let more = 0.03 + share * (1.24 - 1.29 * share);
    Vec2::new(1.0 + more, more)
}

/// How far the profile's `S` slides, as `(1 + more, more)`, for a spherical Gaussian receiver: 0.88 for the Gaussian alone,
/// which would keep its energy at 0.91.
#[kernel]
pub fn rect_laplace_sharpening_sg(share: f32) -> Vec2 {
    let more = 0.88 - share * (0.28 + 0.61 * share);
    Vec2::new(1.0 + more, more)
}

/// The geometric part of [`rect_laplace`](crate::rect::laplace::rect_laplace), and where it comes from: for each
/// pixel, rectangle and light.
#[kernel]
pub fn rect_laplace_integral(reflector: LaplaceReflector, receiver: LaplaceReceiver) -> LaplaceIntegral {
    if rect_laplace_is_dark(reflector, receiver) {
        return rect_laplace_nothing();
    }
    let start = rect_laplace_start(reflector, receiver);
    let first = rect_laplace_spot(receiver, start);
    let local = rect_laplace_local(reflector, receiver, first);
    let moved = rect_laplace_step(receiver, first, local);
    let at = rect_laplace_lift(receiver, moved, 0.03);
    let peak = rect_laplace_point(reflector, receiver, at);
    let extent = rect_laplace_extent(receiver, peak.spot);
    let angles = rect_laplace_angles(peak.spot, peak.local, extent.secant, peak.own);
    let sharpening = rect_laplace_sharpening(angles.share);
    let quarter = rect_laplace_area(angles, extent, sharpening);
    rect_laplace_result(reflector, peak, extent.secant, quarter)
}

/// The geometric part of [`rect_laplace_sg`](crate::rect::laplace::rect_laplace_sg).
#[kernel]
pub fn rect_laplace_integral_sg(reflector: LaplaceReflector, receiver: LaplaceReceiver) -> LaplaceIntegral {
    if rect_laplace_is_dark(reflector, receiver) {
        return rect_laplace_nothing();
    }
    let start = rect_laplace_start(reflector, receiver);
    let first = rect_laplace_spot(receiver, start);
    let local = rect_laplace_local_sg(reflector, receiver, first);
    let moved = rect_laplace_step(receiver, first, local);
    let at = rect_laplace_lift(receiver, moved, 0.03);
    let peak = rect_laplace_point_sg(reflector, receiver, at);
    let extent = rect_laplace_extent(receiver, peak.spot);
    let angles = rect_laplace_angles(peak.spot, peak.local, extent.secant, peak.own);
    let sharpening = rect_laplace_sharpening_sg(angles.share);
    let quarter = rect_laplace_area(angles, extent, sharpening);
    rect_laplace_result(reflector, peak, extent.secant, quarter)
}

/// The geometric part of [`rect_laplace_fast`](crate::rect::laplace::rect_laplace_fast).
#[kernel]
pub fn rect_laplace_fast_integral(reflector: LaplaceReflector, receiver: LaplaceReceiver) -> LaplaceIntegral {
    if rect_laplace_is_dark(reflector, receiver) {
        return rect_laplace_nothing();
    }
    let start = rect_laplace_start(reflector, receiver);
    let peak = rect_laplace_point(reflector, receiver, start);
    let extent = rect_laplace_extent(receiver, peak.spot);
    let angles = rect_laplace_angles(peak.spot, peak.local, extent.secant, peak.own);
    let sharpening = rect_laplace_sharpening(angles.share);
    let quarter = rect_laplace_area_fast(angles, extent, sharpening);
    rect_laplace_result(reflector, peak, extent.secant, quarter)
}

/// The geometric part of [`rect_laplace_fast_sg`](crate::rect::laplace::rect_laplace_fast_sg).
#[kernel]
pub fn rect_laplace_fast_integral_sg(
    reflector: LaplaceReflector,
    receiver: LaplaceReceiver,
) -> LaplaceIntegral {
    if rect_laplace_is_dark(reflector, receiver) {
        return rect_laplace_nothing();
    }
    let start = rect_laplace_start(reflector, receiver);
    let peak = rect_laplace_point_sg(reflector, receiver, start);
    let extent = rect_laplace_extent(receiver, peak.spot);
    let angles = rect_laplace_angles(peak.spot, peak.local, extent.secant, peak.own);
    let sharpening = rect_laplace_sharpening_sg(angles.share);
    let quarter = rect_laplace_area_fast(angles, extent, sharpening);
    rect_laplace_result(reflector, peak, extent.secant, quarter)
}
