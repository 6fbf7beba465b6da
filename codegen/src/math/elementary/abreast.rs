//! Several numbers side by side, a step of a formula at a time.
//!
//! A formula is a chain in which each operation waits for the one before. A processor fills the waits with other numbers'
//! operations, if they come close enough behind: in code for one number after the other the next one's are a whole formula
//! away, in code for several abreast they are next.

/// A function of each number. A loop, since `[T; K]::map` is not always inlined.
#[inline(always)]
pub(super) fn each<const K: usize>(mut a: [f32; K], f: impl Fn(f32) -> f32) -> [f32; K] {
    for x in &mut a {
        *x = f(*x);
    }
    a
}

/// A function of two numbers, of each pair.
#[inline(always)]
pub(super) fn pairs<const K: usize>(mut a: [f32; K], b: [f32; K], f: impl Fn(f32, f32) -> f32) -> [f32; K] {
    for (x, y) in a.iter_mut().zip(b) {
        *x = f(*x, y);
    }
    a
}

/// `c[0] + c[1] x + ..` of each number, from the highest power down.
#[inline(always)]
pub(super) fn polynomial<const K: usize, const N: usize>(x: [f32; K], c: [f32; N]) -> [f32; K] {
    let mut sum = [c[N - 1]; K];
    let mut at = N - 1;
    while at > 0 {
        at -= 1;
        sum = pairs(sum, x, |sum, x| sum * x + c[at]);
    }
    sum
}
