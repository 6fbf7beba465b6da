//! Imperfect shadow maps: points that are spread, places in a map, and what hides what.

use crate::support::{check, close, unit};
use lobe_codegen::glam::{Vec2, Vec3};
use lobe_kernels::brdf::sampling::{frame_to_world, orthonormal_frame};
use lobe_kernels::rsm::imperfect::blocker::{Blocker, spread_triple, triangle_point};
use lobe_kernels::rsm::imperfect::fill::{NO_DEPTH, coded_depth, nearer_depth};
use lobe_kernels::rsm::imperfect::lookup::is_between;
use lobe_kernels::rsm::imperfect::splat::{map_texel, parabolic, splat_level};
use lobe_kernels::scene::NOWHERE;
use proptest::prelude::*;

#[test]
fn every_run_of_the_sequence_is_spread() {
    check((any::<u32>(), 64_u32..2048), |(first, count)| {
        let run = || (0..count).map(|k| spread_triple(first.wrapping_add(k)));
        for axis in 0..3 {
            let below = |bar: f32| run().filter(|u| u[axis] < bar).count() as f64;
            for bar in [0.1, 0.25, 0.5, 0.9] {
                // By chance a standard deviation is up to half the root of the count.
                close(below(bar) as f32, f64::from(bar) * f64::from(count), 16.0, "numbers below")?;
            }
        }
        Ok(())
    });
}

#[test]
fn points_are_in_their_triangle() {
    check((0.0..1.0_f32, 0.0..1.0_f32), |(x, y)| {
        let p = triangle_point(Vec3::ZERO, Vec3::X, Vec3::Y, Vec2::new(x, y));
        prop_assert!(p.min_element() >= 0.0 && p.x + p.y <= 1.0 + 1e-6, "{p}");
        Ok(())
    });
}

/// The direction at a place of a map.
fn direction(normal: Vec3, place: Vec2) -> Vec3 {
    let square = place.length_squared();
    let local = Vec3::new(2.0 * place.x, 2.0 * place.y, 1.0 - square) / (1.0 + square);
    frame_to_world(orthonormal_frame(normal), local)
}

#[test]
fn a_place_is_that_of_its_direction() {
    check((unit(), -1.0..1.0_f32, -1.0..1.0_f32), |(normal, x, y)| {
        let place = Vec2::new(x, y);
        let found = parabolic(normal, direction(normal, place));
        close(found.distance(place), 0.0, 2e-6, "place")?;
        let texel = map_texel(place, 8);
        prop_assert_eq!((texel % 8, texel / 8), ((4.0 * (x + 1.0)) as u32, (4.0 * (y + 1.0)) as u32));
        Ok(())
    });
}

#[test]
fn what_is_beyond_the_map_has_no_texel() {
    check((1.0..30.0_f32, -1.0..1.0_f32, any::<bool>()), |(far, near, is_across)| {
        let place = if is_across { Vec2::new(-far, near) } else { Vec2::new(near, far) };
        prop_assert_eq!(map_texel(place, 16), NOWHERE);
        Ok(())
    });
}

fn blocker(position: Vec3, normal: Vec3) -> Blocker {
    Blocker { position, area: 1.0, normal, shape: 0 }
}

/// Whether a point hides a light from a pixel of a surface with `normal`.
fn hides(point: (Vec3, Vec3), light: Vec3, pixel: (Vec3, Vec3)) -> bool {
    is_between(blocker(point.0, point.1), light, pixel.0, pixel.1, light.distance(pixel.0))
}

#[test]
fn nothing_convex_hides_itself() {
    check((unit(), unit(), unit(), 0.0..10.0_f32), |(at, other, light, far)| {
        // On a sphere lit from outside, within one lit from inside, and on a plane.
        prop_assert!(!hides((other, other), (1.0 + far) * light, (at, at)));
        prop_assert!(!hides((other, -other), 0.1 * far.min(9.0) * light, (at, -at)));
        let flat = |v: Vec3| v - at * v.dot(at);
        prop_assert!(!hides((flat(other), at), light + 2.0 * at, (flat(light), at)));
        Ok(())
    });
}

#[test]
fn a_screen_hides_from_both_sides() {
    check((unit(), 0.01..0.99_f32, any::<bool>()), |(normal, share, is_turned)| {
        // A light over a floor, and a screen between.
        let light = 2.0 * normal;
        let facing = if is_turned { -normal } else { normal };
        prop_assert!(hides((share * light, facing), light, (Vec3::ZERO, normal)));
        prop_assert!(!hides((-share * light, facing), light, (Vec3::ZERO, normal)), "behind the floor");
        prop_assert!(
            !hides(((1.0 + share) * light, facing), light, (Vec3::ZERO, normal)),
            "behind the light"
        );
        Ok(())
    });
}

#[test]
fn a_point_is_as_large_as_its_level() {
    check((0.0..1.0_f32, -1.0..1.0_f32, -1.0..1.0_f32, 0_u32..8), |(share, x, y, log)| {
        let (place, side) = (Vec2::new(x, y), 1 << log);
        // A square in the map, from a tenth of a texel to eight times the map.
        let width = 0.2 / side as f32 * 160.0_f32.powf(share) * (side as f32).powf(share);
        let stretch = 2.0 / (1.0 + place.length_squared());
        let level = splat_level((width * stretch).powi(2), place, side);
        let ratio = width / (2.0 / side as f32 * 2.0_f32.powi(level as i32));
        prop_assert!(level <= log);
        prop_assert!(level == 0 || ratio > 0.7, "{ratio} of a square of level {level}");
        prop_assert!(level == log || ratio < 1.42, "{ratio} of a square of level {level}");
        Ok(())
    });
}

#[test]
fn codes_are_of_depths() {
    check((0.1..10.0_f32, 1.0..9.0_f32, any::<u16>()), |(near, far, at)| {
        let of = |depth: f32, at: u16| coded_depth(NOWHERE - depth.to_bits(), u32::from(at) + 1);
        let (found, nothing) = (of(near, at), coded_depth(0, 0));
        prop_assert_eq!((found.depth, found.blocker), (near, u32::from(at)));
        prop_assert_eq!((nothing.depth, nothing.blocker), (NO_DEPTH, NOWHERE));
        for other in [of(near * far, 7), of(near, 7), nothing] {
            prop_assert_eq!(nearer_depth(found, other).blocker, u32::from(at));
        }
        prop_assert_eq!(nearer_depth(nothing, found).depth, near);
        Ok(())
    });
}
