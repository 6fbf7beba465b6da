//! What naga's validator lets pass and ours does not.
//!
//! Each module here is built by hand, broken in one way.
//! naga accepts it (should a newer naga refuse it, the test says so, and our check may go); what
//! comes out of its writers would be wrong; [`lobe_codegen::validate`] refuses it.

use lobe_codegen::module::Meta;
use lobe_codegen::validate::{ValidateError, validate};
use naga::valid::{Capabilities, ValidationFlags, Validator};
use naga::{
    BinaryOperator, Block, Expression, Function, FunctionArgument, FunctionResult, Handle, Literal, Module,
    Range, Scalar, Span, Statement, Type, TypeInner,
};

const AT: Span = Span::UNDEFINED;

/// A function under construction: `fn broken(x: T, c: bool) -> T`.
struct Broken {
    module: Module,
    function: Function,
    x: Handle<Expression>,
    c: Handle<Expression>,
}

impl Broken {
    fn new(scalar: Scalar) -> Self {
        let mut module = Module::default();
        let mut ty = |scalar| {
            let inner = TypeInner::Scalar(scalar);
            module.types.insert(Type { name: None, inner }, AT)
        };
        let (value, condition) = (ty(scalar), ty(Scalar::BOOL));
        let argument = |name: &str, ty| FunctionArgument { name: Some(name.to_owned()), ty, binding: None };
        let mut function = Function {
            name: Some("broken".to_owned()),
            arguments: vec![argument("x", value), argument("c", condition)],
            result: Some(FunctionResult { ty: value, binding: None }),
            ..Function::default()
        };
        let x = function.expressions.append(Expression::FunctionArgument(0), AT);
        let c = function.expressions.append(Expression::FunctionArgument(1), AT);
        Self { module, function, x, c }
    }

    /// `a + a`, not emitted yet.
    fn double(&mut self, a: Handle<Expression>) -> Handle<Expression> {
        let sum = Expression::Binary { op: BinaryOperator::Add, left: a, right: a };
        self.function.expressions.append(sum, AT)
    }

    fn finish(mut self, body: Vec<Statement>) -> Module {
        self.function.body = Block::from_vec(body);
        self.module.functions.append(self.function, AT);
        self.module
    }
}

fn emit(handle: Handle<Expression>) -> Statement {
    Statement::Emit(Range::new_from_bounds(handle, handle))
}

fn give(value: Handle<Expression>) -> Statement {
    Statement::Return { value: Some(value) }
}

fn block(statements: Vec<Statement>) -> Block {
    Block::from_vec(statements)
}

fn naga_accepts(module: &Module, capabilities: Capabilities) {
    if let Err(error) = Validator::new(ValidationFlags::all(), capabilities).validate(module) {
        panic!("naga refuses this by now: {:?}", error.as_inner());
    }
}

/// naga accepts the module, and we refuse it with these words.
#[track_caller]
fn only_we_refuse(module: Module, words: &str) {
    naga_accepts(&module, Capabilities::empty());
    let message = validate(module, Meta::default()).expect_err("the module is broken").to_string();
    assert!(message.contains("`broken`") && message.contains(words), "{message}");
}

const NOT_BEFORE: &str = "computed in a block that may not run before";

#[test]
fn a_value_of_a_branch_used_after_it() {
    let mut b = Broken::new(Scalar::F32);
    let inside = b.double(b.x);
    let after = b.double(inside);
    let accept = block(vec![emit(inside)]);
    let condition = b.c;
    let module =
        b.finish(vec![Statement::If { condition, accept, reject: Block::new() }, emit(after), give(after)]);
    only_we_refuse(module, NOT_BEFORE);
}

#[test]
fn a_value_of_a_case_used_after_the_switch() {
    let mut b = Broken::new(Scalar::I32);
    let inside = b.double(b.x);
    let after = b.double(inside);
    let case = |value, body| naga::SwitchCase { value, body, fall_through: false };
    let cases = vec![
        case(naga::SwitchValue::I32(1), block(vec![emit(inside)])),
        case(naga::SwitchValue::Default, Block::new()),
    ];
    let selector = b.x;
    let module = b.finish(vec![Statement::Switch { selector, cases }, emit(after), give(after)]);
    only_we_refuse(module, NOT_BEFORE);
}

#[test]
fn a_value_of_a_loop_used_after_it() {
    let mut b = Broken::new(Scalar::F32);
    let inside = b.double(b.x);
    let after = b.double(inside);
    let condition = b.c;
    let leave = Statement::If { condition, accept: block(vec![Statement::Break]), reject: Block::new() };
    let body = block(vec![leave, emit(inside)]);
    let module = b.finish(vec![
        Statement::Loop { body, continuing: Block::new(), break_if: None },
        emit(after),
        give(after),
    ]);
    only_we_refuse(module, NOT_BEFORE);
}

#[test]
fn a_value_that_a_continue_leaves_out() {
    let mut b = Broken::new(Scalar::F32);
    let inside = b.double(b.x);
    let counted = b.double(inside);
    let (condition, x) = (b.c, b.x);
    let skip = Statement::If { condition, accept: block(vec![Statement::Continue]), reject: Block::new() };
    let body = block(vec![skip, emit(inside)]);
    let continuing = block(vec![emit(counted)]);
    let module = b.finish(vec![Statement::Loop { body, continuing, break_if: Some(condition) }, give(x)]);
    only_we_refuse(module, NOT_BEFORE);
}

#[test]
fn what_the_body_computes_before_any_continue_is_seen_by_continuing() {
    let mut b = Broken::new(Scalar::F32);
    let inside = b.double(b.x);
    let counted = b.double(inside);
    let (condition, x) = (b.c, b.x);
    let skip = Statement::If { condition, accept: block(vec![Statement::Continue]), reject: Block::new() };
    let body = block(vec![emit(inside), skip]);
    let continuing = block(vec![emit(counted)]);
    let module = b.finish(vec![Statement::Loop { body, continuing, break_if: Some(condition) }, give(x)]);
    validate(module, Meta::default()).expect("a sound module");
}

#[test]
fn a_value_that_no_emit_computes() {
    let mut b = Broken::new(Scalar::F32);
    let never = b.double(b.x);
    let after = b.double(never);
    let module = b.finish(vec![emit(after), give(after)]);
    only_we_refuse(module, NOT_BEFORE);
}

#[test]
fn a_value_that_is_used_before_its_emit() {
    let mut b = Broken::new(Scalar::F32);
    let late = b.double(b.x);
    let early = b.double(late);
    let module = b.finish(vec![emit(early), emit(late), give(early)]);
    only_we_refuse(module, NOT_BEFORE);
}

#[test]
fn a_path_without_return() {
    let b = Broken::new(Scalar::F32);
    let (condition, x) = (b.c, b.x);
    let accept = block(vec![give(x)]);
    let module = b.finish(vec![Statement::If { condition, accept, reject: Block::new() }]);
    only_we_refuse(module, "returns no value");
}

#[test]
fn an_empty_body_of_a_function_with_result() {
    only_we_refuse(Broken::new(Scalar::F32).finish(Vec::new()), "returns no value");
}

#[test]
fn a_break_out_of_a_switch_reaches_the_end() {
    let b = Broken::new(Scalar::I32);
    let x = b.x;
    let leave = Statement::If { condition: b.c, accept: block(vec![Statement::Break]), reject: Block::new() };
    let case = naga::SwitchCase {
        value: naga::SwitchValue::Default,
        body: block(vec![leave, give(x)]),
        fall_through: false,
    };
    let module = b.finish(vec![Statement::Switch { selector: x, cases: vec![case] }]);
    only_we_refuse(module, "returns no value");
}

/// GLSL.std.450 has these for 16 and 32 bits only; with the capability naga lets them pass.
#[test]
fn a_built_in_function_of_f64() {
    let mut b = Broken::new(Scalar::F64);
    let root =
        Expression::Math { fun: naga::MathFunction::Exp, arg: b.x, arg1: None, arg2: None, arg3: None };
    let root = b.function.expressions.append(root, AT);
    let module = b.finish(vec![emit(root), give(root)]);
    naga_accepts(&module, Capabilities::FLOAT64);
    let error = validate(module, Meta::default()).expect_err("f64 is no type of ours");
    assert!(matches!(error, ValidateError::Invalid(_)), "{error}");
    assert!(error.to_string().contains("FLOAT64"), "{error}");
}

/// naga sees this one itself; a literal that is no number must never get there.
#[test]
fn a_literal_that_is_no_number() {
    for value in [f32::NAN, f32::INFINITY] {
        let mut b = Broken::new(Scalar::F32);
        let literal = b.function.expressions.append(Expression::Literal(Literal::F32(value)), AT);
        let module = b.finish(vec![give(literal)]);
        let error = validate(module, Meta::default()).expect_err("no such literal");
        assert!(matches!(error, ValidateError::Invalid(_)), "{error}");
    }
}

/// The kernel language's way to the same ends: what crosses a branch goes through a variable.
mod sound {
    use lobe_codegen::prelude::*;

    #[kernel]
    pub(crate) fn across_branches(x: f32, c: bool, n: i32) -> f32 {
        let inside = if c { x + x } else { x };
        let of_case = match n {
            1 => inside * 2.0,
            _ => 0.0,
        };
        let mut last = of_case;
        let mut i = 0;
        while i < n {
            i += 1;
            if c {
                continue;
            }
            last = x * i as f32;
        }
        if c {
            return last + last;
        }
        loop {
            if i > n {
                return inside;
            }
            i += 1;
        }
    }
}

#[test]
fn kernels_step_around_the_traps() {
    lobe_codegen::lower(&lobe_codegen::kernels![sound::across_branches]).unwrap_or_else(|e| panic!("{e}"));
}
