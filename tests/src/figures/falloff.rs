//! Falloff of the reflected radiance around the specular peak, and its fit: the rectangle paper's figure 4.

use super::axis::Axis;
use super::plot::{Corner, Figure, Mark, Panel, Series};
use super::{DrawError, largest, real};
use lobe_codegen::kernels;
use lobe_kernels::rect::attenuation::{rect_falloff, rect_falloff_fit, rect_falloff_paper};
use std::f64::consts::{FRAC_PI_2, PI};

/// Light's angle of incidence, its name, and GGX alpha of the rectangle.
const CASES: [(f64, &str, f32); 4] = [
    (PI / 6.0, "π/6", 0.1),
    (2.0 * PI / 5.0, "2π/5", 0.1),
    (PI / 6.0, "π/6", 0.7),
    (2.0 * PI / 5.0, "2π/5", 0.7),
];
const SAMPLES: usize = 1801;
/// One in so many samples is drawn.
const DRAWN: usize = 9;

/// The three curves of a case.
struct Curves {
    fit: Vec<f64>,
    printed: Vec<f64>,
    exact: Vec<f64>,
}

/// The figure.
pub(super) fn figure() -> Result<Figure, DrawError> {
    let curves =
        CASES.iter().map(|(sigma, _, alpha)| curves(*sigma, *alpha)).collect::<Result<Vec<_>, _>>()?;
    let apart = |other: fn(&Curves) -> &Vec<f64>| {
        let of = |c: &Curves| {
            let distances = c.fit.iter().zip(other(c)).map(|(a, b)| a - b);
            format!("{:.3}", largest(distances).abs())
        };
        curves.iter().map(of).collect::<Vec<_>>().join(", ")
    };
    let caption = format!(
        "[RectGlossy] figure 4. The fit exp(−k sin² θ) cos θ of eq. 25 (rect_falloff_fit) was made for eq. 23 with the angle \
         of eq. 24 (rect_falloff_paper); the angle is ψ = θ/2 in truth (rect_falloff). Largest distance of the fit, panel by \
         panel: {} to the printed curve, {} to the exact one. Kernels in f64, {SAMPLES} angles.",
        apart(|c| &c.printed),
        apart(|c| &c.exact)
    );
    let panels = CASES.iter().zip(&curves).map(|((_, name, alpha), curves)| Panel {
        title: format!("σ = {name}, m = {alpha}"),
        x: Axis::linear("angle θ from the peak, degrees", 0.0, 90.0, 15.0),
        y: Axis::linear("f(θ)", 0.0, 1.2, 0.2),
        series: vec![
            Series::new("eq. 23, ψ of eq. 24", 0, Mark::Line(drawn(&curves.printed))),
            Series::new("eq. 23, ψ = θ/2", 2, Mark::Dashes(drawn(&curves.exact))),
            Series::new("fit, eq. 25", 1, Mark::Line(drawn(&curves.fit))),
        ],
        legend: Some(if *alpha < 0.5 { Corner::TopRight } else { Corner::BottomLeft }),
    });
    Ok(Figure {
        name: "falloff",
        title: "Falloff around the specular peak, and its fit".to_owned(),
        panels: panels.collect(),
        caption,
    })
}

fn angle(sample: usize) -> f64 {
    FRAC_PI_2 * sample as f64 / (SAMPLES - 1) as f64
}

fn curves(sigma: f64, alpha: f32) -> Result<Curves, DrawError> {
    let tangent = |theta: f64| libm::tan(theta).min(1e7) as f32;
    let tangents: Vec<f32> = (0..SAMPLES).map(|i| tangent(angle(i))).collect();
    let rows = |rest: &[f32]| -> Vec<Vec<f32>> { tangents.iter().map(|t| [&[*t], rest].concat()).collect() };
    let (cosine, slope) = (libm::cos(sigma) as f32, libm::tan(sigma) as f32);
    Ok(Curves {
        fit: real(kernels![rect_falloff_fit][0], &rows(&[cosine, alpha]))?,
        printed: real(kernels![rect_falloff_paper][0], &rows(&[slope, alpha]))?,
        exact: real(kernels![rect_falloff][0], &rows(&[alpha]))?,
    })
}

fn drawn(values: &[f64]) -> Vec<(f64, f64)> {
    let point = |(i, v): (usize, &f64)| (angle(i).to_degrees(), *v);
    values.iter().enumerate().step_by(DRAWN).map(point).collect()
}
