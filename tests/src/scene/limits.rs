//! What numbers of a scene may be, and the words for those that may not.

use super::{Camera, SceneError};
use lobe_codegen::glam::{DVec3, Vec3};
use std::ops::RangeInclusive;

/// Coordinates in metres: so large that their squares are still numbers.
pub(super) const PLACES: RangeInclusive<f64> = -1e9..=1e9;
/// Radiometric quantities.
pub(super) const POWERS: RangeInclusive<f64> = 0.0..=1e9;
/// Albedos and reflectances.
pub(super) const SHARES: RangeInclusive<f64> = 0.0..=1.0;
/// The narrowest distribution that the kernels promise anything of, and the widest.
pub(super) const ALPHAS: RangeInclusive<f64> = 0.02..=1.0;
/// The cone that kernels know: `spot_irradiance`.
pub(super) const OUTER_DEGREES: RangeInclusive<f64> = 1.15..=89.95;
/// By how much the inner cone is narrower.
pub(super) const LEAST_BLEND_DEGREES: f64 = 0.06;
/// Angles from the bottom of a picture to its top.
const VIEW_DEGREES: RangeInclusive<f64> = 1e-3..=179.0;
/// Columns and rows of the largest picture.
const LARGEST: u32 = 16_384;

pub(super) fn refused<T>(at: &str, message: impl Into<String>) -> Result<T, SceneError> {
    Err(SceneError::Value { at: at.to_owned(), message: message.into() })
}

pub(super) fn number(at: &str, value: f64, range: &RangeInclusive<f64>) -> Result<f32, SceneError> {
    match range.contains(&value) {
        true => Ok(value as f32),
        false => refused(at, format!("{value} is not in {} ..= {}", range.start(), range.end())),
    }
}

pub(super) fn triple(at: &str, value: [f64; 3], range: &RangeInclusive<f64>) -> Result<Vec3, SceneError> {
    let [x, y, z] = value;
    Ok(Vec3::new(number(at, x, range)?, number(at, y, range)?, number(at, z, range)?))
}

pub(super) fn place(at: &str, value: [f64; 3]) -> Result<DVec3, SceneError> {
    triple(at, value, &PLACES)?;
    Ok(DVec3::from_array(value))
}

/// A direction, of whatever length.
pub(super) fn direction(at: &str, value: [f64; 3]) -> Result<DVec3, SceneError> {
    match place(at, value)?.try_normalize() {
        Some(unit) => Ok(unit),
        None => refused(at, "it has no direction; give it a length"),
    }
}

/// A view angle in degrees, called `at`, as radians.
pub(super) fn view_angle(at: &str, degrees: f64) -> Result<f64, SceneError> {
    number(at, degrees, &VIEW_DEGREES)?;
    Ok(degrees.to_radians())
}

/// Columns and rows of a picture.
pub(super) fn picture(size: [u32; 2]) -> Result<[u32; 2], SceneError> {
    for (name, pixels) in ["camera.width", "camera.height"].into_iter().zip(size) {
        if !(1..=LARGEST).contains(&pixels) {
            return refused(name, format!("{pixels} is not in 1 ..= {LARGEST}"));
        }
    }
    Ok(size)
}

/// A camera, unless it looks nowhere.
pub(super) fn camera(
    at: &str,
    [position, target, up]: [DVec3; 3],
    vfov: f64,
    size: [u32; 2],
) -> Result<Camera, SceneError> {
    match Camera::new(position, target, up, vfov, size) {
        Some(camera) => Ok(camera),
        None => refused(at, "it looks at itself, or along its up; move look_at or up"),
    }
}
