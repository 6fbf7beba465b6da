//! The shading: symmetries, and what it is worth against the integral.

use super::{level, scene};
use crate::support::{check, close, rotation};
use lobe_codegen::glam::DVec3;
use lobe_codegen::prelude::*;
use lobe_kernels::rect::chain::{rect_shade_light, rect_shade_light_paper};
use lobe_kernels::rect::energy::rect_energy_ggx;
use lobe_kernels::rect::reflection::{DistantLight, rect_reflection};
use lobe_kernels::rect::shade::rect_shade;
use lobe_kernels::rect::{GlossyReceiver, Rectangle};
use proptest::prelude::*;
use std::f64::consts::PI;

#[test]
fn shading_turns_and_grows_with_the_scene() {
    check(
        (scene(), rotation(), -2.0..2.0_f32),
        |((rectangle, alpha, light, receiver, radius), turn, size)| {
            let plain = rect_shade_light(rectangle, alpha, 1.0, light, receiver, radius);
            let size = 2.0_f32.powf(size);
            let turned = Rectangle {
                position: Vec3::new(1.0, -2.0, 3.0),
                normal: turn * rectangle.normal,
                tangent: turn * rectangle.tangent,
                half_x: size * rectangle.half_x,
                half_y: size * rectangle.half_y,
            };
            let light = DistantLight { direction: turn * light.direction, ..light };
            let receiver = GlossyReceiver {
                position: turned.position + size * (turn * receiver.position),
                normal: turn * receiver.normal,
                view: turn * receiver.view,
                ..receiver
            };
            let other = rect_shade_light(turned, alpha, 1.0, light, receiver, size * radius);
            let scale = plain.radiance.max(1e-3 * plain.amplitude);
            prop_assert!(
                (other.radiance - plain.radiance).abs() <= 3e-3 * scale,
                "{} became {}",
                plain.radiance,
                other.radiance
            );
            Ok(())
        },
    );
}

#[test]
fn nothing_shines_from_below() {
    check(scene(), |(rectangle, alpha, light, receiver, radius)| {
        let shade =
            |light, receiver| rect_shade_light(rectangle, alpha, 1.0, light, receiver, radius).radiance;
        let mirrored = |v: Vec3| Vec3::new(v.x, v.y, -v.z);
        let under = DistantLight { direction: mirrored(light.direction), ..light };
        let low = GlossyReceiver { position: mirrored(receiver.position), ..receiver };
        let behind = GlossyReceiver { view: -receiver.normal, ..receiver };
        let away = GlossyReceiver { normal: -receiver.normal, view: -receiver.view, ..receiver };
        prop_assert!(shade(light, receiver) >= 0.0);
        for (light, receiver) in [(under, receiver), (light, low), (light, behind), (light, away)] {
            prop_assert_eq!(shade(light, receiver), 0.0);
        }
        Ok(())
    });
}

#[test]
fn the_printed_form_lacks_the_factor_of_its_light() {
    check(scene(), |(rectangle, alpha, light, receiver, radius)| {
        let right = rect_shade_light(rectangle, alpha, 1.0, light, receiver, radius);
        let printed = rect_shade_light_paper(rectangle, alpha, 1.0, light, receiver, radius);
        let factor = PI * f64::from(alpha * alpha) * f64::from(printed.coverage / right.coverage.max(1e-9));
        if right.coverage > 0.0 {
            close(printed.energy / right.energy, factor, 1e-4 * factor, "energy")?;
        }
        prop_assert!(printed.coverage >= right.coverage);
        Ok(())
    });
}

/// Directions to the light, to the peak, of the normal and to the viewer, for an angle of incidence.
fn leaning(sigma: f64) -> (DVec3, DVec3, DVec3, DVec3) {
    let light = DVec3::new(sigma.sin(), 0.0, sigma.cos());
    let to_peak = DVec3::new(light.x, 0.0, -light.z);
    let normal = (PI / 6.0).cos() * to_peak - 0.5 * DVec3::new(sigma.cos(), 0.0, sigma.sin());
    (light, to_peak, normal, 2.0 * to_peak.dot(normal) * normal - to_peak)
}

/// Equation 3 by quadrature: a GGX rectangle of 4 by 4 around its peak, seen by a position at distance 1 of it whose
/// normal leans 30° from it, and which is looked at in the mirror direction; both BRDFs without their `M`. And
/// equation 13.
fn brute_force(sigma: f64, alpha: f64, own: f64) -> (f64, f64) {
    let (light, to_peak, normal, view) = leaning(sigma);
    let n = 800;
    let (mut shaded, mut energy) = (0.0, 0.0);
    // Cubic spacing: fine near the peak.
    let at = |i: i32| (2.0 * f64::from(i) + 1.0) / f64::from(n) - 1.0;
    let cell = |s: f64| 12.0 * s * s / f64::from(n);
    for i in 0..n {
        for j in 0..n {
            let way = DVec3::new(2.0 * at(i).powi(3), 2.0 * at(j).powi(3), 0.0) + to_peak;
            let dist = way.length();
            let w = way / dist;
            let solid = light.z / dist.powi(3) * cell(at(i)) * cell(at(j));
            let half = (light - w).normalize();
            let below = half.truncate().length_squared() + alpha * alpha * half.z * half.z;
            let from_rectangle = alpha * alpha / (PI * below * below) * light.z;
            let own_half = (w + view).normalize();
            let lobe = (2.0 / (own * own) * (own_half.dot(normal) - 1.0)).exp() / (PI * own * own);
            energy += from_rectangle * solid;
            shaded += from_rectangle * lobe * w.dot(normal).max(0.0) * solid;
        }
    }
    (shaded, energy)
}

#[test]
fn the_shading_is_as_far_from_the_integral_as_stated() {
    // σ in degrees, m of the rectangle, radiance and energy over the integral; the disk has four lobes.
    let stated = [
        (0.01, 0.05, 0.972, 0.868),
        (0.01, 0.1, 1.028, 0.891),
        (0.01, 0.3, 1.386, 1.036),
        (30.0, 0.05, 1.229, 1.107),
        (30.0, 0.1, 1.289, 1.129),
        (30.0, 0.3, 1.566, 1.224),
        (60.0, 0.1, 1.701, 1.549),
        (60.0, 0.3, 1.809, 1.479),
        (75.0, 0.1, 1.129, 1.032),
    ];
    for (sigma, alpha, of_radiance, of_energy) in stated {
        let sigma = f64::to_radians(sigma);
        let (radiance, energy) = brute_force(sigma, alpha, 0.15);
        let (light, to_peak, normal, view) = leaning(sigma);
        let receiver = GlossyReceiver {
            position: -to_peak.as_vec3(),
            normal: normal.as_vec3(),
            view: view.as_vec3(),
            alpha: 0.15,
            reflectance: 1.0,
        };
        let light = DistantLight { direction: light.as_vec3(), irradiance: 1.0 };
        let shade = rect_shade_light(level(2.0, 2.0), alpha as f32, 1.0, light, receiver, 4.0 * alpha as f32);
        let (a, b) = (f64::from(shade.radiance) / radiance, f64::from(shade.energy) / energy);
        assert!((a - of_radiance).abs() < 2e-3, "σ {sigma}, m {alpha}: radiance {a}");
        assert!((b - of_energy).abs() < 2e-3, "σ {sigma}, m {alpha}: energy {b}");
        let fitless =
            rect_energy_ggx(1.0, light.direction.z, light.direction.z, 4.0 * alpha as f32, alpha as f32);
        let c = f64::from(fitless) / energy;
        assert!((0.6..1.2).contains(&c), "σ {sigma}, m {alpha}: energy without a fit {c}");
    }
}

#[test]
fn lights_add() {
    check(scene(), |(rectangle, alpha, light, receiver, radius)| {
        let shade = |e| {
            let reflection =
                rect_reflection(rectangle.normal, alpha, 0.5, DistantLight { irradiance: e, ..light });
            rect_shade(rectangle, reflection, receiver, radius).radiance
        };
        close(shade(3.0), f64::from(shade(1.0) + shade(2.0)), 1e-5 * f64::from(shade(3.0)), "the sum")
    });
}
