//! Values that no `Emit` computes: literals, constants, zeros, arguments, variables.

use super::super::error::{InterpError, Res};
use super::super::layout::Pointee;
use super::super::leaf::Leaf;
use super::super::memory::{Offset, Pointer, Root};
use super::super::model::Model;
use super::{Frame, Machine, Value};
use lobe_codegen::module::Scope;
use naga::{Expression, Handle, Literal};

impl<M: Model> Machine<'_, M> {
    /// Fills in every expression of `frame` that needs no `Emit`.
    pub(super) fn prepare(&mut self, frame: &mut Frame<'_, M>) -> Res<()> {
        for (handle, expression) in frame.function.expressions.iter() {
            if let Some(value) = self.ready(frame, handle, expression)? {
                frame.values[handle.index()] = Some(value);
            }
        }
        Ok(())
    }

    fn ready(
        &mut self,
        frame: &Frame<'_, M>,
        handle: Handle<Expression>,
        expression: &Expression,
    ) -> Res<Option<Value<M>>> {
        Ok(match *expression {
            Expression::Literal(literal) => Some(Value::data(vec![
                self.literal(frame.scope, handle, literal).map_err(|what| frame.unsupported(what))?,
            ])),
            Expression::Constant(constant) => {
                let init = self.module.module().constants[constant].init;
                Some(Value::data(self.global(init)?))
            }
            Expression::ZeroValue(ty) => {
                Some(Value::data(self.zeros(&self.types().kinds(Pointee::Type(ty))?)))
            }
            Expression::FunctionArgument(index) => frame.arguments.get(index as usize).cloned(),
            Expression::LocalVariable(variable) => Some(Value::Pointer(Pointer {
                root: Root::Lane(frame.locals + variable.index()),
                offset: Offset::Uniform(0),
                pointee: Pointee::Type(frame.function.local_variables[variable].ty),
            })),
            Expression::GlobalVariable(variable) => self.globals[variable.index()].map(|root| {
                Value::Pointer(Pointer {
                    root,
                    offset: Offset::Uniform(0),
                    pointee: Pointee::Type(self.module.module().global_variables[variable].ty),
                })
            }),
            Expression::Override(_) => return Err(frame.unsupported("Expression::Override")),
            Expression::Compose { .. }
            | Expression::Access { .. }
            | Expression::AccessIndex { .. }
            | Expression::Splat { .. }
            | Expression::Swizzle { .. }
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
            | Expression::CooperativeMultiplyAdd { .. } => None,
        })
    }

    /// A literal in every lane; the exact value of a float is the one that its decimal text states.
    fn literal(&self, scope: Scope, handle: Handle<Expression>, literal: Literal) -> Result<Leaf<M>, String> {
        let m = &self.model;
        Ok(match literal {
            Literal::F32(value) => {
                let exact = self.module.meta().exact.get(&(scope, handle)).copied();
                Leaf::from_floats(vec![m.float(value, exact.unwrap_or(value.into())); self.lanes])
            }
            Literal::U32(value) => Leaf::from_words(vec![m.word(value); self.lanes]),
            Literal::I32(value) => Leaf::from_words(vec![m.word(value as u32); self.lanes]),
            Literal::Bool(value) => Leaf::from_bools(vec![m.boolean(value); self.lanes]),
            Literal::F64(_)
            | Literal::F16(_)
            | Literal::U16(_)
            | Literal::I16(_)
            | Literal::U64(_)
            | Literal::I64(_)
            | Literal::AbstractInt(_)
            | Literal::AbstractFloat(_) => return Err(format!("the literal {literal:?}")),
        })
    }

    /// A global expression.
    pub(super) fn global(&self, handle: Handle<Expression>) -> Res<Vec<Leaf<M>>> {
        let module = self.module.module();
        let refuse = |what: String| InterpError::Unsupported { what, function: "constants".to_owned() };
        match &module.global_expressions[handle] {
            Expression::Literal(literal) => {
                Ok(vec![self.literal(Scope::Global, handle, *literal).map_err(refuse)?])
            }
            Expression::Constant(constant) => self.global(module.constants[*constant].init),
            Expression::ZeroValue(ty) => Ok(self.zeros(&self.types().kinds(Pointee::Type(*ty))?)),
            Expression::Compose { components, .. } => {
                let parts = components.iter().map(|c| self.global(*c)).collect::<Res<Vec<_>>>()?;
                Ok(parts.concat())
            }
            Expression::Splat { size, value } => {
                let value = self.global(*value)?;
                Ok(std::iter::repeat_n(value, *size as usize).flatten().collect())
            }
            other @ (Expression::Override(_)
            | Expression::Access { .. }
            | Expression::AccessIndex { .. }
            | Expression::Swizzle { .. }
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

    /// First value of a global variable.
    pub(in super::super) fn initial(
        &self,
        ty: Handle<naga::Type>,
        init: Option<Handle<Expression>>,
    ) -> Res<Vec<Leaf<M>>> {
        match init {
            Some(init) => self.global(init),
            None => Ok(self.zeros(&self.types().kinds(Pointee::Type(ty))?)),
        }
    }
}
