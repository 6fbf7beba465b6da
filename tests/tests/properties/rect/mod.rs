//! Properties of the glossy rectangle: the falloff and its fit, the disk's energy and area, the shading and what it is
//! worth against the integral, the form factor.

mod disk;
mod falloff;
mod laplace;
mod matt;
mod quadrature;
mod shade;

use lobe_codegen::prelude::*;
use lobe_kernels::rect::GlossyReceiver;
use lobe_kernels::rect::Rectangle;
use lobe_kernels::rect::reflection::DistantLight;
use proptest::prelude::*;

/// A rectangle in the plane `z = 0`.
pub(super) fn level(half_x: f32, half_y: f32) -> Rectangle {
    Rectangle { position: Vec3::ZERO, normal: Vec3::Z, tangent: Vec3::X, half_x, half_y }
}

/// A rectangle, a light on its side, a position on its side and a viewer on the position's: the scene of a shading.
type Scene = (Rectangle, f32, DistantLight, GlossyReceiver, f32);

pub(super) fn scene() -> impl Strategy<Value = Scene> {
    let rectangle = (0.2..3.0_f32, 0.2..3.0_f32).prop_map(|(x, y)| level(x, y));
    let receiver = (-1.0..1.0_f32, -1.0..1.0_f32, 0.3..3.0_f32, 0.05..0.6_f32, 0.3..1.0_f32, 0.0..6.0_f32);
    let light = (0.05..1.3_f32, 0.0..6.0_f32).prop_map(|(sigma, phi)| DistantLight {
        direction: Vec3::new(sigma.sin() * phi.cos(), sigma.sin() * phi.sin(), sigma.cos()),
        irradiance: 1.0,
    });
    (rectangle, 0.05..0.7_f32, light, receiver, 0.05..0.8_f32).prop_map(
        |(rectangle, alpha, light, (x, y, z, own, tilt, phi), radius)| {
            // Towards the peak, and looked at from near the mirror direction.
            let to_peak = (light.direction - 2.0 * light.direction.z * Vec3::Z).normalize();
            let aside = to_peak.any_orthonormal_vector();
            let normal = (to_peak + tilt * 0.3 * aside).normalize();
            let mirror = 2.0 * to_peak.dot(normal) * normal - to_peak;
            let view = (mirror + 0.1 * phi.sin() * aside).normalize();
            let receiver =
                GlossyReceiver { position: Vec3::new(x, y, z), normal, view, alpha: own, reflectance: 1.0 };
            (rectangle, alpha, light, receiver, radius)
        },
    )
}
