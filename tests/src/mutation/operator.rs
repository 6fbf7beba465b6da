//! What an expression may become by mistake.

use super::fault::Kind;
use naga::{BinaryOperator, Expression, Function, Handle, Literal, MathFunction, Module, UnaryOperator};

/// A mistake: its kind, and what the expression becomes.
pub(crate) type Mistake = (Kind, Expression);

/// All mistakes at `expression`, of the same type if the module's types permit them at all.
pub(crate) fn mistakes(module: &Module, function: &Function, expression: &Expression) -> Vec<Mistake> {
    match *expression {
        Expression::Literal(literal) => literals(literal),
        Expression::Constant(constant) => match module.global_expressions[module.constants[constant].init] {
            Expression::Literal(literal) => literals(literal),
            _ => Vec::new(),
        },
        Expression::Unary { op: UnaryOperator::Negate, expr } => vec![(Kind::Dropped, same(expr))],
        Expression::Unary { op: UnaryOperator::LogicalNot, expr } => {
            let same = Expression::Binary { op: BinaryOperator::LogicalAnd, left: expr, right: expr };
            vec![(Kind::FlippedComparison, same)]
        }
        Expression::Binary { op, left, right } => binary(op, left, right),
        Expression::Math { fun, arg, arg1, arg2, .. } => math(fun, arg, arg1, arg2),
        Expression::Select { condition, accept, reject } => {
            vec![(Kind::FlippedComparison, Expression::Select { condition, accept: reject, reject: accept })]
        }
        Expression::AccessIndex { base, index } => component(module, function, base, index),
        Expression::Compose { ty, ref components } => swapped_components(ty, components),
        _ => Vec::new(),
    }
}

/// `x` itself, as an expression of its own.
fn same(x: Handle<Expression>) -> Expression {
    Expression::Math { fun: MathFunction::Max, arg: x, arg1: Some(x), arg2: None, arg3: None }
}

fn literals(literal: Literal) -> Vec<Mistake> {
    let small = |x: f32, by: f64| (f64::from(x) * (1.0 + by)) as f32;
    let with = |kind, literal| (kind, Expression::Literal(literal));
    match literal {
        Literal::F32(0.0) => Vec::new(),
        Literal::F32(x) => vec![
            with(Kind::LiteralBy1e4, Literal::F32(small(x, 1e-4))),
            with(Kind::LiteralBy1e6, Literal::F32(small(x, 1e-6))),
        ],
        Literal::I32(n) => {
            [n.wrapping_add(1), n.wrapping_sub(1)].map(|n| with(Kind::OffByOne, Literal::I32(n))).to_vec()
        }
        Literal::U32(n) => {
            [n.wrapping_add(1), n.wrapping_sub(1)].map(|n| with(Kind::OffByOne, Literal::U32(n))).to_vec()
        }
        Literal::Bool(b) => vec![with(Kind::FlippedComparison, Literal::Bool(!b))],
        _ => Vec::new(),
    }
}

fn binary(op: BinaryOperator, left: Handle<Expression>, right: Handle<Expression>) -> Vec<Mistake> {
    use BinaryOperator as B;
    let with = |kind, op| (kind, Expression::Binary { op, left, right });
    let mut all = Vec::new();
    if matches!(op, B::Subtract | B::Divide | B::Modulo | B::ShiftLeft | B::ShiftRight) && left != right {
        all.push((Kind::SwappedOperands, Expression::Binary { op, left: right, right: left }));
    }
    let wrong = match op {
        B::Add => B::Subtract,
        B::Subtract => B::Add,
        B::Multiply => B::Divide,
        B::Divide => B::Multiply,
        B::And => B::InclusiveOr,
        B::InclusiveOr => B::And,
        B::ExclusiveOr => B::InclusiveOr,
        B::LogicalAnd => B::LogicalOr,
        B::LogicalOr => B::LogicalAnd,
        B::ShiftLeft => B::ShiftRight,
        B::ShiftRight => B::ShiftLeft,
        B::Modulo => B::Divide,
        B::Less => B::Greater,
        B::LessEqual => B::GreaterEqual,
        B::Greater => B::Less,
        B::GreaterEqual => B::LessEqual,
        B::Equal => B::NotEqual,
        B::NotEqual => B::Equal,
    };
    let compares =
        matches!(op, B::Less | B::LessEqual | B::Greater | B::GreaterEqual | B::Equal | B::NotEqual);
    all.push(with(if compares { Kind::FlippedComparison } else { Kind::WrongOperator }, wrong));
    let other_end = match op {
        B::Less => Some(B::LessEqual),
        B::LessEqual => Some(B::Less),
        B::Greater => Some(B::GreaterEqual),
        B::GreaterEqual => Some(B::Greater),
        _ => None,
    };
    all.extend(other_end.map(|op| with(Kind::LoopBound, op)));
    all
}

fn math(
    fun: MathFunction,
    arg: Handle<Expression>,
    arg1: Option<Handle<Expression>>,
    arg2: Option<Handle<Expression>>,
) -> Vec<Mistake> {
    use MathFunction as M;
    let with = |fun| (Kind::WrongBuiltin, Expression::Math { fun, arg, arg1, arg2, arg3: None });
    let mut all = Vec::new();
    if matches!(fun, M::Abs | M::Clamp | M::Saturate | M::Max | M::Min) && arg1 != Some(arg) {
        all.push((Kind::Dropped, same(arg)));
    }
    if let (M::Max | M::Min, Some(other)) = (fun, arg1.filter(|other| *other != arg)) {
        all.push((Kind::Dropped, same(other)));
    }
    if let (M::Pow | M::Atan2 | M::Step | M::Cross | M::Reflect | M::Mix, Some(other)) = (fun, arg1) {
        let swapped = Expression::Math { fun, arg: other, arg1: Some(arg), arg2, arg3: None };
        all.extend((other != arg).then_some((Kind::SwappedOperands, swapped)));
    }
    let pairs = [
        (M::Sin, M::Cos),
        (M::Exp, M::Exp2),
        (M::Log, M::Log2),
        (M::Sqrt, M::InverseSqrt),
        (M::Min, M::Max),
        (M::Floor, M::Ceil),
        (M::Round, M::Trunc),
        (M::Asin, M::Acos),
        (M::Sinh, M::Cosh),
        (M::Tan, M::Atan),
        (M::Tanh, M::Atan),
        (M::Fract, M::Floor),
        (M::Sign, M::Abs),
        (M::FirstLeadingBit, M::FirstTrailingBit),
        (M::CountLeadingZeros, M::CountTrailingZeros),
        (M::CountOneBits, M::ReverseBits),
    ];
    let other = pairs.iter().find_map(|&(a, b)| if a == fun { Some(b) } else { (b == fun).then_some(a) });
    all.extend(other.map(with));
    all
}

/// The next component of a vector, element of an array, or member of a structure that has the same type.
fn component(module: &Module, function: &Function, base: Handle<Expression>, index: u32) -> Vec<Mistake> {
    let Some(ty) = type_of(module, function, base) else { return Vec::new() };
    let count = match module.types[ty].inner {
        naga::TypeInner::Vector { size, .. } => size as u32,
        naga::TypeInner::Matrix { columns, .. } => columns as u32,
        naga::TypeInner::Array { size: naga::ArraySize::Constant(n), .. } => n.get(),
        naga::TypeInner::Struct { ref members, .. } => {
            let ty = members[index as usize].ty;
            let others = (1..members.len()).map(|by| (index as usize + by) % members.len());
            let next = others.into_iter().find(|&at| members[at].ty == ty);
            let next =
                next.map(|at| (Kind::WrongComponent, Expression::AccessIndex { base, index: at as u32 }));
            return next.into_iter().collect();
        }
        _ => return Vec::new(),
    };
    let next = Expression::AccessIndex { base, index: (index + 1) % count };
    if count > 1 { vec![(Kind::WrongComponent, next)] } else { Vec::new() }
}

/// The type behind an expression that is a variable, an argument, or a value made of parts.
fn type_of(module: &Module, function: &Function, at: Handle<Expression>) -> Option<Handle<naga::Type>> {
    match function.expressions[at] {
        Expression::FunctionArgument(n) => Some(function.arguments[n as usize].ty),
        Expression::LocalVariable(variable) => Some(function.local_variables[variable].ty),
        Expression::CallResult(callee) => module.functions[callee].result.as_ref().map(|r| r.ty),
        Expression::Compose { ty, .. } | Expression::ZeroValue(ty) => Some(ty),
        Expression::Load { pointer } => type_of(module, function, pointer),
        Expression::AccessIndex { base, index } => {
            match module.types[type_of(module, function, base)?].inner {
                naga::TypeInner::Struct { ref members, .. } => members.get(index as usize).map(|m| m.ty),
                naga::TypeInner::Array { base, .. } => Some(base),
                _ => None,
            }
        }
        Expression::Binary { left, right, .. } => {
            type_of(module, function, left).or_else(|| type_of(module, function, right))
        }
        Expression::Unary { expr, .. } => type_of(module, function, expr),
        _ => None,
    }
}

fn swapped_components(ty: Handle<naga::Type>, components: &[Handle<Expression>]) -> Vec<Mistake> {
    match components {
        [first, second, ..] if first != second => {
            let mut components = components.to_vec();
            components.swap(0, 1);
            vec![(Kind::WrongComponent, Expression::Compose { ty, components })]
        }
        _ => Vec::new(),
    }
}
