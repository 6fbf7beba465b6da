//! Kernels of tables whose rows hold lists: the library's kernels, over arrays.
//!
//! A shader has no lists; there a loop or a mip chain calls the same kernels.

use lobe_codegen::def::FunctionRef;
use lobe_codegen::glam::Vec3;
use lobe_codegen::kernels;
use lobe_codegen::prelude::*;
use lobe_kernels::filter::{
    moments_empty, moments_merge, moments_of_lobe, moments_of_position, moments_to_lobe, toksvig_length_paper,
};
use lobe_kernels::vsgl::vsgl_from_moments;

/// What the filter of lobes returns.
#[kernel]
pub struct FilteredLobe {
    /// Average of the directions.
    pub mean: Vec3,
    /// Its length.
    pub len: f32,
    /// Unit axis.
    pub axis: Vec3,
    /// Sharpness.
    pub sharpness: f32,
}

/// What virtual point lights make together.
#[kernel]
pub struct FilteredLight {
    /// Sum of the weights.
    pub weight: f32,
    /// Mean position.
    pub mean: Vec3,
    /// Trace of the covariance of the positions.
    pub trace: f32,
    /// Variance along one axis.
    pub variance: f32,
    /// Average of the directions.
    pub direction: Vec3,
    /// Unit axis.
    pub axis: Vec3,
    /// Sharpness.
    pub sharpness: f32,
    /// Radiant intensity along the axis.
    pub intensity: f32,
}

/// Lobes, filtered into one.
///
/// The first lobe's mean direction is the reference.
#[kernel(family = "filter", cite = "[Toksvig05]")]
pub fn toksvig_list(
    axes: [Vec3; 64],
    sharpnesses: [f32; 64],
    weights: [f32; 64],
    count: u32,
) -> FilteredLobe {
    let reference = toksvig_length_paper(sharpnesses[0]) * axes[0];
    let mut moments = moments_empty();
    for i in 0..count {
        let lobe = moments_of_lobe(axes[i as usize], sharpnesses[i as usize], weights[i as usize], reference);
        moments = moments_merge(moments, lobe);
    }
    let mean = reference + moments.mean;
    let lobe = moments_to_lobe(moments, reference);
    FilteredLobe { mean, len: length(mean), axis: lobe.axis, sharpness: lobe.sharpness }
}

/// Virtual point lights, filtered into one light.
///
/// The first position is the origin, the first lobe's mean direction the reference.
#[kernel(family = "vsgl", cite = "[Tokuyoshi15b] section 2")]
pub fn vsgl_list(
    positions: [Vec3; 64],
    axes: [Vec3; 64],
    sharpnesses: [f32; 64],
    weights: [f32; 64],
    count: u32,
) -> FilteredLight {
    let origin = positions[0];
    let reference = toksvig_length_paper(sharpnesses[0]) * axes[0];
    let mut places = moments_empty();
    let mut lobes = moments_empty();
    for i in 0..count {
        let weight = weights[i as usize];
        places = moments_merge(places, moments_of_position(positions[i as usize], weight, origin));
        lobes = moments_merge(
            lobes,
            moments_of_lobe(axes[i as usize], sharpnesses[i as usize], weight, reference),
        );
    }
    let light = vsgl_from_moments(places, origin, lobes, reference);
    FilteredLight {
        weight: lobes.weight,
        mean: light.mean,
        trace: places.spread,
        variance: light.variance,
        direction: reference + lobes.mean,
        axis: light.axis,
        sharpness: light.sharpness,
        intensity: light.intensity,
    }
}

/// The kernel `name` among these.
#[must_use]
pub fn find(name: &str) -> Option<FunctionRef> {
    kernels![toksvig_list, vsgl_list].into_iter().find(|k| k().name == name)
}
