//! Product of an anisotropic and an isotropic lobe, with half the sharpness and with all of it: the rectangle
//! paper's figure 7.

use super::axis::Axis;
use super::plot::{Corner, Figure, Mark, Panel, Series};
use super::quadrature::anisotropic;
use super::{DrawError, largest, real};
use lobe_codegen::def::FunctionRef;
use lobe_codegen::kernels;
use lobe_kernels::asg::{asg_sg_product_integral, asg_sg_product_integral_paper};

const SHARPNESSES: [f64; 4] = [10.0, 50.0, 200.0, 1000.0];
/// Tilts of the isotropic lobe, in degrees.
const TILTS: [f64; 7] = [0.0, 5.0, 10.0, 20.0, 30.0, 45.0, 60.0];
/// The second bandwidth over the first.
const RATIO: f64 = 0.25;
const BANDWIDTHS: usize = 37;

/// At one bandwidth and sharpness.
struct Cell {
    bandwidth: f64,
    /// Over the exact value, on the axis.
    on_axis: f64,
    /// Largest error over all tilts, over the exact value on the axis.
    tilted: f64,
}

/// The figure.
pub(super) fn figure() -> Result<Figure, DrawError> {
    let axis = Axis::log("bandwidth λ", 0, 4, 1);
    let half = kernels![asg_sg_product_integral][0];
    let all = kernels![asg_sg_product_integral_paper][0];
    let exact = exact(&axis);
    let (half, all) = (curves(half, &exact)?, curves(all, &exact)?);
    let on_axis = |curves: &[Vec<Cell>], from: f64| {
        let cells = curves.iter().flatten().filter(|c| c.bandwidth >= from);
        largest(cells.map(|c| c.on_axis - 1.0))
    };
    let tilted = |from: f64| largest(half.iter().flatten().filter(|c| c.bandwidth >= from).map(|c| c.tilted));
    let caption = format!(
        "[RectGlossy] figure 7. Closed form of the integral of an anisotropic lobe, bandwidths λ and λ/4, times a spherical Gaussian of sharpness \
         ν, over the exact integral. Eq. 11 takes ν as printed: off by {} on the axis even for λ ≥ 50. By its own eq. 1 \
         it is ν/2, as in asg_sg_product_integral: off by {} for λ ≥ 50, {} for λ ≥ 10. Below: the largest error for lobes \
         tilted by up to 60° along either tangent, over the exact value on the axis; with ν/2 it is at most {} for λ ≥ 50. \
         Kernels in f64; exact values by quadrature.",
        percent(on_axis(&all, 50.0)),
        percent(on_axis(&half, 50.0)),
        percent(on_axis(&half, 10.0)),
        percent(tilted(50.0))
    );
    let panel = |title: &str, y: Axis, curves: &[Vec<Cell>], pick: fn(&Cell) -> f64, legend| Panel {
        title: title.to_owned(),
        x: axis.clone(),
        y,
        series: series(curves, pick),
        legend,
    };
    let ratio = || Axis::linear("closed form / exact", 0.4, 1.6, 0.2);
    let error = || Axis::log("largest error / peak", -5, 1, 1);
    let (right, left) = (Some(Corner::TopRight), Some(Corner::BottomLeft));
    Ok(Figure {
        name: "convolution",
        title: "Anisotropic times isotropic lobe: ν or ν/2".to_owned(),
        panels: vec![
            panel("On the axis, ν/2", ratio(), &half, |c| c.on_axis, right),
            panel("On the axis, ν as printed", ratio(), &all, |c| c.on_axis, right),
            panel("Tilted up to 60°, ν/2", error(), &half, |c| c.tilted.max(1e-9), right),
            panel("Tilted up to 60°, ν as printed", error(), &all, |c| c.tilted.max(1e-9), left),
        ],
        caption,
    })
}

fn percent(share: f64) -> String {
    let percent = 100.0 * share.abs();
    if percent < 10.0 { format!("{percent:.1} %") } else { format!("{percent:.0} %") }
}

fn series(curves: &[Vec<Cell>], pick: fn(&Cell) -> f64) -> Vec<Series> {
    let one = |(index, cells): (usize, &Vec<Cell>)| {
        let points: Vec<(f64, f64)> = cells.iter().map(|c| (c.bandwidth, pick(c))).collect();
        let mark = if index % 2 == 0 { Mark::Line(points) } else { Mark::Dashes(points) };
        Series::new(&format!("ν = {}", SHARPNESSES[index]), index, mark)
    };
    curves.iter().enumerate().map(one).collect()
}

/// The exact integrals of all tilts at one bandwidth and sharpness.
struct Exact {
    bandwidth: f64,
    mu: f64,
    nu: f64,
    values: Vec<f64>,
}

fn exact(axis: &Axis) -> Vec<Vec<Exact>> {
    let axes = directions();
    let one = |bandwidth: f64, nu: f64| {
        let mu = f64::from((bandwidth * RATIO) as f32);
        let values = axes.iter().map(|p| anisotropic(bandwidth, mu, nu, p.map(f64::from))).collect();
        Exact { bandwidth, mu, nu, values }
    };
    let bandwidths = || axis.values(BANDWIDTHS).map(|b| f64::from(b as f32));
    SHARPNESSES.iter().map(|nu| bandwidths().map(|b| one(b, *nu)).collect()).collect()
}

fn curves(kernel: FunctionRef, exact: &[Vec<Exact>]) -> Result<Vec<Vec<Cell>>, DrawError> {
    exact.iter().map(|row| row.iter().map(|exact| cell(kernel, exact)).collect()).collect()
}

fn cell(kernel: FunctionRef, exact: &Exact) -> Result<Cell, DrawError> {
    let Exact { bandwidth, mu, nu, ref values } = *exact;
    let rows: Vec<Vec<f32>> = directions().iter().map(|p| arguments(bandwidth, mu, nu, *p)).collect();
    let found = real(kernel, &rows)?;
    let errors = found.iter().zip(values).map(|(found, exact)| (found - exact) / values[0]);
    Ok(Cell { bandwidth, on_axis: found[0] / values[0], tilted: largest(errors).abs() })
}

/// The axes of the isotropic lobe, the one on the anisotropic lobe's first.
fn directions() -> Vec<[f32; 3]> {
    let along = |turned: bool| {
        TILTS.iter().map(move |degrees| {
            let (s, c) = (libm::sin(degrees.to_radians()) as f32, libm::cos(degrees.to_radians()) as f32);
            if turned { [0.0, s, c] } else { [s, 0.0, c] }
        })
    };
    along(false).chain(along(true)).collect()
}

/// In the order of the kernel's scalars: `z`, `x`, `y`, bandwidths, amplitude; axis, sharpness, log amplitude.
fn arguments(lambda: f64, mu: f64, nu: f64, p: [f32; 3]) -> Vec<f32> {
    let frame = [0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    let lobe = [p[0], p[1], p[2], nu as f32, 0.0];
    frame.into_iter().chain([lambda as f32, mu as f32, 1.0]).chain(lobe).collect()
}
