//! Hilbert's curve through the texels of a map.

use lobe_codegen::glam::UVec2;
use lobe_kernels::rsm::chain::MapLevel;
use lobe_kernels::rsm::curve::{curve_bits, curve_place, curve_texel};
use lobe_kernels::scene::NOWHERE;

#[test]
fn each_step_leads_to_a_neighbour_and_all_places_are_met() {
    for bits in 0..7_u32 {
        let side = 1_u32 << bits;
        let mut met = vec![false; (side * side) as usize];
        let mut before: Option<UVec2> = None;
        for step in 0..side * side {
            let place = curve_place(step, bits);
            assert!(place.max_element() < side, "bits {bits}, step {step}: {place}");
            let seen = std::mem::replace(&mut met[(place.y * side + place.x) as usize], true);
            assert!(!seen, "bits {bits}, step {step}: {place} a second time");
            let way = before.map(|before| place.as_ivec2() - before.as_ivec2());
            assert!(way.is_none_or(|way| way.abs().element_sum() == 1), "bits {bits}, step {step}: {way:?}");
            before = Some(place);
        }
    }
}

#[test]
fn each_texel_of_any_map_is_met_once() {
    for (width, height) in [(1, 1), (1, 7), (5, 3), (8, 8), (9, 4), (33, 17)] {
        let map = MapLevel { first: 0, width, height };
        let steps = 1_u32 << (2 * curve_bits(map));
        let mut texels: Vec<u32> =
            (0..steps).map(|step| curve_texel(step, map)).filter(|texel| *texel != NOWHERE).collect();
        texels.sort_unstable();
        assert!(texels.into_iter().eq(0..width * height), "{width} x {height}");
    }
}
