//! Values that no `Emit` computes: literals, constants, zeros, arguments, variables.

use super::super::error::{InterpError, Res};
use super::super::program::{Scalar, Value};
use super::frame::{Frame, Item};
use super::layout::{Packing, Shape};
use super::{Lowerer, malformed};
use lobe_codegen::module::Scope;
use naga::{AddressSpace, Expression, Handle, Literal};

impl<'m> Lowerer<'m> {
    /// Fills in every expression of `frame` that needs no `Emit`.
    pub(crate) fn prepare(&mut self, frame: &mut Frame<'m>) -> Res<()> {
        for (handle, expression) in frame.function.expressions.iter() {
            if expression.needs_pre_emit() || matches!(expression, Expression::FunctionArgument(_)) {
                let item = self.ready(frame, handle, expression)?;
                frame.values[handle.index()] = item;
            }
        }
        Ok(())
    }

    /// The value of an expression that needs no `Emit`; local variables come later.
    fn ready(
        &mut self,
        frame: &Frame<'m>,
        handle: Handle<Expression>,
        expression: &Expression,
    ) -> Res<Option<Item>> {
        if let Expression::FunctionArgument(index) = *expression {
            return Ok(frame.arguments.get(index as usize).cloned());
        }
        if let Expression::GlobalVariable(variable) = *expression {
            return self.global_variable(variable);
        }
        if let Expression::LocalVariable(_) = expression {
            return Ok(None);
        }
        let values = match *expression {
            Expression::Literal(literal) => {
                vec![self.literal(frame.scope, handle, literal).map_err(|what| frame.unsupported(what))?]
            }
            Expression::Constant(constant) => self.global(self.module.module().constants[constant].init)?,
            Expression::ZeroValue(ty) => {
                let scalars = self.types().kinds(Shape::Type(ty))?;
                self.zeros(&scalars)
            }
            ref other => return Err(frame.unsupported(format!("{other:?}"))),
        };
        Ok(Some(Item::values(values)))
    }

    /// Computes an expression that no `Emit` covers: the first value of a local variable.
    pub(crate) fn ensure(&mut self, frame: &mut Frame<'m>, handle: Handle<Expression>) -> Res<()> {
        if frame.values[handle.index()].is_some() {
            return Ok(());
        }
        if let Expression::Compose { components, .. } = &frame.function.expressions[handle] {
            for component in components {
                self.ensure(frame, *component)?;
            }
        } else if let Expression::Splat { value, .. } = frame.function.expressions[handle] {
            self.ensure(frame, value)?;
        }
        self.emit(frame, handle)
    }

    /// A literal; the exact value of a float is the one that its decimal text states.
    fn literal(
        &mut self,
        scope: Scope,
        handle: Handle<Expression>,
        literal: Literal,
    ) -> Result<Value, String> {
        let exact = self.module.meta().exact.get(&(scope, handle)).copied();
        let b = &mut self.b;
        Ok(match literal {
            Literal::F32(v) => b.bits(Scalar::F32, v.to_bits().into(), exact.unwrap_or(v.into())),
            Literal::F64(v) => b.bits(Scalar::F64, v.to_bits(), v),
            Literal::F16(v) => {
                let v = f32::from(v);
                b.bits(Scalar::F16, v.to_bits().into(), exact.unwrap_or(v.into()))
            }
            Literal::U32(v) => b.u32(v),
            Literal::I32(v) => b.bits(Scalar::I32, (v as u32).into(), v.into()),
            Literal::U64(v) => b.bits(Scalar::U64, v, v as f64),
            Literal::I64(v) => b.bits(Scalar::I64, v as u64, v as f64),
            Literal::Bool(v) => self.boolean(v),
            Literal::U16(v) => b.bits(Scalar::U16, v.into(), v.into()),
            Literal::I16(v) => b.bits(Scalar::I16, (i32::from(v) as u32).into(), v.into()),
            Literal::AbstractInt(_) | Literal::AbstractFloat(_) => {
                return Err(format!("the literal {literal:?}"));
            }
        })
    }

    /// A global expression.
    pub(crate) fn global(&mut self, handle: Handle<Expression>) -> Res<Vec<Value>> {
        let module = self.module.module();
        let refuse =
            |what: String| InterpError::Unsupported { what, function: "constants".to_owned(), at: None };
        match &module.global_expressions[handle] {
            Expression::Literal(literal) => {
                Ok(vec![self.literal(Scope::Global, handle, *literal).map_err(refuse)?])
            }
            Expression::Constant(constant) => self.global(module.constants[*constant].init),
            Expression::ZeroValue(ty) => {
                let scalars = self.types().kinds(Shape::Type(*ty))?;
                Ok(self.zeros(&scalars))
            }
            Expression::Compose { components, .. } => {
                let parts = components.iter().map(|c| self.global(*c)).collect::<Res<Vec<_>>>()?;
                Ok(parts.concat())
            }
            Expression::Splat { size, value } => {
                let value = self.global(*value)?;
                Ok(std::iter::repeat_n(value, *size as usize).flatten().collect())
            }
            Expression::AccessIndex { base, index } => {
                let shape = self.types().shape(&self.module.info()[*base])?;
                let (part, at) = self.types().member(shape, *index, Packing::Packed(1))?;
                let count = self.types().count(part)?;
                let values = self.global(*base)?;
                let part = values.get(at as usize..(at + count) as usize);
                Ok(part.ok_or(malformed("an index leads out of a constant"))?.to_vec())
            }
            Expression::Swizzle { size, vector, pattern } => {
                let values = self.global(*vector)?;
                let taken = pattern.iter().take(*size as usize).filter_map(|c| values.get(*c as usize));
                Ok(taken.copied().collect())
            }
            other @ (Expression::Override(_)
            | Expression::Access { .. }
            | Expression::FunctionArgument(_)
            | Expression::GlobalVariable(_)
            | Expression::LocalVariable(_)
            | Expression::Load { .. }
            | Expression::ImageSample { .. }
            | Expression::ImageLoad { .. }
            | Expression::ImageQuery { .. }
            | Expression::Unary { .. }
            | Expression::Binary { .. }
            | Expression::Select { .. }
            | Expression::Derivative { .. }
            | Expression::Relational { .. }
            | Expression::Math { .. }
            | Expression::As { .. }
            | Expression::CallResult(_)
            | Expression::AtomicResult { .. }
            | Expression::WorkGroupUniformLoadResult { .. }
            | Expression::ArrayLength(_)
            | Expression::RayQueryVertexPositions { .. }
            | Expression::RayQueryProceedResult
            | Expression::RayQueryGetIntersection { .. }
            | Expression::SubgroupBallotResult
            | Expression::SubgroupOperationResult { .. }
            | Expression::CooperativeLoad { .. }
            | Expression::CooperativeMultiplyAdd { .. }) => {
                Err(refuse(format!("the global expression {other:?}")))
            }
        }
    }

    /// Makes the private variables, with their first values.
    pub(crate) fn private_variables(&mut self) -> Res<()> {
        let module = self.module.module();
        for (handle, variable) in module.global_variables.iter() {
            if variable.space != AddressSpace::Private {
                continue;
            }
            let shape = Shape::Type(variable.ty);
            let values = match variable.init {
                Some(init) => self.global(init)?,
                None => {
                    let scalars = self.types().kinds(shape)?;
                    self.unwritten(&scalars)
                }
            };
            let indexed = self.scan.indexed_globals.contains(&handle.index());
            self.globals[handle.index()] = Some(self.variable(shape, values, indexed)?);
        }
        Ok(())
    }

    /// What a global variable is: a place, or nothing that may be used here, or that nothing uses.
    fn global_variable(&mut self, variable: Handle<naga::GlobalVariable>) -> Res<Option<Item>> {
        if let Some(pointer) = self.globals[variable.index()] {
            return Ok(Some(Item::Pointer(pointer)));
        }
        let Some(Scope::Entry(entry)) = self.entry() else { return Ok(None) };
        if self.module.info().get_entry_point(entry)[variable].is_empty() {
            return Ok(None);
        }
        if let Some(item) = self.texture_variable(variable)? {
            return Ok(Some(item));
        }
        let pointer = self.shared(variable)?.ok_or(malformed("an image is used as memory"));
        Ok(pointer.ok().map(Item::Pointer))
    }
}
