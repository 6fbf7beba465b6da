//! The interreflection of surfaces that mask, with a spot for each lobe.
//!
//! [`rect_laplace`](crate::rect::laplace::rect_laplace) takes one spot, and reflectances for constant. Two things fail
//! it in rooms, where rectangles meet the surfaces that see them:
//!
//! - **Masking.** The reflectances have Smith's visibility, which grows towards the horizon about as the cosine falls.
//!   Here it is part of the integrand's form: of the pixel's cosine `c` only `c V(c)` counts, whose logarithm falls by the
//!   share `o α²/(S (c A + o S))` of what the cosine's does, `S² = α² + (1 - α²) c²`, `A² = α² + (1 - α²) o²`, `o` the
//!   view's cosine; and the rectangle's visibility adds its own.
//! - **Lobes apart.** Where the two mirror directions are far from each other, the product of two GGX lobes has two
//!   modes, each lobe's peak on the other's tail. The search is begun at either, and each result counts by the share of
//!   its own lobe in the squared curvature there. Where both searches end at one spot the shares add up to 1.
//!
//! Measured on scenes of the reference (glossy of glossy, without occlusion): `tests/SCENES.md`.

use crate::constants::PI;
use crate::rect::laplace::evaluate::{
    LaplaceForm, LaplacePair, LaplaceSpot, rect_laplace_fall, rect_laplace_form, rect_laplace_pair,
    rect_laplace_spot,
};
use crate::rect::laplace::frame::{LaplaceReceiver, LaplaceReflector, rect_laplace_is_dark};
use crate::rect::laplace::integral::{
    LaplaceIntegral, LaplacePoint, rect_laplace_nothing, rect_laplace_result, rect_laplace_sharpening,
};
use crate::rect::laplace::search::{rect_laplace_lift, rect_laplace_step};
use crate::rect::laplace::width::{rect_laplace_angles, rect_laplace_area, rect_laplace_extent};
use lobe_codegen::prelude::*;

/// What masking changes of the integrand's form.
#[kernel]
pub struct LaplaceMasking {
    /// Share of the fall of the pixel's cosine that the cosine times its visibility does not have.
    pub cosine: f32,
    /// Power of the distance by which masking rises.
    pub rise: f32,
}

/// Results of both searches; their sum is the integral.
#[kernel]
pub struct LaplaceSplit {
    /// Around the reflector's lobe.
    pub by_reflector: LaplaceIntegral,
    /// Around the receiver's.
    pub by_receiver: LaplaceIntegral,
}

/// `√(α² + (1 - α²) c²)`.
#[kernel]
pub fn rect_laplace_masked_root(square: f32, rest: f32, cosine: f32) -> f32 {
    sqrt(square + rest * (cosine * cosine))
}

/// The power of the distance by which the rectangle's visibility rises.
#[kernel]
pub fn rect_laplace_rise(reflector: LaplaceReflector, spot: LaplaceSpot) -> f32 {
    let gloss = reflector.gloss;
    let incidence = max(reflector.light.z, 1e-3);
    let leaving = rect_laplace_masked_root(gloss.square, gloss.rest, spot.down);
    let arriving = rect_laplace_masked_root(gloss.square, gloss.rest, incidence);
    let by_view = incidence * leaving;
    let by_light = spot.down * arriving;
    let steep = incidence * gloss.rest * (spot.down * spot.down) / leaving;
    (steep + by_light) / (by_view + by_light)
}

/// What masking of both surfaces changes at a spot.
#[kernel]
pub fn rect_laplace_masking(
    reflector: LaplaceReflector,
    receiver: LaplaceReceiver,
    spot: LaplaceSpot,
) -> LaplaceMasking {
    let gloss = receiver.gloss;
    let light = max(spot.cosine, 0.02);
    let view = max(receiver.cosine, 0.02);
    let by_light = rect_laplace_masked_root(gloss.square, gloss.rest, light);
    let by_view = rect_laplace_masked_root(gloss.square, gloss.rest, view);
    let kept = view * gloss.square / (by_light * (light * by_view + view * by_light));
    let cosine = 1.0 - kept;
    LaplaceMasking { cosine, rise: rect_laplace_rise(reflector, spot) + cosine }
}

/// The integrand's form with masking. Second derivatives are held where the lobe's width stays positive.
#[kernel]
pub fn rect_laplace_masked(
    receiver: LaplaceReceiver,
    spot: LaplaceSpot,
    plain: LaplaceForm,
    masking: LaplaceMasking,
) -> LaplaceForm {
    let horizon = receiver.facing.xy() / max(spot.cosine, 0.05);
    let squares = Vec3::new(horizon.x * horizon.x, horizon.y * horizon.y, horizon.x * horizon.y);
    let second = plain.second - masking.cosine * squares - Vec3::new(masking.rise, masking.rise, 0.0);
    LaplaceForm {
        gradient: plain.gradient + masking.cosine * horizon - masking.rise * spot.along,
        second: Vec3::new(max(second.x, -0.9), max(second.y, -0.9), second.z),
    }
}

/// Share of the reflector's lobe in the squared curvature at a spot.
#[kernel]
pub fn rect_laplace_lobe_share(pair: LaplacePair, weight: f32) -> f32 {
    let k = pair.reflector.scale;
    let l = pair.receiver.scale;
    let own = pair.reflector_fall.weight * (k * k) * (pair.reflector.products.x + pair.reflector.products.y);
    let other = weight * (l * l) * (pair.receiver.products.x + pair.receiver.products.y);
    own * own / max(own * own + other * other, 1e-30)
}

/// Where a direction from the pixel meets the rectangle, clamped to it and lifted above the pixel's horizon.
#[kernel]
pub fn rect_laplace_met(receiver: LaplaceReceiver, dir: Vec3) -> Vec2 {
    let scale = receiver.offset.z / max(-dir.z, 0.05);
    let met = clamp(receiver.offset.xy() + scale * dir.xy(), -receiver.extent, receiver.extent);
    rect_laplace_lift(receiver, met, 0.1)
}

/// A step of the search with masking.
#[kernel]
pub fn rect_laplace_masked_step(reflector: LaplaceReflector, receiver: LaplaceReceiver, at: Vec2) -> Vec2 {
    let spot = rect_laplace_spot(receiver, at);
    let pair = rect_laplace_pair(reflector, receiver, spot);
    let fall = rect_laplace_fall(pair.receiver.square, receiver.gloss);
    let plain = rect_laplace_form(receiver, spot, pair, fall.weight);
    let local = rect_laplace_masked(receiver, spot, plain, rect_laplace_masking(reflector, receiver, spot));
    rect_laplace_lift(receiver, rect_laplace_step(receiver, spot, local), 0.03)
}

/// The integral about a point, out of its form there.
#[kernel]
pub fn rect_laplace_about(
    reflector: LaplaceReflector,
    receiver: LaplaceReceiver,
    peak: LaplacePoint,
) -> LaplaceIntegral {
    let extent = rect_laplace_extent(receiver, peak.spot);
    let angles = rect_laplace_angles(peak.spot, peak.local, extent.secant, peak.own);
    let quarter = rect_laplace_area(angles, extent, rect_laplace_sharpening(angles.share));
    rect_laplace_result(reflector, peak, extent.secant, quarter)
}

/// What is found from `start` in two steps: for the reflector's lobe if `side` is 0, for the receiver's if 1.
#[kernel]
pub fn rect_laplace_mode(
    reflector: LaplaceReflector,
    receiver: LaplaceReceiver,
    start: Vec2,
    side: f32,
) -> LaplaceIntegral {
    let moved = rect_laplace_masked_step(reflector, receiver, start);
    let at = rect_laplace_masked_step(reflector, receiver, moved);
    let spot = rect_laplace_spot(receiver, at);
    let pair = rect_laplace_pair(reflector, receiver, spot);
    let fall = rect_laplace_fall(pair.receiver.square, receiver.gloss);
    let plain = rect_laplace_form(receiver, spot, pair, fall.weight);
    let roots = (1.0 + pair.reflector_fall.value) * (1.0 + fall.value);
    let peak = LaplacePoint {
        spot,
        local: rect_laplace_masked(receiver, spot, plain, rect_laplace_masking(reflector, receiver, spot)),
        density: receiver.gloss.square * (roots * roots),
        own: (2.0 * spot.down) * pair.reflector.scale * pair.reflector_fall.value,
    };
    let found = rect_laplace_about(reflector, receiver, peak);
    let share = abs(side - rect_laplace_lobe_share(pair, fall.weight));
    LaplaceIntegral { value: share * found.value, dir: found.dir }
}

/// The integral by a spot for each lobe, of surfaces that mask: for each pixel, rectangle and light.
///
/// Reflectances are to be taken at the two directions.
#[kernel]
pub fn rect_laplace_split(reflector: LaplaceReflector, receiver: LaplaceReceiver) -> LaplaceSplit {
    if rect_laplace_is_dark(reflector, receiver) {
        return LaplaceSplit { by_reflector: rect_laplace_nothing(), by_receiver: rect_laplace_nothing() };
    }
    let image = Vec3::new(reflector.light.x, reflector.light.y, -reflector.light.z);
    let first = rect_laplace_met(receiver, image);
    let second = rect_laplace_met(receiver, receiver.mirror);
    LaplaceSplit {
        by_reflector: rect_laplace_mode(reflector, receiver, first, 0.0),
        by_receiver: rect_laplace_mode(reflector, receiver, second, 1.0),
    }
}

/// The form of the integrand without the receiver's lobe: the reflector's and the cosine, with the reflector's masking.
#[kernel]
pub fn rect_laplace_matt_form(
    reflector: LaplaceReflector,
    receiver: LaplaceReceiver,
    spot: LaplaceSpot,
    pair: LaplacePair,
) -> LaplaceForm {
    let plain = rect_laplace_form(receiver, spot, pair, 0.0);
    let masking = LaplaceMasking { cosine: 0.0, rise: rect_laplace_rise(reflector, spot) };
    rect_laplace_masked(receiver, spot, plain, masking)
}

/// A step of the search for a matt receiver.
#[kernel]
pub fn rect_laplace_matt_step(reflector: LaplaceReflector, receiver: LaplaceReceiver, at: Vec2) -> Vec2 {
    let spot = rect_laplace_spot(receiver, at);
    let pair = rect_laplace_pair(reflector, receiver, spot);
    let local = rect_laplace_matt_form(reflector, receiver, spot, pair);
    rect_laplace_lift(receiver, rect_laplace_step(receiver, spot, local), 0.03)
}

/// The irradiance of a matt receiver by a glossy rectangle, without light's irradiance and the rectangle's reflectance.
///
/// `(n·i) ∫ D_r(h_r) (n_x·w)+ dw`, by [`rect_laplace_split`]'s search about the reflector's lobe.
#[kernel]
pub fn rect_laplace_matt(reflector: LaplaceReflector, receiver: LaplaceReceiver) -> LaplaceIntegral {
    if rect_laplace_is_dark(reflector, receiver) {
        return rect_laplace_nothing();
    }
    let image = Vec3::new(reflector.light.x, reflector.light.y, -reflector.light.z);
    let start = rect_laplace_met(receiver, image);
    let moved = rect_laplace_matt_step(reflector, receiver, start);
    let at = rect_laplace_matt_step(reflector, receiver, moved);
    let spot = rect_laplace_spot(receiver, at);
    let pair = rect_laplace_pair(reflector, receiver, spot);
    let root = 1.0 + pair.reflector_fall.value;
    let peak = LaplacePoint {
        spot,
        local: rect_laplace_matt_form(reflector, receiver, spot, pair),
        density: PI * (root * root),
        own: (2.0 * spot.down) * pair.reflector.scale * pair.reflector_fall.value,
    };
    rect_laplace_about(reflector, receiver, peak)
}
