//! The camera: one ray through the middle of each pixel.

use lobe_codegen::glam::{DVec3, Vec3};

/// A pinhole camera.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// Columns and rows of the picture.
    pub size: [u32; 2],
    position: DVec3,
    forward: DVec3,
    right: DVec3,
    up: DVec3,
    /// Half the height of the picture at distance 1.
    half_height: f64,
}

/// Where a ray begins, and its unit direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    /// Its beginning, m.
    pub origin: Vec3,
    /// Its unit direction.
    pub direction: Vec3,
}

/// Shorter than this, a cross product of unit vectors says nothing of their plane.
const LEAST_SINE: f64 = 1e-4;

impl Camera {
    /// A camera at `position` that looks at `target`; `vfov` is the angle from the bottom of the picture to its top, in
    /// radians. `None` if the three are of no use: `target` at the camera, or `up` along the view.
    pub(super) fn new(position: DVec3, target: DVec3, up: DVec3, vfov: f64, size: [u32; 2]) -> Option<Self> {
        let forward = (target - position).try_normalize()?;
        let across = forward.cross(up.try_normalize()?);
        let right = across.try_normalize().filter(|_| across.length() > LEAST_SINE)?;
        let half_height = (0.5 * vfov).tan();
        Some(Self { size, position, forward, right, up: right.cross(forward), half_height })
    }

    /// Where it is, m.
    #[must_use]
    pub fn position(&self) -> Vec3 {
        self.position.as_vec3()
    }

    /// The same camera where everything is `factor` times as large.
    #[must_use]
    pub fn scaled(&self, factor: f32) -> Self {
        Self { position: f64::from(factor) * self.position, ..*self }
    }

    /// The same camera with a picture of other columns and rows.
    #[must_use]
    pub fn with_size(&self, size: [u32; 2]) -> Self {
        Self { size, ..*self }
    }

    /// The unit direction of view; and at distance 1, from the middle of the picture to that of its right and of its upper
    /// side.
    #[must_use]
    pub fn axes(&self) -> [Vec3; 3] {
        let [width, height] = self.size.map(f64::from);
        let half_width = self.half_height * width / height;
        [self.forward, half_width * self.right, self.half_height * self.up].map(|axis| axis.as_vec3())
    }

    /// The ray through the middle of a pixel; rows count from the top, columns from the left.
    #[must_use]
    pub fn ray(&self, column: u32, row: u32) -> Ray {
        let [width, height] = self.size.map(f64::from);
        let x = (2.0 * (f64::from(column) + 0.5) / width - 1.0) * self.half_height * width / height;
        let y = (1.0 - 2.0 * (f64::from(row) + 0.5) / height) * self.half_height;
        let direction = (self.forward + x * self.right + y * self.up).normalize();
        Ray { origin: self.position.as_vec3(), direction: direction.as_vec3() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera() -> Camera {
        let quarter = std::f64::consts::FRAC_PI_2;
        Camera::new(DVec3::new(0.0, 0.0, 2.0), DVec3::ZERO, DVec3::Y, quarter, [4, 2]).unwrap()
    }

    /// With a view of 90 degrees the middles of the corner pixels are at `(±3/2, ±1/2)` at distance 1.
    #[test]
    fn rays_go_through_the_middles_of_pixels() {
        for ((column, row), (x, y)) in
            [((0, 0), (-1.5, 0.5)), ((3, 0), (1.5, 0.5)), ((0, 1), (-1.5, -0.5)), ((2, 1), (0.5, -0.5))]
        {
            let Ray { origin, direction } = camera().ray(column, row);
            assert_eq!(origin, Vec3::new(0.0, 0.0, 2.0));
            let expected = Vec3::new(x, y, -1.0).normalize();
            assert!((direction - expected).length() < 1e-7, "{direction} {expected}");
        }
    }

    #[test]
    fn a_camera_that_sees_nothing_is_none() {
        let new = |target, up| Camera::new(DVec3::ONE, target, up, 1.0, [1, 1]);
        assert!(new(DVec3::ONE, DVec3::Y).is_none());
        assert!(new(DVec3::ZERO, DVec3::ZERO).is_none());
        assert!(new(DVec3::ZERO, DVec3::ONE).is_none());
        assert!(new(DVec3::ZERO, DVec3::X).is_some());
    }
}
