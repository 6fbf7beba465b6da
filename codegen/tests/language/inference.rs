//! Types of integers without suffix.

use crate::check::{agrees, refusal};
use lobe_codegen::kernels;
use lobe_codegen::prelude::*;

#[kernel]
fn from_use(n: u32, k: i32) -> u32 {
    let three = 3;
    let two = 2;
    let nine = three * three;
    (n + three) * nine + (k + two) as u32
}

#[kernel]
fn from_the_right(n: u32) -> u32 {
    let a = (1 << 3) & n;
    let b = 5 + n;
    let c = 0 == n || 3 < n;
    a + b + c as u32
}

#[kernel]
fn from_a_later_branch(n: u32) -> u32 {
    let a = if n > 3 { 1 } else { n };
    let b = match n {
        0 => 7,
        1 => n * 2,
        _ => 1,
    };
    a + b + if n > 4 { 0 } else { n } + max(2, n) + select(0, 1, n > 2)
}

#[kernel]
fn in_places(n: u32) -> u32 {
    let mut a = [n, 1, 2];
    a[0] = 5;
    a[1] += 7;
    let mut v = UVec2::new(1, n);
    v.x = 9;
    for i in 0..n {
        a[2] += i;
    }
    a[0] + a[1] + a[2] + v.x
}

/// What is expected of a product is not what its scalar factor is.
#[kernel]
fn mixed_shapes(v: Vec3, w: UVec3, p: bool) -> Vec3 {
    let s = v * if p { 2.0 } else { v.x };
    let u = w * if p { 2 } else { 3 } + if p { 1 } else { w.x };
    s * u.x as f32
        * match u.y {
            0 => 1.0,
            _ => 0.5,
        }
}

/// The left side of a shift says nothing about the right one.
#[kernel]
fn shift_of_other_type(n: i32, k: u32) -> i32 {
    n >> ({
        let two = 2;
        two | k
    } & 7)
}

#[test]
fn integers_take_the_type_of_their_use() {
    agrees(kernels![from_use][0]);
    agrees(kernels![from_the_right][0]);
    agrees(kernels![from_a_later_branch][0]);
    agrees(kernels![in_places][0]);
    agrees(kernels![mixed_shapes][0]);
    agrees(kernels![shift_of_other_type][0]);
}

#[kernel]
fn assumed(n: u32) -> u32 {
    let mut step = 3;
    step += 1;
    n + step
}

#[test]
fn what_cannot_be_inferred_says_how_to_write_it() {
    let message = refusal(kernels![assumed][0]);
    assert!(message.contains("`step` was taken as i32"), "{message}");
    assert!(message.contains("write `1u32`, or state the type in its `let`"), "{message}");
    assert!(message.contains("    n + step"), "{message}");
}
