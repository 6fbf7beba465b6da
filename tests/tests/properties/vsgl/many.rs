//! One light for many virtual point lights.

use lobe_codegen::glam::Vec3;
use lobe_kernels::filter::{moments_empty, moments_merge, moments_of_lobe, moments_of_position};
use lobe_kernels::vsgl::{
    Vsgl, vpl_radiance, vpl_transfer, vsgl_diffuse, vsgl_diffuse_paper, vsgl_from_moments,
    vsgl_from_moments_paper, vsgl_specular,
};

/// VPLs, each of power 1, on a disk at distance 1 above the origin that is tilted by 17.5 degrees; they emit as a
/// cosine.
struct Disk {
    normal: Vec3,
    positions: Vec<Vec3>,
}

impl Disk {
    fn new(radius: f32) -> Self {
        let n: u16 = 64;
        let normal = Vec3::new(-0.3, -0.1, -1.0).normalize();
        let (x, y) = normal.any_orthonormal_pair();
        let rings = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
        let positions = rings.map(|(i, j)| {
            let r = radius * ((f32::from(i) + 0.5) / f32::from(n)).sqrt();
            let phi = std::f32::consts::TAU * (f32::from(j) + 0.5 * f32::from(i % 2)) / f32::from(n);
            Vec3::Z + r * phi.cos() * x + r * phi.sin() * y
        });
        Self { normal, positions: positions.collect() }
    }

    /// The light that stands for it.
    fn light(&self, literal: bool) -> Vsgl {
        let reference = 2.0 / 3.0 * self.normal;
        let (mut places, mut lobes) = (moments_empty(), moments_empty());
        for position in &self.positions {
            places = moments_merge(places, moments_of_position(*position, 1.0, Vec3::Z));
            lobes = moments_merge(lobes, moments_of_lobe(self.normal, 2.0, 1.0, reference));
        }
        let make = if literal { vsgl_from_moments_paper } else { vsgl_from_moments };
        make(places, Vec3::Z, lobes, reference)
    }

    /// What the VPLs make the origin reflect by `lobe`, which includes the receiver's cosine.
    fn sum(&self, lobe: impl Fn(Vec3) -> f32) -> f64 {
        let each = self.positions.iter().map(|position| {
            let (d, dir) = (position.length(), position.normalize());
            // A cosine emitter: 1/π in power/sr along the normal.
            let emitter = std::f32::consts::FRAC_1_PI;
            let transfer = vpl_transfer(1.0, lobe(dir), emitter, 1.0, -dir.dot(self.normal));
            f64::from(vpl_radiance(transfer, d))
        });
        each.sum()
    }
}

/// Ratios of the light's to the VPLs' radiance: paper's diffuse, clamped cosine, specular.
fn ratios(radius: f32, literal: bool) -> [f64; 3] {
    let disk = Disk::new(radius);
    let light = disk.light(literal);
    let (origin, z) = (Vec3::ZERO, Vec3::Z);
    let cosine = |dir: Vec3| dir.z.max(0.0) * std::f32::consts::FRAC_1_PI;
    // Straight up, a lobe of alpha 0.3: bandwidth 1/(4 alpha²) both ways.
    let glossy = |dir: Vec3| dir.z.max(0.0) * (-(dir.x * dir.x + dir.y * dir.y) / 0.36).exp();
    let (diffuse, specular) = (disk.sum(cosine), disk.sum(glossy));
    [
        f64::from(vsgl_diffuse_paper(light, origin, z, 1.0)) / diffuse,
        f64::from(vsgl_diffuse(light, origin, z, 1.0)) / diffuse,
        f64::from(vsgl_specular(light, origin, z, z, 0.3, 1.0)) / specular,
    ]
}

#[test]
fn one_light_stands_for_4096_vpls() {
    // Radius over distance; ratios with half the trace for the variance, and with the trace as printed.
    let table = [
        (0.01, [0.973, 0.973, 0.973], [0.973, 0.973, 0.973]),
        (0.1, [0.972, 0.975, 0.977], [0.964, 0.968, 0.960]),
        (0.3, [0.965, 0.985, 1.004], [0.896, 0.930, 0.879]),
        (1.0, [0.957, 1.067, 1.227], [0.643, 0.731, 0.739]),
        (3.0, [1.003, 1.152, 1.428], [0.529, 0.607, 0.730]),
    ];
    for (radius, half, literal) in table {
        for (found, wanted) in [(ratios(radius, false), half), (ratios(radius, true), literal)] {
            for (f, w) in found.iter().zip(wanted) {
                assert!((f - w).abs() < 2e-3, "radius {radius}: {found:.4?} instead of {wanted:?}");
            }
        }
    }
}
