//! What proxies come to, all of them together.

use super::{Deviation, Proxies, Proxy};
use lobe_codegen::prelude::Vec3;
use serde::Serialize;
use std::fmt;

/// Proxies in figures.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Summary {
    /// How many there are.
    pub count: usize,
    /// Triangles that they stand for.
    pub triangles: usize,
    /// Area of what they stand for, m².
    pub area: f64,
    /// Share of that area that is left when it is seen along its proxy's normal.
    pub covered: f64,
    /// Area of the rectangles in that area: 1 where they fit, 2 of a rectangle around a triangle.
    pub overlap: f64,
    /// The largest deviations of all, and the root mean square by area.
    pub deviation: Deviation,
}

impl Proxy {
    /// Its area, m².
    #[must_use]
    pub fn area(&self) -> f64 {
        4.0 * f64::from(self.half_x) * f64::from(self.half_y)
    }

    /// Its corners, counter-clockwise for who sees its front, m.
    #[must_use]
    pub fn corners(&self) -> [Vec3; 4] {
        let (x, y) = (self.half_x * self.tangent, self.half_y * self.normal.cross(self.tangent));
        [-x - y, x - y, x + y, y - x].map(|offset| self.position + offset)
    }

    /// Its covered area, m².
    #[must_use]
    pub fn covered(&self) -> f64 {
        f64::from(self.fill) * self.area()
    }
}

impl Proxies {
    /// Them in figures.
    #[must_use]
    pub fn summary(&self) -> Summary {
        let sum = |of: fn(&Proxy) -> f64| self.rectangles.iter().map(of).sum::<f64>();
        let most = |of: fn(&Proxy) -> f32| self.rectangles.iter().map(of).fold(0.0, f32::max);
        let covered = sum(Proxy::covered);
        let squares = sum(|proxy| proxy.covered() * f64::from(proxy.deviation.rms).powi(2));
        Summary {
            count: self.rectangles.len(),
            triangles: self.rectangles.iter().map(|proxy| proxy.triangles).sum(),
            area: self.area,
            covered: covered / self.area,
            overlap: sum(Proxy::area) / self.area,
            deviation: Deviation {
                max: most(|proxy| proxy.deviation.max),
                rms: (squares / covered).sqrt() as f32,
                angle_deg: most(|proxy| proxy.deviation.angle_deg),
            },
        }
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { count, triangles, area, covered, overlap, deviation } = self;
        let Deviation { max, rms, angle_deg } = deviation;
        writeln!(f, "{count} rectangles for {triangles} triangles, {area:.4} m²")?;
        writeln!(f, "covered    {:6.2} % of the area, as seen along normals", 100.0 * covered)?;
        writeln!(f, "overlap    {overlap:6.3} m² of rectangles for each m²")?;
        writeln!(f, "deviation  {max:.3e} m at most, {rms:.3e} m rms, {angle_deg:.2} degrees")
    }
}
