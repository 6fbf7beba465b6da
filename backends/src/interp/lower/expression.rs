//! Expressions that an `Emit` computes, each by its family.

use super::super::error::Res;
use super::super::program::Value;
use super::Lowerer;
use super::frame::{Frame, Item};
use naga::{Expression, Handle};

impl<'m> Lowerer<'m> {
    /// Computes `handle`.
    pub(crate) fn emit(&mut self, frame: &mut Frame<'m>, handle: Handle<Expression>) -> Res<()> {
        if frame.values[handle.index()].is_some() && frame.function.expressions[handle].needs_pre_emit() {
            return Ok(());
        }
        self.b.at = frame.function.expressions.get_span(handle);
        let item = self.evaluate(frame, handle)?;
        frame.values[handle.index()] = Some(item);
        Ok(())
    }

    fn evaluate(&mut self, frame: &Frame<'m>, handle: Handle<Expression>) -> Res<Item> {
        match frame.function.expressions[handle] {
            Expression::Compose { ref components, .. } => {
                let parts = components.iter().map(|c| frame.data(*c)).collect::<Res<Vec<_>>>()?;
                Ok(Item::values(parts.concat()))
            }
            Expression::Splat { size, value } => Ok(Item::values(vec![frame.single(value)?; size as usize])),
            Expression::Swizzle { size, vector, pattern } => {
                let values = frame.data(vector)?;
                let taken = pattern.iter().take(size as usize).filter_map(|c| values.get(*c as usize));
                Ok(Item::values(taken.copied().collect()))
            }
            Expression::Access { base, index } => self.access(frame, base, index),
            Expression::AccessIndex { base, index } => self.access_index(frame, base, index),
            Expression::Load { pointer } => Ok(Item::values(self.load(frame.pointer(pointer)?)?)),
            Expression::ArrayLength(array) => self.array_length(frame, array),
            Expression::Unary { op, expr } => Ok(Item::values(self.unary(frame, op, expr)?)),
            Expression::Binary { op, left, right } => Ok(Item::values(self.binary(frame, op, left, right)?)),
            Expression::Select { condition, accept, reject } => {
                let [condition, accept, reject] =
                    [frame.data(condition)?, frame.data(accept)?, frame.data(reject)?];
                let conditions = condition.iter().cycle();
                let pairs = conditions.zip(accept.iter().zip(reject.iter()));
                Ok(Item::values(pairs.map(|(c, (a, r))| self.b.select(*c, *a, *r)).collect()))
            }
            Expression::Relational { fun, argument } => {
                let values = frame.data(argument)?;
                Ok(Item::values(self.relational(fun, &values)?))
            }
            Expression::Math { fun, arg, arg1, arg2, arg3 } => {
                Ok(Item::values(self.math(frame, fun, arg, [arg1, arg2, arg3])?))
            }
            Expression::As { expr, kind, convert } => {
                Ok(Item::values(self.cast(frame, expr, kind, convert)?))
            }
            Expression::ImageSample { .. } | Expression::ImageLoad { .. } | Expression::ImageQuery { .. } => {
                self.read_texture(frame, handle)
            }
            ref other @ (Expression::Literal(_)
            | Expression::Constant(_)
            | Expression::Override(_)
            | Expression::ZeroValue(_)
            | Expression::FunctionArgument(_)
            | Expression::GlobalVariable(_)
            | Expression::LocalVariable(_)
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

    /// `f` of each pair of scalars; a lone one goes with all of the other side.
    pub(crate) fn pairs(
        &mut self,
        a: &[Value],
        b: &[Value],
        mut f: impl FnMut(&mut Self, Value, Value) -> Value,
    ) -> Vec<Value> {
        match (a, b) {
            ([a], b) => b.iter().map(|b| f(self, *a, *b)).collect(),
            (a, [b]) => a.iter().map(|a| f(self, *a, *b)).collect(),
            (a, b) => a.iter().zip(b).map(|(a, b)| f(self, *a, *b)).collect(),
        }
    }
}
