//! Floats of 16 and 64 bits: no permitted driver leaves their bounds, and the bounds are of the size of what is promised.

use crate::soundness::{CALLS, Seen, check, kernel};
use crate::support::{Chance, float_column, floats, foreign};
use lobe_backends::interp::{Buffer, Interpreter, ShadowColumns, ShadowFloat};
use lobe_codegen::accuracy::Model;
use lobe_codegen::validate;

const ROWS: usize = 300;

/// A function of f32 that does its work in another width.
fn widened(kernel: &str, width: &str) -> String {
    let inner = kernel.replace("fn f(", "fn g(").replace("f32", width);
    format!(
        "enable f16;
        {inner}
        fn f(a: f32, b: f32, c: f32) -> f32 {{ return f32(g({width}(a), {width}(b), {width}(c))); }}"
    )
}

fn shadow(text: &str, args: &[f32], model: &str) -> ShadowColumns {
    let module = foreign(text);
    let model = Model::named(model).expect("a model");
    let interpreter = Interpreter::new(&module).unwrap().with_accuracy(model);
    let args = floats(&args.iter().map(|x| vec![*x]).collect::<Vec<_>>());
    interpreter.shadow(module.function("f").unwrap(), &args, None).unwrap()
}

/// Exact value and bound of `expression` in `a`, `b` and `c`, which are of `width`.
fn bound(width: &str, expression: &str, args: [f32; 3]) -> (f64, f64) {
    let text = widened(&format!("fn f(a: f32, b: f32, c: f32) -> f32 {{ return {expression}; }}"), width);
    let shadow = shadow(&text, &args, "portable");
    let (_, exact, bound) = float_column(&shadow, 0);
    (exact[0], bound[0])
}

fn check_width(width: &str, least: usize, used: f64) {
    let mut seen = Seen::default();
    for round in 0..250 {
        let mut chance = Chance(0xf10a7 + round);
        let text = widened(&kernel(&mut chance), width);
        if validate::foreign_wgsl(&text).is_err() {
            continue; // A constant part that naga folds and finds out of range, or no function of this width.
        }
        let args = floats(&[chance.floats(ROWS), chance.floats(ROWS), chance.floats(ROWS)]);
        check(&text, &args, 0xf10a7 + round, &mut seen);
    }
    println!(
        "{width}: {} rows, {} bounded, {} ambiguous, {:.3} used",
        seen.rows, seen.bounded, seen.ambiguous, seen.used
    );
    assert!(seen.rows > least && seen.bounded * 10 > seen.rows && seen.ambiguous > least / 100);
    assert!(seen.used > used, "the drivers are too tame: {}", seen.used);
}

#[test]
fn chance_drivers_stay_within_the_bounds_of_halves() {
    check_width("f16", 30_000, 0.9);
}

#[test]
fn chance_drivers_stay_within_the_bounds_of_doubles() {
    check_width("f64", 5_000, 0.9);
}

#[test]
fn every_function_of_halves_is_sound_near_its_critical_points() {
    let points =
        [0.0, 1.0, -1.0, 0.5, 2.0, -2.0, 3.140_625, 1.570_312_5, 6.1e-5, 6e-8, 11.0, -10.5, 256.0, 65000.0];
    let mut arguments = Vec::new();
    for p in points {
        let p = half::f16::from_f32(p).to_bits();
        arguments
            .extend((-12_i16..=12).map(|step| half::f16::from_bits(p.saturating_add_signed(step)).to_f32()));
    }
    let others: Vec<f32> = arguments.iter().rev().copied().collect();
    let of_halves = [
        "f16(i32(a)) + f16(u32(b))",
        "f16(f32(a) * 1.1)",
        "f16(f32(a * b) * f32(b))",
        "select(a, b, a * 1.1 < b)",
        "select(b, a, bool(a))",
    ];
    let mut seen = Seen::default();
    for call in CALLS.iter().chain(&of_halves) {
        for wrap in ["x", "x * 1.1 * 0.909"] {
            let text = format!(
                "enable f16;
                fn g(x: f16, b: f16) -> f16 {{ let a = {wrap}; return {call}; }}
                fn f(x: f32, b: f32) -> f32 {{ return f32(g(f16(x), f16(b))); }}"
            );
            check(&text, &floats(&[arguments.clone(), others.clone()]), 77, &mut seen);
        }
    }
    assert!(seen.bounded * 2 > seen.rows, "{} of {}", seen.bounded, seen.rows);
}

#[test]
fn bounds_are_of_the_size_of_what_is_promised() {
    let half = 2.0_f64.powi(-10);
    let single = 2.0_f64.powi(-23);
    // Expression, width, arguments, the least and the largest bound in ULP of the exact value.
    let cases = [
        ("a + b", "f16", [1.0, 0.001, 0.0], 0.5, 1.0),
        ("a * b", "f16", [1.5, 1.500_976_6, 0.0], 0.5, 1.0),
        ("a / b", "f16", [1.0, 3.0, 0.0], 2.5, 2.51),
        ("exp(a)", "f16", [2.0, 0.0, 0.0], 5.0, 5.01),
        ("inverseSqrt(a)", "f16", [2.0, 0.0, 0.0], 2.0, 2.01),
        ("sqrt(a)", "f16", [2.0, 0.0, 0.0], 4.5, 4.52),
        ("a + b", "f16", [1.0, 2.0, 0.0], 0.0, 0.0),
        ("a + b", "f64", [1.0, 1e-12, 0.0], 0.0, 1.0),
        ("a * b", "f64", [1.1, 1.1, 0.0], 0.5, 1.0),
        ("a / b", "f64", [1.0, 3.0, 0.0], 2.5, 2.51),
        ("sqrt(a)", "f64", [2.0, 0.0, 0.0], 4.5, 4.51),
        ("a + b", "f64", [1.0, 2.0, 0.0], 0.0, 0.0),
    ];
    for (expression, width, args, least, largest) in cases {
        let ulp = if width == "f16" { half } else { single };
        let (exact, bound) = bound(width, expression, args);
        let ulps = bound / (exact.abs() * ulp);
        // The result as f32 may round once more.
        let slack = if width == "f64" && largest > 0.0 { 1.0 } else { 0.0 };
        assert!((least..=largest + slack).contains(&ulps), "{expression} in {width}: {ulps} ULP");
    }
}

#[test]
fn what_no_format_holds_and_nothing_promises_has_no_bound() {
    for (expression, width, args) in [
        ("a * b", "f16", [300.0, 300.0, 0.0]),
        ("a + b", "f16", [65504.0, 65504.0, 0.0]),
        ("a / b", "f16", [1.0, 20000.0, 0.0]),
        ("sin(a)", "f16", [4.0, 0.0, 0.0]),
        ("a / b", "f64", [1.0, 0.0, 0.0]),
    ] {
        assert_eq!(bound(width, expression, args).1, f64::INFINITY, "{expression} in {width}");
    }
    let sum = |width| widened("fn f(a: f32, b: f32, c: f32) -> f32 { return a + b; }", width);
    for (width, model, is_bounded) in
        [("f16", "wgsl", true), ("f16", "hlsl", false), ("f64", "vulkan", true), ("f64", "wgsl", false)]
    {
        let shadow = shadow(&sum(width), &[1.0, 1.0 / 3.0, 0.0], model);
        assert_eq!(float_column(&shadow, 0).2[0].is_finite(), is_bounded, "{width} by {model}");
    }
}

/// What an entry point may leave of floats of 16 and 64 bits; what the interpreter and chance drivers leave is among it.
fn left(text: &str, buffers: &[Buffer]) -> Vec<ShadowFloat> {
    let module = foreign(text);
    let interpreter = Interpreter::new(&module).unwrap();
    let [shadow] =
        interpreter.shadow_run(0, [2, 1, 1], &mut buffers.to_vec()).unwrap().buffers.try_into().unwrap();
    for driver in 0..12 {
        let mut left = buffers.to_vec();
        match driver {
            0 => interpreter.run(0, [2, 1, 1], &mut left).unwrap(),
            seed => interpreter.perturbed_run(0, [2, 1, 1], &mut left, seed).unwrap(),
        }
        for float in &shadow.floats {
            let bytes = &left[1].data[float.at..float.at + float.bytes as usize];
            let found = match bytes {
                [a, b] => half::f16::from_le_bytes([*a, *b]).to_f64(),
                _ => f64::from_le_bytes(bytes.try_into().unwrap()),
            };
            let near = (found - float.exact).abs() <= float.bound || float.bound.is_infinite();
            assert!(near, "driver {driver}: {found:e} is not {float:?}\n{text}");
            assert!(driver > 0 || found == float.value, "{found:e} is not {float:?}");
        }
    }
    shadow.floats
}

#[test]
fn floats_of_other_widths_keep_their_bounds_in_memory() {
    let entry = |structure: &str, body: &str| {
        format!(
            "enable f16;
            {structure}
            @group(0) @binding(0) var<storage, read> a: array<f32>;
            @group(0) @binding(1) var<storage, read_write> b: array<S>;
            var<workgroup> w: array<S, 4>;
            @compute @workgroup_size(4)
            fn main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) l: u32) {{
                let i = id.x; let x = a[i] * 1.1;
                {body}
            }}"
        )
    };
    let halves = "struct S { p: f16, q: f16, r: vec3<f16>, n: u32 }";
    let doubles = "struct S { p: f64, q: vec2<f64>, n: u32 }";
    // Scalars that keep a bound, of those that were written.
    let cases = [
        (halves, "b[i].p = f16(x); b[i].q = f16(x) * 0.3h; b[i].n = 7u;", 16, 16),
        (halves, "w[l].r = vec3(f16(x)) / 3.0h; workgroupBarrier(); b[i].r = w[3u - l].r;", 24, 24),
        (halves, "b[i].p = f16(x); b[i].q = b[i].p + b[i].p;", 16, 16),
        // Half of a word is written by what may not happen.
        (halves, "b[i].p = 2.0h; if x * 0.9 < 1.1 * a[i] { b[i].p = f16(x); }", 8, 8),
        (halves, "b[u32(x * 0.1) % 2u].q = f16(i);", 1, 1),
        (doubles, "b[i].p = f64(x) / 3.0lf; b[i].q = vec2(f64(x), 0.1lf); b[i].n = 7u;", 24, 24),
        (doubles, "w[l].p = f64(x); workgroupBarrier(); b[i].p = w[3u - l].p * f64(a[i]);", 8, 8),
    ];
    let input: Vec<u8> = (0..8).flat_map(|i| (0.7 + 0.3 * i as f32).to_le_bytes()).collect();
    for (structure, body, written, bounded) in cases {
        let buffers =
            [(0, input.clone()), (1, vec![0; 512])].map(|(binding, data)| Buffer { group: 0, binding, data });
        let floats = left(&entry(structure, body), &buffers);
        let kept = floats.iter().filter(|f| f.bound.is_finite()).count();
        assert_eq!((floats.len(), kept), (written, bounded), "{body}");
    }
}
