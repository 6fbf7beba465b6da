//! Expressions that an `Emit` computes.

use super::super::error::Res;
use super::super::leaf::Leaf;
use super::super::model::Model;
use super::{Frame, Machine, Value};
use naga::{Expression, Handle, RelationalFunction, TypeInner, UnaryOperator};

impl<'m, M: Model> Machine<'m, M> {
    /// Computes `handle` in all lanes.
    pub(super) fn emit(&mut self, frame: &mut Frame<'m, M>, handle: Handle<Expression>) -> Res<()> {
        if frame.values[handle.index()].is_some() && frame.function.expressions[handle].needs_pre_emit() {
            return Ok(());
        }
        let value = self.evaluate(frame, handle)?;
        frame.values[handle.index()] = Some(value);
        Ok(())
    }

    fn evaluate(&mut self, frame: &Frame<'m, M>, handle: Handle<Expression>) -> Res<Value<M>> {
        match frame.function.expressions[handle] {
            Expression::Compose { ref components, .. } => {
                let parts = components.iter().map(|c| frame.data(*c)).collect::<Res<Vec<_>>>()?;
                Ok(Value::data(parts.concat()))
            }
            Expression::Splat { size, value } => {
                Ok(Value::data(vec![frame.scalar(value)?.clone(); size as usize]))
            }
            Expression::Swizzle { size, vector, pattern } => {
                let leaves = frame.data(vector)?;
                let taken = pattern.iter().take(size as usize).filter_map(|c| leaves.get(*c as usize));
                Ok(Value::data(taken.cloned().collect()))
            }
            Expression::Access { base, index } => self.access(frame, base, index),
            Expression::AccessIndex { base, index } => self.access_index(frame, base, index),
            Expression::Load { pointer } => {
                let pointer = frame.pointer(pointer)?;
                Ok(Value::data(self.memory.load(&self.model, self.types(), pointer, self.lanes)?))
            }
            Expression::ArrayLength(array) => self.array_length(frame, array),
            Expression::Unary { op, expr } => Ok(Value::data(self.unary(frame, op, expr)?)),
            Expression::Binary { op, left, right } => Ok(Value::data(self.binary(frame, op, left, right)?)),
            Expression::Select { condition, accept, reject } => {
                let [condition, accept, reject] =
                    [frame.data(condition)?, frame.data(accept)?, frame.data(reject)?];
                Ok(Value::data(self.select(&frame.flow.active, condition, accept, reject)?))
            }
            Expression::Relational { fun, argument } => {
                Ok(Value::data(self.relational(fun, frame.data(argument)?)?))
            }
            Expression::Math { fun, arg, arg1, arg2, arg3 } => {
                let rest = [arg1, arg2, arg3];
                Ok(Value::data(self.math(frame, fun, arg, rest)?))
            }
            Expression::As { expr, kind, convert } => Ok(Value::data(self.cast(frame, expr, kind, convert)?)),
            ref other @ (Expression::Literal(_)
            | Expression::Constant(_)
            | Expression::Override(_)
            | Expression::ZeroValue(_)
            | Expression::FunctionArgument(_)
            | Expression::GlobalVariable(_)
            | Expression::LocalVariable(_)
            | Expression::ImageSample { .. }
            | Expression::ImageLoad { .. }
            | Expression::ImageQuery { .. }
            | Expression::Derivative { .. }
            | Expression::CallResult(_)
            | Expression::AtomicResult { .. }
            | Expression::WorkGroupUniformLoadResult { .. }
            | Expression::RayQueryVertexPositions { .. }
            | Expression::RayQueryProceedResult
            | Expression::RayQueryGetIntersection { .. }
            | Expression::SubgroupBallotResult
            | Expression::SubgroupOperationResult { .. }
            | Expression::CooperativeLoad { .. }
            | Expression::CooperativeMultiplyAdd { .. }) => Err(frame.unsupported(format!("{other:?}"))),
        }
    }

    /// The type of an expression.
    pub(super) fn type_of(&self, frame: &Frame<'m, M>, handle: Handle<Expression>) -> &'m TypeInner {
        frame.info[handle].ty.inner_with(&self.module.module().types)
    }

    fn unary(
        &self,
        frame: &Frame<'m, M>,
        op: UnaryOperator,
        operand: Handle<Expression>,
    ) -> Res<Vec<Leaf<M>>> {
        let m = &self.model;
        let leaves = frame.data(operand)?.iter();
        match op {
            UnaryOperator::Negate => leaves
                .map(|leaf| match leaf {
                    Leaf::Float(_) => self.map_f(leaf, |a| m.neg(a)),
                    Leaf::Word(_) | Leaf::Bool(_) => self.map_w(leaf, u32::wrapping_neg),
                })
                .collect(),
            UnaryOperator::LogicalNot => leaves.map(|leaf| self.map_b(leaf, |a| m.not(a))).collect(),
            UnaryOperator::BitwiseNot => leaves.map(|leaf| self.map_w(leaf, |a| !a)).collect(),
        }
    }

    fn relational(&self, fun: RelationalFunction, leaves: &[Leaf<M>]) -> Res<Vec<Leaf<M>>> {
        let m = &self.model;
        let fold = |f: &dyn Fn(M::B, M::B) -> M::B| {
            let (first, rest) =
                leaves.split_first().ok_or(super::InterpError::Malformed("a vector without components"))?;
            let all = rest.iter().try_fold(first.clone(), |all, leaf| self.zip_b(&all, leaf, f));
            Ok(vec![all?])
        };
        let test = |f: &dyn Fn(M::F) -> M::B| {
            let one = |leaf: &Leaf<M>| Ok(Leaf::from_bools(leaf.floats()?.iter().map(|a| f(*a)).collect()));
            leaves.iter().map(one).collect()
        };
        match fun {
            RelationalFunction::All => fold(&|a, b| m.and(a, b)),
            RelationalFunction::Any => fold(&|a, b| m.or(a, b)),
            RelationalFunction::IsNan => test(&|a| m.is_nan(a)),
            RelationalFunction::IsInf => test(&|a| m.is_inf(a)),
        }
    }
}
