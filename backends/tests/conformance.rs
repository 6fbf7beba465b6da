//! Every operation that has one right result, on numbers of every width: over tuples of edges and over
//! random rows, against integer arithmetic of our own.
//!
//! `LOBE_ROWS` says how many random rows an operation takes; 10^7 each is a matter of an hour.

mod common;
#[path = "conformance/drivers.rs"]
mod drivers;
#[path = "conformance/packed.rs"]
mod packed;
#[path = "conformance/real.rs"]
mod real;
#[path = "conformance/run.rs"]
mod run;
#[path = "conformance/soft.rs"]
mod soft;
#[path = "conformance/whole.rs"]
mod whole;

use lobe_backends::interp::Isa;
use run::{Operation, Ty};

/// Rows that are in memory at once.
const AT_ONCE: usize = 1 << 17;

/// Rows of edges that a driver is asked.
const AT_MOST_ON_A_DRIVER: usize = 8192;

/// Random rows an operation.
fn rows() -> usize {
    std::env::var("LOBE_ROWS").ok().and_then(|n| n.parse().ok()).unwrap_or(100_000)
}

/// SplitMix64.
fn chance(seed: u64) -> impl FnMut() -> u64 {
    let mut state = seed;
    move || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
}

/// All tuples of the arguments' edges, or as many of them, by chance, as there are random rows.
fn tuples(operation: &Operation, chance: &mut impl FnMut() -> u64) -> Vec<Vec<u64>> {
    let edges: Vec<Vec<u64>> = operation.args.iter().map(|ty| ty.edges()).collect();
    let all: usize = edges.iter().map(Vec::len).product();
    let count = all.min(rows());
    let row = |i: usize| {
        let mut rest = i;
        let pick = |of: &Vec<u64>| {
            let item = of[rest % of.len()];
            rest /= of.len();
            item
        };
        edges.iter().map(pick).collect()
    };
    (0..count).map(|i| row(if count == all { i } else { chance() as usize % all })).collect()
}

fn check(operations: Vec<Operation>) {
    let seed = std::env::var("LOBE_SEED").ok().and_then(|s| s.parse().ok()).unwrap_or(1);
    println!("LOBE_SEED={seed}");
    let mut chance = chance(seed);
    for operation in operations {
        let edges = tuples(&operation, &mut chance);
        for isa in Isa::available() {
            operation.check(&edges, isa);
        }
        let mut left = rows();
        while left > 0 {
            let count = left.min(AT_ONCE);
            let row = |_| operation.args.iter().map(|ty| ty.random(&mut chance)).collect();
            let random: Vec<Vec<u64>> = (0..count).map(row).collect();
            operation.check(&random, Isa::best());
            left -= count;
        }
    }
}

#[test]
fn words_of_several_numbers() {
    check(packed::operations());
}

macro_rules! widths {
    ($($name:ident $family:ident $ty:ident;)*) => {
        $(#[test]
        fn $name() {
            check($family::operations(Ty::$ty));
        })*
    };
}

widths! {
    integers_of_16_bits whole I16;
    integers_of_16_bits_without_sign whole U16;
    integers_of_32_bits whole I32;
    integers_of_32_bits_without_sign whole U32;
    integers_of_64_bits whole I64;
    integers_of_64_bits_without_sign whole U64;
    floats_of_16_bits real F16;
    floats_of_32_bits real F32;
    floats_of_64_bits real F64;
}

#[test]
fn on_lavapipe_integers_are_the_same_and_floats_as_near_as_wgsl_asks() {
    let Some(mut gpu) = drivers::lavapipe() else { return };
    let mut chance = chance(1);
    let integers = run::INTEGERS.into_iter().flat_map(whole::operations);
    let floats = run::FLOATS.into_iter().flat_map(real::operations);
    for operation in integers.chain(floats).chain(packed::operations()) {
        let mut edges = tuples(&operation, &mut chance);
        edges.truncate(AT_MOST_ON_A_DRIVER);
        operation.check_on(&mut gpu, &edges);
    }
}
