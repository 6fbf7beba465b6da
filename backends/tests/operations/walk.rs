//! Which operations a module has.

use crate::rows::{self, BarrierKind, Key, ScalarType};
use naga::{Block, Expression, Function, Module, Statement, TypeInner};
use std::collections::BTreeSet;

/// All operations of `module`.
pub(crate) fn keys(module: &Module) -> BTreeSet<Key> {
    let mut found = BTreeSet::new();
    module.types.iter().for_each(|(_, ty)| of_type(&ty.inner, &mut found));
    found.extend(module.global_variables.iter().map(|(_, v)| rows::space(&v.space)));
    module.global_expressions.iter().for_each(|(_, e)| of_expression(e, &mut found));
    let bodies =
        module.functions.iter().map(|(_, f)| f).chain(module.entry_points.iter().map(|e| &e.function));
    bodies.for_each(|f| of_function(module, f, &mut found));
    found
}

fn of_type(inner: &TypeInner, found: &mut BTreeSet<Key>) {
    found.insert(rows::type_inner(inner));
    match inner {
        TypeInner::Scalar(scalar)
        | TypeInner::Vector { scalar, .. }
        | TypeInner::Matrix { scalar, .. }
        | TypeInner::Atomic(scalar) => found.extend([rows::scalar(&ScalarType::of(*scalar))]),
        TypeInner::Pointer { space, .. } => found.extend([rows::space(space)]),
        TypeInner::Array { size, .. } => found.extend([rows::array_size(size)]),
        TypeInner::Image { dim, class, .. } => {
            found.insert(rows::image_dimension(dim));
            found.insert(rows::image_class(class));
            if let naga::ImageClass::Storage { format, .. } = class {
                found.insert(rows::storage_format(format));
            }
        }
        _ => {}
    }
}

fn of_function(module: &Module, function: &Function, found: &mut BTreeSet<Key>) {
    if !function.local_variables.is_empty() {
        found.insert(rows::space(&naga::AddressSpace::Function));
    }
    for argument in &function.arguments {
        argument.binding.iter().for_each(|b| of_binding(b, found));
        if let TypeInner::Struct { members, .. } = &module.types[argument.ty].inner {
            members.iter().filter_map(|m| m.binding.as_ref()).for_each(|b| of_binding(b, found));
        }
    }
    function.expressions.iter().for_each(|(_, e)| of_expression(e, found));
    of_block(&function.body, found);
}

fn of_binding(binding: &naga::Binding, found: &mut BTreeSet<Key>) {
    found.insert(rows::binding(binding));
    if let naga::Binding::BuiltIn(builtin) = binding {
        found.insert(rows::builtin(builtin));
    }
}

fn of_expression(expression: &Expression, found: &mut BTreeSet<Key>) {
    found.insert(rows::expression(expression));
    match expression {
        Expression::Literal(literal) => found.insert(rows::literal(literal)),
        Expression::Unary { op, .. } => found.insert(rows::unary(op)),
        Expression::Binary { op, .. } => found.insert(rows::binary(op)),
        Expression::Relational { fun, .. } => found.insert(rows::relational(fun)),
        Expression::Math { fun, .. } => found.insert(rows::math(fun)),
        Expression::ImageSample { level, .. } => found.insert(rows::sample_level(level)),
        Expression::ImageQuery { query, .. } => found.insert(rows::image_query(query)),
        _ => false,
    };
}

fn of_block(block: &Block, found: &mut BTreeSet<Key>) {
    block.iter().for_each(|s| of_statement(s, found));
}

fn of_statement(statement: &Statement, found: &mut BTreeSet<Key>) {
    found.insert(rows::statement(statement));
    match statement {
        Statement::Block(block) => of_block(block, found),
        Statement::If { accept, reject, .. } => [accept, reject].into_iter().for_each(|b| of_block(b, found)),
        Statement::Loop { body, continuing, .. } => {
            [body, continuing].into_iter().for_each(|b| of_block(b, found));
        }
        Statement::Switch { cases, .. } => cases.iter().for_each(|case| {
            found.insert(rows::switch_value(&case.value));
            of_block(&case.body, found);
        }),
        Statement::ControlBarrier(flags) | Statement::MemoryBarrier(flags) => {
            found.extend(BarrierKind::all_of(*flags).map(|kind| rows::barrier(&kind)));
        }
        Statement::Atomic { fun, .. } | Statement::ImageAtomic { fun, .. } => {
            found.insert(rows::atomic(fun));
        }
        Statement::SubgroupGather { mode, .. } => {
            found.insert(rows::gather(mode));
            if let naga::GatherMode::QuadSwap(direction) = mode {
                found.insert(rows::direction(direction));
            }
        }
        Statement::SubgroupCollectiveOperation { op, collective_op, .. } => {
            found.extend([rows::subgroup(op), rows::collective(collective_op)]);
        }
        _ => {}
    }
}
