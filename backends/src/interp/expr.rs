//! Expressions over all lanes.

use super::error::{Fault, Internal, Result};
use super::exec::{Executor, Frame, first_word};
use super::model::{Comparison, F1, F2, Model};
use super::value::{Column, Offset, Pointee, Pointer, Root, Slot, Value, kind, kinds, width};
use lobe_codegen::module::Scope;
use naga::{
    BinaryOperator, Expression, Handle, Literal, RelationalFunction, ScalarKind, TypeInner, UnaryOperator,
};
use std::rc::Rc;

impl<'m, M: Model> Executor<'m, M> {
    /// The type of an expression.
    pub(super) fn inner(&self, frame: &Frame<'m, M>, handle: Handle<Expression>) -> &'m TypeInner {
        let module = self.module;
        let info: &'m naga::valid::FunctionInfo = frame.info;
        info[handle].ty.inner_with(&module.module().types)
    }

    /// Whether an expression's scalars are signed integers.
    pub(super) fn is_signed(&self, frame: &Frame<'m, M>, handle: Handle<Expression>) -> bool {
        self.scalar_kind(frame, handle) == Some(ScalarKind::Sint)
    }

    fn scalar_kind(&self, frame: &Frame<'m, M>, handle: Handle<Expression>) -> Option<ScalarKind> {
        self.inner(frame, handle).scalar_kind()
    }

    /// Evaluates an expression whose operands have been.
    pub(super) fn evaluate(
        &mut self,
        frame: &mut Frame<'m, M>,
        handle: Handle<Expression>,
    ) -> Result<Slot<M>> {
        let function = frame.function;
        let value = match function.expressions[handle] {
            Expression::Literal(literal) => {
                let exact = self.module.meta().exact.get(&(frame.scope, handle)).copied();
                vec![self.literal(literal, exact)?]
            }
            Expression::Constant(constant) => {
                let init = self.module.module().constants[constant].init;
                return Ok(Slot::Value(Rc::new(self.global(init)?)));
            }
            Expression::ZeroValue(ty) => self.zero(&self.module.module().types[ty].inner)?,
            Expression::Compose { ref components, .. } => {
                let mut columns = Vec::new();
                for component in components {
                    columns.extend(self.value(frame, *component)?.iter().cloned());
                }
                columns
            }
            Expression::Splat { size, value } => {
                let value = self.value(frame, value)?;
                vec![value[0].clone(); size as usize]
            }
            Expression::Swizzle { size, vector, pattern } => {
                let vector = self.value(frame, vector)?;
                pattern[..size as usize].iter().map(|c| vector[*c as usize].clone()).collect()
            }
            Expression::FunctionArgument(index) => return Ok(frame.arguments[index as usize].clone()),
            Expression::LocalVariable(variable) => return Ok(Slot::Pointer(Self::local(frame, variable))),
            Expression::GlobalVariable(variable) => {
                let ty = self.module.module().global_variables[variable].ty;
                let ty = Pointee::Type(ty);
                return Ok(Slot::Pointer(Pointer {
                    root: Root::Shared(variable),
                    offset: Offset::Same(0),
                    ty,
                }));
            }
            Expression::Load { pointer } => {
                let pointer = self.pointer(frame, pointer)?;
                return Ok(Slot::Value(self.load(&pointer)?));
            }
            Expression::Access { base, index } => return self.access(frame, base, index),
            Expression::AccessIndex { base, index } => return self.access_index(frame, base, index as usize),
            Expression::Unary { op, expr } => self.unary(frame, op, expr)?,
            Expression::Binary { op, left, right } => self.binary(frame, op, left, right)?,
            Expression::Select { condition, accept, reject } => {
                self.select(frame, condition, accept, reject)?
            }
            Expression::Relational { fun, argument } => self.relational(frame, fun, argument)?,
            Expression::Math { fun, arg, arg1, arg2, arg3 } => {
                self.math(frame, fun, [Some(arg), arg1, arg2, arg3])?
            }
            Expression::As { expr, kind, convert } => self.cast(frame, expr, kind, convert)?,
            Expression::ArrayLength(pointer) => {
                let pointer = self.pointer(frame, pointer)?;
                let length = self.array_length(&pointer)? as u32;
                vec![Column::W(vec![M::word(length); self.lanes])]
            }
            Expression::CallResult(_)
            | Expression::AtomicResult { .. }
            | Expression::WorkGroupUniformLoadResult { .. } => return Err(Internal::NotEvaluated.into()),
            Expression::Override(_)
            | Expression::ImageSample { .. }
            | Expression::ImageLoad { .. }
            | Expression::ImageQuery { .. }
            | Expression::Derivative { .. }
            | Expression::RayQueryVertexPositions { .. }
            | Expression::RayQueryProceedResult
            | Expression::RayQueryGetIntersection { .. }
            | Expression::SubgroupBallotResult
            | Expression::SubgroupOperationResult { .. }
            | Expression::CooperativeLoad { .. }
            | Expression::CooperativeMultiplyAdd { .. } => {
                let name = first_word(&format!("{:?}", function.expressions[handle]));
                return Err(Fault::Unsupported(format!("the expression {name}")));
            }
        };
        Ok(Slot::Value(Rc::new(value)))
    }

    fn literal(&self, literal: Literal, exact: Option<f64>) -> Result<Column<M>> {
        Ok(match literal {
            Literal::F32(v) => Column::F(vec![M::float(v, exact.unwrap_or(v.into())); self.lanes]),
            Literal::I32(v) => Column::W(vec![M::word(v as u32); self.lanes]),
            Literal::U32(v) => Column::W(vec![M::word(v); self.lanes]),
            Literal::Bool(v) => Column::B(vec![M::bool(v); self.lanes]),
            Literal::F64(_)
            | Literal::F16(_)
            | Literal::U16(_)
            | Literal::I16(_)
            | Literal::U64(_)
            | Literal::I64(_)
            | Literal::AbstractInt(_)
            | Literal::AbstractFloat(_) => return Err(Internal::Type.into()),
        })
    }

    /// A constant expression of the module.
    pub(super) fn global(&mut self, handle: Handle<Expression>) -> Result<Vec<Column<M>>> {
        let module = self.module.module();
        match module.global_expressions[handle] {
            Expression::Literal(literal) => {
                let exact = self.module.meta().exact.get(&(Scope::Global, handle)).copied();
                Ok(vec![self.literal(literal, exact)?])
            }
            Expression::Constant(constant) => self.global(module.constants[constant].init),
            Expression::ZeroValue(ty) => self.zero(&module.types[ty].inner),
            Expression::Compose { ref components, .. } => {
                let parts = components.iter().map(|c| self.global(*c)).collect::<Result<Vec<_>>>()?;
                Ok(parts.concat())
            }
            Expression::Splat { size, value } => {
                let value = self.global(value)?;
                Ok(vec![value[0].clone(); size as usize])
            }
            ref other => Err(Fault::Unsupported(format!(
                "the constant expression {}",
                first_word(&format!("{other:?}"))
            ))),
        }
    }

    pub(super) fn zero(&self, inner: &TypeInner) -> Result<Vec<Column<M>>> {
        let mut all = Vec::new();
        kinds(self.module.module(), inner, &mut all)?;
        Ok(all.into_iter().map(|k| Column::zero(k, self.lanes)).collect())
    }

    // ---- parts of composites

    /// Scalars of each part, and parts, of what an expression (or the target of a pointer) is.
    fn parts(&self, inner: &TypeInner) -> Result<(usize, usize, Pointee)> {
        let types = &self.module.module().types;
        Ok(match *inner {
            TypeInner::Vector { size, scalar } => (1, size as usize, Pointee::Scalars(1, kind(scalar)?)),
            TypeInner::Matrix { columns, rows, scalar } => {
                (rows as usize, columns as usize, Pointee::Scalars(rows as usize, kind(scalar)?))
            }
            TypeInner::Array { base, size, .. } => {
                let count = super::value::fixed(size)?.unwrap_or(usize::MAX);
                (width(self.module.module(), &types[base].inner)?, count, Pointee::Type(base))
            }
            _ => return Err(Internal::Type.into()),
        })
    }

    fn access(
        &mut self,
        frame: &mut Frame<'m, M>,
        base: Handle<Expression>,
        index: Handle<Expression>,
    ) -> Result<Slot<M>> {
        let index = self.value(frame, index)?;
        let words = index[0].words()?;
        for (i, &word) in words.iter().enumerate() {
            self.notes.indeterminate[i] |= !M::is_known(word) && frame.flow.live[i];
        }
        // Out of bounds means the last element; a negative index is a large one.
        let clamped = |count: usize| {
            words
                .iter()
                .map(move |&w| (M::word_value(w) as usize).min(count.saturating_sub(1)))
                .collect::<Vec<_>>()
        };
        match self.slot(frame, base)? {
            Slot::Pointer(pointer) => {
                let (step, mut count, ty) = self.pointee_parts(&pointer)?;
                if count == usize::MAX {
                    count = self.array_length(&pointer)?;
                }
                let offsets = clamped(count)
                    .iter()
                    .enumerate()
                    .map(|(i, at)| pointer.offset.lane(i) + at * step)
                    .collect();
                Ok(Slot::Pointer(Pointer { offset: Offset::Each(Rc::new(offsets)), ty, ..pointer }))
            }
            Slot::Value(value) => {
                let (step, count, _) = self.parts(self.inner(frame, base))?;
                let at = clamped(count);
                let mut part = value[..step].to_vec();
                for (k, column) in part.iter_mut().enumerate() {
                    for (i, at) in at.iter().enumerate() {
                        column.copy_lane(&value[at * step + k], i);
                    }
                }
                Ok(Slot::Value(Rc::new(part)))
            }
        }
    }

    fn pointee_parts(&self, pointer: &Pointer) -> Result<(usize, usize, Pointee)> {
        match pointer.ty {
            Pointee::Type(ty) => self.parts(&self.module.module().types[ty].inner),
            Pointee::Scalars(n, kind) => Ok((1, n, Pointee::Scalars(1, kind))),
        }
    }

    fn access_index(
        &mut self,
        frame: &mut Frame<'m, M>,
        base: Handle<Expression>,
        index: usize,
    ) -> Result<Slot<M>> {
        let types = &self.module.module().types;
        match self.slot(frame, base)? {
            Slot::Pointer(pointer) => {
                let (offset, ty) = match pointer.ty {
                    Pointee::Type(ty) => match types[ty].inner {
                        TypeInner::Struct { ref members, .. } => {
                            (self.member_offset(members, index)?, Pointee::Type(members[index].ty))
                        }
                        ref inner => {
                            let (step, mut count, ty) = self.parts(inner)?;
                            if count == usize::MAX {
                                count = self.array_length(&pointer)?;
                            }
                            (index.min(count.saturating_sub(1)) * step, ty)
                        }
                    },
                    Pointee::Scalars(_, kind) => (index, Pointee::Scalars(1, kind)),
                };
                let offset = match &pointer.offset {
                    Offset::Same(o) => Offset::Same(o + offset),
                    Offset::Each(each) => Offset::Each(Rc::new(each.iter().map(|o| o + offset).collect())),
                };
                Ok(Slot::Pointer(Pointer { offset, ty, ..pointer }))
            }
            Slot::Value(value) => {
                let (offset, count) = match self.inner(frame, base) {
                    TypeInner::Struct { members, .. } => (
                        self.member_offset(members, index)?,
                        width(self.module.module(), &types[members[index].ty].inner)?,
                    ),
                    inner => {
                        let (step, _, _) = self.parts(inner)?;
                        (index * step, step)
                    }
                };
                Ok(Slot::Value(Rc::new(value[offset..offset + count].to_vec())))
            }
        }
    }

    fn member_offset(&self, members: &[naga::StructMember], index: usize) -> Result<usize> {
        let types = &self.module.module().types;
        members[..index].iter().map(|m| width(self.module.module(), &types[m.ty].inner)).sum()
    }

    // ---- operators

    fn unary(
        &mut self,
        frame: &mut Frame<'m, M>,
        op: UnaryOperator,
        expr: Handle<Expression>,
    ) -> Result<Vec<Column<M>>> {
        let value = self.value(frame, expr)?;
        value
            .iter()
            .map(|column| {
                Ok(match (op, column) {
                    (UnaryOperator::Negate, Column::F(x)) => Column::F(map(x, M::f1(F1::Negate))),
                    (UnaryOperator::Negate, Column::W(x)) => {
                        Column::W(map(x, |x| M::w1(x, u32::wrapping_neg)))
                    }
                    (UnaryOperator::BitwiseNot, Column::W(x)) => Column::W(map(x, |x| M::w1(x, |x| !x))),
                    (UnaryOperator::LogicalNot, Column::B(x)) => Column::B(map(x, M::not)),
                    (UnaryOperator::Negate | UnaryOperator::BitwiseNot | UnaryOperator::LogicalNot, _) => {
                        return Err(Internal::Kind.into());
                    }
                })
            })
            .collect()
    }

    fn binary(
        &mut self,
        frame: &mut Frame<'m, M>,
        op: BinaryOperator,
        left: Handle<Expression>,
        right: Handle<Expression>,
    ) -> Result<Vec<Column<M>>> {
        let (l, r) = (self.value(frame, left)?, self.value(frame, right)?);
        let (l_inner, r_inner) = (self.inner(frame, left), self.inner(frame, right));
        if op == BinaryOperator::Multiply
            && let Some(product) = super::matrix::multiply::<M>(l_inner, r_inner, &l, &r)?
        {
            return Ok(product);
        }
        let signed = l_inner.scalar_kind() == Some(ScalarKind::Sint);
        let n = l.len().max(r.len());
        (0..n)
            .map(|i| {
                // A scalar meets every component.
                let (a, b) = (&l[if l.len() == 1 { 0 } else { i }], &r[if r.len() == 1 { 0 } else { i }]);
                super::operator::binary::<M>(op, a, b, signed)
            })
            .collect()
    }

    fn select(
        &mut self,
        frame: &mut Frame<'m, M>,
        condition: Handle<Expression>,
        accept: Handle<Expression>,
        reject: Handle<Expression>,
    ) -> Result<Vec<Column<M>>> {
        let condition = self.value(frame, condition)?;
        let (accept, reject) = (self.value(frame, accept)?, self.value(frame, reject)?);
        for column in condition.iter() {
            for (i, &lane) in column.bools()?.iter().enumerate() {
                self.notes.ambiguous[i] |= M::is_ambiguous(lane) && frame.flow.live[i];
            }
        }
        (0..accept.len())
            .map(|i| {
                let condition = &condition[if condition.len() == 1 { 0 } else { i }];
                Column::select(condition.bools()?, &accept[i], &reject[i])
            })
            .collect()
    }

    fn relational(
        &mut self,
        frame: &mut Frame<'m, M>,
        fun: RelationalFunction,
        argument: Handle<Expression>,
    ) -> Result<Vec<Column<M>>> {
        let value = self.value(frame, argument)?;
        let fold = |f: fn(M::B, M::B) -> M::B| -> Result<Vec<Column<M>>> {
            let mut lanes = value[0].bools()?.to_vec();
            for column in &value[1..] {
                lanes = zip(&lanes, column.bools()?, f);
            }
            Ok(vec![Column::B(lanes)])
        };
        match fun {
            RelationalFunction::All => fold(M::and),
            RelationalFunction::Any => fold(|a, b| M::not(M::and(M::not(a), M::not(b)))),
            RelationalFunction::IsNan => value.iter().map(|c| is_nan::<M>(c)).collect(),
            RelationalFunction::IsInf => Err(Fault::Unsupported("isInf".to_owned())),
        }
    }

    fn cast(
        &mut self,
        frame: &mut Frame<'m, M>,
        expr: Handle<Expression>,
        to: ScalarKind,
        convert: Option<u8>,
    ) -> Result<Vec<Column<M>>> {
        let from = self.scalar_kind(frame, expr).ok_or(Internal::Kind)?;
        if !matches!(convert, None | Some(4)) && to != ScalarKind::Bool {
            return Err(Internal::Type.into());
        }
        let value: Value<M> = self.value(frame, expr)?;
        value.iter().map(|column| super::operator::cast::<M>(column, from, to, convert.is_some())).collect()
    }
}

fn is_nan<M: Model>(column: &Column<M>) -> Result<Column<M>> {
    Ok(Column::B(map(column.floats()?, |x| M::compare(Comparison::NotEqual, x, x))))
}

/// Applies `f` in every lane.
pub(super) fn map<T: Copy, R>(x: &[T], f: impl Fn(T) -> R) -> Vec<R> {
    x.iter().map(|&x| f(x)).collect()
}

/// Applies `f` in every lane.
pub(super) fn zip<T: Copy, U: Copy, R>(x: &[T], y: &[U], f: impl Fn(T, U) -> R) -> Vec<R> {
    x.iter().zip(y).map(|(&x, &y)| f(x, y)).collect()
}

/// A float operation on two columns.
pub(super) fn f2<M: Model>(op: F2, a: &Column<M>, b: &Column<M>) -> Result<Column<M>> {
    Ok(Column::F(zip(a.floats()?, b.floats()?, M::f2(op))))
}

/// A float operation on a column.
pub(super) fn f1<M: Model>(op: F1, a: &Column<M>) -> Result<Column<M>> {
    Ok(Column::F(map(a.floats()?, M::f1(op))))
}
