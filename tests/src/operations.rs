//! A kernel for each operation of the kernel language, for the conformance test: every operation runs on
//! every executor.
//!
//! [`OPERATIONS`] names, for each intrinsic, the kernels that call it; a test fails when one has none.
//! Domains reach as far as the languages promise anything.

use lobe_codegen::def::FunctionRef;
use lobe_codegen::intrinsics::Intrinsic;
use lobe_codegen::kernels;
use lobe_codegen::prelude::*;

macro_rules! operations {
    ($($(#[$meta:meta])* $intrinsic:ident: fn $name:ident($($arg:ident: $ty:ty = $domain:expr),*) -> $ret:ty { $body:expr })*) => {
        $(
            #[doc = concat!("Calls `", stringify!($intrinsic), "`.")]
            #[kernel(family = "operation", domain($($arg = $domain),*))]
            pub fn $name($($arg: $ty),*) -> $ret {
                $body
            }
        )*

        /// The kernels of each intrinsic.
        pub const OPERATIONS: &[(Intrinsic, FunctionRef)] = &[
            $((Intrinsic::$intrinsic, kernels![$name][0]),)*
        ];
    };
}

operations! {
    Abs: fn op_abs(x: f32 = -1e30..=1e30) -> f32 { abs(x) }
    Abs: fn op_abs_integer(x: i32 = -2147483648..=2147483647) -> i32 { abs(x) }
    Min: fn op_min(x: f32 = -1e30..=1e30, y: f32 = -1e30..=1e30) -> f32 { min(x, y) }
    Min: fn op_min_integer(x: i32 = -100..=100, y: i32 = -100..=100) -> i32 { min(x, y) }
    Min: fn op_min_unsigned(x: u32 = 0..=4294967295_u32, y: u32 = 0..=4294967295_u32) -> u32 { min(x, y) }
    Max: fn op_max(x: f32 = -1e30..=1e30, y: f32 = -1e30..=1e30) -> f32 { max(x, y) }
    Max: fn op_max_vector(x: Vec3 = -1e30..=1e30, y: Vec3 = -1e30..=1e30) -> Vec3 { max(x, y) }
    Clamp: fn op_clamp(x: f32 = -1e6..=1e6, low: f32 = -10.0..=0.0, high: f32 = 0.0..=10.0) -> f32 { clamp(x, low, high) }
    Clamp: fn op_clamp_integer(x: i32 = -1000..=1000, low: i32 = -10..=0, high: i32 = 0..=10) -> i32 { clamp(x, low, high) }
    Saturate: fn op_saturate(x: f32 = -1e6..=1e6) -> f32 { saturate(x) }
    Sign: fn op_sign(x: f32 = -1e30..=1e30) -> f32 { sign(x) }
    Sign: fn op_sign_integer(x: i32 = -2147483648..=2147483647) -> i32 { sign(x) }
    Ceil: fn op_ceil(x: f32 = -1e9..=1e9) -> f32 { ceil(x) }
    Floor: fn op_floor(x: f32 = -1e9..=1e9) -> f32 { floor(x) }
    Floor: fn op_floor_vector(x: Vec4 = -1e4..=1e4) -> Vec4 { floor(x) }
    Round: fn op_round(x: f32 = -1e9..=1e9) -> f32 { round(x) }
    Trunc: fn op_trunc(x: f32 = -1e9..=1e9) -> f32 { trunc(x) }
    Fract: fn op_fract(x: f32 = -1e6..=1e6) -> f32 { fract(x) }
    Step: fn op_step(edge: f32 = -1e6..=1e6, x: f32 = -1e6..=1e6) -> f32 { step(edge, x) }
    Sqrt: fn op_sqrt(x: f32 = 0.0..=1e38) -> f32 { sqrt(x) }
    InverseSqrt: fn op_inverse_sqrt(x: f32 = 1e-37..=1e38) -> f32 { inverse_sqrt(x) }
    Exp: fn op_exp(x: f32 = -87.0..=87.0) -> f32 { exp(x) }
    Exp: fn op_exp_vector(x: Vec2 = -20.0..=20.0) -> Vec2 { exp(x) }
    Exp2: fn op_exp2(x: f32 = -125.0..=125.0) -> f32 { exp2(x) }
    Log: fn op_log(x: f32 = 1e-37..=1e38) -> f32 { log(x) }
    Log2: fn op_log2(x: f32 = 1e-37..=1e38) -> f32 { log2(x) }
    Pow: fn op_pow(x: f32 = 1e-3..=1e3, y: f32 = -4.0..=4.0) -> f32 { pow(x, y) }
    Sin: fn op_sin(x: f32 = -3.14159..=3.14159) -> f32 { sin(x) }
    Cos: fn op_cos(x: f32 = -3.14159..=3.14159) -> f32 { cos(x) }
    Tan: fn op_tan(x: f32 = -1.5..=1.5) -> f32 { tan(x) }
    Asin: fn op_asin(x: f32 = -1.0..=1.0) -> f32 { asin(x) }
    Acos: fn op_acos(x: f32 = -1.0..=1.0) -> f32 { acos(x) }
    Atan: fn op_atan(x: f32 = -1e6..=1e6) -> f32 { atan(x) }
    Atan2: fn op_atan2(y: f32 = -10.0..=10.0, x: f32 = 1e-3..=10.0) -> f32 { atan2(y, x) }
    Sinh: fn op_sinh(x: f32 = -80.0..=80.0) -> f32 { sinh(x) }
    Cosh: fn op_cosh(x: f32 = -80.0..=80.0) -> f32 { cosh(x) }
    Tanh: fn op_tanh(x: f32 = -20.0..=20.0) -> f32 { tanh(x) }
    Asinh: fn op_asinh(x: f32 = -1e3..=1e3) -> f32 { asinh(x) }
    Acosh: fn op_acosh(x: f32 = 1.001..=1e6) -> f32 { acosh(x) }
    Atanh: fn op_atanh(x: f32 = -0.999..=0.999) -> f32 { atanh(x) }
    Degrees: fn op_degrees(x: f32 = -1e6..=1e6) -> f32 { degrees(x) }
    Radians: fn op_radians(x: f32 = -1e6..=1e6) -> f32 { radians(x) }
    Fma: fn op_fma(x: f32 = -1e6..=1e6, y: f32 = -1e6..=1e6, z: f32 = -1e6..=1e6) -> f32 { fma(x, y, z) }
    Mix: fn op_mix(x: f32 = -1e6..=1e6, y: f32 = -1e6..=1e6, t: f32 = 0.0..=1.0) -> f32 { mix(x, y, t) }
    Mix: fn op_mix_vector(x: Vec3 = -1e3..=1e3, y: Vec3 = -1e3..=1e3, t: Vec3 = 0.0..=1.0) -> Vec3 { mix(x, y, t) }
    SmoothStep: fn op_smoothstep(low: f32 = -10.0..=-1.0, high: f32 = 1.0..=10.0, x: f32 = -20.0..=20.0) -> f32 { smoothstep(low, high, x) }
    Dot: fn op_dot(x: Vec3 = -1e3..=1e3, y: Vec3 = -1e3..=1e3) -> f32 { dot(x, y) }
    Dot: fn op_dot_four(x: Vec4 = -1e3..=1e3, y: Vec4 = -1e3..=1e3) -> f32 { x.dot(y) }
    Length: fn op_length(x: Vec3 = -1e3..=1e3) -> f32 { length(x) }
    Distance: fn op_distance(x: Vec2 = -1e3..=1e3, y: Vec2 = -1e3..=1e3) -> f32 { distance(x, y) }
    Normalize: fn op_normalize(x: Vec3 = 1e-3..=1e3) -> Vec3 { normalize(x) }
    Cross: fn op_cross(x: Vec3 = -1e3..=1e3, y: Vec3 = -1e3..=1e3) -> Vec3 { cross(x, y) }
    Reflect: fn op_reflect(x: Vec3 = unit, y: Vec3 = unit) -> Vec3 { reflect(x, y) }
    Refract: fn op_refract(x: Vec3 = unit, y: Vec3 = unit, eta: f32 = 0.5..=0.9) -> Vec3 { refract(x, y, eta) }
    FaceForward: fn op_face_forward(x: Vec3 = unit, y: Vec3 = unit, z: Vec3 = unit) -> Vec3 { face_forward(x, y, z) }
    Transpose: fn op_transpose(m: Mat3 = -10.0..=10.0, x: Vec3 = -10.0..=10.0) -> Vec3 { transpose(m) * x }
    CountOneBits: fn op_count_one_bits(x: u32 = 0..=4294967295_u32) -> u32 { count_one_bits(x) }
    CountLeadingZeros: fn op_count_leading_zeros(x: u32 = 0..=4294967295_u32) -> u32 { count_leading_zeros(x) }
    CountTrailingZeros: fn op_count_trailing_zeros(x: u32 = 0..=4294967295_u32) -> u32 { count_trailing_zeros(x) }
    ReverseBits: fn op_reverse_bits(x: u32 = 0..=4294967295_u32) -> u32 { reverse_bits(x) }
    FirstLeadingBit: fn op_first_leading_bit(x: i32 = -2147483648..=2147483647) -> i32 { first_leading_bit(x) }
    FirstTrailingBit: fn op_first_trailing_bit(x: u32 = 0..=4294967295_u32) -> u32 { first_trailing_bit(x) }
    ExtractBits: fn op_extract_bits(x: u32 = 0..=4294967295_u32, offset: u32 = 0..=31, count: u32 = 0..=32) -> u32 { extract_bits(x, offset, min(count, 32 - offset)) }
    ExtractBits: fn op_extract_bits_signed(x: i32 = -2147483648..=2147483647, offset: u32 = 0..=31, count: u32 = 0..=32) -> i32 { extract_bits(x, offset, min(count, 32 - offset)) }
    InsertBits: fn op_insert_bits(x: u32 = 0..=4294967295_u32, bits: u32 = 0..=4294967295_u32, offset: u32 = 0..=31, count: u32 = 0..=32) -> u32 { insert_bits(x, bits, offset, min(count, 32 - offset)) }
    Select: fn op_select(x: f32 = -1e6..=1e6, y: f32 = -1e6..=1e6) -> f32 { select(x, 2.0 * y, x < y) }
    All: fn op_all(x: Vec3 = -1.0..=1.0, y: Vec3 = -1.0..=1.0) -> bool { all(x.cmplt(y)) }
    Any: fn op_any(x: Vec3 = -1.0..=1.0, y: Vec3 = -1.0..=1.0) -> bool { any(x.cmpge(y)) }
}

/// Kernels for what is no intrinsic: operators, casts, matrices, control flow.
pub const OTHERS: &[FunctionRef] = &kernels![
    op_float_operators,
    op_integer_operators,
    op_unsigned_operators,
    op_casts,
    op_bits,
    op_matrices,
    op_matrix_product,
    op_arrays,
    op_loop,
    op_match,
];

/// `+ - * / %` on floats.
#[kernel(family = "operation", domain(x = -1e6..=1e6, y = 1e-3..=1e6))]
pub fn op_float_operators(x: f32, y: f32) -> Vec4 {
    Vec4::new(x + y, x - y, x * y, x / y)
}

/// Arithmetic, comparison and shifts of signed integers; products wrap.
#[kernel(family = "operation", domain(x = -2147483648..=2147483647, y = 1..=1000))]
pub fn op_integer_operators(x: i32, y: i32) -> IVec4 {
    let shifted = (x >> 3) ^ (y << 5);
    IVec4::new(x.wrapping_mul(y), x / y, x % y, if x < y { shifted } else { x & y | 64 })
}

/// The same of unsigned integers.
#[kernel(family = "operation", domain(x = 0..=4294967295_u32, y = 1..=1000))]
pub fn op_unsigned_operators(x: u32, y: u32) -> UVec4 {
    let shifted = (x >> 3) ^ (y << 5);
    UVec4::new(x.wrapping_mul(y), x / y, x % y, if x < y { shifted } else { !x & y | 64 })
}

/// Conversions between numbers.
#[kernel(family = "operation", domain(x = -1e9..=1e9, n = -2147483648..=2147483647))]
pub fn op_casts(x: f32, n: i32) -> Vec4 {
    Vec4::new(x as i32 as f32, abs(x) as u32 as f32, n as f32, n as u32 as f32)
}

/// Bits of floats.
#[kernel(family = "operation", domain(x = -1e30..=1e30))]
pub fn op_bits(x: f32) -> f32 {
    f32::from_bits(x.to_bits() & 0x7fff_ffff)
}

/// A matrix times a vector, and a matrix scaled.
#[kernel(family = "operation", domain(m = -10.0..=10.0, x = -10.0..=10.0))]
pub fn op_matrices(m: Mat3, x: Vec3) -> Vec3 {
    m * x + (m * 2.0).y_axis
}

/// A matrix times a matrix.
#[kernel(family = "operation", domain(a = -10.0..=10.0, b = -10.0..=10.0))]
pub fn op_matrix_product(a: Mat2, b: Mat2) -> Mat2 {
    a * b - a
}

/// An array indexed when it runs.
#[kernel(family = "operation", domain(x = -10.0..=10.0, i = 0..=3))]
pub fn op_arrays(x: f32, i: u32) -> f32 {
    let mut values = [x, 2.0 * x, x * x, 1.0];
    values[i as usize] += 1.0;
    values[((i + 1) % 4) as usize] - values[i as usize]
}

/// A loop that leaves early.
#[kernel(family = "operation", domain(x = -1.0..=1.0, n = 0..=40))]
pub fn op_loop(x: f32, n: i32) -> f32 {
    let mut sum = 0.0;
    for i in 0..n {
        if i == 3 {
            continue;
        }
        if i > 30 {
            break;
        }
        sum = sum * x + 1.0;
    }
    sum
}

/// A choice among integers.
#[kernel(family = "operation", domain(n = -3..=5))]
pub fn op_match(n: i32) -> i32 {
    match n {
        -1 => 10,
        0 | 1 => 20,
        2 => n * 30,
        _ => -n,
    }
}
