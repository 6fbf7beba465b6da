//! The functions that kernels call, for scalars and vectors alike.

use super::scalar;
use glam::{IVec2, IVec3, IVec4, UVec2, UVec3, UVec4, Vec2, Vec3, Vec4};

/// `f32` or a vector of it.
pub trait Float: Copy {
    /// Applies `f` to each component.
    fn map(self, f: impl Fn(f32) -> f32) -> Self;
    /// Applies `f` to pairs of components.
    fn zip(self, b: Self, f: impl Fn(f32, f32) -> f32) -> Self;
    /// Applies `f` to triples of components.
    fn zip3(self, b: Self, c: Self, f: impl Fn(f32, f32, f32) -> f32) -> Self;
}

impl Float for f32 {
    fn map(self, f: impl Fn(f32) -> f32) -> Self {
        f(self)
    }
    fn zip(self, b: Self, f: impl Fn(f32, f32) -> f32) -> Self {
        f(self, b)
    }
    fn zip3(self, b: Self, c: Self, f: impl Fn(f32, f32, f32) -> f32) -> Self {
        f(self, b, c)
    }
}

macro_rules! float_vector {
    ($($ty:ident: $($c:ident)*;)*) => {
        $(impl Float for $ty {
            fn map(self, f: impl Fn(f32) -> f32) -> Self {
                Self::new($(f(self.$c)),*)
            }
            fn zip(self, b: Self, f: impl Fn(f32, f32) -> f32) -> Self {
                Self::new($(f(self.$c, b.$c)),*)
            }
            fn zip3(self, b: Self, c: Self, f: impl Fn(f32, f32, f32) -> f32) -> Self {
                Self::new($(f(self.$c, b.$c, c.$c)),*)
            }
        })*
    };
}
float_vector! { Vec2: x y; Vec3: x y z; Vec4: x y z w; }

/// A number or a vector of numbers.
pub trait Numeric: Copy {
    /// See [`scalar::min`].
    fn minimum(self, b: Self) -> Self;
    /// See [`scalar::max`].
    fn maximum(self, b: Self) -> Self;
}

/// A signed number or a vector of such.
pub trait Signed: Copy {
    /// See [`scalar::abs`]; the most negative integer stays as it is.
    fn magnitude(self) -> Self;
    /// See [`scalar::sign`].
    fn signum(self) -> Self;
}

macro_rules! numeric_float {
    ($($ty:ident)*) => {
        $(
            impl Numeric for $ty {
                fn minimum(self, b: Self) -> Self {
                    Float::zip(self, b, scalar::min)
                }
                fn maximum(self, b: Self) -> Self {
                    Float::zip(self, b, scalar::max)
                }
            }
            impl Signed for $ty {
                fn magnitude(self) -> Self {
                    Float::map(self, scalar::abs)
                }
                fn signum(self) -> Self {
                    Float::map(self, scalar::sign)
                }
            }
        )*
    };
}
numeric_float! { f32 Vec2 Vec3 Vec4 }

macro_rules! numeric_integer {
    ($($ty:ident)*) => {
        $(impl Numeric for $ty {
            fn minimum(self, b: Self) -> Self {
                self.min(b)
            }
            fn maximum(self, b: Self) -> Self {
                self.max(b)
            }
        })*
    };
}
numeric_integer! { i32 u32 IVec2 IVec3 IVec4 UVec2 UVec3 UVec4 }

impl Signed for i32 {
    fn magnitude(self) -> Self {
        self.wrapping_abs()
    }
    fn signum(self) -> Self {
        i32::signum(self)
    }
}

macro_rules! signed_vector {
    ($($ty:ident: $($c:ident)*;)*) => {
        $(impl Signed for $ty {
            fn magnitude(self) -> Self {
                Self::new($(self.$c.wrapping_abs()),*)
            }
            fn signum(self) -> Self {
                Self::new($(self.$c.signum()),*)
            }
        })*
    };
}
signed_vector! { IVec2: x y; IVec3: x y z; IVec4: x y z w; }

macro_rules! lifted {
    ($($name:ident($($arg:ident)*) $zip:ident;)*) => {
        $(
            #[doc = concat!("Componentwise [`scalar::", stringify!($name), "`].")]
            pub fn $name<T: Float>($($arg: T),*) -> T {
                lifted!(@call $zip scalar::$name, $($arg)*)
            }
        )*
    };
    (@call $zip:ident $f:path, $first:ident $($rest:ident)*) => { $first.$zip($($rest,)* $f) };
}

lifted! {
    exp(x) map;
    exp2(x) map;
    log(x) map;
    log2(x) map;
    sqrt(x) map;
    inverse_sqrt(x) map;
    sin(x) map;
    cos(x) map;
    tan(x) map;
    asin(x) map;
    acos(x) map;
    atan(x) map;
    sinh(x) map;
    cosh(x) map;
    tanh(x) map;
    asinh(x) map;
    acosh(x) map;
    atanh(x) map;
    saturate(x) map;
    ceil(x) map;
    floor(x) map;
    round(x) map;
    trunc(x) map;
    fract(x) map;
    degrees(x) map;
    radians(x) map;
    pow(x y) zip;
    atan2(y x) zip;
    step(edge x) zip;
    fma(x y z) zip3;
    mix(x y t) zip3;
    smoothstep(low high x) zip3;
}

/// Componentwise [`scalar::min`].
pub fn min<T: Numeric>(a: T, b: T) -> T {
    a.minimum(b)
}

/// Componentwise [`scalar::max`].
pub fn max<T: Numeric>(a: T, b: T) -> T {
    a.maximum(b)
}

/// Componentwise [`scalar::clamp`].
pub fn clamp<T: Numeric>(x: T, low: T, high: T) -> T {
    x.maximum(low).minimum(high)
}

/// Componentwise [`scalar::abs`].
pub fn abs<T: Signed>(x: T) -> T {
    x.magnitude()
}

/// Componentwise [`scalar::sign`].
pub fn sign<T: Signed>(x: T) -> T {
    x.signum()
}
