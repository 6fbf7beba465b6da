//! Operations on integers of all widths, by counting and by long arithmetic.

use crate::run::{INTEGERS, Operation, Ty};

fn operation(wgsl: &str, args: Vec<Ty>, result: Ty, oracle: impl Fn(&[i128]) -> i128 + 'static) -> Operation {
    let types = args.clone();
    let oracle = Box::new(move |bits: &[u64]| {
        let values: Vec<i128> = types.iter().zip(bits).map(|(ty, b)| ty.value(*b)).collect();
        let value = oracle(&values);
        if result == Ty::Bool { value as u64 } else { result.wrap(value) }
    });
    Operation { wgsl: wgsl.to_owned(), args, result, oracle }
}

/// The bits of a number, lowest first.
fn bits(ty: Ty, value: i128) -> Vec<bool> {
    (0..ty.bits()).map(|i| value >> i & 1 == 1).collect()
}

fn number(bits: impl IntoIterator<Item = bool>) -> i128 {
    bits.into_iter().enumerate().map(|(i, b)| i128::from(b) << i).sum()
}

/// The index of the last bit that is as wanted; -1 if none is.
fn last(bits: &[bool], wanted: bool) -> i128 {
    bits.iter().rposition(|b| *b == wanted).map_or(-1, |i| i as i128)
}

/// Where bits begin and end: both clamped to the number.
fn field(ty: Ty, at: i128, count: i128) -> std::ops::Range<usize> {
    let at = at.min(ty.bits().into()) as usize;
    at..(at + (count.min(ty.bits().into()) as usize)).min(ty.bits() as usize)
}

fn extract(ty: Ty, v: &[i128]) -> i128 {
    let part = bits(ty, v[0])[field(ty, v[1], v[2])].to_vec();
    let full = number(part.iter().copied());
    if ty.signed() && part.last() == Some(&true) { full - (1 << part.len()) } else { full }
}

fn insert(ty: Ty, v: &[i128]) -> i128 {
    let mut to = bits(ty, v[0]);
    let from = bits(ty, v[1]);
    for (i, at) in field(ty, v[2], v[3]).enumerate() {
        to[at] = from[i];
    }
    number(to)
}

/// Of two numbers of the type.
fn arithmetic(ty: Ty) -> Vec<Operation> {
    type Of2 = fn(&[i128]) -> i128;
    let same: [(&str, Of2); 12] = [
        ("a + b", |v| v[0] + v[1]),
        ("a - b", |v| v[0] - v[1]),
        ("a * b", |v| v[0].wrapping_mul(v[1])),
        ("a / b", |v| if v[1] == 0 { v[0] } else { v[0] / v[1] }),
        ("a % b", |v| if v[1] == 0 { 0 } else { v[0] % v[1] }),
        ("a & b", |v| v[0] & v[1]),
        ("a | b", |v| v[0] | v[1]),
        ("a ^ b", |v| v[0] ^ v[1]),
        ("min(a, b)", |v| v[0].min(v[1])),
        ("max(a, b)", |v| v[0].max(v[1])),
        ("dot(vec2(a, b), vec2(b, a))", |v| v[0].wrapping_mul(v[1]).wrapping_mul(2)),
        ("select(a, b, a < b)", |v| v[0].max(v[1])),
    ];
    let tests: [(&str, Of2); 6] = [
        ("a == b", |v| (v[0] == v[1]).into()),
        ("a != b", |v| (v[0] != v[1]).into()),
        ("a < b", |v| (v[0] < v[1]).into()),
        ("a <= b", |v| (v[0] <= v[1]).into()),
        ("a > b", |v| (v[0] > v[1]).into()),
        ("a >= b", |v| (v[0] >= v[1]).into()),
    ];
    let numbers = same.into_iter().map(|(wgsl, f)| operation(wgsl, vec![ty; 2], ty, f));
    numbers.chain(tests.into_iter().map(|(wgsl, f)| operation(wgsl, vec![ty; 2], Ty::Bool, f))).collect()
}

/// Of one number, of three, and with counts.
fn others(ty: Ty) -> Vec<Operation> {
    let width = i128::from(ty.bits());
    let one = |wgsl: &str, f: fn(Ty, i128) -> i128| operation(wgsl, vec![ty], ty, move |v| f(ty, v[0]));
    let mut all = vec![
        operation("clamp(a, b, c)", vec![ty; 3], ty, |v| v[0].max(v[1]).min(v[2])),
        operation("a << b", vec![ty, Ty::U32], ty, move |v| v[0].wrapping_shl((v[1] % width) as u32)),
        operation("a >> b", vec![ty, Ty::U32], ty, move |v| v[0] >> (v[1] % width)),
        one("~a", |_, v| -1 - v),
        one("abs(a)", |_, v| v.abs()),
        one("countOneBits(a)", |ty, v| bits(ty, v).iter().filter(|b| **b).count() as i128),
        one("countLeadingZeros(a)", |ty, v| i128::from(ty.bits()) - 1 - last(&bits(ty, v), true)),
        one("countTrailingZeros(a)", |ty, v| {
            bits(ty, v).iter().position(|b| *b).unwrap_or(ty.bits() as usize) as i128
        }),
        one("reverseBits(a)", |ty, v| number(bits(ty, v).into_iter().rev())),
        one("firstTrailingBit(a)", |ty, v| bits(ty, v).iter().position(|b| *b).map_or(-1, |i| i as i128)),
        one("firstLeadingBit(a)", |_, _| 0),
        operation("extractBits(a, b, c)", vec![ty, Ty::U32, Ty::U32], ty, move |v| extract(ty, v)),
        operation("insertBits(a, b, c, d)", vec![ty, ty, Ty::U32, Ty::U32], ty, move |v| insert(ty, v)),
    ];
    let leading = all.iter_mut().find(|o| o.wgsl == "firstLeadingBit(a)").unwrap();
    *leading = one("firstLeadingBit(a)", |ty, v| last(&bits(ty, v), !(ty.signed() && v < 0)));
    if ty.signed() {
        all.push(one("-a", |_, v| -v));
        all.push(one("sign(a)", |_, v| v.signum()));
    }
    all
}

/// From each type to each, and to booleans.
fn conversions(from: Ty) -> Vec<Operation> {
    let mut all: Vec<_> = INTEGERS
        .into_iter()
        .map(|to| operation(&format!("{}(a)", to.name()), vec![from], to, |v| v[0]))
        .collect();
    all.push(operation("bool(a)", vec![from], Ty::Bool, |v| (v[0] != 0).into()));
    all.push(operation(&format!("{}(bool(a))", from.name()), vec![from], from, |v| (v[0] != 0).into()));
    all
}

pub(crate) fn operations(ty: Ty) -> Vec<Operation> {
    [arithmetic(ty), others(ty), conversions(ty)].into_iter().flatten().collect()
}
