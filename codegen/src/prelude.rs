//! What a file of kernels imports: the attribute, glam's types and every intrinsic.
//!
//! ```
//! use lobe_codegen::prelude::*;
//!
//! /// Twice the square root.
//! #[kernel]
//! pub fn twice_root(x: f32) -> f32 {
//!     2.0 * sqrt(x)
//! }
//!
//! assert_eq!(twice_root(9.0), 6.0);
//! ```

pub use crate::intrinsics::markers::*;
pub use crate::math::*;
pub use glam::{
    BVec2, BVec3, BVec4, IVec2, IVec3, IVec4, Mat2, Mat3, Mat4, UVec2, UVec3, UVec4, Vec2, Vec3, Vec4,
};
// Swizzles are methods of these.
pub use glam::{Vec2Swizzles, Vec3Swizzles, Vec4Swizzles};
pub use lobe_macros::kernel;
pub use std::sync::atomic::{AtomicI32, AtomicU32};
