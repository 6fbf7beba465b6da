//! Error of the spherical Gaussian that stands for the clamped cosine: the supplement's figure 1, and the
//! numerical error of the two forms.

use super::axis::Axis;
use super::plot::{Corner, Figure, Mark, Panel, Series, number};
use super::{DrawError, largest, real};
use lobe_codegen::kernels;
use lobe_kernels::hsg::{clamped_cosine, clamped_cosine_paper};

/// Cosines that are evaluated.
const SAMPLES: usize = 30_000;
/// Places that are drawn, each for all samples around it.
const BINS: usize = 150;

/// The figure.
pub(super) fn figure() -> Result<Figure, DrawError> {
    let cosines: Vec<f32> = (0..=SAMPLES).map(|i| i as f32 / SAMPLES as f32).collect();
    let rows: Vec<Vec<f32>> = cosines.iter().map(|c| vec![*c]).collect();
    let [ours, printed] = [kernels![clamped_cosine][0], kernels![clamped_cosine_paper][0]];
    let (ours, printed) = (real(ours, &rows)?, real(printed, &rows)?);
    let difference = |f: fn(f32) -> f32, exact: &[f64]| -> Vec<f64> {
        cosines.iter().zip(exact).map(|(c, exact)| f64::from(f(*c)) - exact).collect()
    };
    let approximation: Vec<f64> = cosines.iter().zip(&ours).map(|(c, value)| value - f64::from(*c)).collect();
    let ours = difference(clamped_cosine, &ours);
    let printed = difference(clamped_cosine_paper, &printed);
    let (low, high) = range(&approximation);
    let caption = format!(
        "[Tokuyoshi22] supplement, figure 1. The approximation differs from max(cos θ, 0) by {} to {} (f64). Evaluated as \
         printed, a (exp(l cos θ) − 1), rounding in strict f32 adds up to {}, and more on a driver, whose exp may err by \
         3 ULP. The form of clamped_cosine, which does not cancel, adds at most {}. {} cosines; at each place the largest \
         of {} is drawn.",
        number(low),
        number(high),
        number(largest(printed.iter().copied()).abs()),
        number(largest(ours.iter().copied()).abs()),
        SAMPLES + 1,
        SAMPLES / BINS
    );
    Ok(Figure {
        name: "clamped_cosine",
        title: "Clamped cosine as a spherical Gaussian".to_owned(),
        panels: vec![
            signed(&cosines, &approximation, &printed),
            sizes(&cosines, &approximation, &printed, &ours),
        ],
        caption,
    })
}

fn signed(cosines: &[f32], approximation: &[f64], printed: &[f64]) -> Panel {
    let scaled = |v: f64| v * 1e4;
    let noise = bins(cosines, printed).map(|(x, values)| {
        let (low, high) = range(values);
        (x, scaled(low), scaled(high))
    });
    let curve = bins(cosines, approximation).map(|(x, values)| (x, scaled(values[values.len() / 2])));
    Panel {
        title: "Approximation, and rounding of the printed form".to_owned(),
        x: Axis::linear("cos θ", 0.0, 1.0, 0.2),
        y: Axis::linear("error, 10^{−4}", -2.0, 3.5, 1.0),
        series: vec![
            Series::new("rounding, as printed, strict f32", 0, Mark::Band(noise.collect())),
            Series::new("approximation, f64", 1, Mark::Line(curve.collect())),
        ],
        legend: Some(Corner::TopLeft),
    }
}

fn sizes(cosines: &[f32], approximation: &[f64], printed: &[f64], ours: &[f64]) -> Panel {
    let size = |values: &[f64]| -> Vec<(f64, f64)> {
        let largest = |(x, values): (f64, &[f64])| (x, largest(values.iter().copied()).abs().max(1e-30));
        bins(cosines, values).map(largest).collect()
    };
    Panel {
        title: "Sizes of the errors".to_owned(),
        x: Axis::linear("cos θ", 0.0, 1.0, 0.2),
        y: Axis::log("|error|", -10, -1, 1),
        series: vec![
            Series::new("rounding, as printed", 0, Mark::Line(size(printed))),
            Series::new("approximation", 1, Mark::Line(size(approximation))),
            Series::new("rounding, clamped_cosine", 2, Mark::Line(size(ours))),
        ],
        legend: Some(Corner::TopLeft),
    }
}

/// The values around each place.
fn bins<'a>(cosines: &[f32], values: &'a [f64]) -> impl Iterator<Item = (f64, &'a [f64])> {
    let n = SAMPLES / BINS;
    let middles: Vec<f64> = cosines.chunks(n).map(|chunk| f64::from(chunk[chunk.len() / 2])).collect();
    middles.into_iter().zip(values.chunks(n)).take(BINS)
}

fn range(values: &[f64]) -> (f64, f64) {
    values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(*v), high.max(*v)))
}
