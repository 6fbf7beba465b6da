//! A small evaluator of naga functions: the second opinion on what a lowered kernel means.
//!
//! It follows the IR to the letter (an expression is computed where its `Emit` stands, and only
//! there) and knows no more of it than kernels use.
//! The interpreter of the house is another crate, which this one may not depend on.

use crate::operation;
use naga::{Block, Expression, Function, Handle, Literal, Module, Statement, SwitchValue, TypeInner};

/// A value.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Value {
    F32(f32),
    I32(i32),
    U32(u32),
    Bool(bool),
    Parts(Vec<Value>),
    /// A place in a local variable.
    Pointer(Handle<naga::LocalVariable>, Vec<usize>),
}

enum Flow {
    Next,
    Break,
    Continue,
    Return(Option<Value>),
}

/// Runs `function` on `arguments`.
pub(crate) fn run(module: &Module, function: &Function, arguments: Vec<Value>) -> Option<Value> {
    let variables = function.local_variables.iter().map(|(_, v)| zero(module, v.ty)).collect();
    let values = vec![None; function.expressions.len()];
    let mut frame = Frame { module, function, arguments, variables, values, steps: 0 };
    match frame.block(&function.body) {
        Flow::Return(value) => value,
        Flow::Next | Flow::Break | Flow::Continue => None,
    }
}

/// The zero of a type.
pub(crate) fn zero(module: &Module, ty: Handle<naga::Type>) -> Value {
    let scalar = |s: naga::Scalar| match s.kind {
        naga::ScalarKind::Float => Value::F32(0.0),
        naga::ScalarKind::Sint => Value::I32(0),
        naga::ScalarKind::Uint => Value::U32(0),
        _ => Value::Bool(false),
    };
    match module.types[ty].inner {
        TypeInner::Scalar(s) => scalar(s),
        TypeInner::Vector { size, scalar: s } => Value::Parts(vec![scalar(s); size as usize]),
        TypeInner::Matrix { columns, rows, scalar: s } => {
            Value::Parts(vec![Value::Parts(vec![scalar(s); rows as usize]); columns as usize])
        }
        TypeInner::Array { base, size: naga::ArraySize::Constant(n), .. } => {
            Value::Parts(vec![zero(module, base); n.get() as usize])
        }
        TypeInner::Struct { ref members, .. } => {
            Value::Parts(members.iter().map(|m| zero(module, m.ty)).collect())
        }
        ref other => panic!("no zero of {other:?}"),
    }
}

pub(crate) fn literal(l: Literal) -> Value {
    match l {
        Literal::F32(v) => Value::F32(v),
        Literal::I32(v) => Value::I32(v),
        Literal::U32(v) => Value::U32(v),
        Literal::Bool(v) => Value::Bool(v),
        other => panic!("the literal {other:?}"),
    }
}

fn flat(value: Value) -> Vec<Value> {
    match value {
        Value::Parts(parts) => parts,
        scalar => vec![scalar],
    }
}

struct Frame<'m> {
    module: &'m Module,
    function: &'m Function,
    arguments: Vec<Value>,
    variables: Vec<Value>,
    values: Vec<Option<Value>>,
    steps: usize,
}

impl Frame<'_> {
    fn block(&mut self, block: &Block) -> Flow {
        for statement in block {
            match self.statement(statement) {
                Flow::Next => {}
                other => return other,
            }
        }
        Flow::Next
    }

    fn statement(&mut self, statement: &Statement) -> Flow {
        self.steps += 1;
        assert!(self.steps < 1_000_000, "a loop does not end");
        match *statement {
            Statement::Emit(ref range) => {
                for handle in range.clone() {
                    self.values[handle.index()] = Some(self.compute(handle));
                }
            }
            Statement::Block(ref block) => return self.block(block),
            Statement::If { condition, ref accept, ref reject } => {
                let taken = if self.value(condition) == Value::Bool(true) { accept } else { reject };
                return self.block(taken);
            }
            Statement::Switch { selector, ref cases } => return self.switch(selector, cases),
            Statement::Loop { ref body, ref continuing, break_if } => {
                return self.repeat(body, continuing, break_if);
            }
            Statement::Break => return Flow::Break,
            Statement::Continue => return Flow::Continue,
            Statement::Return { value } => return Flow::Return(value.map(|v| self.value(v))),
            Statement::Store { pointer, value } => {
                let value = self.value(value);
                *self.place(pointer) = value;
            }
            Statement::Call { function, ref arguments, result } => {
                let arguments = arguments.iter().map(|a| self.value(*a)).collect();
                let value = run(self.module, &self.module.functions[function], arguments);
                if let Some(result) = result {
                    self.values[result.index()] = value;
                }
            }
            ref other => panic!("the statement {other:?}"),
        }
        Flow::Next
    }

    fn switch(&mut self, selector: Handle<Expression>, cases: &[naga::SwitchCase]) -> Flow {
        let wanted = match self.value(selector) {
            Value::I32(v) => SwitchValue::I32(v),
            Value::U32(v) => SwitchValue::U32(v),
            other => panic!("a switch over {other:?}"),
        };
        let start = cases.iter().position(|c| c.value == wanted);
        let start = start.or_else(|| cases.iter().position(|c| c.value == SwitchValue::Default));
        for case in &cases[start.expect("a default case")..] {
            match self.block(&case.body) {
                Flow::Next if case.fall_through => {}
                Flow::Next | Flow::Break => return Flow::Next,
                other => return other,
            }
        }
        Flow::Next
    }

    fn repeat(&mut self, body: &Block, continuing: &Block, break_if: Option<Handle<Expression>>) -> Flow {
        loop {
            match self.block(body) {
                Flow::Next | Flow::Continue => {}
                Flow::Break => return Flow::Next,
                returned => return returned,
            }
            assert!(matches!(self.block(continuing), Flow::Next), "`continuing` jumps");
            if break_if.is_some_and(|c| self.value(c) == Value::Bool(true)) {
                return Flow::Next;
            }
        }
    }

    fn place(&mut self, pointer: Handle<Expression>) -> &mut Value {
        let Value::Pointer(variable, path) = self.value(pointer) else { panic!("a store to no pointer") };
        path.iter().fold(&mut self.variables[variable.index()], |value, &i| match value {
            Value::Parts(parts) => &mut parts[i],
            other => panic!("{other:?} has no parts"),
        })
    }

    fn value(&self, handle: Handle<Expression>) -> Value {
        if self.function.expressions[handle].needs_pre_emit() {
            return self.compute(handle);
        }
        self.values[handle.index()].clone().unwrap_or_else(|| panic!("{handle:?} is used before its Emit"))
    }

    fn part(&self, base: Handle<Expression>, index: usize) -> Value {
        match self.value(base) {
            Value::Pointer(variable, mut path) => {
                path.push(index);
                Value::Pointer(variable, path)
            }
            Value::Parts(parts) => parts[index].clone(),
            other => panic!("{other:?} has no parts"),
        }
    }

    fn compute(&self, handle: Handle<Expression>) -> Value {
        match self.function.expressions[handle] {
            Expression::Literal(l) => literal(l),
            Expression::Constant(c) => self.constant(self.module.constants[c].init),
            Expression::ZeroValue(ty) => zero(self.module, ty),
            Expression::FunctionArgument(i) => self.arguments[i as usize].clone(),
            Expression::LocalVariable(v) => Value::Pointer(v, Vec::new()),
            Expression::Compose { ty, ref components } => {
                let parts: Vec<Value> = components.iter().map(|c| self.value(*c)).collect();
                let is_vector = matches!(self.module.types[ty].inner, TypeInner::Vector { .. });
                // A vector may be composed of shorter ones.
                Value::Parts(if is_vector { parts.into_iter().flat_map(flat).collect() } else { parts })
            }
            Expression::AccessIndex { base, index } => self.part(base, index as usize),
            Expression::Access { base, index } => match self.value(index) {
                Value::U32(i) => self.part(base, i as usize),
                Value::I32(i) => self.part(base, i as usize),
                other => panic!("the index {other:?}"),
            },
            Expression::Splat { size, value } => Value::Parts(vec![self.value(value); size as usize]),
            Expression::Swizzle { size, vector, pattern } => {
                let part = |c: &naga::SwizzleComponent| self.part(vector, *c as usize);
                Value::Parts(pattern[..size as usize].iter().map(part).collect())
            }
            Expression::Load { pointer } => {
                let Value::Pointer(variable, path) = self.value(pointer) else { panic!("a load of a value") };
                path.iter().fold(self.variables[variable.index()].clone(), |value, &i| match value {
                    Value::Parts(parts) => parts[i].clone(),
                    other => panic!("{other:?} has no parts"),
                })
            }
            Expression::Unary { op, expr } => operation::unary(op, &self.value(expr)),
            Expression::Binary { op, left, right } => {
                operation::binary(op, &self.value(left), &self.value(right))
            }
            Expression::Select { condition, accept, reject } => {
                self.value(if self.value(condition) == Value::Bool(true) { accept } else { reject })
            }
            Expression::Relational { fun, argument } => operation::relational(fun, &self.value(argument)),
            Expression::Math { fun, arg, arg1, arg2, .. } => {
                let arguments: Vec<Value> =
                    [Some(arg), arg1, arg2].into_iter().flatten().map(|a| self.value(a)).collect();
                operation::math(fun, &arguments)
            }
            Expression::As { expr, kind, convert } => operation::convert(&self.value(expr), kind, convert),
            ref other => panic!("the expression {other:?}"),
        }
    }

    fn constant(&self, handle: Handle<Expression>) -> Value {
        match self.module.global_expressions[handle] {
            Expression::Literal(l) => literal(l),
            Expression::Compose { ref components, .. } => {
                Value::Parts(components.iter().map(|c| self.constant(*c)).collect())
            }
            ref other => panic!("the constant {other:?}"),
        }
    }
}
