//! [`KernelType`] and [`KernelValue`] for Rust's scalars, glam's vectors and matrices, and arrays.

use crate::data::WordReader;
use crate::def::{KernelType, KernelValue, Scalar, TypeDef};
use glam::{
    BVec2, BVec3, BVec4, IVec2, IVec3, IVec4, Mat2, Mat3, Mat4, UVec2, UVec3, UVec4, Vec2, Vec3, Vec4,
};
use std::sync::atomic::{AtomicI32, AtomicU32};

macro_rules! scalar {
    ($($ty:ident $kind:ident $read:expr, $write:expr;)*) => {
        $(
            impl KernelType for $ty {
                const TYPE: TypeDef = TypeDef::Scalar(Scalar::$kind);
            }
            impl KernelValue for $ty {
                fn read(words: &mut WordReader<'_>) -> Self {
                    $read(words.word())
                }
                fn write(&self, words: &mut Vec<u32>) {
                    words.push($write(*self));
                }
            }
        )*
    };
}
scalar! {
    f32 F32 f32::from_bits, f32::to_bits;
    i32 I32 |w| w as i32, |v| v as u32;
    u32 U32 |w| w, |v| v;
    bool Bool |w| w != 0, u32::from;
}

macro_rules! composite {
    ($($ty:ident = $def:expr, $new:ident($($part:ident: $part_ty:ident),*);)*) => {
        $(
            impl KernelType for $ty {
                const TYPE: TypeDef = $def;
            }
            impl KernelValue for $ty {
                fn read(words: &mut WordReader<'_>) -> Self {
                    $(let $part = $part_ty::read(words);)*
                    Self::$new($($part),*)
                }
                fn write(&self, words: &mut Vec<u32>) {
                    $(self.$part.write(words);)*
                }
            }
        )*
    };
}
composite! {
    Vec2 = TypeDef::Vector(2, Scalar::F32), new(x: f32, y: f32);
    Vec3 = TypeDef::Vector(3, Scalar::F32), new(x: f32, y: f32, z: f32);
    Vec4 = TypeDef::Vector(4, Scalar::F32), new(x: f32, y: f32, z: f32, w: f32);
    IVec2 = TypeDef::Vector(2, Scalar::I32), new(x: i32, y: i32);
    IVec3 = TypeDef::Vector(3, Scalar::I32), new(x: i32, y: i32, z: i32);
    IVec4 = TypeDef::Vector(4, Scalar::I32), new(x: i32, y: i32, z: i32, w: i32);
    UVec2 = TypeDef::Vector(2, Scalar::U32), new(x: u32, y: u32);
    UVec3 = TypeDef::Vector(3, Scalar::U32), new(x: u32, y: u32, z: u32);
    UVec4 = TypeDef::Vector(4, Scalar::U32), new(x: u32, y: u32, z: u32, w: u32);
    BVec2 = TypeDef::Vector(2, Scalar::Bool), new(x: bool, y: bool);
    BVec3 = TypeDef::Vector(3, Scalar::Bool), new(x: bool, y: bool, z: bool);
    BVec4 = TypeDef::Vector(4, Scalar::Bool), new(x: bool, y: bool, z: bool, w: bool);
    Mat2 = TypeDef::Matrix(2, 2), from_cols(x_axis: Vec2, y_axis: Vec2);
    Mat3 = TypeDef::Matrix(3, 3), from_cols(x_axis: Vec3, y_axis: Vec3, z_axis: Vec3);
    Mat4 = TypeDef::Matrix(4, 4), from_cols(x_axis: Vec4, y_axis: Vec4, z_axis: Vec4, w_axis: Vec4);
}

impl<T: KernelType, const N: usize> KernelType for [T; N] {
    const TYPE: TypeDef = TypeDef::Array(&T::TYPE, N as u32);
}

impl<T: KernelValue, const N: usize> KernelValue for [T; N] {
    fn read(words: &mut WordReader<'_>) -> Self {
        std::array::from_fn(|_| T::read(words))
    }
    fn write(&self, words: &mut Vec<u32>) {
        self.iter().for_each(|element| element.write(words));
    }
}

impl<T: KernelType> KernelType for [T] {
    const TYPE: TypeDef = TypeDef::Slice(&T::TYPE);
}

impl KernelType for AtomicU32 {
    const TYPE: TypeDef = TypeDef::Atomic(Scalar::U32);
}

impl KernelType for AtomicI32 {
    const TYPE: TypeDef = TypeDef::Atomic(Scalar::I32);
}
