//! What the shadow lane promises, on cases whose answer is known.

use crate::support::{columns, float_column, floats, module, shadow};
use lobe_backends::interp::{Interpreter, ShadowColumn};
use lobe_codegen::data::Columns;

const ULP: f64 = 1.0 / (1 << 23) as f64;

fn one(text: &str, args: &[f32]) -> (f32, f64, f64) {
    let out = shadow(text, &floats(&args.iter().map(|x| vec![*x]).collect::<Vec<_>>()));
    let (value, exact, bound) = float_column(&out, 0);
    (value[0], exact[0], bound[0])
}

#[test]
fn what_is_representable_is_exact() {
    let (value, exact, bound) =
        one("fn f(a: f32, b: f32) -> f32 { return (a + b) * 4.0 - min(a, 1.0); }", &[3.0, 0.5]);
    assert_eq!((value, exact, bound), (13.0, 13.0, 0.0));
}

#[test]
fn one_rounding_costs_at_most_one_ulp() {
    let (_, exact, bound) = one("fn f(a: f32, b: f32) -> f32 { return a * b; }", &[1.1, 1.3]);
    assert!(bound > 0.0 && bound <= ULP * exact, "{bound}");
}

#[test]
fn division_costs_two_and_a_half_ulp_and_needs_an_ordinary_divisor() {
    let text = "fn f(a: f32, b: f32) -> f32 { return a / b; }";
    let (_, exact, bound) = one(text, &[1.0, 3.0]);
    assert!((2.49..2.51).contains(&(bound / exact / ULP)));
    for divisor in [0.0, 1e-39, 1.0e38] {
        assert_eq!(one(text, &[1.0, divisor]).2, f64::INFINITY, "{divisor}");
    }
}

/// The length of a number may be the root of its square, which leaves the range sooner.
#[test]
fn the_length_of_a_number_has_the_bound_of_a_root() {
    let text = "fn f(a: f32) -> f32 { return length(a); }";
    let (value, exact, bound) = one(text, &[-3.0]);
    assert!((value, exact) == (3.0, 3.0) && bound > 0.0 && bound < 20.0 * ULP, "{bound}");
    assert_eq!(one(text, &[-3e19]), (3e19, f64::from(3e19_f32), f64::INFINITY));
}

#[test]
fn cancellation_shows_in_the_bound() {
    let (_, exact, bound) =
        one("fn f(a: f32) -> f32 { return (a + 1.0) * (a - 1.0) - a * a + 1.0; }", &[1234.567]);
    assert!(bound > 0.05 && bound < 1.0 && exact.abs() < 1e-6, "{exact} {bound}");
}

#[test]
fn an_error_that_two_operands_share_cancels() {
    let (_, exact, bound) = one("fn f(x: f32) -> f32 { let e = exp(x); return (e + 1.0) - e; }", &[8.0]);
    // Of the sum's and the difference's rounding, not of the 19 ULP that the exponential may be off.
    assert!((exact - 1.0).abs() < 1e-9 && bound < 3.0 * ULP * 2981.0, "{bound}");
}

#[test]
fn a_newton_step_forgives_its_start() {
    let start = "let y = exp(-0.5 * log(x));";
    let (_, exact, before) = one(&format!("fn f(x: f32) -> f32 {{ {start} return y; }}"), &[1234.5]);
    let step = "return y * (1.5 - 0.5 * x * y * y);";
    let (_, _, after) = one(&format!("fn f(x: f32) -> f32 {{ {start} {step} }}"), &[1234.5]);
    assert!(before > 20.0 * ULP * exact && after < 5.0 * ULP * exact, "{before} {after} {exact}");
}

#[test]
fn a_product_may_be_fused_into_one_sum_and_rounded_in_another() {
    let (_, exact, bound) = one("fn f(a: f32) -> f32 { let p = a * 0.1; return p - p; }", &[1.1]);
    assert!(exact == 0.0 && bound >= 0.1 * ULP / 4.0, "{bound}");
    let (_, _, bound) = one("fn f(a: f32) -> f32 { let p = exp(a); return p - p; }", &[1.0]);
    assert!(bound < 1e-12, "{bound}");
}

#[test]
fn a_difference_decides_where_its_operands_overlap() {
    // `e` is off by far more than a hundredth, in both operands alike.
    let text = "fn f(x: f32) -> f32 { let e = exp(x); return select(1.0, 2.0, e < e + 0.01); }";
    assert_eq!(one(text, &[9.0]).2, 0.0);
    let (_, exact, bound) =
        one("fn f(x: f32) -> f32 { let e = exp(x); return 1.0 / (e + 0.05 - e); }", &[9.0]);
    assert!((exact - 20.0).abs() < 1e-3 && bound < 1.0, "{exact} {bound}");
}

#[test]
fn expm1_over_x_by_higham_has_no_useful_bound_near_zero() {
    let text = "fn f(x: f32) -> f32 { let u = exp(x); return (u - 1.0) / log(u); }";
    // What the logarithm's absolute error leaves, and nothing above: the errors of the exponential cancel.
    for x in [1e-3, -1e-3, 1e-5] {
        let (_, exact, bound) = one(text, &[x]);
        assert!((exact - 1.0).abs() < 1e-2);
        let least = 2_f64.powi(-21) / f64::from(x.abs());
        assert!(bound > 0.99 * least && bound < 1.3 * least, "{x}: {bound}, {least}");
    }
    assert!(one(text, &[1e-6]).2 > 1.0);
    assert_eq!(one(text, &[1e-7]).2, f64::INFINITY);
    let (_, exact, bound) = one(text, &[3.0]);
    assert!(bound < 1e-4 * exact, "{bound}");
}

#[test]
fn guarded_domains_keep_their_bound() {
    let root = "fn f(a: f32) -> f32 { return sqrt(max(0.0, 1.0 - a * a * 1.0000001)); }";
    assert!(one(root, &[1.0]).2 < 1e-3);
    let open = "fn f(a: f32) -> f32 { return sqrt(1.0 - a * a * 1.0000001); }";
    assert_eq!(one(open, &[1.0]).2, f64::INFINITY);
    let angle = "fn f(a: f32) -> f32 { return acos(clamp(a * 1.1, -1.0, 1.0)); }";
    assert!(one(angle, &[0.909_090_9]).2 < 2e-3);
}

#[test]
fn a_number_times_itself_is_not_negative() {
    let text = "fn f(a: f32, b: f32) -> f32 { let d = a * 1.1 - b; return sqrt(d * d); }";
    assert!(one(text, &[1.0, 1.1]).2 < 1e-6);
    let text = "fn f(a: f32, b: f32) -> f32 { return length(vec3(a * 1.1 - b, 0.0, 0.0)); }";
    assert!(one(text, &[1.0, 1.1]).2 < 1e-6);
}

#[test]
fn overflow_has_no_bound_and_nothing_after_it_has() {
    assert_eq!(one("fn f(a: f32) -> f32 { return saturate(a * a); }", &[1e30]).2, f64::INFINITY);
    assert_eq!(one("fn f(a: f32) -> f32 { return min(exp(a), 1.0); }", &[100.0]).2, f64::INFINITY);
    assert!(one("fn f(a: f32) -> f32 { return exp(a); }", &[-200.0]).2 < 1e-37);
}

#[test]
fn sine_is_promised_up_to_pi_only() {
    let text = "fn f(a: f32) -> f32 { return sin(a); }";
    assert!((one(text, &[std::f32::consts::PI]).2 - 1.0 / 2048.0).abs() < 1e-6);
    assert_eq!(one(text, &[3.2]).2, f64::INFINITY);
}

#[test]
fn a_near_equal_comparison_joins_both_sides() {
    let text = "fn f(a: f32, b: f32) -> f32 {
        var r = 0.0;
        if a * 1.1 / 1.0 < b { r = 10.0; } else { r = 20.0; }
        return r;
    }";
    let out = shadow(text, &floats(&[vec![1.3, 1.3, 1.3], vec![1.43, 2.0, 0.5]]));
    let (value, exact, bound) = float_column(&out, 0);
    assert_eq!(out.ambiguous, [true, false, false]);
    assert_eq!(bound, [10.0, 0.0, 0.0]);
    assert!([10.0, 20.0].contains(&value[0]) && [10.0, 20.0].contains(&exact[0]));
    assert_eq!((value[1], value[2]), (10.0, 20.0));
    assert_eq!(out.indeterminate, [false; 3]);
}

#[test]
fn a_select_joins_as_a_branch_does() {
    let text = "fn f(a: f32, b: f32) -> f32 { return select(20.0, 10.0, a * 1.1 / 1.0 < b); }";
    let out = shadow(text, &floats(&[vec![1.3, 1.3], vec![1.43, 2.0]]));
    assert_eq!(float_column(&out, 0).2, [10.0, 0.0]);
    assert_eq!(out.ambiguous, [true, false]);
}

#[test]
fn a_return_on_one_side_waits_for_the_other() {
    let text = "fn f(a: f32, b: f32, c: f32) -> f32 {
        var x = 1.0;
        if a * 1.1 / 1.0 < b { return 5.0; }
        x = 2.0;
        if a * 1.1 / 1.0 < c { x = 7.0; if a < 0.5 { return 100.0; } }
        return x;
    }";
    let out = shadow(text, &floats(&[vec![1.3, 1.3, 1.3], vec![1.43, 1.43, 2.0], vec![1.43, 0.0, 1.43]]));
    let (_, exact, bound) = float_column(&out, 0);
    // Row 0 may return 5, 7 or 2; row 1 returns 5 or 2; row 2 surely 5.
    let holds = |row: usize, x: f64| (x - exact[row]).abs() <= bound[row];
    assert!([5.0, 7.0, 2.0].iter().all(|x| holds(0, *x)) && !holds(0, 100.0));
    assert!([5.0, 2.0].iter().all(|x| holds(1, *x)) && bound[1] == 3.0);
    assert_eq!((exact[2], bound[2]), (5.0, 0.0));
    assert_eq!(out.ambiguous, [true, true, false]);
}

#[test]
fn an_ambiguous_side_sees_the_state_before_the_branch() {
    let text = "fn f(a: f32, b: f32) -> f32 {
        var x = 1.0;
        if a * 1.1 / 1.0 < b { x += 1.0; } else { x += 2.0; }
        return x;
    }";
    let out = shadow(text, &floats(&[vec![1.3], vec![1.43]]));
    let (_, exact, bound) = float_column(&out, 0);
    assert!([2.0, 3.0].contains(&exact[0]) && bound[0] == 1.0);
}

#[test]
fn a_switch_on_an_unknown_integer_joins_all_cases() {
    let text = "fn f(a: f32) -> f32 {
        switch i32(a * 1.1) { case 0: { return 1.0; } case 1: { return 4.0; } default: { return 6.0; } }
    }";
    let out = shadow(text, &floats(&[vec![0.909_090_9, 0.5]]));
    let (_, exact, bound) = float_column(&out, 0);
    assert!((1.0 - exact[0]).abs() <= bound[0] && (6.0 - exact[0]).abs() <= bound[0]);
    assert_eq!((exact[1], bound[1]), (1.0, 0.0));
}

#[test]
fn an_ambiguous_exit_of_a_loop_is_indeterminate() {
    let text = "fn f(a: f32, n: f32) -> f32 {
        var x = 0.0;
        loop { if x >= n { break; } x += a; }
        return x;
    }";
    let out = shadow(text, &floats(&[vec![0.1, 0.25], vec![1.0, 1.0]]));
    assert_eq!(out.indeterminate, [true, false]);
    assert_eq!(float_column(&out, 0).2, [f64::INFINITY, 0.0]);
}

#[test]
fn bits_of_inexact_numbers_are_unknown() {
    let text = "fn f(a: f32, b: f32) -> u32 { return bitcast<u32>(a + b) >> 1u; }";
    let out = shadow(text, &floats(&[vec![1.0, 1.0], vec![2.0, 0.1]]));
    assert!(matches!(&out.columns[0], ShadowColumn::Word { known, .. } if known == &[true, false]));
    let text = "fn f(a: f32, b: f32) -> f32 { return f32(bitcast<u32>(a + b)); }";
    let out = shadow(text, &floats(&[vec![1.0, 1.0], vec![2.0, 0.1]]));
    assert_eq!(out.indeterminate, [false, true]);
}

#[test]
fn whole_parts_are_known_away_from_whole_numbers() {
    let text = "fn f(a: f32) -> i32 { return i32(floor(a * 1.1)); }";
    let out = shadow(text, &floats(&[vec![0.5, 0.909_090_9]]));
    assert!(matches!(&out.columns[0], ShadowColumn::Word { known, .. } if known == &[true, false]));
}

#[test]
fn an_unknown_index_is_indeterminate() {
    let text = "fn f(a: f32) -> f32 { var t = array<f32, 3>(1.0, 2.0, 3.0); return t[i32(a * 1.1)]; }";
    let out = shadow(text, &floats(&[vec![0.5, 0.909_090_9]]));
    assert_eq!(out.indeterminate, [false, true]);
}

#[test]
fn sure_operands_settle_logic() {
    let text = "fn f(a: f32, b: f32) -> u32 { return u32((a * 1.1 / 1.0 < b) & (a > 5.0)) + u32((a * 1.1 < b) | (a < 5.0)); }";
    let out = shadow(text, &floats(&[vec![1.3], vec![1.43]]));
    assert!(matches!(&out.columns[0], ShadowColumn::Word { known, value } if known[0] && value[0] == 1));
}

#[test]
fn flushing_makes_subnormal_numbers_uncertain() {
    let text = "fn f(a: f32) -> f32 { return select(0.0, 1.0, a > 0.0); }";
    let out = shadow(text, &floats(&[vec![1e-40, 1e-37]]));
    assert_eq!(out.ambiguous, [true, false]);
}

#[test]
fn exact_arguments_bring_their_error() {
    let module = module("fn f(a: f32) -> f32 { return a * 2.0; }");
    let interpreter = Interpreter::new(&module).unwrap();
    let args = floats(&[vec![0.1]]);
    let out = interpreter.shadow(module.function("f").unwrap(), &args, Some(&[vec![0.1]])).unwrap();
    let (value, exact, bound) = float_column(&out, 0);
    assert_eq!((value[0], exact[0]), (0.2, 0.2));
    assert!(bound[0] >= f64::from(0.2_f32) - 0.2 && bound[0] < 0.2 * ULP, "{}", bound[0]);
}

#[test]
fn integers_are_known_and_rows_without_floats_have_no_bound() {
    let out = shadow("fn f(a: u32) -> u32 { return a * 3u + u32(a > 2u); }", &columns(&[vec![1, 5]]));
    assert_eq!(out.columns, [ShadowColumn::Word { value: vec![3, 16], known: vec![true, true] }]);
    let none = shadow("fn f(a: f32) -> f32 { return a; }", &Columns::zeros(1, 0));
    assert_eq!((none.rows, none.columns.len()), (0, 1));
}
