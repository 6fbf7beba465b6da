//! Geometric functions. Sums run from the first component to the last, each operation rounded.

use super::{generic::Float, scalar};
use glam::{Mat2, Mat3, Mat4, Vec2, Vec3, Vec4};

/// A vector of floats.
pub trait FloatVector: Float + std::ops::Sub<Output = Self> + std::ops::Mul<f32, Output = Self> {
    /// `x[0] * y[0] + x[1] * y[1] + ..`
    fn inner(self, b: Self) -> f32;
}

macro_rules! float_vector {
    ($($ty:ident)*) => {
        $(impl FloatVector for $ty {
            fn inner(self, b: Self) -> f32 {
                self.dot(b)
            }
        })*
    };
}
float_vector! { Vec2 Vec3 Vec4 }

/// Inner product.
pub fn dot<T: FloatVector>(x: T, y: T) -> f32 {
    x.inner(y)
}

/// `sqrt(dot(x, x))`
pub fn length<T: FloatVector>(x: T) -> f32 {
    scalar::sqrt(x.inner(x))
}

/// `length(x - y)`
pub fn distance<T: FloatVector>(x: T, y: T) -> f32 {
    length(x - y)
}

/// `x / length(x)`, each component divided; NaN for the zero vector.
pub fn normalize<T: FloatVector>(x: T) -> T {
    let l = length(x);
    x.map(|c| c / l)
}

/// Cross product.
pub fn cross(x: Vec3, y: Vec3) -> Vec3 {
    Vec3::new(x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x)
}

/// `x - 2 dot(y, x) y`: the direction `x` mirrored at the plane with unit normal `y`.
pub fn reflect<T: FloatVector>(x: T, y: T) -> T {
    x - y * (2.0 * y.inner(x))
}

/// The direction `x` bent at the plane with unit normal `y` and ratio of indices `eta`; zero when it
/// is reflected wholly.
pub fn refract<T: FloatVector>(x: T, y: T, eta: f32) -> T {
    let d = y.inner(x);
    let k = 1.0 - eta * eta * (1.0 - d * d);
    if k < 0.0 { x.map(|_| 0.0) } else { x * eta - y * (eta * d + scalar::sqrt(k)) }
}

/// `x` if `dot(y, z) < 0`, otherwise `-x`.
pub fn face_forward<T: FloatVector>(x: T, y: T, z: T) -> T {
    if z.inner(y) < 0.0 { x } else { x.map(|c| -c) }
}

/// A square matrix.
pub trait Transpose {
    /// Rows become columns.
    fn transposed(self) -> Self;
}

macro_rules! matrix {
    ($($ty:ident)*) => {
        $(impl Transpose for $ty {
            fn transposed(self) -> Self {
                self.transpose()
            }
        })*
    };
}
matrix! { Mat2 Mat3 Mat4 }

/// Rows become columns.
pub fn transpose<T: Transpose>(m: T) -> T {
    m.transposed()
}
