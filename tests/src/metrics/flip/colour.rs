//! Colour spaces of FLIP.

use lobe_codegen::glam::{DMat3, DVec2, DVec3, Mat3, Vec3};

/// Chromaticities of red, green and blue of sRGB (IEC 61966-2-1).
const PRIMARIES: [DVec2; 3] = [DVec2::new(0.64, 0.33), DVec2::new(0.30, 0.60), DVec2::new(0.15, 0.06)];
/// That of its white, the illuminant D65 (CIE 15).
const WHITE: DVec2 = DVec2::new(0.312_71, 0.329_02);

/// Between linear RGB and CIE XYZ over that of white.
pub(super) struct Colours {
    to_xyz: Mat3,
    to_rgb: Mat3,
}

/// XYZ of a chromaticity, Y being 1.
fn xyz(chromaticity: DVec2) -> DVec3 {
    let DVec2 { x, y } = chromaticity;
    DVec3::new(x / y, 1.0, (1.0 - x - y) / y)
}

impl Default for Colours {
    fn default() -> Self {
        let [red, green, blue] = PRIMARIES.map(xyz);
        let (columns, white) = (DMat3::from_cols(red, green, blue), xyz(WHITE));
        // As much of each as makes white.
        let scaled = columns * DMat3::from_diagonal(columns.inverse() * white);
        let to_xyz = DMat3::from_diagonal(white.recip()) * scaled;
        Self { to_xyz: to_xyz.as_mat3(), to_rgb: to_xyz.inverse().as_mat3() }
    }
}

impl Colours {
    /// Y, Cx, Cz: L*a*b* without its curve, so that filters may be applied.
    pub(super) fn opponent(&self, rgb: Vec3) -> Vec3 {
        let Vec3 { x, y, z } = self.to_xyz * rgb;
        Vec3::new(116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z))
    }

    /// Linear RGB of [`Colours::opponent`].
    pub(super) fn rgb_of_opponent(&self, opponent: Vec3) -> Vec3 {
        let y = (opponent.x + 16.0) / 116.0;
        self.to_rgb * Vec3::new(y + opponent.y / 500.0, y, y - opponent.z / 200.0)
    }

    /// CIE L*a*b*.
    pub(super) fn lab(&self, rgb: Vec3) -> Vec3 {
        let Vec3 { x, y, z } = (self.to_xyz * rgb).map(curve);
        Vec3::new(116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z))
    }
}

/// The cube root, with a straight line near 0.
fn curve(t: f32) -> f32 {
    const DELTA: f32 = 6.0 / 29.0;
    if t > DELTA * DELTA * DELTA { t.cbrt() } else { t / (3.0 * DELTA * DELTA) + 4.0 / 29.0 }
}

/// Colours are paler where it is dark (the effect of Hunt).
pub(super) fn hunt_adjusted(lab: Vec3) -> Vec3 {
    let shade = 0.01 * lab.x;
    Vec3::new(lab.x, shade * lab.y, shade * lab.z)
}

/// The distance of Abasi et al.: in lightness, and in the plane of colours, added.
pub(super) fn hyab(a: Vec3, b: Vec3) -> f32 {
    let gap = a - b;
    gap.x.abs() + gap.y.hypot(gap.z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_is_white_and_back_again() {
        let colours = Colours::default();
        assert!((colours.lab(Vec3::ONE) - Vec3::new(100.0, 0.0, 0.0)).length() < 1e-3);
        assert!((colours.lab(Vec3::ZERO)).length() < 1e-4);
        let rgb = Vec3::new(0.2, 0.7, 0.4);
        assert!((colours.rgb_of_opponent(colours.opponent(rgb)) - rgb).length() < 1e-5);
    }

    /// Red of sRGB as tables of L*a*b* have it.
    #[test]
    fn red_is_where_tables_have_it() {
        let red = Colours::default().lab(Vec3::X);
        assert!((red - Vec3::new(53.24, 80.09, 67.20)).length() < 0.05, "{red}");
    }
}
