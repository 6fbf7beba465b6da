//! What the lanes of a subgroup exchange: plain functions of the lanes' values.
//!
//! Lanes that are not active take no part. Sums and products go from the lowest lane to the highest, each step rounded;
//! drivers may take another order. A value that is gathered from a lane that is not active, or not there, is zero.

use super::program::Scalar;
use super::program::subgroup::{Gather, SubgroupOp};
use half::f16;
use naga::{CollectiveOperation, SubgroupOperation};

/// What an active lane brings; of one that is not, `None`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Brought {
    /// The bits of its value.
    pub(crate) value: u64,
    /// The number that makes a lane, of a gathering.
    pub(crate) index: u64,
}

/// The results of the lanes of one subgroup; those of lanes that are not active do not matter.
pub(crate) fn exchange(op: SubgroupOp, scalar: Scalar, lanes: &[Option<Brought>]) -> Vec<u64> {
    match op {
        SubgroupOp::Ballot(word) => {
            let words = lanes.iter().skip(32 * word as usize).take(32).enumerate();
            let bit =
                |(at, lane): (usize, &Option<Brought>)| u64::from(lane.is_some_and(|l| l.value != 0)) << at;
            vec![words.map(bit).sum(); lanes.len()]
        }
        SubgroupOp::Gather(gather) => {
            let value = |from: usize| lanes[from].map_or(0, |brought| brought.value);
            (0..lanes.len()).map(|at| partner(gather, at, lanes).map_or(0, value)).collect()
        }
        SubgroupOp::Collect(op, how) => collect(op, how, scalar, lanes),
    }
}

/// The active lane that lane `at` gathers from, if there is one.
pub(crate) fn partner(gather: Gather, at: usize, lanes: &[Option<Brought>]) -> Option<usize> {
    let index = lanes[at].map_or(0, |lane| lane.index);
    let from = source(gather, at as u64, index, lanes).and_then(|from| usize::try_from(from).ok())?;
    lanes.get(from).is_some_and(Option::is_some).then_some(from)
}

/// The lane that lane `at` gathers from.
fn source(gather: Gather, at: u64, index: u64, lanes: &[Option<Brought>]) -> Option<u64> {
    let four = at & !3;
    match gather {
        Gather::First => lanes.iter().position(Option::is_some).map(|first| first as u64),
        Gather::Lane => Some(index),
        Gather::Down => at.checked_add(index),
        Gather::Up => at.checked_sub(index),
        Gather::Xor => Some(at ^ index),
        Gather::Quad => (index < 4).then_some(four + index),
        Gather::QuadSwap(bits) => Some(at ^ u64::from(bits)),
    }
}

fn collect(
    op: SubgroupOperation,
    how: CollectiveOperation,
    scalar: Scalar,
    lanes: &[Option<Brought>],
) -> Vec<u64> {
    let mut so_far = None;
    let mut out = Vec::with_capacity(lanes.len());
    for lane in lanes {
        let before = so_far;
        if let Some(Brought { value, .. }) = *lane {
            so_far = Some(before.map_or(value, |sum| combine(op, scalar, sum, value)));
        }
        out.push(match how {
            CollectiveOperation::ExclusiveScan => before.unwrap_or_else(|| neutral(op, scalar)),
            CollectiveOperation::InclusiveScan | CollectiveOperation::Reduce => so_far.unwrap_or(0),
        });
    }
    if how == CollectiveOperation::Reduce {
        out.fill(so_far.unwrap_or(0));
    }
    out
}

/// What an exclusive scan begins with; only sums and products have one.
fn neutral(op: SubgroupOperation, scalar: Scalar) -> u64 {
    match (op, scalar) {
        (SubgroupOperation::Mul, Scalar::F64) => 1f64.to_bits(),
        (SubgroupOperation::Mul, scalar) if scalar.float() => 1f32.to_bits().into(),
        (SubgroupOperation::Mul, _) => 1,
        (_, _) => 0,
    }
}

fn combine(op: SubgroupOperation, scalar: Scalar, a: u64, b: u64) -> u64 {
    use SubgroupOperation as S;
    let (wide, signed) = (scalar.wide(), scalar.signed());
    match (op, scalar) {
        (S::All | S::And, _) => a & b,
        (S::Any | S::Or, _) => a | b,
        (S::Xor, _) => a ^ b,
        (op, Scalar::F64) => {
            arithmetic(op, f64::from_bits(a), f64::from_bits(b), f64::min, f64::max).to_bits()
        }
        (op, scalar) if scalar.float() => {
            let [a, b] = [a, b].map(|bits| f32::from_bits(bits as u32));
            let number = arithmetic(op, a, b, f32::min, f32::max);
            let rounded = if scalar == Scalar::F16 { f16::from_f32(number).to_f32() } else { number };
            rounded.to_bits().into()
        }
        (S::Min, _) if signed => narrow(number(a, wide).min(number(b, wide)) as u64, wide),
        (S::Max, _) if signed => narrow(number(a, wide).max(number(b, wide)) as u64, wide),
        (S::Min, _) => a.min(b),
        (S::Max, _) => a.max(b),
        (S::Add, _) => narrow(a.wrapping_add(b), wide),
        (S::Mul, _) => narrow(a.wrapping_mul(b), wide),
    }
}

fn narrow(bits: u64, wide: bool) -> u64 {
    if wide { bits } else { bits & u64::from(u32::MAX) }
}

/// A signed integer.
fn number(bits: u64, wide: bool) -> i64 {
    if wide { bits as i64 } else { i64::from(bits as u32 as i32) }
}

fn arithmetic<T: std::ops::Add<Output = T> + std::ops::Mul<Output = T>>(
    op: SubgroupOperation,
    a: T,
    b: T,
    min: fn(T, T) -> T,
    max: fn(T, T) -> T,
) -> T {
    match op {
        SubgroupOperation::Mul => a * b,
        SubgroupOperation::Min => min(a, b),
        SubgroupOperation::Max => max(a, b),
        SubgroupOperation::Add
        | SubgroupOperation::All
        | SubgroupOperation::Any
        | SubgroupOperation::And
        | SubgroupOperation::Or
        | SubgroupOperation::Xor => a + b,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lanes(values: &[Option<u64>]) -> Vec<Option<Brought>> {
        values.iter().map(|v| v.map(|value| Brought { value, index: 1 })).collect()
    }

    #[test]
    fn lanes_that_are_not_active_take_no_part() {
        let brought = lanes(&[None, Some(3), None, Some(5)]);
        let sum = |how| exchange(SubgroupOp::Collect(SubgroupOperation::Add, how), Scalar::U32, &brought);
        assert_eq!(sum(CollectiveOperation::Reduce), [8; 4]);
        assert_eq!(
            (sum(CollectiveOperation::InclusiveScan)[3], sum(CollectiveOperation::ExclusiveScan)[3]),
            (8, 3)
        );
        assert_eq!(sum(CollectiveOperation::ExclusiveScan)[1], 0);
        assert_eq!(exchange(SubgroupOp::Ballot(0), Scalar::Bool, &brought), [0b1010; 4]);
        assert_eq!(exchange(SubgroupOp::Ballot(1), Scalar::Bool, &brought), [0; 4]);
        assert_eq!(exchange(SubgroupOp::Gather(Gather::First), Scalar::U32, &brought), [3; 4]);
    }

    #[test]
    fn gathers_find_their_lanes() {
        let brought = lanes(&[Some(10), Some(11), Some(12), Some(13)]);
        let gather = |gather| exchange(SubgroupOp::Gather(gather), Scalar::U32, &brought);
        assert_eq!(gather(Gather::Lane), [11; 4]);
        assert_eq!(gather(Gather::Down)[..3], [11, 12, 13]);
        assert_eq!(gather(Gather::Up)[1..], [10, 11, 12]);
        assert_eq!(gather(Gather::Xor), [11, 10, 13, 12]);
        assert_eq!(gather(Gather::Quad), [11; 4]);
        assert_eq!(gather(Gather::QuadSwap(3)), [13, 12, 11, 10]);
    }

    #[test]
    fn numbers_combine_as_their_type_does() {
        use SubgroupOperation as S;
        let bits = |n: f32| u64::from(n.to_bits());
        let cases = [
            (S::Min, Scalar::I32, u64::from(-3i32 as u32), 2, u64::from(-3i32 as u32)),
            (S::Min, Scalar::U32, u64::from(-3i32 as u32), 2, 2),
            (S::Add, Scalar::U32, u64::from(u32::MAX), 2, 1),
            (S::Mul, Scalar::F32, bits(1.5), bits(-2.0), bits(-3.0)),
            (S::Add, Scalar::F16, bits(2048.0), bits(1.0), bits(2048.0)),
            (S::Max, Scalar::F64, 2f64.to_bits(), (-1f64).to_bits(), 2f64.to_bits()),
        ];
        for (op, scalar, a, b, expected) in cases {
            assert_eq!(combine(op, scalar, a, b), expected, "{op:?} {scalar:?}");
        }
    }
}
