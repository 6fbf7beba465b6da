//! Lobes warped to directions of light.

use super::{about, near};
use crate::support::{check, close, direction, unit};
use lobe_codegen::glam::Vec3;
use lobe_kernels::asg::asg_eval;
use lobe_kernels::brdf::lobe::{asg_ndf, asg_ndf_warp, sg_ndf, sg_ndf_warp};
use lobe_kernels::sg::sg_eval;
use proptest::prelude::*;

#[test]
fn warps_have_their_stated_distance_to_the_reflected_distribution() {
    // [alpha, view in degrees, that of the isotropic lobe, that of the anisotropic one]; none: not stated.
    let rows = [
        (0.05_f32, 0.0, Some(0.001), 0.003),
        (0.05, 30.0, Some(0.09), 0.005),
        (0.05, 60.0, Some(0.43), 0.037),
        (0.05, 75.0, Some(0.80), 0.10),
        (0.3, 0.0, None, 0.07),
        (0.3, 30.0, None, 0.07),
        (0.3, 60.0, None, 0.17),
        (0.3, 75.0, None, 0.34),
    ];
    for (alpha, degrees, isotropic, anisotropic) in rows {
        let view = direction(f64::to_radians(degrees).cos(), 0.4);
        let ndf = sg_ndf(Vec3::Z, alpha);
        let truth = |l: Vec3| f64::from(sg_eval((l + view).normalize(), ndf));
        let (sg, asg) = (sg_ndf_warp(Vec3::Z, view, alpha), asg_ndf_warp(Vec3::Z, view, alpha));
        let gap = |lobe: &dyn Fn(Vec3) -> f64| {
            let width = 2.0 * f64::from(alpha);
            about(sg.axis, width, |l| (lobe(l) - truth(l)).abs()) / about(sg.axis, width, truth)
        };
        let found = (gap(&|l| f64::from(sg_eval(l, sg))), gap(&|l| f64::from(asg_eval(l, asg))));
        println!("alpha {alpha}, {degrees}°: {found:?}");
        if let Some(stated) = isotropic {
            near(found.0, stated, 0.05 * stated + 0.006, "isotropic");
        }
        near(found.1, anisotropic, 0.1 * anisotropic + 0.006, "anisotropic");
    }
}

#[test]
fn warps_hold_the_energy_and_are_frames() {
    check((unit(), unit(), 1e-3..=1.0_f32), |(n, v, alpha)| {
        let asg = asg_ndf_warp(n, v, alpha);
        let frame = [asg.x.length(), asg.y.length(), asg.z.length()];
        prop_assert!(frame.iter().all(|l| (l - 1.0).abs() < 3e-6), "{frame:?}");
        let skew = [asg.x.dot(asg.y), asg.y.dot(asg.z), asg.z.dot(asg.x), asg.x.dot(n)];
        prop_assert!(skew.iter().all(|c| c.abs() < 3e-6), "{skew:?}");
        prop_assert!((asg.z - sg_ndf_warp(n, v, alpha).axis).length() < 1e-6);
        let cosine = f64::from(n.dot(v)).abs();
        prop_assume!(cosine > 1e-2);
        // The isotropic lobe's sharpness is twice the geometric mean of the bandwidths.
        let mean = 2.0 * f64::from(asg.lambda).sqrt() * f64::from(asg.mu).sqrt();
        close(sg_ndf_warp(n, v, alpha).sharpness, mean, 1e-4 * mean, "equal energy")?;
        Ok(())
    });
}

#[test]
fn a_view_along_the_normal_gives_an_isotropic_warp() {
    check((unit(), 1e-3..=1.0_f32), |(n, alpha)| {
        let asg = asg_ndf_warp(n, n, alpha);
        prop_assert!((asg.lambda / asg.mu - 1.0).abs() < 2e-6);
        prop_assert!(
            (asg.x.length() - 1.0).abs() < 1e-6 && asg.x.dot(n).abs() < 1e-6 && asg.y.dot(n).abs() < 1e-6
        );
        prop_assert!((asg.z - n).length() < 1e-6);
        let flat = asg_ndf(n, asg.x, alpha, alpha);
        close(flat.lambda, 4.0 * f64::from(asg.mu), 4e-6 * f64::from(flat.lambda), "half angles")?;
        let grazing = asg_ndf_warp(n, asg.x, alpha);
        prop_assert!(grazing.lambda.is_finite() && grazing.x.is_finite());
        Ok(())
    });
}
