//! Types without booleans, and the way to them and back.
//!
//! A type that holds no `bool` is its own transport, and nothing is converted.

use super::{Builder, add_type};
use naga::proc::Layouter;
use naga::{ArraySize, BinaryOperator, Expression, Handle, Literal, Module, ScalarKind, Type, TypeInner};

/// Makes the transport of types.
pub(super) struct Transport<'a> {
    module: &'a mut Module,
    layouter: Layouter,
}

impl<'a> Transport<'a> {
    pub(super) fn new(module: &'a mut Module) -> Result<Self, String> {
        let mut out = Self { module, layouter: Layouter::default() };
        out.update()?;
        Ok(out)
    }

    fn update(&mut self) -> Result<(), String> {
        self.layouter.update(self.module.to_ctx()).map_err(|error| error.to_string())
    }

    /// The type that a value of `ty` has in a buffer.
    pub(super) fn of(&mut self, ty: Handle<Type>) -> Result<Handle<Type>, String> {
        if !holds_bool(self.module, ty) {
            return Ok(ty);
        }
        let inner = match self.module.types[ty].inner.clone() {
            TypeInner::Scalar(_) => TypeInner::Scalar(naga::Scalar::U32),
            TypeInner::Vector { size, .. } => TypeInner::Vector { size, scalar: naga::Scalar::U32 },
            TypeInner::Array { base, size, .. } => {
                let base = self.of(base)?;
                TypeInner::Array { base, size, stride: self.layouter[base].to_stride() }
            }
            TypeInner::Struct { members, .. } => return self.structure(ty, members),
            // Nothing else holds a bool.
            _ => return Ok(ty),
        };
        let made = add_type(self.module, inner);
        self.update()?;
        Ok(made)
    }

    /// A structure `<name>_in_buffer` of the members' transports.
    fn structure(
        &mut self,
        ty: Handle<Type>,
        mut members: Vec<naga::StructMember>,
    ) -> Result<Handle<Type>, String> {
        let (mut end, mut alignment) = (0u32, naga::proc::Alignment::ONE);
        for member in &mut members {
            member.ty = self.of(member.ty)?;
            let layout = self.layouter[member.ty];
            member.offset = layout.alignment.round_up(end);
            end = member.offset + layout.size;
            alignment = alignment.max(layout.alignment);
        }
        let name = self.module.types[ty].name.as_ref().map(|name| format!("{name}_in_buffer"));
        let inner = TypeInner::Struct { members, span: alignment.round_up(end) };
        let made = self.module.types.insert(Type { name, inner }, naga::Span::UNDEFINED);
        self.update()?;
        Ok(made)
    }
}

fn holds_bool(module: &Module, ty: Handle<Type>) -> bool {
    match &module.types[ty].inner {
        TypeInner::Scalar(scalar) | TypeInner::Vector { scalar, .. } => scalar.kind == ScalarKind::Bool,
        TypeInner::Array { base, .. } => holds_bool(module, *base),
        TypeInner::Struct { members, .. } => members.iter().any(|m| holds_bool(module, m.ty)),
        _ => false,
    }
}

/// Between a value and its transport.
#[derive(Clone, Copy)]
enum Way {
    Decode,
    Encode,
}

impl Builder {
    /// The value of type `ty` whose transport is `value`.
    pub(super) fn decode(&mut self, value: Handle<Expression>, ty: Handle<Type>) -> Handle<Expression> {
        self.convert(value, ty, Way::Decode)
    }

    /// The transport of `value`, which is of type `ty`.
    pub(super) fn encode(&mut self, value: Handle<Expression>, ty: Handle<Type>) -> Handle<Expression> {
        self.convert(value, ty, Way::Encode)
    }

    fn convert(&mut self, value: Handle<Expression>, ty: Handle<Type>, way: Way) -> Handle<Expression> {
        if !holds_bool(&self.module, ty) {
            return value;
        }
        match self.module.types[ty].inner.clone() {
            TypeInner::Scalar(_) => self.convert_words(value, None, way),
            TypeInner::Vector { size, .. } => self.convert_words(value, Some(size), way),
            TypeInner::Array { base, size: ArraySize::Constant(count), .. } => {
                self.convert_parts(value, ty, vec![base; count.get() as usize], way)
            }
            TypeInner::Struct { members, .. } => {
                self.convert_parts(value, ty, members.iter().map(|m| m.ty).collect(), way)
            }
            // Nothing else holds a bool and has a layout.
            _ => value,
        }
    }

    fn convert_words(
        &mut self,
        value: Handle<Expression>,
        size: Option<naga::VectorSize>,
        way: Way,
    ) -> Handle<Expression> {
        match way {
            Way::Decode => {
                let literal = self.declare(Expression::Literal(Literal::U32(0)));
                let zero = match size {
                    Some(size) => self.compute(Expression::Splat { size, value: literal }),
                    None => literal,
                };
                self.compute(Expression::Binary { op: BinaryOperator::NotEqual, left: value, right: zero })
            }
            // A conversion, not a selection: DXC refuses `?:` on vectors, which naga would write.
            Way::Encode => {
                self.compute(Expression::As { expr: value, kind: ScalarKind::Uint, convert: Some(4) })
            }
        }
    }

    fn convert_parts(
        &mut self,
        value: Handle<Expression>,
        ty: Handle<Type>,
        parts: Vec<Handle<Type>>,
        way: Way,
    ) -> Handle<Expression> {
        let mut components = Vec::new();
        for (index, part) in (0u32..).zip(parts) {
            let member = self.compute(Expression::AccessIndex { base: value, index });
            components.push(self.convert(member, part, way));
        }
        let ty = match way {
            Way::Decode => ty,
            // The type was laid out before anything of it was encoded.
            Way::Encode => Transport::new(&mut self.module).and_then(|mut t| t.of(ty)).unwrap_or(ty),
        };
        self.compute(Expression::Compose { ty, components })
    }
}
