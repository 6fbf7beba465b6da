//! The native form of every intrinsic: strict IEEE f32, the same on every machine.
//!
//! The interpreter calls these same functions, so `native` and `interp` agree bit for bit.
//! `exp` and `log` are our own ([`elementary`]), at most 1 ULP, and become vector code; the other
//! elementary functions are evaluated in f64 by the pure Rust `libm` and rounded once: at most 0.5 ULP and a hair.
//! Neither depends on the platform's C library.
//!
//! [`scalar`] holds one lane's arithmetic, [`generic`] the functions that kernels call (any width),
//! [`vector`] the geometric ones, [`bits`] integers and atomics.

pub mod bits;
pub mod elementary;
pub mod generic;
pub mod scalar;
pub mod vector;

pub use bits::{
    all, any, atomic_add, atomic_and, atomic_exchange, atomic_load, atomic_max, atomic_min, atomic_or,
    atomic_store, atomic_sub, atomic_xor, count_leading_zeros, count_one_bits, count_trailing_zeros,
    extract_bits, first_leading_bit, first_trailing_bit, insert_bits, reverse_bits, select, storage_barrier,
    workgroup_barrier,
};
pub use generic::{
    abs, acos, acosh, asin, asinh, atan, atan2, atanh, ceil, clamp, cos, cosh, degrees, exp, exp2, floor,
    fma, fract, inverse_sqrt, log, log2, max, min, mix, pow, radians, round, saturate, sign, sin, sinh,
    smoothstep, sqrt, step, tan, tanh, trunc,
};
pub use vector::{cross, distance, dot, face_forward, length, normalize, reflect, refract, transpose};
