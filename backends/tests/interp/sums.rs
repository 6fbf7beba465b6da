//! Sums in any order: what the bound allows, and what it need not.

use crate::support::{float_column, floats, shadow};

const ULP: f64 = 1.0 / (1 << 23) as f64;

/// Exact value and bound of a function of a, b, c and d.
fn bound(expression: &str, args: [f32; 4]) -> (f64, f64) {
    let text = format!("fn f(a: f32, b: f32, c: f32, d: f32) -> f32 {{ {expression} }}");
    let out = shadow(&text, &floats(&args.map(|x| vec![x])));
    let (_, exact, bound) = float_column(&out, 0);
    (exact[0], bound[0])
}

#[test]
fn a_bound_holds_for_each_order_of_the_terms() {
    for (expression, args, least) in [
        // As written it is exact; as a + (b + c) the small term drowns.
        ("return (a + b) + c;", [1e8, -1e8, 1.25e-3, 0.0], 1.25e-3),
        ("return c - (a - b);", [1e8, 1e8, 1.25e-3, 0.0], 1.25e-3),
        ("let s = a + b; let t = c + d; return s + t;", [1e8, -1e8, 1.25e-3, 2.5e-3], 3.75e-3),
        // The sum of a sum that is zero still has its terms.
        ("var s = 0.0; s += a; s += b; s += c; return s;", [1e8, -1e8, 1.25e-3, 0.0], 1.25e-3),
        ("return -(a + b) + c;", [1e8, -1e8, 1.25e-3, 0.0], 1.25e-3),
        ("return dot(vec3(a, b, c), vec3(d));", [1e8, -1e8, 1.25e-3, 1.0], 1.25e-3),
    ] {
        let (exact, bound) = bound(expression, args);
        assert!(bound >= least && bound <= 8.0 * ULP * 1e8, "{expression}: {exact} ± {bound}");
    }
}

#[test]
fn what_keeps_the_order_keeps_the_bound() {
    for (expression, args) in [
        ("return max(a + b, 0.0) + c;", [1e8, -1e8, 1.1e-3, 0.0]),
        ("return (a + b) * d + c;", [1e8, -1e8, 1.1e-3, 1.0]),
    ] {
        let (exact, bound) = bound(expression, args);
        assert!(bound <= ULP * exact, "{expression}: {exact} ± {bound}");
    }
}

#[test]
fn sums_that_no_order_rounds_are_exact() {
    for (expression, args) in [
        ("return (a + b) + c;", [1.0, 0.25, -3.5, 0.0]),
        ("return a + b + c + d;", [4096.0, 0.5, -4095.5, 2.0]),
        ("var s = 0.0; for (var i = 0; i < 64; i++) { s += a; } return s;", [0.25, 0.0, 0.0, 0.0]),
    ] {
        assert_eq!(bound(expression, args).1, 0.0, "{expression}");
    }
    // One bit more than the format has.
    assert!(bound("return (a + b) + c;", [16_777_216.0, -16_777_216.0, 1.5, 0.0]).1 > 0.0);
}

#[test]
fn terms_of_one_sign_have_a_sum_of_that_sign() {
    let squares = "return sqrt(a * a + b * b + c * c);";
    assert!(bound(squares, [1e-12, 1e-12, 0.0, 0.0]).1.is_finite());
    let (exact, bound) = bound(squares, [0.6, 0.7, 0.8, 0.0]);
    assert!(bound <= 6.5 * ULP * exact, "{exact} ± {bound}");
}

#[test]
fn a_long_sum_of_one_sign_errs_by_its_length_at_most() {
    let text = "var s = 0.0; for (var i = 0; i < 100; i++) { s += a; } return s;";
    let (exact, bound) = bound(text, [0.1, 0.0, 0.0, 0.0]);
    assert!(bound >= 30.0 * ULP * exact && bound <= 101.0 * ULP * exact, "{exact} ± {bound}");
}
