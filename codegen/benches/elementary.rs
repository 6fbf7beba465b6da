//! Errors of the elementary functions over all floats, in ULP against f64.
//!
//! `cargo bench -p lobe-codegen --bench elementary`: a minute.

use lobe_codegen::math::elementary::{exp, log};
use std::time::Instant;

type Row = (&'static str, fn(f32) -> f32, fn(f64) -> f64);

/// Error of `found` in ULP of `exact`; 0 for a result that may be flushed, for NaN of NaN and beyond the range.
fn ulps(found: f32, exact: f64) -> f64 {
    let nearest = exact as f32;
    let same = found == nearest || found.is_nan() && nearest.is_nan();
    let flushed = found == 0.0 && exact.abs() <= f64::from(f32::MIN_POSITIVE);
    if same || flushed {
        return 0.0;
    }
    let spacing = 2_f64.powi(exact.abs().log2().floor() as i32 - 23);
    (f64::from(found) - exact).abs() / spacing
}

fn worst(f: fn(f32) -> f32, exact: fn(f64) -> f64) -> (f64, f32) {
    let mut worst = (0.0, 0.0);
    for bits in 0..=u32::MAX {
        let x = f32::from_bits(bits);
        let error = ulps(f(x), exact(x.into()));
        if error > worst.0 || error.is_nan() {
            worst = (error, x);
        }
    }
    worst
}

fn main() {
    let table: [Row; 2] = [("exp", exp, libm::exp), ("log", log, libm::log)];
    for (name, f, exact) in table {
        let begin = Instant::now();
        let (error, at) = worst(f, exact);
        println!("{name:5} {error:.3} ULP at {at:e} ({:.0} s)", begin.elapsed().as_secs_f64());
    }
}
