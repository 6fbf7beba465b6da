//! Interreflection from a glossy rectangle.

pub mod angle;
pub mod attenuation;
pub mod diffuse;
pub mod disk;
pub mod energy;
pub mod laplace;
pub mod light;
pub mod peak;
pub mod shade;

use lobe_codegen::prelude::*;

/// A rectangle that reflects on the side that its normal points to.
#[kernel]
pub struct Rectangle {
    /// Of its middle.
    #[domain(-100.0..=100.0)]
    pub position: Vec3,
    /// Unit normal of the reflecting side.
    #[domain(unit)]
    pub normal: Vec3,
    /// Unit vector along the first pair of sides; the second pair is along `cross(normal, tangent)`.
    #[domain(normal_to(normal))]
    pub tangent: Vec3,
    /// Half the extent along the tangent.
    #[domain(1e-3..=100.0)]
    pub half_x: f32,
    /// Half the extent across.
    #[domain(1e-3..=100.0)]
    pub half_y: f32,
}
