//! Lights that turn.

use crate::scene::{Light, Scene};
use lobe_codegen::glam::{DVec3, Vec3};

/// How lights turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turn {
    /// By how much from picture to picture, in degrees.
    pub degrees: f64,
    /// How many pictures.
    pub pictures: usize,
}

/// The scene with each light turned by an angle, in degrees, about an axis across its direction.
#[must_use]
pub fn turned(scene: &Scene, degrees: f64) -> Scene {
    let turn = |dir: Vec3| turned_by(dir, degrees.to_radians());
    let lights = scene.lights.iter().map(|light| match *light {
        Light::Directional { to_light, irradiance } => {
            Light::Directional { to_light: turn(to_light), irradiance }
        }
        Light::Spot { position, axis, inner, outer, intensity } => {
            Light::Spot { position, axis: turn(axis), inner, outer, intensity }
        }
    });
    Scene { lights: lights.collect(), ..scene.clone() }
}

/// A direction turned towards one across it.
fn turned_by(dir: Vec3, angle: f64) -> Vec3 {
    let dir = dir.as_dvec3().normalize();
    // Neither along nor across an axis of most scenes, so that light moves over all surfaces.
    let across = dir.cross(DVec3::new(0.3, 0.9, 0.2)).try_normalize().unwrap_or(DVec3::X);
    (libm::cos(angle) * dir + libm::sin(angle) * across).as_vec3()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_turn_by_the_angle() {
        for dir in [Vec3::Y, Vec3::new(0.3, 0.9, 0.2).normalize(), Vec3::new(-0.6, 0.0, 0.8)] {
            let found = turned_by(dir, 0.25);
            assert!((found.length() - 1.0).abs() < 1e-6);
            assert!((found.dot(dir) - 0.25_f32.cos()).abs() < 1e-6, "{dir} to {found}");
            assert!((turned_by(dir, 0.0) - dir).length() < 1e-7);
        }
    }
}
