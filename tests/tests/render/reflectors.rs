//! What the reference draws its samples from: all that is lit is in it, and it is drawn as often as it says.

use crate::scene;
use lobe_codegen::glam::{Vec2, Vec3};
use lobe_kernels::reference::rectangle::rectangle_point;
use lobe_kernels::reference::reflector::{Reflector, chosen, lit_part, mirroring_place, reflector_drawn};
use lobe_kernels::scene::light::light_at;
use lobe_tests::domain::Rng;
use lobe_tests::proxies::{Options, proxies};
use lobe_tests::render::Uploaded;
use lobe_tests::scene::{Light, Scene};

const SEED: u64 = 0x5eed_0007;

/// What is uploaded of a box with spots of all widths, some of them in or behind walls.
fn uploaded(rng: &mut Rng) -> Uploaded {
    let mut scene: Scene = scene("cornell_L0.json");
    scene.lights = (0..6).map(|_| spot(rng)).collect();
    let proxies = proxies(&scene, &Options::default()).unwrap_or_else(|e| panic!("{e}"));
    Uploaded::new(&scene, &proxies)
}

fn spot(rng: &mut Rng) -> Light {
    let mut number = |size: f32| (2.0 * rng.unit() - 1.0) as f32 * size;
    let position = Vec3::new(number(1.5), number(1.5), number(1.5));
    let axis = Vec3::new(number(1.0), number(1.0), number(1.0)).normalize_or(Vec3::Y);
    let outer = 0.05 + number(0.5).abs() * 3.0;
    Light::Spot { position, axis, inner: 0.5 * outer, outer, intensity: Vec3::splat(3.0) }
}

/// What is lit of a surface by a light.
fn pair(reflectors: &[Reflector], surface: u32, light: u32) -> Option<&Reflector> {
    reflectors.iter().find(|r| r.surface == surface && r.light == light)
}

#[test]
fn nothing_that_is_lit_is_left_out() {
    let mut rng = Rng::new(SEED, "lit parts");
    for _ in 0..50 {
        let uploaded = uploaded(&mut rng);
        let surfaces = (0_u32..).zip(&uploaded.surfaces);
        let lights = &uploaded.lights;
        for ((surface, of), (light, source)) in surfaces.flat_map(|s| (0..).zip(lights).map(move |l| (s, l)))
        {
            let pair = pair(&uploaded.reflectors, surface, light);
            for _ in 0..50 {
                let u = Vec2::new(rng.unit() as f32, rng.unit() as f32);
                let place = 2.0 * u - 1.0;
                let arriving = light_at(*source, rectangle_point(of.rectangle, u));
                let is_lit = arriving.irradiance.x > 0.0 && arriving.dir.dot(of.rectangle.normal) > 0.0;
                let is_in = pair.is_some_and(|r| place.cmpge(r.low).all() && place.cmple(r.high).all());
                assert!(is_in || !is_lit, "seed {SEED:x}: {place} of {of:?} by {source:?}");
            }
        }
    }
}

/// Of the box about an ellipse that lies on its surface as a whole, π/4 are lit.
#[test]
fn little_is_taken_for_lit_that_is_dark() {
    let mut rng = Rng::new(SEED, "dark parts");
    let (mut lit, mut all) = (0, 0);
    for _ in 0..50 {
        let uploaded = uploaded(&mut rng);
        let is_inside = |r: &&Reflector| r.low.min_element() > -1.0 && r.high.max_element() < 1.0;
        for reflector in uploaded.reflectors.iter().filter(is_inside) {
            let rectangle = uploaded.surfaces[reflector.surface as usize].rectangle;
            let part = lit_part(rectangle, reflector.low, reflector.high);
            for _ in 0..50 {
                let place = rectangle_point(part, Vec2::new(rng.unit() as f32, rng.unit() as f32));
                let arriving = light_at(uploaded.lights[reflector.light as usize], place);
                lit += u32::from(arriving.irradiance.x > 0.0);
                all += 1;
            }
        }
    }
    let share = f64::from(lit) / f64::from(all);
    assert!(all >= 500, "seed {SEED:x}: {all} places are few");
    assert!((share - 0.785).abs() < 0.05, "seed {SEED:x}: {share} of {all} places are lit");
}

#[test]
fn reflectors_are_drawn_as_often_as_they_say() {
    let mut rng = Rng::new(SEED, "shares");
    for _ in 0..50 {
        let reflectors = uploaded(&mut rng).reflectors;
        let mut drawn = vec![0.0; reflectors.len()];
        for (met, reflector) in (0_u32..).zip(&reflectors) {
            drawn[reflector_drawn(*reflector, met, 0.0) as usize] += f64::from(reflector.keep);
            drawn[reflector.stand_in as usize] += 1.0 - f64::from(reflector.keep);
        }
        for (drawn, reflector) in drawn.iter().zip(&reflectors) {
            let wanted = f64::from(reflector.share) * reflectors.len() as f64;
            assert!(
                (drawn - wanted).abs() < 1e-5 * reflectors.len() as f64,
                "seed {SEED:x}: {drawn} {wanted}"
            );
        }
        let whole: f64 = reflectors.iter().map(|r| f64::from(r.share)).sum();
        assert!((whole - 1.0).abs() < 1e-5, "seed {SEED:x}: shares add up to {whole}");
        assert_eq!(chosen(0.999_999_94, reflectors.len() as u32), reflectors.len() as u32 - 1);
    }
}

/// The way over the place is the shortest from the light to the position by the rectangle, or ends at its side.
#[test]
fn light_is_mirrored_where_its_way_is_shortest() {
    let mut rng = Rng::new(SEED, "mirroring");
    for _ in 0..50 {
        let uploaded = uploaded(&mut rng);
        for reflector in &uploaded.reflectors {
            let light = uploaded.lights[reflector.light as usize];
            let surface = uploaded.surfaces[reflector.surface as usize];
            let part = lit_part(surface.rectangle, reflector.low, reflector.high);
            let height = 0.2 + rng.unit() as f32;
            let position =
                rectangle_point(part, Vec2::new(rng.unit() as f32, rng.unit() as f32)) + height * part.normal;
            let way = |place: Vec3| place.distance(position) + place.distance(light.position);
            let found = mirroring_place(part, light, position);
            let is_inside = {
                let offset = found - part.position;
                let across = part.normal.cross(part.tangent);
                offset.dot(part.tangent).abs() < 0.999 * part.half_x
                    && offset.dot(across).abs() < 0.999 * part.half_y
            };
            let other = rectangle_point(part, Vec2::new(rng.unit() as f32, rng.unit() as f32));
            assert!(
                !is_inside || way(found) <= way(other) + 1e-5,
                "seed {SEED:x}: {found} {other} of {part:?}"
            );
        }
    }
}
