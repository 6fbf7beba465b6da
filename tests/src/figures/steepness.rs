//! Steepness of the hemispherical integral, fitted and best: the supplement's figure 2, and what it costs.

use super::axis::Axis;
use super::plot::{Corner, Figure, Mark, Panel, Series, number};
use super::quadrature::{hemisphere, minimum};
use super::{DrawError, largest, real};
use lobe_codegen::kernels;
use lobe_kernels::hsg::{hsg_integral, hsg_steepness, hsg_upper_integral};
use lobe_kernels::sg::sg_integral;

/// Cosines at which the two shapes are compared, on one side: they are odd.
const COSINES: usize = 40;

/// At one sharpness.
struct Column {
    sharpness: f64,
    fitted: f64,
    best: f64,
    /// Errors of the integral over that of the sphere, cosine by cosine: of the fit and of the best steepness.
    errors: Vec<(f64, f64, f64)>,
}

/// The figure.
pub(super) fn figure() -> Result<Figure, DrawError> {
    let axis = Axis::log("sharpness k", -2, 5, 1);
    let sharpnesses: Vec<f32> = axis.values(113).map(|k| k as f32).collect();
    let columns = columns(&sharpnesses)?;
    let detail = self::columns(&[6.3])?;
    let worst = |pick: fn(&(f64, f64, f64)) -> f64| {
        let of = |c: &Column| largest(c.errors.iter().map(pick)).abs();
        columns
            .iter()
            .map(|c| (of(c), c.sharpness))
            .fold((0.0, 0.0), |a: (f64, f64), b| if b.0 > a.0 { b } else { a })
    };
    let (fitted, best) = (worst(|e| e.1), worst(|e| e.2));
    let off = |from: f64| {
        let apart = columns.iter().filter(|c| c.sharpness >= from).map(|c| c.fitted / c.best - 1.0);
        100.0 * largest(apart)
    };
    let caption = format!(
        "[Tokuyoshi22] supplement, figure 2. The fitted steepness t(k) of hsg_steepness against the one that fits the exact hemispherical integral best \
         (least squares over the cosine): off by up to {:.1} %, by {:.1} % for k ≥ 1. The integral of hsg_integral \
         then errs by at most {} of the lobe's integral over the sphere, at k = {:.1}; the best steepness would leave \
         {}: the shape limits, not the fit. Kernels in f64; exact values by quadrature over circles around the axis.",
        off(0.0).abs(),
        off(1.0).abs(),
        number(fitted.0),
        fitted.1,
        number(best.0)
    );
    Ok(Figure {
        name: "steepness",
        title: "Steepness of the hemispherical integral".to_owned(),
        panels: vec![
            values(&axis, &columns),
            apart(&axis, &columns),
            costs(&axis, &columns),
            shape(&detail[0]),
        ],
        caption,
    })
}

fn columns(sharpnesses: &[f32]) -> Result<Vec<Column>, DrawError> {
    let singles: Vec<Vec<f32>> = sharpnesses.iter().map(|k| vec![*k]).collect();
    let widths = real(kernels![hsg_steepness][0], &singles)?;
    let uppers = real(kernels![hsg_upper_integral][0], &singles)?;
    let spheres = real(kernels![sg_integral][0], &singles)?;
    let cosines: Vec<f32> = (-50..=50).map(|i| i as f32 / 50.0).collect();
    let mut columns = Vec::new();
    for (index, sharpness) in sharpnesses.iter().enumerate() {
        let k = f64::from(*sharpness);
        let rows: Vec<Vec<f32>> = cosines.iter().map(|c| vec![*c, *sharpness]).collect();
        let found = real(kernels![hsg_integral][0], &rows)?;
        let (upper, sphere) = (uppers[index], spheres[index]);
        let lower = sphere - upper;
        let best = best(k, upper, lower);
        let error = |(c, found): (&f32, f64)| {
            let c = f64::from(*c);
            let exact = hemisphere(c, k);
            // Interpolated between the hemispheres by the best steepness.
            let share = 0.5 + 0.5 * ratio(c, best);
            (c, (found - exact) / sphere, (lower + share * (upper - lower) - exact) / sphere)
        };
        let errors = cosines.iter().zip(found).map(error).collect();
        columns.push(Column { sharpness: k, fitted: k * widths[index], best, errors });
    }
    Ok(columns)
}

/// The steepness whose shape is nearest to the exact one.
fn best(k: f64, upper: f64, lower: f64) -> f64 {
    let cosine = |i: usize| (i as f64 + 0.5) / COSINES as f64;
    let exact: Vec<f64> =
        (0..COSINES).map(|i| 2.0 * (hemisphere(cosine(i), k) - lower) / (upper - lower) - 1.0).collect();
    let distance = |t: f64| -> f64 {
        exact.iter().enumerate().map(|(i, e)| (ratio(cosine(i), t) - e) * (ratio(cosine(i), t) - e)).sum()
    };
    let near = (0.5 * k).sqrt();
    minimum(0.2 * near.min(k), 2.0 * near, distance)
}

/// The shape that is fitted.
fn ratio(c: f64, t: f64) -> f64 {
    libm::erf(t * c) / libm::erf(t)
}

fn values(axis: &Axis, columns: &[Column]) -> Panel {
    let asymptote = axis.values(2).map(|k| (k, (0.5 * k).sqrt()));
    let dots = columns.iter().step_by(4).map(|c| (c.sharpness, c.best));
    Panel {
        title: "Steepness".to_owned(),
        x: axis.clone(),
        y: Axis::log("t(k)", -3, 3, 1),
        series: vec![
            Series::new("√(k/2)", 3, Mark::Dashes(asymptote.collect())),
            Series::new(
                "fit, hsg_steepness",
                1,
                Mark::Line(columns.iter().map(|c| (c.sharpness, c.fitted)).collect()),
            ),
            Series::new("best", 0, Mark::Dots(dots.collect())),
        ],
        legend: Some(Corner::BottomRight),
    }
}

fn apart(axis: &Axis, columns: &[Column]) -> Panel {
    let line = columns.iter().map(|c| (c.sharpness, 100.0 * (c.fitted / c.best - 1.0)));
    Panel {
        title: "Fit against the best".to_owned(),
        x: axis.clone(),
        y: Axis::linear("difference, %", -16.0, 4.0, 4.0),
        series: vec![Series::new("", 1, Mark::Line(line.collect()))],
        legend: None,
    }
}

fn costs(axis: &Axis, columns: &[Column]) -> Panel {
    let line = |pick: fn(&(f64, f64, f64)) -> f64| {
        columns.iter().map(|c| (c.sharpness, 1e3 * largest(c.errors.iter().map(pick)).abs())).collect()
    };
    Panel {
        title: "Largest error of the integral, over all cosines".to_owned(),
        x: axis.clone(),
        y: Axis::linear("of the sphere's, 10^{−3}", 0.0, 6.0, 1.0),
        series: vec![
            Series::new("best steepness", 0, Mark::Dashes(line(|e| e.2))),
            Series::new("fit, hsg_integral", 1, Mark::Line(line(|e| e.1))),
        ],
        legend: Some(Corner::TopRight),
    }
}

fn shape(column: &Column) -> Panel {
    let line =
        |pick: fn(&(f64, f64, f64)) -> f64| column.errors.iter().map(|e| (e.0, 1e3 * pick(e))).collect();
    Panel {
        title: "Error of the integral at k = 6.3".to_owned(),
        x: Axis::linear("cosine to the hemisphere's axis", -1.0, 1.0, 0.5),
        y: Axis::linear("of the sphere's, 10^{−3}", -6.0, 6.0, 2.0),
        series: vec![
            Series::new("best steepness", 0, Mark::Dashes(line(|e| e.2))),
            Series::new("fit, hsg_integral", 1, Mark::Line(line(|e| e.1))),
        ],
        legend: Some(Corner::BottomLeft),
    }
}
