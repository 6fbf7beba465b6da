//! `match` on integers, and jumps out of it.

use crate::check::{agrees, agrees_on};
use lobe_codegen::kernels;
use lobe_codegen::prelude::*;

#[kernel]
fn values(n: i32) -> i32 {
    match n {
        -1 => 10,
        0 | 3 => 20,
        1 => {
            let k = n * 2;
            k + 1
        }
        0x7 => 4,
        _ => n,
    }
}

#[kernel]
fn without_sign(n: u32) -> f32 {
    let x = match n % 4 {
        0 => 0.5,
        1u32 => 1.5,
        _ => {
            if n > 6 {
                return -1.0;
            }
            2.5
        }
    };
    x * 2.0
}

/// An arm below `_` is never reached, and the first of two equal patterns is taken.
#[kernel]
#[allow(unreachable_patterns, reason = "that is what is tested")]
fn first_arm_wins(n: i32) -> i32 {
    let a = match n {
        1 => 1,
        1 | 2 | 2 => 2,
        _ => 3,
        4 => 4,
    };
    let b = match n {
        0 | _ => 5,
        1 => 6,
    };
    a * 10 + b
}

#[kernel]
fn breaks_out(n: i32) -> i32 {
    let mut total = 0;
    for i in 0..=n {
        match i {
            3 => continue,
            5 | 6 => break,
            _ => {
                total += i;
            }
        }
        let mut j = 0;
        while j < i {
            j += 1;
            match j {
                2 => match total {
                    0 => continue,
                    7 => return -total,
                    12 => break,
                    _ => total += 1,
                },
                4 => break,
                _ => {}
            }
            total += 10;
        }
        total += 100;
    }
    total
}

/// The inner loop is entered again after it was left from inside a `match`.
#[kernel]
fn left_and_entered_again(n: u32) -> u32 {
    let mut total = 0u32;
    for i in 0..n {
        let mut j = 0;
        loop {
            match j {
                2 => break,
                _ => {
                    match i {
                        1 => break,
                        _ => total += 1,
                    }
                    total += 10;
                }
            }
            j += 1;
        }
        total += 1000;
    }
    total
}

#[kernel]
fn value_or_break(n: i32) -> i32 {
    let mut total = 0;
    let mut i = n;
    loop {
        let step = match i {
            0 => break,
            1 | 2 => 1,
            3 => {
                i -= 1;
                continue;
            }
            _ => 2,
        };
        total += step;
        i -= 1;
        if i < -6 {
            break;
        }
    }
    total
}

#[kernel]
fn returns_in_all_arms(n: u32) -> f32 {
    loop {
        match n {
            0 => return 1.0,
            1 => return 2.0,
            _ => return 3.0,
        }
    }
}

#[kernel]
fn evaluated_once(n: i32) -> i32 {
    let mut k = n;
    match {
        k += 1;
        k
    } {
        1 => k * 10,
        2 => k * 20,
        _ => k,
    }
}

#[test]
fn match_takes_the_arm_that_rust_takes() {
    agrees(kernels![values][0]);
    agrees(kernels![without_sign][0]);
    agrees(kernels![first_arm_wins][0]);
    agrees(kernels![evaluated_once][0]);
    agrees(kernels![returns_in_all_arms][0]);
}

#[test]
fn jumps_out_of_a_match_reach_the_loop() {
    agrees(kernels![breaks_out][0]);
    agrees_on(kernels![breaks_out][0], (0..30).map(|n| vec![n]).collect());
    agrees(kernels![left_and_entered_again][0]);
    agrees(kernels![value_or_break][0]);
}
