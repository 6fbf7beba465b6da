//! Control flow: every lane goes its own way.

use crate::support::{call, columns, module, word};
use lobe_backends::interp::{Buffer, InterpError, Interpreter};
use lobe_codegen::foreign::{self, Language, Source};

fn rows(text: &str, native: impl Fn(u32) -> u32) {
    let args: Vec<u32> = (0..700).collect();
    let got = call(text, &columns(std::slice::from_ref(&args)));
    for (a, got) in args.iter().zip(&got.columns[0]) {
        assert_eq!(*got, native(*a), "{text}\nof {a}");
    }
}

/// What is computed before another variable takes the old value must not be in its place too early.
#[test]
fn variables_of_a_loop_swap() {
    for (body, step) in [
        ("let t = y; y = x; x = t;", (|x, y| (y, x)) as fn(u32, u32) -> (u32, u32)),
        ("y = x; x = 7u - (y + y);", |x, _| (7u32.wrapping_sub(x.wrapping_add(x)), x)),
        ("let t = x + y; x = y; y = t;", |x, y| (y, x.wrapping_add(y))),
    ] {
        let text = format!(
            "fn f(a: u32) -> u32 {{
                var x = a; var y = a * 5u;
                for (var i = 0u; i < 3u; i++) {{ {body} }}
                return x ^ (y << 16u);
            }}"
        );
        rows(&text, |a| {
            let (x, y) = (0..3).fold((a, a * 5), |(x, y), _| step(x, y));
            x ^ y << 16
        });
    }
}

#[test]
fn early_returns_mask_the_rest() {
    rows(
        "fn f(a: u32) -> u32 {
            var x = a;
            if a % 3u == 0u { if a % 2u == 0u { return 7u; } x += 1u; } else if a % 5u == 0u { return x; }
            x *= 2u;
            return x;
        }",
        |a| match a {
            a if a % 6 == 0 => 7,
            a if a % 3 == 0 => (a + 1) * 2,
            a if a % 5 == 0 => a,
            a => a * 2,
        },
    );
}

#[test]
fn nested_loops_break_continue_and_return() {
    rows(
        "fn f(a: u32) -> u32 {
            var sum = 0u;
            for (var i = 0u; i < a % 17u; i++) {
                if i % 3u == 1u { continue; }
                var j = 0u;
                loop {
                    if j > i { break; }
                    if sum > 90u { return sum + 1000u; }
                    j++;
                    if j % 2u == 0u { continue; }
                    sum += j;
                    continuing { sum += 1u; break if sum == 40u; }
                }
                if i == 11u { break; }
            }
            return sum;
        }",
        |a| {
            let mut sum = 0;
            for i in 0..a % 17 {
                if i % 3 == 1 {
                    continue;
                }
                let mut j = 0;
                loop {
                    if j > i {
                        break;
                    }
                    if sum > 90 {
                        return sum + 1000;
                    }
                    j += 1;
                    if j % 2 != 0 {
                        sum += j;
                    }
                    sum += 1;
                    if sum == 40 {
                        break;
                    }
                }
                if i == 11 {
                    break;
                }
            }
            sum
        },
    );
}

#[test]
fn switches_choose_one_case() {
    rows(
        "fn f(a: u32) -> u32 {
            var x = 0u;
            switch a % 7u {
                case 0u: { x = 10u; }
                case 1u, 4u: { if a > 100u { break; } x = 20u; }
                case 2u: { return 5u; }
                default: { x = 30u; }
            }
            return x + 1u;
        }",
        |a| match a % 7 {
            0 => 11,
            1 | 4 if a > 100 => 1,
            1 | 4 => 21,
            2 => 5,
            _ => 31,
        },
    );
}

#[test]
fn a_switch_in_a_loop_continues_the_loop() {
    rows(
        "fn f(a: u32) -> u32 {
            var x = 0u;
            for (var i = 0u; i < 6u; i++) {
                switch (a + i) % 3u { case 0u: { continue; } case 1u: { x += 1u; } default: { break; } }
                x += 10u;
            }
            return x;
        }",
        |a| (0..6).map(|i| [0, 11, 10][(a as usize + i) % 3]).sum(),
    );
}

#[test]
fn calls_return_to_their_lanes_and_write_through_pointers() {
    rows(
        "fn bump(p: ptr<function, u32>, by: u32) -> u32 { if by > 3u { return 0u; } *p += by; return *p; }
        fn f(a: u32) -> u32 {
            var x = a;
            var y = 0u;
            if a % 2u == 0u { y = bump(&x, a % 8u); }
            return x * 1000u + y;
        }",
        |a| {
            let by = a % 8;
            let x = if a % 2 == 0 && by <= 3 { a + by } else { a };
            x * 1000 + if a % 2 == 0 && by <= 3 { x } else { 0 }
        },
    );
}

#[test]
fn private_variables_live_for_the_call() {
    rows(
        "var<private> total: u32 = 5u;
        fn add(x: u32) { total += x; }
        fn f(a: u32) -> u32 { if a > 3u { add(a); } add(1u); return total; }",
        |a| if a > 3 { a + 6 } else { 6 },
    );
}

#[test]
fn an_endless_loop_runs_out_of_fuel() {
    let module =
        module("fn f(a: u32) -> u32 { var x = a; loop { x += 1u; if x == a { break; } } return x; }");
    let interpreter = Interpreter::new(&module).unwrap().with_fuel(1000);
    let result = interpreter.call(module.function("f").unwrap(), &columns(&[vec![1]]));
    assert_eq!(result, Err(InterpError::OutOfFuel { function: "f".to_owned() }));
}

#[test]
fn arguments_that_do_not_fit_are_refused() {
    let module = module("fn f(a: vec2<u32>) -> u32 { return a.x; }");
    let interpreter = Interpreter::new(&module).unwrap();
    let result = interpreter.call(module.function("f").unwrap(), &columns(&[vec![1]]));
    assert!(matches!(result, Err(InterpError::Arguments { expected: 2, found: 1, .. })));
}

#[test]
fn what_is_not_supported_is_named_with_its_function() {
    let module = module("fn f(a: f32) -> f32 { return dpdx(a); }");
    let interpreter = Interpreter::new(&module).unwrap();
    let error = interpreter.call(module.function("f").unwrap(), &columns(&[vec![1]])).unwrap_err();
    assert!(error.to_string().contains("Derivative") && error.to_string().contains("`f`"), "{error}");
}

#[test]
fn selections_are_per_component() {
    assert_eq!(
        word(
            "fn f(a: u32) -> u32 { let v = select(vec2(1u, 2u), vec2(10u, 20u), vec2(a > 1u, a > 5u)); return v.x + v.y; }",
            &[3]
        ),
        12
    );
}

/// Variables of a loop that take each other's values at once, early, late and in nested rounds.
#[test]
fn variables_of_a_loop_change_places() {
    let bodies = [
        "let t = a; a = b; b = t;",
        "let t = a; a = b; b = c; c = t;",
        "let t = a * 2.0; a = a + 1.0; b = t + b;",
        "let t = a * 2.0; if i % 3u == x { a = b; b = t; continue; } b = t - b; a = b * t + c;",
        "let t = a; if i == x { break; } a = b; if i % 2u == 1u { b = t; } else { b = c; c = t; }",
        "for (var j = 0u; j < x; j++) { let t = a; a = b + 0.5; b = t; if j > 2u { break; } } c = a - b * c;",
        "switch i % 4u { case 0u: { a = b; } case 1u, 2u: { let t = b; b = a; a = t; } default: { continue; } }",
    ];
    let rows: Vec<u32> = (0..300).map(|i| i % 7).collect();
    let numbers: Vec<u32> = (0..300).map(|i| (i as f32 * 0.37 - 20.0).to_bits()).collect();
    for body in bodies {
        let text = format!(
            "fn f(x: u32, y: f32) -> vec3<f32> {{
                var a = y; var b = 2.0; var c = 3.0;
                for (var i = 0u; i < x + 3u; i++) {{ {body} }}
                return vec3(a, b, c);
            }}"
        );
        call(&text, &columns(&[rows.clone(), numbers.clone()]));
    }
}

#[test]
fn cases_without_a_break_run_into_the_next() {
    let glsl = "#version 450
        layout(local_size_x = 8) in;
        layout(set = 0, binding = 0) buffer Out { int v[]; };
        void main() {
            int r = 1;
            switch (int(gl_LocalInvocationIndex)) {
                case 0: r += 10;
                case 1: r *= 3;
                case 2: if (r > 20) { r -= 7; break; } r += 100; break;
                case 5:
                case 6: r = 55;
                default: r -= 1;
                case 3: r *= 2;
            }
            v[gl_LocalInvocationIndex] = r;
        }";
    let source = Source { name: "cases.comp".to_owned(), language: Language::Glsl, bytes: glsl.into() };
    let module = foreign::read(&source).unwrap();
    let mut buffers = [Buffer { group: 0, binding: 0, data: vec![0; 32] }];
    Interpreter::new(&module).unwrap().run(0, [1, 1, 1], buffers.as_mut_slice()).unwrap();
    let got: Vec<i32> = buffers[0].data.as_chunks().0.iter().map(|c| i32::from_le_bytes(*c)).collect();
    // (1 + 10) * 3 - 7, 1 * 3 + 100, 1 + 100, 1 * 2, (1 - 1) * 2, (55 - 1) * 2 twice, (1 - 1) * 2
    assert_eq!(got, [26, 103, 101, 2, 0, 108, 108, 0]);
}

#[test]
fn what_no_round_changes_is_computed_before_the_loop_and_what_one_changes_is_not() {
    rows(
        "fn f(a: u32) -> u32 {
            var scale = a % 5u;
            var sum = 0u;
            for (var i = 0u; i < a % 7u; i++) {
                let same = (a ^ 3u) % 11u;
                let changing = scale * 3u + same;
                for (var j = 0u; j < i; j++) { sum += changing ^ (i << 1u); }
                if i == 3u { scale += same; }
                sum += changing;
            }
            return sum;
        }",
        |a| {
            let (mut scale, mut sum) = (a % 5, 0u32);
            for i in 0..a % 7 {
                let same = (a ^ 3) % 11;
                let changing = scale * 3 + same;
                sum += (changing ^ (i << 1)) * i;
                if i == 3 {
                    scale += same;
                }
                sum += changing;
            }
            sum
        },
    );
}

/// A loop whose counter decides by `comparison`, in `ty`, from `from` by `step`.
fn counted(comparison: &str, ty: &str, [from, step, to]: [i32; 3]) -> String {
    format!(
        "fn f(a: u32) -> u32 {{
            var rounds = a;
            for (var i = {ty}({from}); i {comparison} {ty}({to}); i += {ty}({step})) {{ rounds += 1u; }}
            return rounds;
        }}"
    )
}

#[test]
fn loops_end_by_every_comparison() {
    for ty in ["i32", "u32", "f32"] {
        for (comparison, counts, rounds) in [
            ("<", [0, 3, 10], 4),
            ("<=", [0, 3, 9], 4),
            (">", [20, -3, 10], 4),
            (">=", [20, -3, 11], 4),
            ("!=", [4, 2, 12], 4),
            ("==", [4, 2, 4], 1),
            ("<", [10, 1, 10], 0),
        ] {
            if ty != "u32" || counts[1] > 0 {
                rows(&counted(comparison, ty, counts), |a| a + rounds);
            }
        }
    }
}

#[test]
fn sums_of_products_of_three_round_each_time() {
    rows(
        "fn f(a: u32) -> u32 {
            let x = f32(a) * 0.37 + 0.1;
            var sum = 0.3;
            var other = 1.0;
            for (var i = 0u; i < 9u; i++) {
                let y = f32(i) + 0.7;
                sum = sum + x * 1.1 * y;
                other = other + x * other * y;
                other = x * sum * x + other;
            }
            return bitcast<u32>(sum) ^ bitcast<u32>(other);
        }",
        |a| {
            let x = a as f32 * 0.37 + 0.1;
            let (mut sum, mut other) = (0.3f32, 1.0f32);
            for i in 0..9 {
                let y = i as f32 + 0.7;
                sum += x * 1.1 * y;
                other += x * other * y;
                other += x * sum * x;
            }
            sum.to_bits() ^ other.to_bits()
        },
    );
}
