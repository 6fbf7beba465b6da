//! The camera's rays.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::Pharr23;
use crate::scene::{NOWHERE, SceneRay};
use lobe_codegen::prelude::*;

/// A pinhole camera.
#[kernel]
pub struct PinholeCamera {
    /// Where it is.
    #[domain(-100.0..=100.0)]
    pub position: Vec3,
    /// Columns of the picture.
    pub width: u32,
    /// Unit direction through the middle of the picture.
    #[domain(unit)]
    pub forward: Vec3,
    /// Rows of the picture.
    pub height: u32,
    /// From the middle of the picture at distance 1 to the middle of its right side.
    pub right: Vec3,
    /// From there to the middle of its upper side.
    pub up: Vec3,
}

/// The ray through the middle of a pixel.
///
/// `normalize(f + (2 (i + ½)/W - 1) r + (1 - 2 (j + ½)/H) u)`
/// Source: [Pharr23] section 5.2.2.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `camera` | the camera | position -100 ..= 100 | m |
/// | `column`, `row` | the pixel, from the left and from the top | below the size | 1 |
///
/// Returns the ray, of reach 1e30.
#[kernel]
pub fn camera_ray(camera: PinholeCamera, column: u32, row: u32) -> SceneRay {
    let x = (2 * column + 1) as f32 / camera.width as f32 - 1.0;
    let y = 1.0 - (2 * row + 1) as f32 / camera.height as f32;
    let towards = camera.forward + (x * camera.right + y * camera.up);
    let dir = towards * inverse_sqrt(dot(towards, towards));
    SceneRay { origin: camera.position, reach: 1e30, dir, leaving: NOWHERE, reaching: NOWHERE }
}

/// The rays of all pixels, row by row: a pass.
#[kernel(workgroup_size(64))]
pub fn camera_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] camera: &PinholeCamera,
    #[storage(0, 1)] rays: &mut [SceneRay],
) {
    let i = id.x;
    if i < rays.len() as u32 {
        rays[i as usize] = camera_ray(*camera, i % camera.width, i / camera.width);
    }
}
