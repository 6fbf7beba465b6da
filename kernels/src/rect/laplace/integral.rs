//! The geometric part of the interreflection, for each pixel, rectangle and light.

use crate::hsg::TWO_PI;
use crate::rect::laplace::evaluate::{
    LaplaceForm, LaplaceSpot, rect_laplace_fall, rect_laplace_fall_sg, rect_laplace_form,
    rect_laplace_receiver_slope, rect_laplace_reflector_slope, rect_laplace_spot,
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

/// What arrives where nothing can.
#[kernel]
pub fn rect_laplace_nothing() -> LaplaceIntegral {
    LaplaceIntegral { value: 0.0, dir: Vec3::new(0.0, 0.0, -1.0) }
}

/// Result out of its factors.
#[kernel]
pub fn rect_laplace_result(
    reflector: LaplaceReflector,
    peak: LaplacePoint,
    secant: Vec2,
    area: f32,
) -> LaplaceIntegral {
    let spot = peak.spot;
    // No approximate area makes a projected solid angle above 2π.
    let seen = min(max(spot.cosine, 0.0) * spot.down * (secant.x * secant.y * area), TWO_PI);
    LaplaceIntegral {
        value: reflector.peak * peak.density * seen,
        dir: Vec3::new(spot.along.x, spot.along.y, -spot.down),
    }
}

/// Form around a spot, for the search.
#[kernel]
pub fn rect_laplace_local(
    reflector: LaplaceReflector,
    receiver: LaplaceReceiver,
    spot: LaplaceSpot,
) -> LaplaceForm {
    let ours = rect_laplace_reflector_slope(reflector.light, spot);
    let theirs = rect_laplace_receiver_slope(receiver, spot);
    let reflector_fall = rect_laplace_fall(ours.square, reflector.gloss);
    let receiver_fall = rect_laplace_fall(theirs.square, receiver.gloss);
    rect_laplace_form(receiver, spot, ours, reflector_fall.weight, theirs, receiver_fall.weight)
}

/// Form around a spot, for the search; spherical Gaussian.
#[kernel]
pub fn rect_laplace_local_sg(
    reflector: LaplaceReflector,
    receiver: LaplaceReceiver,
    spot: LaplaceSpot,
) -> LaplaceForm {
    let ours = rect_laplace_reflector_slope(reflector.light, spot);
    let theirs = rect_laplace_receiver_slope(receiver, spot);
    let reflector_fall = rect_laplace_fall(ours.square, reflector.gloss);
    let receiver_fall = rect_laplace_fall_sg(theirs.square, receiver.gloss);
    rect_laplace_form(receiver, spot, ours, reflector_fall.weight, theirs, receiver_fall.weight)
}

/// Everything at a spot.
#[kernel]
pub fn rect_laplace_point(reflector: LaplaceReflector, receiver: LaplaceReceiver, at: Vec2) -> LaplacePoint {
    let spot = rect_laplace_spot(receiver, at);
    let ours = rect_laplace_reflector_slope(reflector.light, spot);
    let theirs = rect_laplace_receiver_slope(receiver, spot);
    let reflector_fall = rect_laplace_fall(ours.square, reflector.gloss);
    let receiver_fall = rect_laplace_fall(theirs.square, receiver.gloss);
    let falls = (1.0 + reflector_fall.value) * (1.0 + receiver_fall.value);
    LaplacePoint {
        spot,
        local: rect_laplace_form(receiver, spot, ours, reflector_fall.weight, theirs, receiver_fall.weight),
        density: receiver.gloss.square * (falls * falls),
        own: (2.0 * spot.down) * ours.scale * reflector_fall.value,
    }
}

/// Everything at a spot; spherical Gaussian.
#[kernel]
pub fn rect_laplace_point_sg(
    reflector: LaplaceReflector,
    receiver: LaplaceReceiver,
    at: Vec2,
) -> LaplacePoint {
    let spot = rect_laplace_spot(receiver, at);
    let ours = rect_laplace_reflector_slope(reflector.light, spot);
    let theirs = rect_laplace_receiver_slope(receiver, spot);
    let reflector_fall = rect_laplace_fall(ours.square, reflector.gloss);
    let receiver_fall = rect_laplace_fall_sg(theirs.square, receiver.gloss);
    let reflector_root = 1.0 + reflector_fall.value;
    LaplacePoint {
        spot,
        local: rect_laplace_form(receiver, spot, ours, reflector_fall.weight, theirs, receiver_fall.weight),
        density: reflector_root * reflector_root * receiver_fall.value / receiver.gloss.square,
        own: (2.0 * spot.down) * ours.scale * reflector_fall.value,
    }
}

/// Sharpening.
#[kernel]
pub fn rect_laplace_sharpening(share: f32) -> Vec2 {
    let more = 0.03 + share * (1.24 - 1.29 * share);
    Vec2::new(1.0 + more, more)
}

/// Sharpening; spherical Gaussian.
#[kernel]
pub fn rect_laplace_sharpening_sg(share: f32) -> Vec2 {
    let more = 0.88 - share * (0.28 + 0.61 * share);
    Vec2::new(1.0 + more, more)
}

/// Inner evaluation.
#[kernel]
pub fn rect_laplace_integral(reflector: LaplaceReflector, receiver: LaplaceReceiver) -> LaplaceIntegral {
    if rect_laplace_is_dark(reflector, receiver) {
        return rect_laplace_nothing();
    }
    let start = rect_laplace_lift(receiver, rect_laplace_start(reflector, receiver), 0.1);
    let first = rect_laplace_spot(receiver, start);
    let step = rect_laplace_step(receiver, first, rect_laplace_local(reflector, receiver, first));
    let peak = rect_laplace_point(reflector, receiver, rect_laplace_lift(receiver, step, 0.03));
    let extent = rect_laplace_extent(receiver, peak.spot);
    let angles = rect_laplace_angles(peak.spot, peak.local, extent.secant, peak.own);
    let area = rect_laplace_area(angles, extent, rect_laplace_sharpening(angles.share));
    rect_laplace_result(reflector, peak, extent.secant, area)
}

/// Inner evaluation; spherical Gaussian.
#[kernel]
pub fn rect_laplace_integral_sg(reflector: LaplaceReflector, receiver: LaplaceReceiver) -> LaplaceIntegral {
    if rect_laplace_is_dark(reflector, receiver) {
        return rect_laplace_nothing();
    }
    let start = rect_laplace_lift(receiver, rect_laplace_start(reflector, receiver), 0.1);
    let first = rect_laplace_spot(receiver, start);
    let step = rect_laplace_step(receiver, first, rect_laplace_local_sg(reflector, receiver, first));
    let peak = rect_laplace_point_sg(reflector, receiver, rect_laplace_lift(receiver, step, 0.03));
    let extent = rect_laplace_extent(receiver, peak.spot);
    let angles = rect_laplace_angles(peak.spot, peak.local, extent.secant, peak.own);
    let area = rect_laplace_area(angles, extent, rect_laplace_sharpening_sg(angles.share));
    rect_laplace_result(reflector, peak, extent.secant, area)
}

/// Inner evaluation; fast.
#[kernel]
pub fn rect_laplace_fast_integral(reflector: LaplaceReflector, receiver: LaplaceReceiver) -> LaplaceIntegral {
    if rect_laplace_is_dark(reflector, receiver) {
        return rect_laplace_nothing();
    }
    let start = rect_laplace_lift(receiver, rect_laplace_start(reflector, receiver), 0.1);
    let peak = rect_laplace_point(reflector, receiver, start);
    let extent = rect_laplace_extent(receiver, peak.spot);
    let angles = rect_laplace_angles(peak.spot, peak.local, extent.secant, peak.own);
    let area = rect_laplace_area_fast(angles, extent, rect_laplace_sharpening(angles.share));
    rect_laplace_result(reflector, peak, extent.secant, area)
}

/// Inner evaluation; fast; spherical Gaussian.
#[kernel]
pub fn rect_laplace_fast_integral_sg(
    reflector: LaplaceReflector,
    receiver: LaplaceReceiver,
) -> LaplaceIntegral {
    if rect_laplace_is_dark(reflector, receiver) {
        return rect_laplace_nothing();
    }
    let start = rect_laplace_lift(receiver, rect_laplace_start(reflector, receiver), 0.1);
    let peak = rect_laplace_point_sg(reflector, receiver, start);
    let extent = rect_laplace_extent(receiver, peak.spot);
    let angles = rect_laplace_angles(peak.spot, peak.local, extent.secant, peak.own);
    let area = rect_laplace_area_fast(angles, extent, rect_laplace_sharpening_sg(angles.share));
    rect_laplace_result(reflector, peak, extent.secant, area)
}
