//! Structures that naga fills up are written member by member: what fills them is nobody's, and costs a write a word.

use super::within;
use naga::{Block, Expression, Function, GlobalVariable, Handle, Module, Range, Statement, Type, TypeInner};

/// Takes the stores to elements of these buffers apart where words would be written that fill.
pub(super) fn by_member(module: &mut Module, is_buffer: impl Fn(Handle<GlobalVariable>) -> bool) {
    let Module { types, global_variables, functions, entry_points, .. } = module;
    let bodies = functions.iter_mut().map(|(_, function)| function);
    for function in bodies.chain(entry_points.iter_mut().map(|entry| &mut entry.function)) {
        if !function.expressions.iter().any(|(_, it)| matches!(it, Expression::GlobalVariable(_))) {
            continue;
        }
        let within = within(function);
        let element = |pointer: Handle<Expression>| {
            let global = within[pointer.index()].filter(|&global| is_buffer(global))?;
            // The element itself: one step into the array.
            let (Expression::Access { base, .. } | Expression::AccessIndex { base, .. }) =
                function.expressions[pointer]
            else {
                return None;
            };
            let Expression::GlobalVariable(_) = function.expressions[base] else { return None };
            match types[global_variables[global].ty].inner {
                TypeInner::Array { base, .. } => members(types, base),
                _ => None,
            }
        };
        let counts: Vec<Option<u32>> =
            function.expressions.iter().map(|(handle, _)| element(handle)).collect();
        if counts.iter().all(Option::is_none) {
            continue;
        }
        let body = std::mem::take(&mut function.body);
        function.body = rewritten(body, function, &counts);
    }
}

/// The number of members of a structure that has words besides them.
fn members(types: &naga::UniqueArena<Type>, ty: Handle<Type>) -> Option<u32> {
    let TypeInner::Struct { ref members, span } = types[ty].inner else { return None };
    let mut end = 0;
    for member in members {
        if member.offset != end {
            return Some(members.len() as u32);
        }
        end += bytes(types, member.ty);
    }
    (end != span).then_some(members.len() as u32)
}

fn bytes(types: &naga::UniqueArena<Type>, ty: Handle<Type>) -> u32 {
    match types[ty].inner {
        TypeInner::Scalar(scalar) => scalar.width.into(),
        TypeInner::Vector { size, scalar } => size as u32 * u32::from(scalar.width),
        TypeInner::Array { size: naga::ArraySize::Constant(count), stride, .. } => count.get() * stride,
        TypeInner::Struct { span, .. } => span,
        _ => 0,
    }
}

/// The block with a store for each member; `counts` says of each pointer how many its element has.
fn rewritten(block: Block, function: &mut Function, counts: &[Option<u32>]) -> Block {
    let mut out = Block::new();
    for (statement, span) in block.span_into_iter() {
        let mut again = |block: Block| rewritten(block, function, counts);
        let statement = match statement {
            Statement::Store { pointer, value } => {
                match counts.get(pointer.index()).copied().flatten() {
                    Some(count) => (0..count).for_each(|index| {
                        store(function, &mut out, (pointer, value), index, span);
                    }),
                    None => out.push(Statement::Store { pointer, value }, span),
                }
                continue;
            }
            Statement::Block(block) => Statement::Block(again(block)),
            Statement::If { condition, accept, reject } => {
                Statement::If { condition, accept: again(accept), reject: again(reject) }
            }
            Statement::Switch { selector, mut cases } => {
                cases.iter_mut().for_each(|case| case.body = again(std::mem::take(&mut case.body)));
                Statement::Switch { selector, cases }
            }
            Statement::Loop { body, continuing, break_if } => {
                Statement::Loop { body: again(body), continuing: again(continuing), break_if }
            }
            other => other,
        };
        out.push(statement, span);
    }
    out
}

/// Stores one member.
fn store(
    function: &mut Function,
    out: &mut Block,
    (pointer, value): (Handle<Expression>, Handle<Expression>),
    index: u32,
    span: naga::Span,
) {
    let pointer = function.expressions.append(Expression::AccessIndex { base: pointer, index }, span);
    let value = function.expressions.append(Expression::AccessIndex { base: value, index }, span);
    out.push(Statement::Emit(Range::new_from_bounds(pointer, value)), span);
    out.push(Statement::Store { pointer, value }, span);
}
