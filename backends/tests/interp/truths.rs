//! What a module carries beside its IR: exact literals, and the functions that others approximate.

use crate::support::{float_column, floats};
use lobe_backends::interp::Interpreter;
use lobe_codegen::ValidModule;
use lobe_codegen::def::Truth;
use lobe_codegen::module::{Meta, Scope};
use lobe_codegen::validate::validate;
use naga::{Expression, Literal};

/// The module of `text`, with what `tell` adds.
fn module(text: &str, tell: impl Fn(&naga::Module, &mut Meta)) -> ValidModule {
    let module = naga::front::wgsl::parse_str(text).unwrap();
    let mut meta = Meta::default();
    tell(&module, &mut meta);
    validate(module, meta).unwrap()
}

fn one(module: &ValidModule, x: f32) -> (f32, f64, f64) {
    let f = module.function("f").unwrap();
    let out = Interpreter::new(module).unwrap().shadow(f, &floats(&[vec![x]]), None).unwrap();
    let (value, exact, bound) = float_column(&out, 0);
    (value[0], exact[0], bound[0])
}

#[test]
fn a_literal_is_what_its_decimal_text_states() {
    let tell = |module: &naga::Module, meta: &mut Meta| {
        for (handle, function) in module.functions.iter() {
            for (expression, kind) in function.expressions.iter() {
                if matches!(kind, Expression::Literal(Literal::F32(_))) {
                    meta.exact.insert((Scope::Function(handle), expression), 0.1);
                }
            }
        }
    };
    let module = module("fn f(x: f32) -> f32 { return x * 0.1; }", tell);
    let (value, exact, bound) = one(&module, 1.0);
    assert_eq!((value, exact), (0.1, 0.1));
    assert!(bound >= (f64::from(0.1_f32) - 0.1).abs() && bound < 1e-8);
}

#[test]
fn the_error_of_an_approximation_is_part_of_its_bound() {
    let text = "fn near_exp(x: f32) -> f32 { return 1.0 + x + 0.5 * x * x; }
        fn f(x: f32) -> f32 { return near_exp(x) * 2.0; }";
    let tell = |module: &naga::Module, meta: &mut Meta| {
        let near = module.functions.iter().find(|(_, f)| f.name.as_deref() == Some("near_exp")).unwrap().0;
        meta.truths.insert(near, Truth::Unary(f64::exp));
    };
    let (value, exact, bound) = one(&module(text, tell), 0.25);
    let error = 2.0 * (0.25_f64.exp() - 1.28125);
    assert_eq!((value, exact), (2.5625, 2.0 * 0.25_f64.exp()));
    assert!(bound >= error && bound < error * 1.01 + 1e-6, "{bound} {error}");
    assert_eq!(one(&module(text, |_, _| {}), 0.25), (2.5625, 2.5625, 0.0));
}

#[test]
fn a_truth_of_two_arguments_sees_both() {
    let text =
        "fn f(x: f32) -> f32 { return near(x, 4.0); } fn near(x: f32, y: f32) -> f32 { return max(x, y); }";
    let tell = |module: &naga::Module, meta: &mut Meta| {
        let near = module.functions.iter().find(|(_, f)| f.name.as_deref() == Some("near")).unwrap().0;
        meta.truths.insert(near, Truth::Binary(f64::hypot));
    };
    let (_, exact, bound) = one(&module(text, tell), 3.0);
    assert_eq!((exact, bound), (5.0, 1.0));
}
