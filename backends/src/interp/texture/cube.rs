//! Faces of cubes: which one a direction meets, and what lies past its edges.

/// A place on a face: coordinates from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct OnFace {
    pub(super) face: u32,
    pub(super) place: [f32; 2],
}

/// The face along which a direction is longest, z before y before x where two are as long.
fn face(direction: [f64; 3]) -> u32 {
    let [x, y, z] = direction.map(f64::abs);
    let axis = if z >= x && z >= y {
        2
    } else if y >= x {
        1
    } else {
        0
    };
    axis * 2 + u32::from(direction[axis as usize] < 0.0)
}

/// A vector in the frame of a face: to the right, down, and outwards.
fn turn<T: Copy + std::ops::Neg<Output = T>>(face: u32, [x, y, z]: [T; 3]) -> [T; 3] {
    match face {
        0 => [-z, -y, x],
        1 => [z, -y, -x],
        2 => [x, z, y],
        3 => [x, -z, -y],
        4 => [x, -y, z],
        _ => [-x, -y, -z],
    }
}

/// And back.
fn turn_back(face: u32, [right, down, out]: [i64; 3]) -> [i64; 3] {
    match face {
        0 => [out, -down, -right],
        1 => [-out, -down, right],
        2 => [right, out, down],
        3 => [right, -out, -down],
        4 => [right, -down, out],
        _ => [-right, -down, -out],
    }
}

/// Where a direction meets the cube.
pub(super) fn meet(direction: [f32; 3]) -> OnFace {
    let face = face(direction.map(f64::from));
    let [right, down, out] = turn(face, direction);
    OnFace { face, place: [right, down].map(|n| 0.5 * (n / out.abs()) + 0.5) }
}

/// How the place on a face changes where the direction changes by `change`.
pub(super) fn slope(direction: [f32; 3], change: [f32; 3]) -> [f64; 2] {
    let wide = direction.map(f64::from);
    let face = face(wide);
    let ([right, down, out], [by_right, by_down, by_out]) =
        (turn(face, wide), turn(face, change.map(f64::from)));
    [(right, by_right), (down, by_down)].map(|(n, by)| 0.5 * (by * out - n * by_out) / (out * out))
}

/// The texel at a place on a face that may be one past an edge; `None` past a corner, where there is none.
pub(super) fn neighbour(face_of: u32, place: [i64; 2], size: u32) -> Option<(u32, [u32; 2])> {
    let size = i64::from(size);
    let outside = place.map(|n| n < 0 || n >= size);
    if outside == [false; 2] {
        return Some((face_of, place.map(|n| n as u32)));
    }
    if outside == [true; 2] {
        return None;
    }
    // Twice the distance of the texel's centre from the face's, in texels; seen from the cube's centre it lies
    // beyond the edge, within the texel of the next face that touches it.
    let [right, down] = place.map(|n| 2 * n + 1 - size);
    let direction = turn_back(face_of, [right, down, size]);
    let next = face(direction.map(|n| n as f64));
    let [right, down, out] = turn(next, direction);
    let texel = |n: i64| ((n + out) * size).div_euclid(2 * out).clamp(0, size - 1) as u32;
    Some((next, [texel(right), texel(down)]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_meet_the_middles_of_their_faces() {
        for face in 0..6 {
            let mut direction = [0.0; 3];
            direction[face as usize / 2] = if face % 2 == 0 { 3.0 } else { -3.0 };
            assert_eq!(meet(direction), OnFace { face, place: [0.5, 0.5] });
        }
        assert_eq!(meet([1.0, 0.5, -0.5]), OnFace { face: 0, place: [0.75, 0.25] });
        assert_eq!(meet([1.0, 1.0, 1.0]).face, 4);
    }

    #[test]
    fn neighbours_of_neighbours_are_at_home() {
        for size in [1, 2, 5] {
            let last = i64::from(size) - 1;
            for face in 0..6 {
                for along in 0..=last {
                    for (out, home) in [
                        ([-1, along], [0, along]),
                        ([last + 1, along], [last, along]),
                        ([along, -1], [along, 0]),
                        ([along, last + 1], [along, last]),
                    ] {
                        let (next, there) = neighbour(face, out, size).expect("no corner");
                        assert_ne!(next, face);
                        // One of the four steps from there leads back.
                        let there = there.map(i64::from);
                        let steps = [[-1, 0], [1, 0], [0, -1], [0, 1]];
                        let back = steps
                            .iter()
                            .filter_map(|[x, y]| neighbour(next, [there[0] + x, there[1] + y], size));
                        assert!(
                            back.into_iter().any(|found| found == (face, home.map(|n| n as u32))),
                            "{face} {out:?} of {size}"
                        );
                    }
                }
            }
        }
        assert_eq!(neighbour(0, [-1, -1], 4), None);
    }

    #[test]
    fn slopes_are_difference_quotients() {
        let (direction, change) = ([0.3f32, -0.2, 0.9], [0.5f32, 0.25, -0.125]);
        let step = 1e-3;
        let moved = std::array::from_fn(|axis| direction[axis] + step * change[axis]);
        let (from, to) = (meet(direction), meet(moved));
        let slope = slope(direction, change);
        for (axis, slope) in slope.into_iter().enumerate() {
            let quotient = f64::from((to.place[axis] - from.place[axis]) / step);
            assert!((quotient - slope).abs() < 2e-3, "{quotient} {slope}");
        }
    }
}
