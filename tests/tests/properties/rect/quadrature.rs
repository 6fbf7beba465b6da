//! The quadrature of one bounce: against the integral, in another frame of the same rectangle, and far outside of its
//! domain.
//!
//! Each test draws its cases from a seed that it prints; `LOBE_SEED=n` repeats a run.

use crate::support::{check, unit};
use lobe_codegen::prelude::*;
use lobe_kernels::brdf::Material;
use lobe_kernels::rect::Rectangle;
use lobe_kernels::rect::pixel::{RectBounce, RectPixel, rect_pixel_quadrature};
use lobe_kernels::reference::one_bounce::{OneBounce, one_bounce_area_integrand};
use lobe_kernels::scene::light::Arriving;
use lobe_kernels::scene::{NOWHERE, Seen};
use proptest::prelude::*;
use std::sync::Mutex;

/// `exp(mean |ln(radiance/integral)|)`, at most.
const STATED_FACTOR: f64 = 1.03;

/// The same of the light of a diffuse rectangle.
const STATED_MATT_FACTOR: f64 = 1.04;

/// A glossy surface without a diffuse lobe.
fn glossy(alpha: f32, f0: f32) -> Material {
    Material { diffuse_albedo: Vec3::ZERO, f0: Vec3::splat(f0), f90: 1.0, alpha }
}

/// A rectangle in its own frame, a pixel before it that rather faces it, a light and a viewer above the surfaces; distributions are no sharper
/// than `alpha`.
fn scene(alpha: f32) -> impl Strategy<Value = RectBounce> {
    let shape = (-1.3..0.5_f32, -1.3..0.5_f32, alpha..0.6_f32, alpha..0.6_f32, 0.0..1.0_f32);
    let place = (-1.2..1.2_f32, -1.2..1.2_f32, -1.0..0.3_f32);
    (shape, place, unit(), unit(), unit()).prop_map(|((hx, hy, mr, mx, f0), (px, py, pz), light, n, v)| {
        let (half_x, half_y) = (10.0_f32.powf(hx), 10.0_f32.powf(hy));
        let rectangle = Rectangle { position: Vec3::ZERO, normal: Vec3::Z, tangent: Vec3::X, half_x, half_y };
        let position = Vec3::new(px * (half_x + 0.5), py * (half_y + 0.5), 10.0_f32.powf(pz));
        let n = (n - 0.9 * Vec3::Z).normalize_or(-Vec3::Z);
        let seen = Seen {
            position,
            surface: 0,
            normal: n,
            point_index: NOWHERE,
            view: (v + 1.2 * n).normalize_or(n),
        };
        let dir = (light + 1.2 * Vec3::Z).normalize_or(Vec3::Z);
        RectBounce {
            rectangle,
            reflector: glossy(mr, f0),
            arriving: Arriving { dir, dist: 1e30, irradiance: Vec3::ONE },
            seen,
            receiver: glossy(mx, 0.5),
        }
    })
}

/// The radiance, integrated over the rectangle by a fine grid of directions.
fn truth(bounce: &RectBounce) -> f64 {
    let rectangle = bounce.rectangle;
    let one = OneBounce {
        position: bounce.seen.position,
        normal: bounce.seen.normal,
        view: bounce.seen.view,
        material: bounce.receiver,
        rectangle,
        rectangle_material: bounce.reflector,
        light: bounce.arriving.dir,
    };
    let height = bounce.seen.position.z;
    let rows = places(height, bounce.seen.position.y, rectangle.half_y);
    let columns = places(height, bounce.seen.position.x, rectangle.half_x);
    let value = |x: f32, y: f32| f64::from(one_bounce_area_integrand(one, Vec3::new(x, y, 0.0)).x);
    rows.iter().map(|(y, dy)| dy * columns.iter().map(|(x, dx)| dx * value(*x, *y)).sum::<f64>()).sum()
}

/// Places of `-half ..= half` at equal steps of the angle as seen from `height` above `foot`, and what each stands for.
fn places(height: f32, foot: f32, half: f32) -> Vec<(f32, f64)> {
    const COUNT: usize = 160;
    let (height, foot, half) = (f64::from(height), f64::from(foot), f64::from(half));
    let (low, high) = (((-half - foot) / height).atan(), ((half - foot) / height).atan());
    let step = (high - low) / COUNT as f64;
    (0..COUNT)
        .map(|k| {
            let tangent = (low + (k as f64 + 0.5) * step).tan();
            ((foot + height * tangent) as f32, height * (1.0 + tangent * tangent) * step)
        })
        .collect()
}

/// Holds the factor by which `part` of the pixel is off from the integral, over scenes that are lit.
fn hold(scenes: impl Strategy<Value = RectBounce>, part: fn(&RectPixel) -> Vec3, stated: f64) {
    let found = Mutex::new(Vec::new());
    check(scenes, |bounce| {
        let wanted = truth(&bounce);
        if wanted > 1e-3 {
            let value = f64::from(part(&rect_pixel_quadrature(bounce)).x);
            found.lock().expect("no panic").push((value / wanted).ln().abs());
        }
        Ok(())
    });
    let found = found.into_inner().expect("no panic");
    let factor = (found.iter().sum::<f64>() / found.len() as f64).exp();
    println!("{} scenes, off by a factor of {factor:.4}", found.len());
    assert!(found.len() > 30, "only {} scenes are lit", found.len());
    assert!(factor < stated, "off by a factor of {factor}");
}

#[test]
fn the_quadrature_is_as_near_to_the_integral_as_stated() {
    hold(scene(0.1), |pixel| pixel.specular, STATED_FACTOR);
}

#[test]
fn light_of_a_diffuse_rectangle_is_as_near_to_the_integral_as_stated() {
    let matt = Material { diffuse_albedo: Vec3::splat(0.8), f0: Vec3::ZERO, f90: 0.0, alpha: 0.5 };
    let scenes = (scene(0.05), 0.05..1.0_f32).prop_map(move |(mut bounce, alpha)| {
        (bounce.reflector, bounce.receiver.alpha) = (matt, alpha);
        bounce
    });
    hold(scenes, |pixel| pixel.specular_of_diffuse, STATED_MATT_FACTOR);
}

#[test]
fn a_rectangle_has_no_first_side() {
    check(scene(0.1), |bounce| {
        let mut bounce = bounce;
        let rectangle = bounce.rectangle;
        // The pixel's horizon is beyond an edge, as that of surfaces that meet at a right angle.
        bounce.seen.position.x = -rectangle.half_x - 0.1;
        bounce.seen.normal = Vec3::X;
        bounce.seen.view.x = bounce.seen.view.x.abs();
        let turned =
            Rectangle { tangent: Vec3::Y, half_x: rectangle.half_y, half_y: rectangle.half_x, ..rectangle };
        let one = rect_pixel_quadrature(bounce).specular.x;
        let other = rect_pixel_quadrature(RectBounce { rectangle: turned, ..bounce }).specular.x;
        prop_assert!((one - other).abs() <= 1e-3 * one + 1e-9, "{one} and {other}");
        Ok(())
    });
}

#[test]
fn wild_rectangles_give_light() {
    let wild = (-4.0..4.0_f32, -4.0..4.0_f32, -7.0..4.0_f32, 0.0..1.0_f32, 0.0..1.0_f32, 0u32..6);
    check((scene(0.02), wild), |(bounce, (hx, hy, height, mr, mx, pose))| {
        let mut bounce = bounce;
        bounce.rectangle.half_x = 10.0_f32.powf(hx);
        bounce.rectangle.half_y = 10.0_f32.powf(hy);
        bounce.seen.position.z = 10.0_f32.powf(height);
        bounce.reflector.alpha = mr * mr * mr;
        bounce.receiver.alpha = mx * mx * mx;
        bounce.receiver.diffuse_albedo = Vec3::ONE;
        bounce.reflector.diffuse_albedo = Vec3::ONE;
        match pose {
            0 => bounce.seen.normal = Vec3::Z,
            1 => bounce.seen.normal = -Vec3::Z,
            2 => bounce.seen.normal = Vec3::X,
            3 => bounce.seen.view = bounce.seen.normal,
            4 => bounce.arriving.dir = Vec3::Z,
            _ => {}
        }
        let pixel = rect_pixel_quadrature(bounce);
        for light in [pixel.specular, pixel.diffuse, pixel.specular_of_diffuse] {
            prop_assert!(light.is_finite() && light.min_element() >= 0.0, "{bounce:?}: {pixel:?}");
        }
        Ok(())
    });
}
