//! The claim of the shadow lane: no permitted driver leaves the bound.
//!
//! Chance kernels, chance arguments, chance drivers; each failure prints the seed and the kernel.

use crate::support::{Chance, columns, float_column, floats, foreign, module};
use lobe_backends::interp::{Interpreter, ShadowColumn};
use lobe_codegen::accuracy::Model;
use lobe_codegen::data::Columns;

const ROWS: usize = 300;
const DRIVERS: u64 = 12;

/// Shares of rows with a finite bound and of rows that met an ambiguous decision.
#[derive(Default)]
pub(crate) struct Seen {
    pub(crate) rows: usize,
    pub(crate) bounded: usize,
    pub(crate) ambiguous: usize,
    /// Largest share of a bound that a driver used up.
    pub(crate) used: f64,
}

/// Checks strict and chance drivers of every model against the bounds of `f`.
pub(crate) fn check(text: &str, args: &Columns, seed: u64, seen: &mut Seen) {
    for (index, model) in Model::all().iter().enumerate() {
        let mut other = Seen::default();
        check_model(model, text, args, seed, if index == 0 { &mut *seen } else { &mut other });
    }
}

/// The same for one model.
pub(crate) fn check_model(model: &'static Model, text: &str, args: &Columns, seed: u64, seen: &mut Seen) {
    let module = if text.contains("f16") || text.contains("f64") { foreign(text) } else { module(text) };
    let f = module.function("f").unwrap();
    let interpreter = Interpreter::new(&module).unwrap().with_accuracy(model);
    let shadow = interpreter.shadow(f, args, None).unwrap();
    let strict = interpreter.call(f, args).unwrap();
    let mut results = vec![strict.clone()];
    results.extend((0..DRIVERS).map(|d| interpreter.perturbed(f, args, seed ^ d).unwrap()));
    for (index, column) in shadow.columns.iter().enumerate() {
        for row in 0..args.rows {
            let words: Vec<u32> = results.iter().map(|r| r.columns[index][row]).collect();
            let place =
                || format!("{}, seed {seed:#x} row {row} of {:?}\n{text}", model.name, argument(args, row));
            match column {
                ShadowColumn::Float { value, exact, bound } => {
                    let (a, b) = (value[row], f32::from_bits(words[0]));
                    assert!(a == b || a.is_nan() && b.is_nan(), "value {a} is not strict {b}: {}", place());
                    seen.rows += 1;
                    seen.bounded += usize::from(bound[row].is_finite());
                    if bound[row].is_finite() {
                        let worst = words.iter().map(|w| (f64::from(f32::from_bits(*w)) - exact[row]).abs());
                        let worst =
                            worst.fold(0.0, |a, b| if b.is_nan() { f64::NAN } else { f64::max(a, b) });
                        assert!(worst <= bound[row], "error {worst:e}, bound {:e}: {}", bound[row], place());
                        if bound[row] > 0.0 {
                            seen.used = seen.used.max(worst / bound[row]);
                        }
                    }
                }
                ShadowColumn::Word { value, known } => {
                    assert_eq!(value[row], words[0], "{}", place());
                    assert!(!known[row] || words.iter().all(|w| *w == words[0]), "{words:?}: {}", place());
                }
            }
        }
    }
    seen.ambiguous += shadow.ambiguous.iter().filter(|a| **a).count();
}

fn argument(args: &Columns, row: usize) -> Vec<f32> {
    args.row(row).into_iter().map(f32::from_bits).collect()
}

/// An expression of `a`, `b`, `c` and the variables in scope.
fn expression(chance: &mut Chance, depth: usize, names: &[String]) -> String {
    if depth == 0 || chance.below(9) == 0 {
        return match chance.below(4) {
            0 => format!("{:.3}", chance.float().clamp(-9.0, 9.0)).replace("-0.000", "0.25"),
            _ => names[chance.below(names.len())].clone(),
        };
    }
    let mut part = || expression(chance, depth - 1, names);
    let (x, y, z) = (part(), part(), part());
    const UNARY: [&str; 22] = [
        "abs",
        "floor",
        "ceil",
        "round",
        "trunc",
        "fract",
        "sign",
        "exp",
        "exp2",
        "sin",
        "cos",
        "atan",
        "sqrt",
        "log",
        "log2",
        "tanh",
        "inverseSqrt",
        "saturate",
        "asin",
        "sinh",
        "acos",
        "degrees",
    ];
    match chance.below(20) {
        0..=2 => format!("({x} + {y})"),
        3..=5 => format!("({x} - {y})"),
        6..=8 => format!("({x} * {y})"),
        9 => format!("({x} / {y})"),
        10 => format!("min({x}, {y})"),
        11 => format!("max({x}, {y})"),
        12 => format!("mix({x}, {y}, {z})"),
        13 => format!("fma({x}, {y}, {z})"),
        14 => format!("select({x}, {y}, {y} < {z})"),
        15 => format!("length(vec2({x}, {y}))"),
        16 => format!("atan2({x}, {y})"),
        17 => format!("normalize(vec3({x}, {y}, {z})).y"),
        _ => format!("{}({x})", UNARY[chance.below(UNARY.len())]),
    }
}

/// A function of statements and branches.
pub(crate) fn kernel(chance: &mut Chance) -> String {
    let mut names: Vec<String> = ["a", "b", "c"].map(String::from).to_vec();
    let mut body = String::new();
    for i in 0..1 + chance.below(3) {
        body += &format!("var v{i} = {};\n", expression(chance, 2, &names));
        names.push(format!("v{i}"));
    }
    for _ in 0..chance.below(4) {
        let target = names.len() - 1;
        let (x, y) = (expression(chance, 1, &names), expression(chance, 1, &names));
        let (p, q) = (expression(chance, 2, &names), expression(chance, 2, &names));
        let accept = match chance.below(4) {
            0 => format!("return {p};"),
            _ => format!("{} = {p};", names[target]),
        };
        let reject = match chance.below(4) {
            0 => String::new(),
            1 => format!("if {y} > {q} {{ return {q}; }}"),
            _ => format!("{} = {q};", names[target]),
        };
        body += &format!("if {x} < {y} {{ {accept} }} else {{ {reject} }}\n");
    }
    let result = expression(chance, 2, &names);
    format!("fn f(a: f32, b: f32, c: f32) -> f32 {{\n{body}return {result};\n}}")
}

#[test]
fn chance_drivers_stay_within_the_bounds_of_chance_kernels() {
    let seed = std::env::var("LOBE_SEED").ok().and_then(|s| s.parse().ok()).unwrap_or(0x10be);
    println!("seed {seed:#x}");
    let mut seen = Seen::default();
    for round in 0..400 {
        let mut chance = Chance(seed + round);
        let text = kernel(&mut chance);
        if lobe_codegen::validate::from_wgsl(&text).is_err() {
            // A constant part that naga folds and finds out of range.
            continue;
        }
        let args = floats(&[chance.floats(ROWS), chance.floats(ROWS), chance.floats(ROWS)]);
        check(&text, &args, seed + round, &mut seen);
    }
    println!(
        "{} rows, {} bounded, {} ambiguous, {:.3} used",
        seen.rows, seen.bounded, seen.ambiguous, seen.used
    );
    assert!(
        seen.rows > 50_000 && seen.bounded * 10 > seen.rows,
        "too few bounds: {} of {}",
        seen.bounded,
        seen.rows
    );
    assert!(seen.ambiguous > 1000, "too few ambiguous rows: {}", seen.ambiguous);
    assert!(seen.used > 0.9, "the drivers are too tame: {}", seen.used);
}

#[test]
fn near_equal_operands_are_joined_soundly() {
    let text = "fn f(a: f32, b: f32, c: f32) -> f32 {
        let x = a * b / c;
        let y = a / c * b;
        var r = x;
        if x < y { r = x * 2.0 - y; if x + c < y + c { return r * 3.0; } } else if x == y { r = 7.0; }
        if r > y { r += sqrt(abs(y)); }
        return r + y;
    }";
    let mut chance = Chance(5);
    let args = floats(&[chance.floats(5000), chance.floats(5000), chance.floats(5000)]);
    let mut seen = Seen::default();
    check(text, &args, 5, &mut seen);
    assert!(seen.ambiguous > 2000 && seen.bounded > 2000);
}

/// A call of each function of floats, of `a` and `b`.
pub(crate) const CALLS: &[&str] = &[
    "sqrt(a)",
    "inverseSqrt(a)",
    "exp(a)",
    "exp2(a)",
    "log(a)",
    "log2(a)",
    "sin(a)",
    "cos(a)",
    "tan(a)",
    "asin(a)",
    "acos(a)",
    "atan(a)",
    "sinh(a)",
    "cosh(a)",
    "tanh(a)",
    "asinh(a)",
    "acosh(a)",
    "atanh(a)",
    "floor(a)",
    "ceil(a)",
    "round(a)",
    "trunc(a)",
    "fract(a)",
    "sign(a)",
    "saturate(a)",
    "degrees(a)",
    "radians(a)",
    "abs(a)",
    "-a",
    "a + b",
    "a - b",
    "a * b",
    "a / b",
    "a % b",
    "pow(a, b)",
    "atan2(a, b)",
    "step(a, b)",
    "min(a, b)",
    "max(a, b)",
    "fma(a, b, a)",
    "mix(a, b, 0.3)",
    "smoothstep(a, b, 0.7)",
    "clamp(a, b, 1.0)",
    "length(a)",
    "distance(a, b)",
    "dot(vec2(a, b), vec2(b, 0.1))",
    "distance(vec2(a, b), vec2(b, a))",
    "normalize(vec2(a, b)).x",
    "cross(vec3(a, b, 1.0), vec3(b, 0.3, a)).x",
    "reflect(vec2(a, b), vec2(0.6, 0.8)).y",
    "refract(vec2(a, b), vec2(0.6, 0.8), 1.3).y",
    "faceForward(vec2(a, b), vec2(b, a), vec2(1.0, -1.0)).x",
];

#[test]
fn every_function_is_sound_near_its_critical_points() {
    let points = [
        0.0,
        1.0,
        -1.0,
        0.5,
        2.0,
        -2.0,
        std::f32::consts::PI,
        std::f32::consts::FRAC_PI_2,
        1e-38,
        88.0,
        -87.0,
    ];
    let mut arguments = Vec::new();
    for p in points {
        for step in -20..=20 {
            arguments.push(f32::from_bits(p.to_bits().saturating_add_signed(step)));
            arguments.push(p + step as f32 * 1e-5);
        }
    }
    let others: Vec<f32> = arguments.iter().rev().copied().collect();
    let mut seen = Seen::default();
    for call in CALLS {
        // The argument as it is, and as an inexact number.
        for wrap in ["x", "x * 1.1 * 0.9090909"] {
            let text = format!("fn f(x: f32, b: f32) -> f32 {{ let a = {wrap}; return {call}; }}");
            check(&text, &floats(&[arguments.clone(), others.clone()]), 77, &mut seen);
        }
    }
    assert!(seen.bounded * 2 > seen.rows);
}

#[test]
fn known_integers_are_the_same_on_every_driver() {
    let text = "fn f(a: f32, b: f32) -> vec4<u32> {
        let x = a * 1.1 + b;
        let i = i32(floor(x));
        return vec4(u32(i), u32(x > b), bitcast<u32>(x), u32(i) * 3u + u32(a < 1.0));
    }";
    let mut chance = Chance(9);
    check(text, &floats(&[chance.floats(3000), chance.floats(3000)]), 9, &mut Seen::default());
}

#[test]
fn loops_of_sure_length_keep_their_bound() {
    let text = "fn f(a: f32, n: u32) -> f32 {
        var sum = 0.0;
        for (var i = 0u; i < n; i++) { if i % 3u == 2u { continue; } sum = sum * 0.9 + a; }
        return sum;
    }";
    let mut chance = Chance(3);
    let mut args = floats(&[chance.floats(1000)]);
    args.columns.push(columns(&[(0..1000).map(|i| i % 40).collect()]).columns.remove(0));
    let mut seen = Seen::default();
    check(text, &args, 3, &mut seen);
    assert_eq!(seen.bounded, seen.rows);
    let module = module(text);
    let shadow =
        Interpreter::new(&module).unwrap().shadow(module.function("f").unwrap(), &args, None).unwrap();
    let (_, exact, bound) = float_column(&shadow, 0);
    assert!(exact.iter().zip(bound).all(|(e, b)| *b <= 1e-5 * e.abs() + 1e-36));
}
