//! Types and constants in words.

use naga::{ArraySize, Expression, Handle, Literal, Module, Scalar, ScalarKind, Type, TypeInner};
use serde::Serialize;

/// The value of a constant, as JSON has it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum ConstantWords {
    /// A float.
    Float(f32),
    /// A signed integer.
    Signed(i32),
    /// An unsigned integer.
    Unsigned(u32),
    /// A boolean.
    Bool(bool),
    /// Components, columns, elements or members.
    Parts(Vec<ConstantWords>),
}

/// The value of a constant expression, when it is written out.
pub(super) fn constant(module: &Module, value: Handle<Expression>) -> Option<ConstantWords> {
    match &module.global_expressions[value] {
        Expression::Literal(literal) => match *literal {
            Literal::F32(v) => Some(ConstantWords::Float(v)),
            Literal::I32(v) => Some(ConstantWords::Signed(v)),
            Literal::U32(v) => Some(ConstantWords::Unsigned(v)),
            Literal::Bool(v) => Some(ConstantWords::Bool(v)),
            _ => None,
        },
        Expression::Constant(other) => constant(module, module.constants[*other].init),
        Expression::Compose { components, .. } => {
            let parts = components.iter().map(|&part| constant(module, part));
            parts.collect::<Option<Vec<_>>>().map(ConstantWords::Parts)
        }
        Expression::Splat { size, value } => {
            constant(module, *value).map(|part| ConstantWords::Parts(vec![part; *size as usize]))
        }
        _ => None,
    }
}

/// A type as WGSL spells it.
pub fn type_name(module: &Module, ty: Handle<Type>) -> String {
    let base = |ty: Handle<Type>| type_name(module, ty);
    match &module.types[ty].inner {
        TypeInner::Scalar(scalar) => scalar_name(*scalar),
        TypeInner::Vector { size, scalar } => format!("vec{}<{}>", *size as u8, scalar_name(*scalar)),
        TypeInner::Matrix { columns, rows, scalar } => {
            format!("mat{}x{}<{}>", *columns as u8, *rows as u8, scalar_name(*scalar))
        }
        TypeInner::Atomic(scalar) => format!("atomic<{}>", scalar_name(*scalar)),
        TypeInner::Array { base: element, size: ArraySize::Constant(n), .. } => {
            format!("array<{}, {n}>", base(*element))
        }
        TypeInner::Array { base: element, .. } => format!("array<{}>", base(*element)),
        TypeInner::Pointer { base: target, .. } => format!("ptr<function, {}>", base(*target)),
        TypeInner::Struct { .. } => module.types[ty].name.clone().unwrap_or_else(|| "struct".to_owned()),
        TypeInner::Image { .. } => "texture".to_owned(),
        TypeInner::Sampler { .. } => "sampler".to_owned(),
        TypeInner::ValuePointer { .. }
        | TypeInner::AccelerationStructure { .. }
        | TypeInner::RayQuery { .. }
        | TypeInner::BindingArray { .. }
        | TypeInner::CooperativeMatrix { .. } => "opaque".to_owned(),
    }
}

fn scalar_name(scalar: Scalar) -> String {
    let letter = match scalar.kind {
        ScalarKind::Bool => return "bool".to_owned(),
        ScalarKind::Float | ScalarKind::AbstractFloat => 'f',
        ScalarKind::Sint | ScalarKind::AbstractInt => 'i',
        ScalarKind::Uint => 'u',
    };
    format!("{letter}{}", u32::from(scalar.width) * 8)
}
