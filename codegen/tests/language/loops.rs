//! `for`, `while`, `loop`, `break`, `continue`.

use crate::check::{agrees, agrees_on, refusal};
use lobe_codegen::kernels;
use lobe_codegen::prelude::*;

#[kernel]
fn sums(n: i32, m: u32) -> i32 {
    let mut total = 0;
    for i in 0..n {
        total += i;
    }
    for i in -2..=n {
        total += i * i;
    }
    for i in m..5 {
        total += i as i32;
    }
    for i in 3..3 {
        total += i + 100;
    }
    for _ in 0..2 {
        total += 1;
    }
    total
}

/// `continue` still counts.
#[kernel]
fn skips(n: u32) -> u32 {
    let mut total = 0u32;
    for i in 0..n {
        if i % 3 == 1 {
            continue;
        }
        for j in 0..=i {
            if j == 2 {
                continue;
            }
            if j == 5 {
                break;
            }
            total += j;
        }
        total += 100;
    }
    total
}

/// The bounds are taken once, and a `mut` counter is a copy.
#[kernel]
fn bounds_once(n: i32) -> i32 {
    let mut end = n;
    let mut total = 0;
    for mut i in 0..end {
        end = 0;
        i *= 2;
        total += i;
    }
    total + end
}

#[kernel]
fn to_the_end(first: u32) -> u32 {
    let mut rounds = 0u32;
    for i in first..=u32::MAX {
        if i == 7 {
            return 99;
        }
        rounds += 1;
    }
    rounds
}

#[kernel]
fn to_the_signed_end(first: i32) -> i32 {
    let mut rounds = 0;
    for _i in first..=i32::MAX {
        rounds += 1;
    }
    rounds
}

#[kernel]
fn whiles(n: i32, x: f32) -> f32 {
    let mut i = 0;
    let mut y = x;
    while i < n && y < 100.0 {
        i += 1;
        if i == 3 {
            continue;
        }
        y = y * 2.0 + 1.0;
    }
    loop {
        y -= 1.0;
        if y < 10.0 {
            break;
        }
        if !(y < 1e6) {
            return -1.0;
        }
    }
    y
}

#[kernel]
fn returns_from_loop(n: u32) -> u32 {
    let mut i = 0u32;
    loop {
        i += 3;
        if i > n {
            return i;
        }
    }
}

/// A variable declared in a loop starts anew each round.
#[kernel]
fn fresh_each_round(n: u32) -> u32 {
    let mut total = 0u32;
    for i in 0..n {
        let mut once = 1u32;
        let late;
        once += i;
        late = once * 2;
        total += late;
    }
    total
}

#[kernel]
fn usize_counter(n: u32) -> f32 {
    let a = [1.0, 2.0, 3.0, 4.0];
    let mut total = 0.0;
    for i in 0..a.len() {
        if i < n as usize {
            total += a[i] * i as f32;
        }
    }
    total
}

#[test]
fn loops_run_as_in_rust() {
    agrees(kernels![sums][0]);
    agrees(kernels![skips][0]);
    agrees(kernels![bounds_once][0]);
    agrees(kernels![whiles][0]);
    agrees(kernels![returns_from_loop][0]);
    agrees(kernels![fresh_each_round][0]);
    agrees(kernels![usize_counter][0]);
}

#[test]
fn an_inclusive_range_may_end_at_the_last_number() {
    agrees_on(kernels![to_the_end][0], vec![vec![u32::MAX - 3], vec![u32::MAX]]);
    agrees_on(kernels![to_the_signed_end][0], vec![vec![i32::MAX as u32 - 3], vec![i32::MAX as u32]]);
}

#[kernel]
#[allow(clippy::empty_loop, reason = "that is what is refused")]
fn forever(x: f32) -> f32 {
    let _ = x;
    loop {}
}

#[test]
fn an_empty_endless_loop_is_refused() {
    assert!(refusal(kernels![forever][0]).contains("this loop never ends and does nothing"));
}
