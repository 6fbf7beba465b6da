//! Random numbers, means and errors.

use super::NOTHING;
use lobe_codegen::glam::{UVec3, UVec4, Vec3};
use lobe_kernels::reference::random::{pcg_hash, pcg3d, pcg4d, random_pair, uniform_of_bits};
use lobe_kernels::reference::running_mean::{
    luminance, running_mean_add, running_mean_merge, running_mean_standard_error,
};
use lobe_tests::domain::Rng;

#[test]
fn hashes_are_the_published_ones() {
    // Values that several independent implementations pin down.
    for (seed, hash) in [
        (0, 129_708_002),
        (1, 2_831_084_092),
        (42, 1_223_963_391),
        (0xdead_beef, 1_730_779_506),
        (1 << 31, 566_699_590),
        (u32::MAX, 3_861_530_882),
    ] {
        assert_eq!(pcg_hash(seed), hash);
    }
    let three = [
        ([0, 0, 0], [2_611_992_518, 2_833_812_075, 1_058_359_340]),
        ([1, 2, 3], [4_204_755_366, 1_223_881_804, 1_500_469_937]),
        ([100, 200, 300], [222_828_298, 771_223_438, 3_286_403_554]),
    ];
    for (seed, hash) in three {
        assert_eq!(pcg3d(UVec3::from(seed)), UVec3::from(hash));
    }
    let four = [
        ([0, 0, 0, 0], [251_852_841, 760_645_481, 850_445_371, 3_542_436_074]),
        ([1, 2, 3, 4], [908_250_390, 4_044_648_920, 3_775_961_919, 45_698_095]),
    ];
    for (seed, hash) in four {
        assert_eq!(pcg4d(UVec4::from(seed)), UVec4::from(hash));
    }
}

/// The same, in whole numbers modulo 2^32.
#[test]
fn hashes_are_those_of_whole_numbers() {
    const M: u64 = 1 << 32;
    let mut rng = Rng::new(5, "hashes");
    for _ in 0..1000 {
        let seed = rng.bits() as u32;
        let state = (u64::from(seed) * 747_796_405 + 2_891_336_453) % M;
        let word = ((state / (1 << (state / (1 << 28) + 4))) ^ state) * 277_803_737 % M;
        assert_eq!(u64::from(pcg_hash(seed)), (word / (1 << 22)) ^ word);
        let seed = [rng.bits() as u32, rng.bits() as u32, rng.bits() as u32];
        let mut v = seed.map(|s| (u64::from(s) * 1_664_525 + 1_013_904_223) % M);
        for round in 0..2 {
            for (to, a, b) in [(0, 1, 2), (1, 2, 0), (2, 0, 1)] {
                v[to] = (v[to] + v[a] * v[b]) % M;
            }
            if round == 0 {
                v = v.map(|x| x ^ (x / (1 << 16)));
            }
        }
        assert_eq!(pcg3d(UVec3::from(seed)), UVec3::from(v.map(|x| x as u32)));
    }
}

#[test]
fn uniform_numbers_are_below_one_and_evenly_spread() {
    assert_eq!(uniform_of_bits(0), 0.0);
    assert_eq!(f64::from(uniform_of_bits(u32::MAX)), 1.0 - 2f64.powi(-24));
    let (n, cells) = (65_536_u32, 16_usize);
    for dimension in 0..4 {
        let mut counts = vec![0.0_f64; cells * cells];
        for index in 0..n {
            let u = random_pair(3, index, dimension);
            counts[(u.x * cells as f32) as usize * cells + (u.y * cells as f32) as usize] += 1.0;
        }
        let expected = f64::from(n) / counts.len() as f64;
        let chi: f64 = counts.iter().map(|c| (c - expected).powi(2) / expected).sum();
        let off = (chi - counts.len() as f64) / (2.0 * counts.len() as f64).sqrt();
        assert!(off.abs() < 5.0, "dimension {dimension}: {off} standard deviations");
    }
}

#[test]
fn running_means_are_those_of_two_passes() {
    let mut rng = Rng::new(9, "running mean");
    // Little noise on a large mean, where sums of squares cancel.
    let numbers: Vec<f32> = (0..5000).map(|_| (1000.0 + 0.5 * rng.normal()) as f32).collect();
    let mean = numbers.iter().map(|x| f64::from(*x)).sum::<f64>() / numbers.len() as f64;
    let squares: f64 = numbers.iter().map(|x| (f64::from(*x) - mean).powi(2)).sum();
    let n = numbers.len() as f64;
    let error = (squares / n / (n - 1.0)).sqrt();
    let whole = numbers.iter().fold(NOTHING, |m, x| running_mean_add(m, *x));
    let parts = numbers.chunks(700).map(|c| c.iter().fold(NOTHING, |m, x| running_mean_add(m, *x)));
    let merged = parts.fold(NOTHING, running_mean_merge);
    for (name, found) in [("added", whole), ("merged", merged)] {
        assert_eq!(found.count, 5000, "{name}");
        assert!(
            (f64::from(found.mean) - mean).abs() < 6e-8 * n.sqrt() * mean + 1e-4,
            "{name}: {} against {mean}",
            found.mean
        );
        let gap = f64::from(running_mean_standard_error(found)) / error - 1.0;
        assert!(gap.abs() < 2e-3, "{name}: {gap}");
    }
    assert_eq!(running_mean_standard_error(NOTHING), 0.0);
    assert_eq!(running_mean_standard_error(running_mean_add(NOTHING, 3.0)), 0.0);
    assert!((luminance(Vec3::ONE) - 1.0).abs() < 1e-6);
}
