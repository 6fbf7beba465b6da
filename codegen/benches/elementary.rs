//! Errors of the elementary functions over all floats, in ULP against f64, and their time for 16 lanes.
//!
//! `cargo bench -p lobe-codegen --bench elementary [-- [--time] FUNCTION ...]`: a minute a function; `--time` leaves out
//! the errors.
#![allow(unsafe_code, reason = "functions compiled for instruction sets, found before they are called")]

use lobe_codegen::math::elementary::*;
use std::hint::black_box;
use std::time::Instant;

/// A function with its loop over lanes for each instruction set, and f64's.
struct Row {
    name: &'static str,
    f: fn(f32) -> f32,
    exact: fn(f64) -> f64,
    lanes: [(&'static str, Option<Lanes>); 3],
}

type Lanes = fn(&mut [f32; LANES], &[f32; LANES]);

const LANES: usize = 128;

macro_rules! lanes {
    ($f:expr, $present:expr, $features:literal) => {{
        #[cfg(target_arch = "x86_64")]
        #[target_feature(enable = $features)]
        fn compiled(d: &mut [f32; LANES], x: &[f32; LANES]) {
            d.iter_mut().zip(x).for_each(|(d, x)| *d = $f(*x));
        }
        #[cfg(target_arch = "x86_64")]
        // SAFETY: asked for only where the processor has them.
        let found = $present.then_some((|d, x| unsafe { compiled(d, x) }) as Lanes);
        #[cfg(not(target_arch = "x86_64"))]
        let found = None;
        found
    }};
}

#[cfg(target_arch = "x86_64")]
fn has_avx2() -> bool {
    is_x86_feature_detected!("avx2")
}

#[cfg(target_arch = "x86_64")]
fn has_avx512() -> bool {
    has_avx2() && is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq")
}

macro_rules! row {
    ($name:literal, $f:expr, $exact:expr) => {
        Row {
            name: $name,
            f: $f,
            exact: $exact,
            lanes: [
                ("portable", Some(|d, x| d.iter_mut().zip(x).for_each(|(d, x)| *d = $f(*x)))),
                ("avx2", lanes!($f, has_avx2(), "avx2")),
                ("avx512", lanes!($f, has_avx512(), "avx2,avx512f,avx512dq,avx512vl,avx512bw")),
            ],
        }
    };
}

fn table() -> Vec<Row> {
    vec![
        row!("exp", exp, libm::exp),
        row!("exp2", exp2, libm::exp2),
        row!("log", log, libm::log),
        row!("log2", log2, libm::log2),
        row!("sin", sin, libm::sin),
        row!("cos", cos, libm::cos),
        row!("tan", tan, libm::tan),
        row!("near::sin", |x| if near::holds(x) { near::sin(x) } else { sin(x) }, libm::sin),
        row!("asin", asin, libm::asin),
        row!("acos", acos, libm::acos),
        row!("atan", atan, libm::atan),
        row!("sinh", sinh, libm::sinh),
        row!("cosh", cosh, libm::cosh),
        row!("tanh", tanh, libm::tanh),
        row!("asinh", asinh, libm::asinh),
        row!("acosh", acosh, |x| if x < 1.0 { f64::NAN } else { libm::acosh(x) }),
        row!("atanh", atanh, libm::atanh),
        row!("x^2.4", |x| pow(x, 2.4), |x| if x < 0.0 { f64::NAN } else { libm::pow(x, 2.4_f32.into()) }),
        row!("atan2 1 x", |x| atan2(1.0, x), |x| libm::atan2(1.0, x)),
    ]
}

/// Error of `found` in ULP of `exact`; 0 for a result that may be flushed, for NaN of NaN and beyond the range.
fn ulps(found: f32, exact: f64) -> f64 {
    let flushed = found == 0.0 && exact.abs() <= f64::from(f32::MIN_POSITIVE);
    let beyond = found == exact as f32 && !(exact as f32).is_finite();
    if flushed || beyond || found.is_nan() && exact.is_nan() { 0.0 } else { distance(found, exact) }
}

/// In units of the last place of a normal number, or the least one.
fn distance(found: f32, exact: f64) -> f64 {
    let exponent = (exact.abs().to_bits() >> 52).max(1023 - 126) - 23;
    (f64::from(found) - exact).abs() / f64::from_bits(exponent << 52)
}

/// Worst error and its argument, in an eighth of the floats.
fn worst_of(row: &Row, part: u32) -> (f64, f32) {
    let mut worst = (0.0, 0.0);
    for bits in (part << 29)..=(part << 29 | (u32::MAX >> 3)) {
        let x = f32::from_bits(bits);
        let error = ulps((row.f)(x), (row.exact)(x.into()));
        if error > worst.0 || error.is_nan() {
            worst = (error, x);
        }
    }
    worst
}

fn worst(row: &Row) -> (f64, f32) {
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get() as u32);
    std::thread::scope(|scope| {
        let part =
            |at| move || (0..8).filter(|p| p % threads == at).map(|p| worst_of(row, p)).collect::<Vec<_>>();
        let running: Vec<_> = (0..threads.min(8)).map(|at| scope.spawn(part(at))).collect();
        let all = running.into_iter().flat_map(|t| t.join().unwrap_or_default());
        all.fold((0.0, 0.0), |a, b| if b.0 > a.0 { b } else { a })
    })
}

/// Least time of many, in ns for 16 lanes.
fn time(lanes: Lanes) -> f64 {
    let x = std::array::from_fn(|lane| 0.007 * (lane as f32 + 1.0));
    let mut d = [0.0; LANES];
    let round = |d: &mut [f32; LANES]| {
        let begin = Instant::now();
        (0..1000).for_each(|_| lanes(black_box(d), black_box(&x)));
        begin.elapsed().as_secs_f64() * 1e9 / 1000.0 / (LANES / 16) as f64
    };
    (0..25).map(|_| round(&mut d)).fold(f64::INFINITY, f64::min)
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let times_only = arguments.iter().any(|a| a == "--time");
    let wanted: Vec<_> = arguments.iter().filter(|a| !a.starts_with("--")).collect();
    for row in table().iter().filter(|r| wanted.is_empty() || wanted.iter().any(|w| *w == r.name)) {
        print!("{:10}", row.name);
        for (isa, lanes) in row.lanes {
            lanes.into_iter().for_each(|lanes| print!(" {isa} {:6.2} ns", time(lanes)));
        }
        if !times_only {
            let (error, at) = worst(row);
            print!("  {error:.3} ULP at {at:e}");
        }
        println!();
    }
}
