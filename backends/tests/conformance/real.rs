//! Operations on floats of all widths that IEEE defines to the last bit, by integer arithmetic.

use crate::run::{FLOATS, INTEGERS, Operation, Ty};
use crate::soft::{self, F16, Format, Number, Way};
use std::cmp::Ordering;

fn operation(
    wgsl: &str,
    (ty, count): (Ty, usize),
    result: Ty,
    oracle: impl Fn(&[Number]) -> Number + 'static,
) -> Operation {
    let (from, to) = (ty.format().unwrap(), result.format());
    let oracle = Box::new(move |bits: &[u64]| {
        let numbers: Vec<Number> = bits.iter().map(|b| from.decode(*b)).collect();
        to.map_or(0, |to| to.encode(oracle(&numbers)))
    });
    Operation { wgsl: wgsl.to_owned(), args: vec![ty; count], result, oracle }
}

fn test(wgsl: &str, ty: Ty, oracle: impl Fn(Option<Ordering>) -> bool + 'static) -> Operation {
    let format = ty.format().unwrap();
    let oracle =
        Box::new(move |v: &[u64]| u64::from(oracle(soft::compare(format.decode(v[0]), format.decode(v[1])))));
    Operation { wgsl: wgsl.to_owned(), args: vec![ty; 2], result: Ty::Bool, oracle }
}

/// The smaller; the other one when one is NaN; the first of equals.
fn min(a: Number, b: Number) -> Number {
    if a == Number::Nan || soft::compare(b, a) == Some(Ordering::Less) { b } else { a }
}

/// The larger; the other one when one is NaN; the first of equals.
fn max(a: Number, b: Number) -> Number {
    if a == Number::Nan || soft::compare(b, a) == Some(Ordering::Greater) { b } else { a }
}

fn fraction(a: Number) -> Number {
    soft::add(a, soft::neg(soft::whole(a, Way::Down)))
}

fn arithmetic(ty: Ty) -> Vec<Operation> {
    type Of = fn(&[Number]) -> Number;
    let one = soft::of_integer(1);
    let table: [(&str, usize, Of); 19] = [
        ("a + b", 2, |v| soft::add(v[0], v[1])),
        ("a - b", 2, |v| soft::add(v[0], soft::neg(v[1]))),
        ("a * b", 2, |v| soft::mul(v[0], v[1])),
        ("a * a", 1, |v| soft::mul(v[0], v[0])),
        ("a / b", 2, |v| soft::div(v[0], v[1])),
        ("a % b", 2, |v| soft::rem(v[0], v[1])),
        ("-a", 1, |v| soft::neg(v[0])),
        ("abs(a)", 1, |v| soft::abs(v[0])),
        ("min(a, b)", 2, |v| min(v[0], v[1])),
        ("max(a, b)", 2, |v| max(v[0], v[1])),
        ("clamp(a, b, c)", 3, |v| min(max(v[0], v[1]), v[2])),
        ("saturate(a)", 1, |v| min(max(v[0], soft::of_integer(0)), soft::of_integer(1))),
        ("floor(a)", 1, |v| soft::whole(v[0], Way::Down)),
        ("ceil(a)", 1, |v| soft::whole(v[0], Way::Up)),
        ("trunc(a)", 1, |v| soft::whole(v[0], Way::ToZero)),
        ("round(a)", 1, |v| soft::whole(v[0], Way::ToEven)),
        ("fract(a)", 1, |v| fraction(v[0])),
        ("sqrt(a)", 1, |v| soft::sqrt(v[0])),
        ("fma(a, b, c)", 3, |v| soft::add(soft::mul(v[0], v[1]), v[2])),
    ];
    let mut all: Vec<_> = table.into_iter().map(|(wgsl, n, f)| operation(wgsl, (ty, n), ty, f)).collect();
    all.push(operation("step(a, b)", (ty, 2), ty, move |v| match soft::compare(v[0], v[1]) {
        Some(Ordering::Less | Ordering::Equal) => one,
        Some(Ordering::Greater) | None => soft::of_integer(0),
    }));
    all.push(operation("sign(a)", (ty, 1), ty, move |v| match soft::compare(v[0], soft::of_integer(0)) {
        Some(Ordering::Less) => soft::neg(one),
        Some(Ordering::Greater) => one,
        Some(Ordering::Equal) | None => v[0],
    }));
    all
}

fn tests(ty: Ty) -> Vec<Operation> {
    vec![
        test("a == b", ty, |o| o == Some(Ordering::Equal)),
        test("a != b", ty, |o| o != Some(Ordering::Equal)),
        test("a < b", ty, |o| o == Some(Ordering::Less)),
        test("a <= b", ty, |o| o.is_some_and(Ordering::is_le)),
        test("a > b", ty, |o| o == Some(Ordering::Greater)),
        test("a >= b", ty, |o| o.is_some_and(Ordering::is_ge)),
    ]
}

/// The largest integer that both types hold.
fn most(format: Format, to: Ty) -> i128 {
    let digits = u32::from(to.signed()) + format.digits;
    let high = to.range().1;
    let high = if to.bits() > digits { high - ((1 << (to.bits() - digits)) - 1) } else { high };
    if format == F16 { high.min(65504) } else { high }
}

fn conversions(ty: Ty) -> Vec<Operation> {
    let format = ty.format().unwrap();
    let mut all: Vec<_> =
        FLOATS.into_iter().map(|to| operation(&format!("{}(a)", to.name()), (ty, 1), to, |v| v[0])).collect();
    for whole in INTEGERS {
        let (low, high) = (whole.range().0, most(format, whole));
        let low = if format == F16 { low.max(-65504) } else { low };
        all.push(Operation {
            wgsl: format!("{}(a)", whole.name()),
            args: vec![ty],
            result: whole,
            oracle: Box::new(move |v| whole.wrap(soft::to_integer(format.decode(v[0]), low, high))),
        });
        all.push(Operation {
            wgsl: format!("{}(a)", ty.name()),
            args: vec![whole],
            result: ty,
            oracle: Box::new(move |v| format.encode(soft::of_integer(whole.value(v[0])))),
        });
    }
    all.push(Operation {
        wgsl: "bool(a)".to_owned(),
        args: vec![ty],
        result: Ty::Bool,
        oracle: Box::new(move |v| (v[0] << (65 - ty.bits()) != 0).into()),
    });
    all
}

/// Functions that take numbers apart and put them together.
fn parts(ty: Ty) -> Vec<Operation> {
    let format = ty.format().unwrap();
    let length = |size: u128| 128 - size.leading_zeros() as i32;
    let significand = operation("frexp(a).fract", (ty, 1), ty, move |v| match v[0] {
        Number::Finite { negative, size, .. } if size != 0 => {
            Number::Finite { negative, size, power: -length(size) }
        }
        other => other,
    });
    let exponent = Operation {
        wgsl: "i32(frexp(a).exp)".to_owned(),
        args: vec![ty],
        result: Ty::I32,
        oracle: Box::new(move |v| match format.decode(v[0]) {
            Number::Finite { size, power, .. } if size != 0 => Ty::I32.wrap((power + length(size)).into()),
            _ => 0,
        }),
    };
    let ldexp = Operation {
        wgsl: "ldexp(a, b)".to_owned(),
        args: vec![ty, Ty::I32],
        result: ty,
        oracle: Box::new(move |v| {
            let by = Ty::I32.value(v[1]).clamp(-5000, 5000) as i32;
            format.encode(match format.decode(v[0]) {
                Number::Finite { negative, size, power } => {
                    Number::Finite { negative, size, power: power + by }
                }
                other => other,
            })
        }),
    };
    let whole = operation("modf(a).whole", (ty, 1), ty, |v| soft::whole(v[0], Way::ToZero));
    let rest = operation("modf(a).fract", (ty, 1), ty, |v| {
        soft::add(v[0], soft::neg(soft::whole(v[0], Way::ToZero)))
    });
    vec![significand, exponent, ldexp, whole, rest]
}

pub(crate) fn operations(ty: Ty) -> Vec<Operation> {
    let mut all: Vec<_> =
        [arithmetic(ty), tests(ty), conversions(ty), parts(ty)].into_iter().flatten().collect();
    if ty == Ty::F32 {
        all.push(operation("quantizeToF16(a)", (ty, 1), ty, |v| F16.decode(F16.encode(v[0]))));
        let bits = |wgsl: &str, args, result| Operation {
            wgsl: wgsl.to_owned(),
            args,
            result,
            oracle: Box::new(|v: &[u64]| v[0]),
        };
        all.push(bits("bitcast<u32>(a)", vec![Ty::F32], Ty::U32));
        all.push(bits("bitcast<f32>(a)", vec![Ty::U32], Ty::F32));
    }
    all
}
