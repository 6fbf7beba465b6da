//! What the reference draws its samples from: surfaces, what each light lights of them, and how often each is drawn.

use lobe_codegen::glam::{DMat2, DVec2, DVec3, Vec2};
use lobe_kernels::brdf::Material;
use lobe_kernels::rect::Rectangle;
use lobe_kernels::reference::reflector::Reflector;
use lobe_kernels::reference::running_mean::luminance;
use lobe_kernels::scene::Surface;
use lobe_kernels::scene::light::{SceneLight, light_at};

/// Share of the samples that all reflectors have alike; the others go by what is reflected.
const ALIKE: f64 = 0.5;
/// By how much what a cone lights is taken larger, over its own size: more than rounding moves its edge.
const MARGIN: f64 = 1e-4;

/// The reflectors of a scene; at least one.
pub(super) fn reflectors(
    surfaces: &[Surface],
    materials: &[Material],
    lights: &[SceneLight],
) -> Vec<Reflector> {
    let lit = (0_u32..).zip(surfaces).flat_map(|(surface, of)| {
        let of_light = move |(light, source)| {
            let (low, high) = lit_part(source, &of.rectangle)?;
            Some(Reflector { low, high, surface, light, stand_in: 0, keep: 1.0, share: 1.0 })
        };
        (0_u32..).zip(lights).filter_map(of_light)
    });
    let mut found: Vec<Reflector> = lit.collect();
    if found.is_empty() {
        found.push(Reflector {
            low: Vec2::NEG_ONE,
            high: Vec2::ONE,
            surface: 0,
            light: 0,
            stand_in: 0,
            keep: 1.0,
            share: 1.0,
        });
    }
    let powers: Vec<f64> = found
        .iter()
        .map(|r| {
            let surface = &surfaces[r.surface as usize];
            power(r, surface, &materials[surface.material as usize], &lights[r.light as usize])
        })
        .collect();
    share_out(&mut found, &powers);
    found
}

/// What is reflected, up to a factor: of what arrives in the middle of what is lit.
fn power(reflector: &Reflector, surface: &Surface, material: &Material, light: &SceneLight) -> f64 {
    let part = lobe_kernels::reference::reflector::lit_part(surface.rectangle, reflector.low, reflector.high);
    let arriving = light_at(*light, part.position);
    let irradiance = luminance(arriving.irradiance) * part.normal.dot(arriving.dir).max(0.0);
    let reflectance = luminance(material.diffuse_albedo + material.f0);
    f64::from(irradiance * reflectance) * f64::from(part.half_x) * f64::from(part.half_y)
}

/// Shares by `powers`, and the table to draw by them (`Vose91`).
fn share_out(reflectors: &mut [Reflector], powers: &[f64]) {
    let count = reflectors.len() as f64;
    let whole: f64 = powers.iter().sum();
    let by_power = if whole > 0.0 && whole.is_finite() { 1.0 - ALIKE } else { 0.0 };
    let share = |power: f64| (1.0 - by_power) / count + by_power * power / whole.max(f64::MIN_POSITIVE);
    let mut left: Vec<f64> = powers.iter().map(|power| share(*power) * count).collect();
    for (reflector, left) in reflectors.iter_mut().zip(&left) {
        reflector.share = (left / count) as f32;
    }
    let (mut small, mut large): (Vec<usize>, Vec<usize>) = (0..left.len()).partition(|i| left[*i] < 1.0);
    while let (Some(less), Some(more)) = (small.pop(), large.pop()) {
        reflectors[less].keep = left[less] as f32;
        reflectors[less].stand_in = more as u32;
        left[more] -= 1.0 - left[less];
        if left[more] < 1.0 { small.push(more) } else { large.push(more) }
    }
}

/// What of a rectangle a light can shine on, in half extents from its middle; none if it is behind or beside it.
fn lit_part(light: &SceneLight, rectangle: &Rectangle) -> Option<(Vec2, Vec2)> {
    let towards = if light.is_spot == 1 { light.position - rectangle.position } else { light.axis };
    if rectangle.normal.dot(towards) <= 0.0 {
        return None;
    }
    let whole = (Vec2::NEG_ONE, Vec2::ONE);
    if light.is_spot == 0 { Some(whole) } else { within(cone_on_plane(light, rectangle)) }
}

/// The part of the square of -1 to 1 that a box has; none if it is beside it.
fn within(area: Option<(DVec2, DVec2)>) -> Option<(Vec2, Vec2)> {
    let Some((middle, half)) = area else {
        return Some((Vec2::NEG_ONE, Vec2::ONE));
    };
    let low = (middle - half).max(DVec2::NEG_ONE);
    let high = (middle + half).min(DVec2::ONE);
    low.cmplt(high).all().then(|| (low.as_vec2(), high.as_vec2()))
}

/// Middle and half extents of the box about the ellipse that a cone cuts out of a rectangle's plane, in the rectangle's half
/// extents from its middle; none where that is no ellipse.
///
/// With `y` from the apex, `(d·y)² - cos² y·y >= 0` is, in coordinates of the plane, `c + 2 b·x - x·M x >= 0`.
fn cone_on_plane(light: &SceneLight, rectangle: &Rectangle) -> Option<(DVec2, DVec2)> {
    let axes = [
        f64::from(rectangle.half_x) * rectangle.tangent.as_dvec3(),
        f64::from(rectangle.half_y) * rectangle.normal.cross(rectangle.tangent).as_dvec3(),
    ];
    let (d, offset) = (light.axis.as_dvec3(), (rectangle.position - light.position).as_dvec3());
    let square = f64::from(light.outer).cos().powi(2);
    let form = |a: DVec3, b: DVec3| d.dot(a) * d.dot(b) - square * a.dot(b);
    let shape = -DMat2::from_cols(
        DVec2::new(form(axes[0], axes[0]), form(axes[0], axes[1])),
        DVec2::new(form(axes[1], axes[0]), form(axes[1], axes[1])),
    );
    let is_ellipse = shape.determinant() > 1e-6 * shape.x_axis.x * shape.y_axis.y && shape.x_axis.x > 0.0;
    if !is_ellipse {
        return None;
    }
    let inverse = shape.inverse();
    let linear = DVec2::new(form(axes[0], offset), form(axes[1], offset));
    let middle = inverse * linear;
    let rest = (form(offset, offset) + linear.dot(middle)).max(0.0);
    let half = DVec2::new((rest * inverse.x_axis.x).sqrt(), (rest * inverse.y_axis.y).sqrt());
    // The other half of the double cone is dark.
    let is_ahead = d.dot(offset + middle.x * axes[0] + middle.y * axes[1]) > 0.0;
    Some((middle, if is_ahead { half * (1.0 + MARGIN) } else { DVec2::ZERO }))
}
