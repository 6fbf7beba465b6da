//! Methods, associated functions and constants of scalars, vectors and matrices.

use super::body::BodyBuilder;
use super::error::{Fail, Lowered};
use super::expr::float_of;
use super::fold;
use super::module::{element, vector_size};
use super::operator::parts;
use super::value::{F32, I32, Lit, U32, Value};
use crate::def::{BinaryOp, Expr, Scalar, Span, TypeDef};
use crate::intrinsics::Intrinsic;
use naga::{Expression, SwizzleComponent};

impl BodyBuilder<'_> {
    /// `receiver.name(arguments)`.
    pub(super) fn method(
        &mut self,
        receiver: &'static Expr,
        name: &str,
        arguments: &'static [Expr],
        span: Span,
    ) -> Lowered<Value> {
        if name == "len" {
            return self.len(receiver, span);
        }
        let this = self.expr(receiver)?;
        let mut others = Vec::new();
        for argument in arguments {
            others.push(self.expr_expecting(argument, Some(&this.ty))?);
        }
        if arguments.is_empty() && name.len() >= 2 && name.chars().all(|c| "xyzw".contains(c)) {
            return self.swizzle(this, name, span);
        }
        let intrinsic = match name {
            "abs" => Some(Intrinsic::Abs),
            "sqrt" => Some(Intrinsic::Sqrt),
            "dot" => Some(Intrinsic::Dot),
            "cross" => Some(Intrinsic::Cross),
            "length" => Some(Intrinsic::Length),
            "mul_add" => Some(Intrinsic::Fma),
            _ => None,
        };
        if let Some(intrinsic) = intrinsic {
            let values: Vec<Value> = std::iter::once(this).chain(others).collect();
            return self.pure(intrinsic.row(), &values, span);
        }
        self.other_method(this, name, &others, span)
    }

    fn other_method(&mut self, this: Value, name: &str, others: &[Value], span: Span) -> Lowered<Value> {
        let comparison = match name {
            "cmpeq" => Some(BinaryOp::Equal),
            "cmpne" => Some(BinaryOp::NotEqual),
            "cmplt" => Some(BinaryOp::Less),
            "cmple" => Some(BinaryOp::LessEqual),
            "cmpgt" => Some(BinaryOp::Greater),
            "cmpge" => Some(BinaryOp::GreaterEqual),
            _ => None,
        };
        match (name, others, parts(&this.ty)) {
            (_, [other], Some((2..=4, _))) if comparison.is_some() && other.ty == this.ty => {
                Ok(self.compare_components(comparison.unwrap_or(BinaryOp::Equal), this, *other, span))
            }
            ("length_squared", [], Some((2..=4, Scalar::F32))) => {
                self.pure(Intrinsic::Dot.row(), &[this, this], span)
            }
            ("recip", [], Some((_, Scalar::F32))) => {
                self.binary(BinaryOp::Divide, Value::float(1.0), this, span)
            }
            ("to_bits", [], Some((1, Scalar::F32))) => self.reinterpret(this, Scalar::U32, span),
            ("wrapping_add", [other], Some((1, Scalar::I32 | Scalar::U32))) => {
                self.binary(BinaryOp::Add, this.decide(&I32), *other, span)
            }
            ("wrapping_sub", [other], Some((1, Scalar::I32 | Scalar::U32))) => {
                self.binary(BinaryOp::Subtract, this.decide(&I32), *other, span)
            }
            ("wrapping_mul", [other], Some((1, Scalar::I32 | Scalar::U32))) => {
                self.binary(BinaryOp::Multiply, this.decide(&I32), *other, span)
            }
            ("extend", [other], Some((n @ 2..=3, s))) if other.ty == TypeDef::Scalar(s) => {
                self.compose(TypeDef::Vector(n + 1, s), &[this, *other], span)
            }
            ("truncate", [], Some((n @ 3..=4, _))) => self.swizzle(this, &"xyz"[..usize::from(n) - 1], span),
            _ => {
                let found = others.iter().map(|v| v.ty.to_string()).collect::<Vec<_>>().join(", ");
                Err(Fail::new(span, format!("{} has no method `{name}({found})` here", this.ty)))
            }
        }
    }

    /// The length of an array, or of a storage slice when it runs.
    fn len(&mut self, receiver: &'static Expr, span: Span) -> Lowered<Value> {
        if let Some(TypeDef::Array(_, n)) = self.peek(receiver) {
            return Ok(Value::literal(Lit::U32(n)));
        }
        let place = self.place(receiver)?;
        match place.map(|p| (p.pointer, p.ty)) {
            Some((pointer, TypeDef::Slice(_))) => Ok(self.value(U32, Expression::ArrayLength(pointer), span)),
            _ => Err(Fail::new(span, "only arrays and storage slices have a length")),
        }
    }

    fn reinterpret(&mut self, value: Value, to: Scalar, span: Span) -> Lowered<Value> {
        let folded = fold::reinterpret(&value, to).map_err(|message| Fail::new(span, message))?;
        Ok(folded.unwrap_or_else(|| self.convert(value, to, None, span)))
    }

    fn swizzle(&mut self, this: Value, name: &str, span: Span) -> Lowered<Value> {
        let Some((n @ 2..=4, scalar)) = parts(&this.ty) else {
            return Err(Fail::new(span, format!("{} has no components", this.ty)));
        };
        let mut pattern = [SwizzleComponent::X; 4];
        for (slot, c) in pattern.iter_mut().zip(name.chars()) {
            let index = "xyzw".find(c).unwrap_or(0);
            if index >= n.into() {
                return Err(Fail::new(span, format!("{} has no component `{c}`", this.ty)));
            }
            *slot = SwizzleComponent::XYZW[index];
        }
        let count = name.len() as u8;
        let vector = self.handle(this, span);
        let swizzle = Expression::Swizzle { size: vector_size(count), vector, pattern };
        Ok(self.value(TypeDef::Vector(count, scalar), swizzle, span))
    }

    /// `ty::name(arguments)`.
    pub(super) fn type_call(
        &mut self,
        ty: &TypeDef,
        name: &str,
        arguments: &'static [Expr],
        span: Span,
    ) -> Lowered<Value> {
        let part = if (name, *ty) == ("from_bits", F32) { U32 } else { element(ty) };
        let mut values = Vec::new();
        for argument in arguments {
            let value = self.expr_expecting(argument, Some(&part))?;
            values.push(self.fit(value, &part, argument.span)?);
        }
        match (name, *ty, &values[..]) {
            ("new", TypeDef::Vector(n, _), values) if values.len() == usize::from(n) => {
                self.compose(*ty, values, span)
            }
            ("splat", TypeDef::Vector(n, _), [value]) => {
                let value = self.handle(*value, span);
                Ok(self.value(*ty, Expression::Splat { size: vector_size(n), value }, span))
            }
            ("from_cols", TypeDef::Matrix(c, _), values) if values.len() == usize::from(c) => {
                self.compose(*ty, values, span)
            }
            ("from_bits", TypeDef::Scalar(Scalar::F32), [bits]) => self.reinterpret(*bits, Scalar::F32, span),
            _ => {
                let message = format!(
                    "no `{ty}::{name}` with {} arguments here: vectors have `new` and `splat`, matrices \
                     `from_cols`, f32 `from_bits`",
                    values.len()
                );
                Err(Fail::new(span, message))
            }
        }
    }

    fn compose(&mut self, ty: TypeDef, values: &[Value], span: Span) -> Lowered<Value> {
        let components = values.iter().map(|v| self.handle(*v, span)).collect();
        let naga_ty = self.modules.ty(&ty);
        Ok(self.value(ty, Expression::Compose { ty: naga_ty, components }, span))
    }

    /// `ty::name`.
    pub(super) fn type_constant(&mut self, ty: &TypeDef, name: &str, span: Span) -> Lowered<Value> {
        let lit = match (*ty, name) {
            (TypeDef::Scalar(Scalar::F32), _) => float_constant(name).map(|v| Lit::F32(v, v.into())),
            (TypeDef::Scalar(Scalar::I32), "MAX") => Some(Lit::I32(i32::MAX)),
            (TypeDef::Scalar(Scalar::I32), "MIN") => Some(Lit::I32(i32::MIN)),
            (TypeDef::Scalar(Scalar::U32), "MAX") => Some(Lit::U32(u32::MAX)),
            (TypeDef::Scalar(Scalar::U32), "MIN") => Some(Lit::U32(0)),
            _ => None,
        };
        if let Some(lit) = lit {
            return Ok(Value::literal(lit));
        }
        if let TypeDef::Vector(n, scalar) = *ty
            && let Some(components) = vector_constant(name, n)
        {
            let values: Vec<Value> = components.iter().map(|&c| number(scalar, c)).collect();
            return self.compose(*ty, &values, span);
        }
        if let (TypeDef::Matrix(c, r), "IDENTITY" | "ZERO") = (*ty, name) {
            let one = f64::from(u8::from(name == "IDENTITY"));
            let mut columns = Vec::new();
            for column in 0..c {
                let values: Vec<Value> =
                    (0..r).map(|row| Value::float(if row == column { one } else { 0.0 })).collect();
                columns.push(self.compose(float_of(r), &values, span)?);
            }
            return self.compose(*ty, &columns, span);
        }
        Err(Fail::new(span, format!("the constant `{ty}::{name}` has no shader form")))
    }
}

fn float_constant(name: &str) -> Option<f32> {
    Some(match name {
        "MAX" => f32::MAX,
        "MIN" => f32::MIN,
        "MIN_POSITIVE" => f32::MIN_POSITIVE,
        "EPSILON" => f32::EPSILON,
        _ => return None,
    })
}

/// Components of glam's constants.
fn vector_constant(name: &str, n: u8) -> Option<Vec<i32>> {
    let axis = |sign: i32, index: u8| {
        (index < n).then(|| (0..n).map(|i| if i == index { sign } else { 0 }).collect())
    };
    match name {
        "ZERO" => Some(vec![0; n.into()]),
        "ONE" => Some(vec![1; n.into()]),
        "NEG_ONE" => Some(vec![-1; n.into()]),
        "X" => axis(1, 0),
        "Y" => axis(1, 1),
        "Z" => axis(1, 2),
        "W" => axis(1, 3),
        "NEG_X" => axis(-1, 0),
        "NEG_Y" => axis(-1, 1),
        "NEG_Z" => axis(-1, 2),
        "NEG_W" => axis(-1, 3),
        _ => None,
    }
}

fn number(scalar: Scalar, value: i32) -> Value {
    match scalar {
        Scalar::F32 => Value::float(value.into()),
        Scalar::U32 => Value::literal(Lit::U32(value as u32)),
        Scalar::I32 | Scalar::Bool => Value::literal(Lit::I32(value)).decide(&I32),
    }
}
