//! Integers, selection, atomics and barriers.

use glam::{BVec2, BVec3, BVec4, IVec2, IVec3, IVec4, UVec2, UVec3, UVec4};
use std::sync::atomic::{AtomicI32, AtomicU32, Ordering};

/// An integer or a vector of integers.
pub trait Integer: Copy {
    /// Applies `f` to the bits of each component; the flag says whether it is signed.
    fn map_bits(self, f: impl Fn(u32, bool) -> u32) -> Self;
    /// Applies `f` to the bits of pairs of components.
    fn zip_bits(self, b: Self, f: impl Fn(u32, u32) -> u32) -> Self;
}

macro_rules! integer_scalar {
    ($($ty:ident $signed:literal;)*) => {
        $(impl Integer for $ty {
            fn map_bits(self, f: impl Fn(u32, bool) -> u32) -> Self {
                f(self as u32, $signed) as Self
            }
            fn zip_bits(self, b: Self, f: impl Fn(u32, u32) -> u32) -> Self {
                f(self as u32, b as u32) as Self
            }
        })*
    };
}
integer_scalar! { u32 false; i32 true; }

macro_rules! integer_vector {
    ($($ty:ident: $($c:ident)*;)*) => {
        $(impl Integer for $ty {
            fn map_bits(self, f: impl Fn(u32, bool) -> u32) -> Self {
                Self::new($(self.$c.map_bits(&f)),*)
            }
            fn zip_bits(self, b: Self, f: impl Fn(u32, u32) -> u32) -> Self {
                Self::new($(self.$c.zip_bits(b.$c, &f)),*)
            }
        })*
    };
}
integer_vector! {
    UVec2: x y; UVec3: x y z; UVec4: x y z w;
    IVec2: x y; IVec3: x y z; IVec4: x y z w;
}

/// Number of bits set.
pub fn count_one_bits<T: Integer>(x: T) -> T {
    x.map_bits(|b, _| b.count_ones())
}

/// Zeros above the highest bit set; 32 for 0.
pub fn count_leading_zeros<T: Integer>(x: T) -> T {
    x.map_bits(|b, _| b.leading_zeros())
}

/// Zeros below the lowest bit set; 32 for 0.
pub fn count_trailing_zeros<T: Integer>(x: T) -> T {
    x.map_bits(|b, _| b.trailing_zeros())
}

/// Bits in reverse order.
pub fn reverse_bits<T: Integer>(x: T) -> T {
    x.map_bits(|b, _| b.reverse_bits())
}

/// Index of the highest bit set (for a negative number: of the highest bit clear); all ones if none.
pub fn first_leading_bit<T: Integer>(x: T) -> T {
    x.map_bits(|b, signed| {
        let b = if signed && b >> 31 == 1 { !b } else { b };
        31_u32.wrapping_sub(b.leading_zeros())
    })
}

/// Index of the lowest bit set; all ones if none.
pub fn first_trailing_bit<T: Integer>(x: T) -> T {
    x.map_bits(|b, _| if b == 0 { u32::MAX } else { b.trailing_zeros() })
}

/// `count` bits from `offset` on, sign-extended for signed integers; both are clamped to the word.
pub fn extract_bits<T: Integer>(x: T, offset: u32, count: u32) -> T {
    let offset = offset.min(32);
    let count = count.min(32 - offset);
    x.map_bits(|b, signed| match count {
        0 => 0,
        _ if signed => (((b << (32 - count - offset)) as i32) >> (32 - count)) as u32,
        _ => (b << (32 - count - offset)) >> (32 - count),
    })
}

/// `x` with `count` bits from `offset` on replaced by the lowest of `bits`; both are clamped to the word.
pub fn insert_bits<T: Integer>(x: T, bits: T, offset: u32, count: u32) -> T {
    let offset = offset.min(32);
    let count = count.min(32 - offset);
    let mask = if count == 0 { 0 } else { (u32::MAX >> (32 - count)) << offset };
    x.zip_bits(bits, |x, b| (x & !mask) | (b.checked_shl(offset).unwrap_or(0) & mask))
}

/// `accept` if `condition` holds, otherwise `reject`.
pub fn select<T>(reject: T, accept: T, condition: bool) -> T {
    if condition { accept } else { reject }
}

/// A vector of booleans.
pub trait BoolVector {
    /// Whether all components hold.
    fn every(self) -> bool;
    /// Whether a component holds.
    fn some(self) -> bool;
}

macro_rules! bool_vector {
    ($($ty:ident)*) => {
        $(impl BoolVector for $ty {
            fn every(self) -> bool {
                self.all()
            }
            fn some(self) -> bool {
                self.any()
            }
        })*
    };
}
bool_vector! { BVec2 BVec3 BVec4 }

/// Whether all components hold.
pub fn all<T: BoolVector>(x: T) -> bool {
    x.every()
}

/// Whether a component holds.
pub fn any<T: BoolVector>(x: T) -> bool {
    x.some()
}

/// `AtomicU32` or `AtomicI32`. Shading languages order atomics relaxed, and so does this.
pub trait Atomic {
    /// What it holds.
    type Value;
    /// Reads.
    fn get(&self) -> Self::Value;
    /// Writes.
    fn set(&self, value: Self::Value);
    /// Replaces the value by `f` of it; returns the former one.
    fn update(&self, f: impl Fn(Self::Value) -> Self::Value) -> Self::Value;
}

macro_rules! atomic {
    ($($ty:ident $value:ident;)*) => {
        $(impl Atomic for $ty {
            type Value = $value;
            fn get(&self) -> $value {
                self.load(Ordering::Relaxed)
            }
            fn set(&self, value: $value) {
                self.store(value, Ordering::Relaxed);
            }
            fn update(&self, f: impl Fn($value) -> $value) -> $value {
                let mut old = self.get();
                while let Err(now) =
                    self.compare_exchange_weak(old, f(old), Ordering::Relaxed, Ordering::Relaxed)
                {
                    old = now;
                }
                old
            }
        })*
    };
}
atomic! { AtomicU32 u32; AtomicI32 i32; }

/// Reads an atomic.
pub fn atomic_load<A: Atomic>(a: &A) -> A::Value {
    a.get()
}

/// Writes an atomic.
pub fn atomic_store<A: Atomic>(a: &A, value: A::Value) {
    a.set(value);
}

macro_rules! updates {
    ($($(#[$doc:meta])* $name:ident $f:expr;)*) => {
        $(
            $(#[$doc])*
            pub fn $name<A: Atomic>(a: &A, value: A::Value) -> A::Value
            where
                A::Value: Bits,
            {
                a.update(|old| $f(old, value))
            }
        )*
    };
}

/// The arithmetic of atomics: wrapping, two's complement.
pub trait Bits: Copy + Ord {
    /// `self + b`
    fn plus(self, b: Self) -> Self;
    /// `self - b`
    fn minus(self, b: Self) -> Self;
    /// `self & b`
    fn conj(self, b: Self) -> Self;
    /// `self | b`
    fn disj(self, b: Self) -> Self;
    /// `self ^ b`
    fn parity(self, b: Self) -> Self;
}

macro_rules! bits {
    ($($ty:ident)*) => {
        $(impl Bits for $ty {
            fn plus(self, b: Self) -> Self {
                self.wrapping_add(b)
            }
            fn minus(self, b: Self) -> Self {
                self.wrapping_sub(b)
            }
            fn conj(self, b: Self) -> Self {
                self & b
            }
            fn disj(self, b: Self) -> Self {
                self | b
            }
            fn parity(self, b: Self) -> Self {
                self ^ b
            }
        })*
    };
}
bits! { u32 i32 }

updates! {
    /// Adds; returns the former value.
    atomic_add Bits::plus;
    /// Subtracts; returns the former value.
    atomic_sub Bits::minus;
    /// Keeps the smaller; returns the former value.
    atomic_min Ord::min;
    /// Keeps the larger; returns the former value.
    atomic_max Ord::max;
    /// Keeps the common bits; returns the former value.
    atomic_and Bits::conj;
    /// Keeps the bits of both; returns the former value.
    atomic_or Bits::disj;
    /// Keeps the bits that differ; returns the former value.
    atomic_xor Bits::parity;
    /// Replaces; returns the former value.
    atomic_exchange |_, new| new;
}

/// Waits for the workgroup. A native call is a single invocation, so there is nothing to wait for.
pub fn workgroup_barrier() {}

/// Makes storage writes visible to the workgroup; nothing to do in a native call.
pub fn storage_barrier() {}
