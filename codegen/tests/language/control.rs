//! `if`, blocks, early return, deferred declarations.

use crate::check::agrees;
use lobe_codegen::kernels;
use lobe_codegen::prelude::*;

#[kernel]
fn chain(x: f32) -> f32 {
    if x < 0.0 {
        -x
    } else if x < 1.0 {
        let y = x * x;
        y + 1.0
    } else if x < 2.0 {
        return 7.0;
    } else {
        x
    }
}

#[kernel]
fn as_value(x: f32, p: bool) -> f32 {
    let y = if p { x } else { 2.0 * x } + if x > 0.0 { 1.0 } else { 0.5 };
    let z = {
        let y = y + 1.0;
        if p {
            return y;
        }
        y * y
    };
    y + z
}

#[kernel]
fn statements(x: f32) -> f32 {
    let mut y = x;
    if y > 1.0 {
        y -= 1.0;
    }
    if y < 0.0 {
        y = 0.0;
    } else if y > 3.0 {
        y = 3.0
    } else {
        if x > 2.0 {
            return 5.0;
        }
        y *= 2.0;
    }
    {
        let y = 9.0;
        let _ = y + 1.0;
    }
    y
}

#[kernel]
fn deferred(x: f32, p: bool) -> f32 {
    let a;
    let b: f32;
    if p {
        a = x;
        b = 1.0;
    } else {
        b = x;
        a = b + 2.0;
    }
    let c;
    match x as i32 {
        0 => c = 1,
        1 | 2 => {
            c = 2;
        }
        _ => c = -1,
    }
    a * b + c as f32
}

#[kernel]
fn diverging_branch(x: f32, n: i32) -> f32 {
    let y = if n > 3 { return x } else { x * 2.0 };
    let z = match n {
        0 => return 0.0,
        1 => y,
        _ => {
            if y > 0.0 {
                return 2.0;
            }
            -y
        }
    };
    y + z
}

#[kernel]
fn both_ways_return(x: f32) -> f32 {
    if x > 0.0 {
        return 1.0;
    } else {
        return -1.0;
    }
}

#[test]
fn branches_deliver_what_rust_delivers() {
    agrees(kernels![chain][0]);
    agrees(kernels![as_value][0]);
    agrees(kernels![statements][0]);
    agrees(kernels![deferred][0]);
    agrees(kernels![diverging_branch][0]);
    agrees(kernels![both_ways_return][0]);
}
