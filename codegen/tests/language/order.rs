//! What is evaluated when, and what is a copy.

use crate::check::agrees;
use lobe_codegen::kernels;
use lobe_codegen::prelude::*;

/// A pair.
#[kernel]
struct Pair {
    /// One.
    a: f32,
    /// The other.
    b: f32,
}

#[kernel]
fn copies(p: f32) -> f32 {
    let mut x = p;
    let a = x;
    x = 2.0;
    let mut v = [a, x, 3.0];
    let w = v;
    v[0] = 10.0;
    let mut s = Pair { a, b: x };
    let t = s;
    s.b += 5.0;
    a + 100.0 * x + w[0] + v[0] + t.b + s.b
}

#[kernel]
fn sum3(a: f32, b: f32, c: f32) -> f32 {
    a + 10.0 * b + 100.0 * c
}

#[kernel]
fn arguments_in_order(p: f32) -> f32 {
    let mut x = p;
    let mut s = Pair { a: p, b: 1.0 };
    let first = sum3(
        x,
        {
            x += 1.0;
            x
        },
        x * 2.0,
    );
    let second = s.a + {
        s.a = 7.0;
        s.a
    } * s.a;
    first + second
}

#[kernel]
fn fields_in_order(p: f32) -> f32 {
    let mut x = p;
    let s = Pair {
        b: {
            x += 1.0;
            x
        },
        a: x * 2.0,
    };
    let t = Pair {
        a: {
            x = 9.0;
            x
        },
        ..s
    };
    s.a + 10.0 * s.b + t.a + t.b
}

/// The right side of an assignment goes first.
#[kernel]
#[allow(unused_assignments, reason = "that is what is tested")]
fn assignments(p: f32, n: u32) -> f32 {
    let mut x = p;
    x += {
        x = 5.0;
        1.0
    };
    let mut i = n % 2;
    let mut a = [1.0, 2.0, 3.0];
    a[i as usize] = {
        i += 1;
        x
    };
    a[i as usize] += {
        i = 0;
        0.5
    };
    let mut v = [Vec3::X, Vec3::Y];
    let mut k = 0;
    // Not so before a compound assignment to a vector.
    v[k] += {
        k = 1;
        Vec3::new(x, 2.0, 3.0)
    };
    a[0] + 10.0 * a[1] + 100.0 * a[2] + x + v[0].x + v[1].y + k as f32
}

#[kernel]
fn conditions(p: f32, n: i32) -> f32 {
    let mut x = p;
    let b = n > 2 && {
        x += 1.0;
        x > 0.0
    };
    let c = n < 1 || {
        x *= 2.0;
        x > 4.0
    };
    if b || c && !b { x } else { -x }
}

#[kernel]
fn shadows(x: f32) -> f32 {
    let x = x + 1.0;
    let y = x;
    let x = x * 2.0;
    let z = {
        let x = x + y;
        let y = x;
        x * y
    };
    for x in 0..2 {
        let _ = x;
    }
    x + y + z
}

#[test]
fn evaluation_follows_rust() {
    agrees(kernels![copies][0]);
    agrees(kernels![arguments_in_order][0]);
    agrees(kernels![fields_in_order][0]);
    agrees(kernels![assignments][0]);
    agrees(kernels![conditions][0]);
    agrees(kernels![shadows][0]);
}
