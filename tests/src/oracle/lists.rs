//! Kernels of tables whose rows hold lists: the library's kernels, over arrays.
//!
//! A shader has no lists; there a loop or a mip chain calls the same kernels.

use lobe_codegen::def::FunctionRef;
use lobe_codegen::glam::Vec3;
use lobe_codegen::kernels;
use lobe_codegen::prelude::*;
use lobe_kernels::filter::{
    moments_empty, moments_merge, moments_of_lobe, moments_to_lobe, toksvig_length_paper,
};

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

/// The kernel `name` among these.
#[must_use]
pub fn find(name: &str) -> Option<FunctionRef> {
    kernels![toksvig_list].into_iter().find(|k| k().name == name)
}
