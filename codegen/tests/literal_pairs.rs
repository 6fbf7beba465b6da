//! No operation on literals alone is left in a module, whatever is written.
//!
//! Definitions are plain data, so random expressions need no macro: each is built as a
//! `FunctionDef`, lowered, and its IR walked.

use lobe_codegen::def::{
    BinaryOp, Binding, Block, Contract, Expr, ExprKind, FunctionDef, FunctionRef, LocalDef, Param, Scalar,
    Source, Span, TypeDef, UnaryOp,
};
use lobe_codegen::{ValidModule, lower};
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use std::cell::Cell;

const F32: TypeDef = TypeDef::Scalar(Scalar::F32);
const AT: Span = Span { start: (1, 0), end: (1, 1) };

/// An expression of one parameter, with the value that f32 arithmetic gives it when it has no `x`.
#[derive(Debug, Clone)]
enum Tree {
    X,
    Literal(i32),
    Negated(Box<Tree>),
    Pair(BinaryOp, Box<Tree>, Box<Tree>),
}

/// A literal of few decimals: `hundredths / 100`.
fn decimals(hundredths: i32) -> (f32, f64) {
    let text = format!("{}e-2", hundredths.abs());
    (text.parse().expect("a float"), text.parse().expect("a float"))
}

impl Tree {
    fn expr(&self) -> &'static Expr {
        let kind = match self {
            Self::X => ExprKind::Local(0),
            Self::Literal(hundredths) => {
                let (value, exact) = decimals(*hundredths);
                ExprKind::Float(value, exact)
            }
            Self::Negated(inner) => ExprKind::Unary(UnaryOp::Negate, inner.expr()),
            Self::Pair(op, l, r) => ExprKind::Binary(*op, l.expr(), r.expr()),
        };
        Box::leak(Box::new(Expr { kind, span: AT }))
    }

    /// The outcome in f32, one rounding an operation; `None` with an `x` inside.
    fn outcome(&self) -> Option<f32> {
        Some(match self {
            Self::X => return None,
            Self::Literal(hundredths) => decimals(*hundredths).0,
            Self::Negated(inner) => -inner.outcome()?,
            Self::Pair(op, l, r) => {
                let (l, r) = (l.outcome()?, r.outcome()?);
                match op {
                    BinaryOp::Add => l + r,
                    BinaryOp::Subtract => l - r,
                    BinaryOp::Multiply => l * r,
                    BinaryOp::Divide => l / r,
                    _ => l % r,
                }
            }
        })
    }
}

fn trees() -> impl Strategy<Value = Tree> {
    let leaf = prop_oneof![
        Just(Tree::X),
        (0..400i32).prop_map(Tree::Literal),
        (0..9i32).prop_map(|n| Tree::Literal(n * 100))
    ];
    leaf.prop_recursive(5, 40, 2, |inner| {
        let op = prop_oneof![
            Just(BinaryOp::Add),
            Just(BinaryOp::Subtract),
            Just(BinaryOp::Multiply),
            Just(BinaryOp::Divide),
            Just(BinaryOp::Remainder),
        ];
        prop_oneof![
            inner.clone().prop_map(|t| Tree::Negated(Box::new(t))),
            (op, inner.clone(), inner).prop_map(|(op, l, r)| Tree::Pair(op, Box::new(l), Box::new(r))),
        ]
    })
}

thread_local! {
    static CURRENT: Cell<Option<&'static FunctionDef>> = const { Cell::new(None) };
}

/// A function pointer cannot carry a definition; it is handed over beside it.
fn current() -> &'static FunctionDef {
    CURRENT.get().expect("a definition")
}

fn lowered(value: &'static Expr) -> Result<ValidModule, String> {
    let def = FunctionDef {
        name: "random",
        module: "",
        docs: &[],
        source: Source { file: "random", line: 1, text: "x" },
        span: AT,
        entry: None,
        params: &[Param { name: "x", ty: F32, binding: Binding::Value, span: AT }],
        ret: Some(F32),
        locals: &[LocalDef { name: "x", mutable: false, span: AT }],
        body: Block { stmts: &[], value: Some(value) },
        contract: Contract {
            family: "",
            cite: "",
            domain: &[],
            budget: &[],
            variant_of: None,
            not_robust: None,
            measured: None,
            truth: None,
        },
        native: None,
    };
    CURRENT.set(Some(Box::leak(Box::new(def))));
    lower(&[current as FunctionRef]).map_err(|e| e.to_string())
}

/// Whether an expression has operands, all of them literals.
fn is_on_literals(expressions: &naga::Arena<naga::Expression>, expression: &naga::Expression) -> bool {
    let literal = |h: naga::Handle<naga::Expression>| matches!(expressions[h], naga::Expression::Literal(_));
    match *expression {
        naga::Expression::Binary { left, right, .. } => literal(left) && literal(right),
        naga::Expression::Unary { expr, .. } | naga::Expression::As { expr, .. } => literal(expr),
        _ => false,
    }
}

fn no_operation_on_literals(module: &ValidModule) {
    for (_, function) in module.module().functions.iter() {
        let expressions = &function.expressions;
        for (_, expression) in expressions.iter() {
            assert!(!is_on_literals(expressions, expression), "{expression:?} in {expressions:#?}");
        }
    }
}

/// What the function returns, if that is a literal, with the value of its decimals.
fn returned(module: &ValidModule) -> Option<(f32, Option<f64>)> {
    let (handle, function) = module.module().functions.iter().next()?;
    let Some(naga::Statement::Return { value: Some(value) }) = function.body.last() else { return None };
    let naga::Expression::Literal(naga::Literal::F32(v)) = function.expressions[*value] else { return None };
    let scope = lobe_codegen::module::Scope::Function(handle);
    Some((v, module.meta().exact.get(&(scope, *value)).copied()))
}

#[test]
fn random_expressions_keep_no_operation_on_literals() {
    let mut runner = TestRunner::new(Config { cases: 2000, failure_persistence: None, ..Config::default() });
    let run = runner.run(&trees(), |tree| {
        match (lowered(tree.expr()), tree.outcome()) {
            (Ok(module), outcome) => {
                no_operation_on_literals(&module);
                if let Some(outcome) = outcome {
                    let (value, exact) = returned(&module).expect("one literal");
                    prop_assert_eq!(value.to_bits(), outcome.to_bits());
                    prop_assert!(exact != Some(f64::from(value)), "recorded though f32 is exact");
                }
            }
            // Only what no language can write is refused.
            (Err(message), _) => {
                prop_assert!(message.contains("no shading language has a literal"), "{message}")
            }
        }
        Ok(())
    });
    run.unwrap_or_else(|e| panic!("{e}"));
}

#[test]
fn the_walk_sees_an_operation_on_literals() {
    let mut expressions = naga::Arena::new();
    let literal = naga::Expression::Literal(naga::Literal::F32(1.0));
    let left = expressions.append(literal, naga::Span::UNDEFINED);
    let sum = naga::Expression::Binary { op: naga::BinaryOperator::Add, left, right: left };
    assert!(is_on_literals(&expressions, &sum));
}
