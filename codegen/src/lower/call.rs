//! Calls of kernels and of intrinsics.

use super::body::BodyBuilder;
use super::error::{Fail, Lowered};
use super::operator::parts;
use super::value::{BOOL, F32, Place, U32, Value};
use crate::def::{Expr, FunctionDef, Scalar, Span, TypeDef};
use crate::intrinsics::{Intrinsic, Op, Row, Shape};
use naga::{Expression, Statement};

impl BodyBuilder<'_> {
    /// Calls a kernel; the result, if it returns one.
    pub(super) fn call(
        &mut self,
        def: &'static FunctionDef,
        arguments: &'static [Expr],
        span: Span,
    ) -> Lowered<Option<Value>> {
        if def.entry.is_some() {
            return Err(Fail::new(
                span,
                format!("`{}` is an entry point, which only the host calls", def.name),
            ));
        }
        let function = match self.modules.function(def) {
            Ok(function) => function,
            Err(error) => return Err(self.stop(error)),
        };
        let mut handles = Vec::new();
        for (argument, param) in arguments.iter().zip(def.params) {
            let value = self.expr_expecting(argument, Some(&param.ty))?;
            let value = self.fit(value, &param.ty, argument.span)?;
            handles.push(self.handle(value, argument.span));
        }
        let result = def.ret.map(|ty| Value::expr(ty, self.append(Expression::CallResult(function), span)));
        let handle = result.map(|value| self.handle(value, span));
        self.push(Statement::Call { function, arguments: handles, result: handle }, span);
        Ok(result)
    }

    /// An intrinsic; the result, if it has one.
    pub(super) fn intrinsic(
        &mut self,
        op: Intrinsic,
        arguments: &'static [Expr],
        expected: Option<&TypeDef>,
        span: Span,
    ) -> Lowered<Option<Value>> {
        let row = op.row();
        match row.op {
            Op::Barrier(barrier) => {
                self.push(Statement::ControlBarrier(barrier), span);
                Ok(None)
            }
            Op::AtomicLoad | Op::AtomicStore | Op::Atomic(_) => self.atomic(row, arguments, span),
            Op::Math(_) | Op::Relational(_) | Op::Select => {
                let values = self.arguments(row, arguments, expected, span)?;
                self.pure(row, &values, span).map(Some)
            }
        }
    }

    /// The arguments; integers without suffix take the type of the others.
    fn arguments(
        &mut self,
        row: &Row,
        arguments: &'static [Expr],
        expected: Option<&TypeDef>,
        span: Span,
    ) -> Lowered<Vec<Value>> {
        let hint = if matches!(row.shape, Shape::Reduce(_) | Shape::Relational) { None } else { expected };
        let mut values = Vec::new();
        for argument in arguments {
            values.push(self.expr_expecting(argument, hint)?);
        }
        let decided = values.iter().find(|v| !v.is_undecided() && v.ty != BOOL).map(|v| v.ty);
        if let Some(ty) = decided {
            values.iter_mut().for_each(|v| *v = v.decide(&ty));
        }
        if matches!(row.shape, Shape::ExtractBits | Shape::InsertBits) {
            let first = values.len().saturating_sub(2);
            values[first..].iter_mut().for_each(|v| *v = v.decide(&U32));
        }
        if values.is_empty() {
            return Err(Fail::new(span, format!("`{}` takes arguments", row.name)));
        }
        Ok(values)
    }

    /// An operation without effect on values.
    pub(super) fn pure(&mut self, row: &Row, values: &[Value], span: Span) -> Lowered<Value> {
        let ty = signature(row.shape, values).ok_or_else(|| {
            let found = values.iter().map(|v| v.ty.to_string()).collect::<Vec<_>>().join(", ");
            Fail::new(span, format!("`{}` does not take ({found})", row.name))
        })?;
        let handles: Vec<_> = values.iter().map(|v| self.handle(*v, span)).collect();
        let expression = match row.op {
            Op::Math(fun) => Expression::Math {
                fun,
                arg: handles[0],
                arg1: handles.get(1).copied(),
                arg2: handles.get(2).copied(),
                arg3: handles.get(3).copied(),
            },
            Op::Relational(fun) => Expression::Relational { fun, argument: handles[0] },
            Op::Select => {
                Expression::Select { reject: handles[0], accept: handles[1], condition: handles[2] }
            }
            Op::Atomic(_) | Op::AtomicLoad | Op::AtomicStore | Op::Barrier(_) => {
                return Err(Fail::new(span, format!("`{}` stands as a statement", row.name)));
            }
        };
        Ok(self.value(ty, expression, span))
    }

    fn atomic(&mut self, row: &Row, arguments: &'static [Expr], span: Span) -> Lowered<Option<Value>> {
        let Some(target) = arguments.first() else { return Err(Fail::new(span, "an atomic is missing")) };
        let place = self.place(target)?;
        let Some(Place { pointer, ty: TypeDef::Atomic(kind) }) = place else {
            return Err(Fail::new(target.span, format!("`{}` takes a reference to an atomic", row.name)));
        };
        let ty = TypeDef::Scalar(kind);
        if row.op == Op::AtomicLoad {
            return Ok(Some(self.load(Place { pointer, ty }, span)));
        }
        let Some(argument) = arguments.get(1) else { return Err(Fail::new(span, "a value is missing")) };
        let value = self.expr_expecting(argument, Some(&ty))?;
        let value = self.fit(value, &ty, argument.span)?;
        match row.op {
            Op::Atomic(fun) => {
                let value = self.handle(value, argument.span);
                let naga_ty = self.modules.ty(&ty);
                let result = self.append(Expression::AtomicResult { ty: naga_ty, comparison: false }, span);
                self.push(Statement::Atomic { pointer, fun, value, result: Some(result) }, span);
                Ok(Some(Value::expr(ty, result)))
            }
            _ => {
                self.store(Place { pointer, ty }, value, span);
                Ok(None)
            }
        }
    }
}

/// The result's type, if the arguments fit.
fn signature(shape: Shape, values: &[Value]) -> Option<TypeDef> {
    let types: Vec<TypeDef> = values.iter().map(|v| v.ty).collect();
    let first = *types.first()?;
    let same = |n: u8| types.len() == usize::from(n) && types.iter().all(|t| *t == first);
    let kind = parts(&first).map(|(_, s)| s);
    let is_float_vector = matches!(first, TypeDef::Vector(_, Scalar::F32));
    let is_integer = matches!(kind, Some(Scalar::I32 | Scalar::U32));
    let ok = match shape {
        Shape::Float(n) => same(n) && kind == Some(Scalar::F32),
        Shape::Numeric(n) => same(n) && matches!(kind, Some(Scalar::F32 | Scalar::I32 | Scalar::U32)),
        Shape::Signed => same(1) && matches!(kind, Some(Scalar::F32 | Scalar::I32)),
        Shape::Integer => same(1) && is_integer,
        Shape::ExtractBits => is_integer && types[1..] == [U32, U32],
        Shape::InsertBits => is_integer && types.len() == 4 && types[1] == first && types[2..] == [U32, U32],
        Shape::Reduce(n) | Shape::Vector(n) => same(n) && is_float_vector,
        Shape::Cross => same(2) && first == TypeDef::Vector(3, Scalar::F32),
        Shape::Refract => is_float_vector && types[1..] == [first, F32],
        Shape::Transpose => types.len() == 1 && matches!(first, TypeDef::Matrix(..)),
        Shape::Select => kind.is_some() && types[1..] == [first, BOOL],
        Shape::Relational => same(1) && kind == Some(Scalar::Bool) && first != BOOL,
        Shape::AtomicLoad | Shape::AtomicStore | Shape::AtomicUpdate | Shape::Barrier => false,
    };
    let result = match shape {
        Shape::Reduce(_) => F32,
        Shape::Relational => BOOL,
        _ => first,
    };
    ok.then_some(result)
}
