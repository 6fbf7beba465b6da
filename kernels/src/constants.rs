//! Multiples of π.

use lobe_codegen::prelude::*;

/// π, the projected solid angle of a hemisphere.
#[kernel]
pub const PI: f32 = 3.14159265358979323846;

/// π/2.
#[kernel]
pub const HALF_PI: f32 = 1.57079632679489661923;

/// 2π, the solid angle of a hemisphere.
#[kernel]
pub const TWO_PI: f32 = 6.2831853071795864769;

/// 4π, the solid angle of the sphere.
#[kernel]
pub const FOUR_PI: f32 = 12.566370614359172954;

/// 1/π.
#[kernel]
pub const INVERSE_PI: f32 = 0.31830988618379067154;
