//! A vector's component by a computed index, of which naga's SPIR-V front end makes choices between all of them.
//!
//! The choices end in the first component where the index leads out of the vector, which SPIR-V forbids: so nobody would
//! see the mistake. As an access it is one again.

use naga::{Arena, BinaryOperator, Expression, Handle, Literal, Module};
use std::collections::HashSet;

/// Makes accesses of the choices again.
pub(super) fn settle(module: &mut Module) {
    let functions = module.functions.iter_mut().map(|(_, function)| function);
    let points = module.entry_points.iter_mut().map(|point| &mut point.function);
    functions.chain(points).for_each(|function| settle_function(&mut function.expressions));
}

fn settle_function(expressions: &mut Arena<Expression>) {
    let mut inner = HashSet::new();
    // The last choice comes first, and those that it rejects are its own.
    for (handle, _) in expressions.iter().rev() {
        if !inner.contains(&handle) {
            inner.extend(rejected(expressions, handle));
        }
    }
    let handles: Vec<_> = expressions.iter().map(|(handle, _)| handle).collect();
    for handle in handles {
        if !inner.contains(&handle)
            && let Some((base, index)) = choice(expressions, handle)
        {
            expressions[handle] = Expression::Access { base, index };
        }
    }
}

/// The choices behind `handle`, if it is the last.
fn rejected(expressions: &Arena<Expression>, handle: Handle<Expression>) -> Vec<Handle<Expression>> {
    let mut all = Vec::new();
    let mut at = handle;
    while choice(expressions, at).is_some()
        && let Expression::Select { reject, .. } = expressions[at]
    {
        all.push(reject);
        at = reject;
    }
    all
}

/// The vector and the index of a choice between its components from the first on.
fn choice(
    expressions: &Arena<Expression>,
    handle: Handle<Expression>,
) -> Option<(Handle<Expression>, Handle<Expression>)> {
    let Expression::Select { condition, accept, reject } = expressions[handle] else { return None };
    let Expression::Binary { op: BinaryOperator::Equal, left, right: index } = expressions[condition] else {
        return None;
    };
    let (base, number) = component(expressions, accept)?;
    if literal(expressions, left)? != number {
        return None;
    }
    let before = match number {
        0 => return None,
        1 => component(expressions, reject).filter(|(_, first)| *first == 0).map(|(base, _)| (base, index)),
        _ => choice(expressions, reject).filter(|_| last(expressions, reject) == Some(number - 1)),
    };
    before.filter(|before| *before == (base, index))
}

/// The component that a choice accepts.
fn last(expressions: &Arena<Expression>, choice: Handle<Expression>) -> Option<u32> {
    let Expression::Select { accept, .. } = expressions[choice] else { return None };
    component(expressions, accept).map(|(_, number)| number)
}

/// The vector of which this is a component, and its number.
fn component(
    expressions: &Arena<Expression>,
    handle: Handle<Expression>,
) -> Option<(Handle<Expression>, u32)> {
    let Expression::Access { base, index } = expressions[handle] else { return None };
    Some((base, literal(expressions, index)?))
}

fn literal(expressions: &Arena<Expression>, handle: Handle<Expression>) -> Option<u32> {
    match expressions[handle] {
        Expression::Literal(Literal::U32(number)) => Some(number),
        Expression::Literal(Literal::I32(number)) => number.try_into().ok(),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::foreign::{Language, Source, read};

    const BYTES: &[u8] = include_bytes!("../../../tests/cases/corpus/spirv_component.spv");

    #[test]
    fn a_component_by_a_computed_index_is_an_access() {
        let (name, language) = ("a.spv".to_owned(), Language::Spirv);
        let module = read(&Source { name, language, bytes: BYTES.to_vec() }).unwrap();
        let (_, function) = module.module().functions.iter().next().unwrap();
        let expressions = &function.expressions;
        let computed = expressions.iter().filter(|(_, expression)| match expression {
            Expression::Access { base, index } => {
                literal(expressions, *index).is_none()
                    && matches!(expressions[*base], Expression::Compose { .. })
            }
            _ => false,
        });
        assert_eq!(computed.count(), 1);
    }

    /// Choices between components 0 and 1 of two vectors, by an index each.
    fn choices(second_vector: bool, second_index: bool, number: u32) -> Arena<Expression> {
        let mut all = Arena::new();
        let mut append = |expression| all.append(expression, naga::Span::UNDEFINED);
        let [vectors, indices] = [0, 2].map(|at| [0, 1].map(|n| Expression::FunctionArgument(at + n)));
        let vectors = vectors.map(&mut append);
        let indices = indices.map(&mut append);
        let zero = append(Expression::Literal(Literal::U32(0)));
        let one = append(Expression::Literal(Literal::U32(1)));
        let other = append(Expression::Literal(Literal::U32(number)));
        let reject = append(Expression::Access { base: vectors[0], index: zero });
        let accept = append(Expression::Access { base: vectors[usize::from(second_vector)], index: one });
        let right = indices[usize::from(second_index)];
        let condition = append(Expression::Binary { op: BinaryOperator::Equal, left: other, right });
        append(Expression::Select { condition, accept, reject });
        all
    }

    #[test]
    fn other_choices_stay() {
        for (second_vector, second_index, number, is_access) in [
            (false, false, 1, true),
            (false, true, 1, true),
            (true, false, 1, false),
            (false, false, 0, false),
        ] {
            let mut all = choices(second_vector, second_index, number);
            settle_function(&mut all);
            let (_, last) = all.iter().last().unwrap();
            assert_eq!(matches!(last, Expression::Access { .. }), is_access, "{number} {second_vector}");
        }
    }
}
