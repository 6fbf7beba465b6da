//! Every row of the table of intrinsics, bit for bit against the native function of the same name.

use crate::support::{call, columns};
use lobe_codegen::data::Columns;
use lobe_codegen::glam::{Mat3, Vec2, Vec3};
use lobe_codegen::intrinsics::{Intrinsic, Op, TABLE};
use lobe_codegen::math;

const EDGES: [f32; 24] = [
    0.0,
    -0.0,
    1e-45,
    -1e-45,
    1.0e-39,
    f32::MIN_POSITIVE,
    -f32::MIN_POSITIVE,
    1e-6,
    0.25,
    -0.5,
    0.5,
    0.999_999_94,
    1.0,
    -1.0,
    1.5,
    2.5,
    -3.7,
    88.8,
    -104.0,
    3e9,
    3.0e38,
    f32::MAX,
    f32::INFINITY,
    f32::NAN,
];
const WORDS: [u32; 12] =
    [0, 1, 2, 3, 31, 32, 33, 0x55aa_1234, 0x7fff_ffff, 0x8000_0000, 0x8000_0001, u32::MAX];

/// An infix operator and Rust's.
type Operator<T> = (&'static str, fn(T, T) -> T);
/// Rust's form of a comparison.
type Compare = fn(&f32, &f32) -> bool;

/// All tuples of `n` items.
fn tuples<T: Copy>(items: &[T], n: usize) -> Vec<Vec<T>> {
    (0..items.len().pow(n as u32))
        .map(|i| (0..n).map(|k| items[i / items.len().pow(k as u32) % items.len()]).collect())
        .collect()
}

/// Compares `f(a: A, b: B, ..) -> R` with `native`, row by row; NaN equals NaN.
fn same(text: &str, rows: &[Vec<u32>], native: impl Fn(&[u32]) -> Vec<u32>) {
    let width = rows[0].len();
    let got = call(text, &Columns::from_rows(width, rows));
    for (r, row) in rows.iter().enumerate() {
        let (got, want) = (got.row(r), native(row));
        let equal = |(a, b): (&u32, &u32)| {
            a == b || (text.contains("f32") && f32::from_bits(*a).is_nan() && f32::from_bits(*b).is_nan())
        };
        assert!(
            got.len() == want.len() && got.iter().zip(&want).all(equal),
            "{text}\narguments {:x?} ({:?})\ngot {got:x?}, native {want:x?}",
            row,
            row.iter().map(|w| f32::from_bits(*w)).collect::<Vec<_>>(),
        );
    }
}

fn bits(rows: Vec<Vec<f32>>) -> Vec<Vec<u32>> {
    rows.into_iter().map(|row| row.into_iter().map(f32::to_bits).collect()).collect()
}

fn function(call: &str, args: usize, ty: &str, result: &str) -> String {
    let names = ["a", "b", "c", "d"];
    let params: Vec<_> = names[..args].iter().map(|n| format!("{n}: {ty}")).collect();
    format!("fn f({}) -> {result} {{ return {call}({}); }}", params.join(", "), names[..args].join(", "))
}

fn float1(name: &str, f: fn(f32) -> f32) {
    same(&function(name, 1, "f32", "f32"), &bits(tuples(&EDGES, 1)), |w| {
        vec![f(f32::from_bits(w[0])).to_bits()]
    });
}

fn float2(name: &str, f: fn(f32, f32) -> f32) {
    same(&function(name, 2, "f32", "f32"), &bits(tuples(&EDGES, 2)), |w| {
        vec![f(f32::from_bits(w[0]), f32::from_bits(w[1])).to_bits()]
    });
}

fn float3(name: &str, f: fn(f32, f32, f32) -> f32) {
    same(&function(name, 3, "f32", "f32"), &bits(tuples(&EDGES, 3)), |w| {
        let x = |i: usize| f32::from_bits(w[i]);
        vec![f(x(0), x(1), x(2)).to_bits()]
    });
}

fn word_rows(n: usize) -> Vec<Vec<u32>> {
    tuples(&WORDS, n)
}

fn signed1(name: &str, f: fn(i32) -> i32) {
    same(&function(name, 1, "i32", "i32"), &word_rows(1), |w| vec![f(w[0] as i32) as u32]);
}

fn unsigned1(name: &str, f: fn(u32) -> u32) {
    same(&function(name, 1, "u32", "u32"), &word_rows(1), |w| vec![f(w[0])]);
}

fn vec3(w: &[u32]) -> Vec3 {
    Vec3::new(f32::from_bits(w[0]), f32::from_bits(w[1]), f32::from_bits(w[2]))
}

fn words3(v: Vec3) -> Vec<u32> {
    v.to_array().map(f32::to_bits).to_vec()
}

/// Vectors of ordinary and of extreme components.
fn vectors(n: usize) -> Vec<Vec<u32>> {
    let mut chance = crate::support::Chance(11);
    let mut row = |i: usize| {
        let mut pick = |edge: bool| if edge { EDGES[chance.below(EDGES.len())] } else { chance.float() };
        (0..n).map(|_| pick(i.is_multiple_of(3)).to_bits()).collect()
    };
    (0..3000).map(&mut row).collect()
}

/// The case of one row; `None` for what other tests hold (atomics, barriers).
fn case(intrinsic: Intrinsic) -> Option<Box<dyn Fn()>> {
    use Intrinsic as I;
    Some(match intrinsic {
        I::Abs => Box::new(|| {
            float1("abs", math::abs);
            signed1("abs", math::abs);
        }),
        I::Min => Box::new(|| {
            float2("min", math::min);
            same(&function("min", 2, "i32", "i32"), &word_rows(2), |w| {
                vec![math::min(w[0] as i32, w[1] as i32) as u32]
            });
            same(&function("min", 2, "u32", "u32"), &word_rows(2), |w| vec![math::min(w[0], w[1])]);
        }),
        I::Max => Box::new(|| {
            float2("max", math::max);
            same(&function("max", 2, "i32", "i32"), &word_rows(2), |w| {
                vec![math::max(w[0] as i32, w[1] as i32) as u32]
            });
            same(&function("max", 2, "u32", "u32"), &word_rows(2), |w| vec![math::max(w[0], w[1])]);
        }),
        I::Clamp => Box::new(|| {
            float3("clamp", math::clamp);
            same(&function("clamp", 3, "i32", "i32"), &word_rows(3), |w| {
                vec![math::clamp(w[0] as i32, w[1] as i32, w[2] as i32) as u32]
            });
            same(&function("clamp", 3, "u32", "u32"), &word_rows(3), |w| vec![math::clamp(w[0], w[1], w[2])]);
        }),
        I::Saturate => Box::new(|| float1("saturate", math::saturate)),
        I::Sign => Box::new(|| {
            float1("sign", math::sign);
            signed1("sign", math::sign);
        }),
        I::Ceil => Box::new(|| float1("ceil", math::ceil)),
        I::Floor => Box::new(|| float1("floor", math::floor)),
        I::Round => Box::new(|| float1("round", math::round)),
        I::Trunc => Box::new(|| float1("trunc", math::trunc)),
        I::Fract => Box::new(|| float1("fract", math::fract)),
        I::Step => Box::new(|| float2("step", math::step)),
        I::Sqrt => Box::new(|| float1("sqrt", math::sqrt)),
        I::InverseSqrt => Box::new(|| float1("inverseSqrt", math::inverse_sqrt)),
        I::Exp => Box::new(|| float1("exp", math::exp)),
        I::Exp2 => Box::new(|| float1("exp2", math::exp2)),
        I::Log => Box::new(|| float1("log", math::log)),
        I::Log2 => Box::new(|| float1("log2", math::log2)),
        I::Pow => Box::new(|| float2("pow", math::pow)),
        I::Sin => Box::new(|| float1("sin", math::sin)),
        I::Cos => Box::new(|| float1("cos", math::cos)),
        I::Tan => Box::new(|| float1("tan", math::tan)),
        I::Asin => Box::new(|| float1("asin", math::asin)),
        I::Acos => Box::new(|| float1("acos", math::acos)),
        I::Atan => Box::new(|| float1("atan", math::atan)),
        I::Atan2 => Box::new(|| float2("atan2", math::atan2)),
        I::Sinh => Box::new(|| float1("sinh", math::sinh)),
        I::Cosh => Box::new(|| float1("cosh", math::cosh)),
        I::Tanh => Box::new(|| float1("tanh", math::tanh)),
        I::Asinh => Box::new(|| float1("asinh", math::asinh)),
        I::Acosh => Box::new(|| float1("acosh", math::acosh)),
        I::Atanh => Box::new(|| float1("atanh", math::atanh)),
        I::Degrees => Box::new(|| float1("degrees", math::degrees)),
        I::Radians => Box::new(|| float1("radians", math::radians)),
        I::Fma => Box::new(|| float3("fma", math::fma)),
        I::Mix => Box::new(|| float3("mix", math::mix)),
        I::SmoothStep => Box::new(|| float3("smoothstep", math::smoothstep)),
        I::Dot
        | I::Length
        | I::Distance
        | I::Normalize
        | I::Cross
        | I::Reflect
        | I::Refract
        | I::FaceForward
        | I::Transpose => return geometry(intrinsic),
        I::CountOneBits => Box::new(|| unsigned1("countOneBits", math::count_one_bits)),
        I::CountLeadingZeros => Box::new(|| unsigned1("countLeadingZeros", math::count_leading_zeros)),
        I::CountTrailingZeros => Box::new(|| unsigned1("countTrailingZeros", math::count_trailing_zeros)),
        I::ReverseBits => Box::new(|| signed1("reverseBits", math::reverse_bits)),
        I::FirstLeadingBit => Box::new(|| {
            unsigned1("firstLeadingBit", math::first_leading_bit);
            signed1("firstLeadingBit", math::first_leading_bit);
        }),
        I::FirstTrailingBit => Box::new(|| unsigned1("firstTrailingBit", math::first_trailing_bit)),
        I::ExtractBits => Box::new(|| {
            let text = "fn f(a: i32, b: u32, c: u32) -> i32 { return extractBits(a, b, c); }";
            same(text, &word_rows(3), |w| vec![math::extract_bits(w[0] as i32, w[1], w[2]) as u32]);
            same(&text.replace("i32", "u32"), &word_rows(3), |w| vec![math::extract_bits(w[0], w[1], w[2])]);
        }),
        I::InsertBits => Box::new(|| {
            let text = "fn f(a: u32, b: u32, c: u32, d: u32) -> u32 { return insertBits(a, b, c, d); }";
            same(text, &word_rows(4), |w| vec![math::insert_bits(w[0], w[1], w[2], w[3])]);
        }),
        I::Select => Box::new(|| {
            let text = "fn f(a: u32, b: u32, c: u32) -> u32 { return select(a, b, c > 2u); }";
            same(text, &word_rows(3), |w| vec![math::select(w[0], w[1], w[2] > 2)]);
        }),
        I::All => Box::new(|| quantifier("all", |a, b| a && b)),
        I::Any => Box::new(|| quantifier("any", |a, b| a || b)),
        I::AtomicLoad
        | I::AtomicStore
        | I::AtomicAdd
        | I::AtomicSub
        | I::AtomicMin
        | I::AtomicMax
        | I::AtomicAnd
        | I::AtomicOr
        | I::AtomicXor
        | I::AtomicExchange
        | I::WorkgroupBarrier
        | I::StorageBarrier => return None,
    })
}

fn quantifier(name: &str, f: fn(bool, bool) -> bool) {
    let text = format!("fn f(a: u32, b: u32) -> u32 {{ return u32({name}(vec2<bool>(a > 2u, b > 2u))); }}");
    same(&text, &word_rows(2), |w| vec![f(w[0] > 2, w[1] > 2).into()]);
}

fn geometry(intrinsic: Intrinsic) -> Option<Box<dyn Fn()>> {
    use Intrinsic as I;
    let two = |name: &str, result: &str| function(name, 2, "vec3<f32>", result);
    let (dot, cross, reflect) = (two("dot", "f32"), two("cross", "vec3<f32>"), two("reflect", "vec3<f32>"));
    let (distance, length) = (two("distance", "f32"), function("length", 1, "vec3<f32>", "f32"));
    let normalize = function("normalize", 1, "vec3<f32>", "vec3<f32>");
    let facing = function("faceForward", 3, "vec3<f32>", "vec3<f32>");
    let refract = "fn f(a: vec3<f32>, b: vec3<f32>, c: f32) -> vec3<f32> { return refract(a, b, c); }";
    let transpose = "fn f(a: mat3x3<f32>) -> mat3x3<f32> { return transpose(a); }";
    Some(if intrinsic == I::Dot {
        Box::new(move || {
            same(&dot, &vectors(6), |w| vec![math::dot(vec3(w), vec3(&w[3..])).to_bits()]);
        })
    } else if intrinsic == I::Length {
        Box::new(move || same(&length, &vectors(3), |w| vec![math::length(vec3(w)).to_bits()]))
    } else if intrinsic == I::Distance {
        Box::new(move || {
            same(&distance, &vectors(6), |w| vec![math::distance(vec3(w), vec3(&w[3..])).to_bits()])
        })
    } else if intrinsic == I::Normalize {
        Box::new(move || same(&normalize, &vectors(3), |w| words3(math::normalize(vec3(w)))))
    } else if intrinsic == I::Cross {
        Box::new(move || same(&cross, &vectors(6), |w| words3(math::cross(vec3(w), vec3(&w[3..])))))
    } else if intrinsic == I::Reflect {
        Box::new(move || same(&reflect, &vectors(6), |w| words3(math::reflect(vec3(w), vec3(&w[3..])))))
    } else if intrinsic == I::Refract {
        Box::new(move || {
            same(refract, &vectors(7), |w| {
                words3(math::refract(vec3(w), vec3(&w[3..]), f32::from_bits(w[6])))
            });
        })
    } else if intrinsic == I::FaceForward {
        Box::new(move || {
            same(&facing, &vectors(9), |w| words3(math::face_forward(vec3(w), vec3(&w[3..]), vec3(&w[6..]))));
        })
    } else {
        Box::new(move || {
            same(transpose, &vectors(9), |w| {
                let m = math::transpose(Mat3::from_cols(vec3(w), vec3(&w[3..]), vec3(&w[6..])));
                [m.x_axis, m.y_axis, m.z_axis].into_iter().flat_map(words3).collect()
            });
        })
    })
}

#[test]
fn every_intrinsic_equals_its_native_function_bit_for_bit() {
    let mut cases = 0;
    for row in TABLE {
        match (case(row.intrinsic), row.op) {
            (Some(check), _) => {
                check();
                cases += 1;
            }
            (None, Op::Math(_) | Op::Relational(_) | Op::Select) => panic!("{} has no case", row.name),
            (None, Op::Atomic(_) | Op::AtomicLoad | Op::AtomicStore | Op::Barrier(_)) => {}
        }
    }
    assert!(cases > 50);
}

#[test]
fn infix_operators_on_floats_equal_rusts_bit_for_bit() {
    let operators: [Operator<f32>; 5] = [
        ("+", |a, b| a + b),
        ("-", |a, b| a - b),
        ("*", |a, b| a * b),
        ("/", |a, b| a / b),
        ("%", |a, b| a % b),
    ];
    for (name, f) in operators {
        let text = format!("fn f(a: f32, b: f32) -> f32 {{ return a {name} b; }}");
        same(&text, &bits(tuples(&EDGES, 2)), |w| {
            vec![f(f32::from_bits(w[0]), f32::from_bits(w[1])).to_bits()]
        });
    }
}

#[test]
fn comparisons_of_floats_equal_rusts() {
    let operators: [(&str, Compare); 6] =
        [("==", f32::eq), ("!=", f32::ne), ("<", f32::lt), ("<=", f32::le), (">", f32::gt), (">=", f32::ge)];
    for (name, f) in operators {
        let text = format!("fn f(a: f32, b: f32) -> bool {{ return a {name} b; }}");
        same(&text, &bits(tuples(&EDGES, 2)), |w| {
            vec![f(&f32::from_bits(w[0]), &f32::from_bits(w[1])).into()]
        });
    }
}

#[test]
fn vectors_broadcast_scalars_as_glam_does() {
    let text = "fn f(a: vec3<f32>, s: f32) -> vec3<f32> { return (a * s + s * a) / s - a; }";
    same(text, &vectors(4), |w| {
        let (a, s) = (vec3(w), f32::from_bits(w[3]));
        words3((a * s + s * a) / s - a)
    });
    let text = "fn f(a: vec3<f32>, b: vec3<f32>, t: f32) -> vec3<f32> { return mix(a, b, t); }";
    same(text, &vectors(7), |w| {
        let t = f32::from_bits(w[6]);
        words3(math::mix(vec3(w), vec3(&w[3..]), Vec3::splat(t)))
    });
}

#[test]
fn matrix_products_add_in_the_order_of_glam() {
    let matrix = |w: &[u32]| Mat3::from_cols(vec3(w), vec3(&w[3..]), vec3(&w[6..]));
    let columns_of =
        |m: Mat3| [m.x_axis, m.y_axis, m.z_axis].into_iter().flat_map(words3).collect::<Vec<_>>();
    same("fn f(m: mat3x3<f32>, v: vec3<f32>) -> vec3<f32> { return m * v; }", &vectors(12), |w| {
        words3(matrix(w) * vec3(&w[9..]))
    });
    same("fn f(m: mat3x3<f32>, n: mat3x3<f32>) -> mat3x3<f32> { return m * n; }", &vectors(18), |w| {
        columns_of(matrix(w) * matrix(&w[9..]))
    });
    same("fn f(m: mat3x3<f32>, s: f32) -> mat3x3<f32> { return m * s; }", &vectors(10), |w| {
        columns_of(matrix(w) * f32::from_bits(w[9]))
    });
    same("fn f(m: mat3x3<f32>, n: mat3x3<f32>) -> mat3x3<f32> { return m - n; }", &vectors(18), |w| {
        columns_of(matrix(w) - matrix(&w[9..]))
    });
    same("fn f(m: mat2x2<f32>, v: vec2<f32>) -> vec2<f32> { return v * m; }", &vectors(6), |w| {
        let x: Vec<f32> = w.iter().map(|w| f32::from_bits(*w)).collect();
        let v = Vec2::new(x[4], x[5]);
        vec![v.dot(Vec2::new(x[0], x[1])).to_bits(), v.dot(Vec2::new(x[2], x[3])).to_bits()]
    });
}

#[test]
fn no_rows_give_no_rows() {
    let out = call("fn f(a: f32) -> vec2<f32> { return vec2(a, a); }", &columns(&[vec![]]));
    assert_eq!((out.rows, out.width()), (0, 2));
}
