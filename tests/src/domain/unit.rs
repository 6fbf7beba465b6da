//! Vectors of length one, alone and in relation to those drawn before them.
//!
//! What goes wrong with directions goes wrong where they coincide, oppose or are perpendicular, which
//! independent random vectors never are.

use super::rng::Rng;

/// Angles to an earlier vector, in radians, at the edges: from far below f32's resolution of a cosine.
const ANGLES: [f64; 7] = [1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1];

/// How many edge vectors there are when `earlier` others of this dimension have been drawn.
pub(super) fn n_edges(n: usize, earlier: usize) -> usize {
    2 * n + 2 + earlier * relations()
}

fn relations() -> usize {
    3 + 2 * ANGLES.len()
}

/// Edge vector `index`: an axis, a diagonal, or one in a special relation to an earlier vector.
pub(super) fn edge(n: usize, index: usize, earlier: &[&[f32]], rng: &mut Rng) -> Vec<f32> {
    let sign = if index.is_multiple_of(2) { 1.0 } else { -1.0 };
    if index < 2 * n {
        return (0..n).map(|i| if i == index / 2 { sign as f32 } else { 0.0 }).collect();
    }
    if index < 2 * n + 2 {
        return rounded(&vec![sign; n]);
    }
    let index = index - 2 * n - 2;
    let peers: Vec<&[f32]> = earlier.iter().copied().filter(|v| v.len() == n).collect();
    let other = peers[index / relations()];
    match index % relations() {
        0 => other.to_vec(),
        1 => other.iter().map(|c| -c).collect(),
        2 => at_angle(other, std::f64::consts::FRAC_PI_2, rng),
        rest => {
            let angle = ANGLES[(rest - 3) / 2];
            let flip = if rest % 2 == 0 { std::f64::consts::PI } else { 0.0 };
            at_angle(other, flip - angle, rng)
        }
    }
}

/// A random vector: half of the time uniform, else at a log-uniform angle to an earlier one or its
/// opposite.
pub(super) fn random(n: usize, earlier: &[&[f32]], rng: &mut Rng) -> Vec<f32> {
    let peers: Vec<&[f32]> = earlier.iter().copied().filter(|v| v.len() == n).collect();
    if peers.is_empty() || rng.one_in(2) {
        return uniform(n, rng);
    }
    let other = peers[rng.below(peers.len())];
    let angle = std::f64::consts::PI * 10f64.powf(-8.0 * rng.unit());
    let flip = if rng.one_in(2) { std::f64::consts::PI } else { 0.0 };
    at_angle(other, flip - angle, rng)
}

/// A vector at a log-uniform angle to `from`.
pub(super) fn near(from: &[f32], rng: &mut Rng) -> Vec<f32> {
    at_angle(from, std::f64::consts::PI * 10f64.powf(-8.0 * rng.unit()), rng)
}

/// The part of `vector` that is perpendicular to `z`, of length one; something else perpendicular if there is none.
pub(super) fn made_normal_to(z: &[f32], vector: &[f32]) -> Vec<f32> {
    let z = normalised(&z.iter().map(|c| f64::from(*c)).collect::<Vec<_>>());
    let along: f64 = vector.iter().zip(&z).map(|(v, z)| f64::from(*v) * z).sum();
    let aside: Vec<f64> = vector.iter().zip(&z).map(|(v, z)| f64::from(*v) - along * z).collect();
    if aside.iter().map(|c| c * c).sum::<f64>() > 1e-12 {
        return rounded(&aside);
    }
    let axis: &[f32] = if z[0].abs() < 0.5 { &[1.0, 0.0, 0.0] } else { &[0.0, 1.0, 0.0] };
    made_normal_to(&z.iter().map(|c| *c as f32).collect::<Vec<_>>(), axis)
}

/// A random vector perpendicular to `z`.
pub(super) fn normal_to(z: &[f32], rng: &mut Rng) -> Vec<f32> {
    at_angle(z, std::f64::consts::FRAC_PI_2, rng)
}

/// `z x x`, of unit vectors that are perpendicular.
pub(super) fn cross(z: &[f32], x: &[f32]) -> Vec<f32> {
    let product = |i: usize, j: usize| f64::from(z[i]) * f64::from(x[j]) - f64::from(z[j]) * f64::from(x[i]);
    rounded(&[product(1, 2), product(2, 0), product(0, 1)])
}

fn uniform(n: usize, rng: &mut Rng) -> Vec<f32> {
    let vector: Vec<f64> = (0..n).map(|_| rng.normal()).collect();
    rounded(&vector)
}

/// A vector at `angle` to `other`, in a random direction from it.
fn at_angle(other: &[f32], angle: f64, rng: &mut Rng) -> Vec<f32> {
    let other = normalised(&other.iter().map(|c| f64::from(*c)).collect::<Vec<_>>());
    let mut aside: Vec<f64> = other.iter().map(|_| rng.normal()).collect();
    let along: f64 = aside.iter().zip(&other).map(|(a, o)| a * o).sum();
    aside.iter_mut().zip(&other).for_each(|(a, o)| *a -= along * o);
    let aside = normalised(&aside);
    let (sin, cos) = angle.sin_cos();
    rounded(&other.iter().zip(&aside).map(|(o, a)| cos * o + sin * a).collect::<Vec<_>>())
}

/// Of length one in f64.
pub(crate) fn normalised(vector: &[f64]) -> Vec<f64> {
    let length = vector.iter().map(|c| c * c).sum::<f64>().sqrt();
    if length > 0.0 {
        vector.iter().map(|c| c / length).collect()
    } else {
        (0..vector.len()).map(|i| if i == 0 { 1.0 } else { 0.0 }).collect()
    }
}

fn rounded(vector: &[f64]) -> Vec<f32> {
    normalised(vector).into_iter().map(|c| c as f32).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_stand_in_every_relation_to_an_earlier_vector() {
        let mut rng = Rng::new(7, "test");
        let other = uniform(3, &mut rng);
        let opposite: Vec<f32> = other.iter().map(|c| -c).collect();
        let earlier: [&[f32]; 2] = [&[1.0, 0.0], &other];
        let dot =
            |v: &[f32]| -> f64 { v.iter().zip(&other).map(|(a, b)| f64::from(*a) * f64::from(*b)).sum() };
        let mut edges = (0..n_edges(3, 1)).map(|i| edge(3, i, &earlier, &mut rng)).skip(8);
        assert_eq!(edges.next(), Some(other.clone()));
        assert_eq!(edges.next(), Some(opposite));
        assert!(edges.next().is_some_and(|v| dot(&v).abs() < 1e-6));
        let cosines: Vec<f64> = edges.map(|v| dot(&v)).collect();
        assert_eq!(cosines.len(), 2 * ANGLES.len());
        assert_eq!(cosines.iter().filter(|c| **c > 0.99).count(), ANGLES.len());
        assert_eq!(cosines.iter().filter(|c| **c < -0.99).count(), ANGLES.len());
    }

    #[test]
    fn axes_and_diagonals_have_length_one() {
        let mut rng = Rng::new(7, "test");
        for n in 2..=4 {
            for index in 0..n_edges(n, 0) {
                let square: f32 = edge(n, index, &[], &mut rng).iter().map(|c| c * c).sum();
                assert!((square - 1.0).abs() < 1e-6);
            }
        }
    }
}
