//! Lights without extent.

use crate::reference::light::spot_irradiance;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::Pharr23;
use crate::scene::{NOWHERE, SceneRay};
use lobe_codegen::prelude::*;

/// A light: one infinitely far away, or a cone.
#[kernel]
pub struct SceneLight {
    /// Unit direction to the light; of a cone, of its middle away from the light.
    #[domain(unit)]
    pub axis: Vec3,
    /// 1 for a cone, else 0.
    pub is_spot: u32,
    /// Where a cone is.
    #[domain(-100.0..=100.0)]
    pub position: Vec3,
    /// Half the angle of the cone beyond which there is no light, in rad.
    #[domain(0.02..=1.57)]
    pub outer: f32,
    /// Irradiance across the direction, linear RGB, in W/m²; of a cone, intensity, in W/sr.
    #[domain(0.0..=1e4)]
    pub strength: Vec3,
    /// By how much less the half angle is of the cone in which all of its light is, in rad.
    #[domain(1e-3..=1.57)]
    pub blend: f32,
}

/// What arrives of a light at a point.
#[kernel]
pub struct Arriving {
    /// Unit direction to the light.
    pub dir: Vec3,
    /// How far away it is, in m.
    pub dist: f32,
    /// Irradiance across the direction, linear RGB, in W/m².
    pub irradiance: Vec3,
}

/// What arrives of a light at a point that nothing is in front of.
///
/// Source: [Pharr23] section 12.1, 12.2, by [`spot_irradiance`].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `light` | the light | | |
/// | `position` | the point | -100 ..= 100 | m |
///
/// Returns direction, distance (1e30 for one infinitely far away) and irradiance. Points within 1e-6 m of a cone's
/// place count as that far from it.
#[kernel]
pub fn light_at(light: SceneLight, position: Vec3) -> Arriving {
    if light.is_spot == 1 {
        let offset = light.position - position;
        let square = max(dot(offset, offset), 1e-12);
        let reciprocal = inverse_sqrt(square);
        let dir = offset * reciprocal;
        let dist = square * reciprocal;
        let share = spot_irradiance(light.axis, light.outer, light.blend, dir, dist);
        Arriving { dir, dist, irradiance: share * light.strength }
    } else {
        Arriving { dir: light.axis, dist: 1e30, irradiance: light.strength }
    }
}

/// The ray from a point of a surface to what arrives there.
#[kernel]
pub fn ray_to_light(position: Vec3, surface: u32, arriving: Arriving) -> SceneRay {
    SceneRay {
        origin: position,
        reach: arriving.dist,
        dir: arriving.dir,
        leaving: surface,
        reaching: NOWHERE,
    }
}
