//! Expressions.

use super::body::{BodyBuilder, Local};
use super::error::{Fail, Lowered};
use super::module::element;
use super::operator::parts;
use super::stmt::branches;
use super::value::{F32, I32, Lit, Place, Repr, Sink, U32, Value};
use crate::def::{Callee, Expr, ExprKind, Scalar, Span, StructDef, TypeDef, UnaryOp};
use naga::Expression;

/// The one `i32` literal that is in range only under a minus sign.
const MIN_I32: u64 = 1 << 31;

impl BodyBuilder<'_> {
    /// The value of `e`.
    pub(super) fn expr(&mut self, e: &'static Expr) -> Lowered<Value> {
        self.expr_expecting(e, None)
    }

    /// The value of `e`, where an integer without suffix takes the type that is expected.
    pub(super) fn expr_expecting(&mut self, e: &'static Expr, expected: Option<&TypeDef>) -> Lowered<Value> {
        let value = self.any_expr(e, expected)?;
        Ok(expected.map_or(value, |ty| value.decide(ty)))
    }

    fn any_expr(&mut self, e: &'static Expr, expected: Option<&TypeDef>) -> Lowered<Value> {
        if branches(e) {
            return self.branching(e, expected);
        }
        match &e.kind {
            ExprKind::Float(value, exact) => Ok(Value::literal(Lit::F32(*value, *exact))),
            ExprKind::Int(value, scalar) => int(*value, *scalar, e.span),
            ExprKind::Bool(value) => Ok(Value::literal(Lit::Bool(*value))),
            ExprKind::Local(_) | ExprKind::Field(..) | ExprKind::Index(..) => self.read(e),
            ExprKind::Constant(def) => {
                let def = def();
                let handle = self.modules.constant(def).map_err(|error| self.stop(error))?;
                Ok(self.value(def.ty, Expression::Constant(handle), e.span))
            }
            ExprKind::TypeConstant(ty, name) => self.type_constant(ty, name, e.span),
            ExprKind::Unary(
                UnaryOp::Negate,
                Expr { kind: ExprKind::Int(MIN_I32, Some(Scalar::I32)), .. },
            ) => Ok(Value::literal(Lit::I32(i32::MIN))),
            ExprKind::Unary(op, inner) => {
                let value = self.expr_expecting(inner, expected)?;
                self.unary(*op, value, e.span)
            }
            ExprKind::Binary(op, left, right) => self.binary_expr(*op, left, right, expected, e.span),
            ExprKind::Call(Callee::Function(def), arguments) => {
                let call = self.call(def(), arguments, e.span)?;
                call.ok_or_else(|| Fail::new(e.span, format!("`{}` returns no value", def().name)))
            }
            ExprKind::Call(Callee::Intrinsic(op), arguments) => {
                let call = self.intrinsic(*op, arguments, expected, e.span)?;
                call.ok_or_else(|| Fail::new(e.span, format!("`{}` returns no value", op.row().name)))
            }
            ExprKind::TypeCall(ty, name, arguments) => self.type_call(ty, name, arguments, e.span),
            ExprKind::Method(receiver, name, arguments) => self.method(receiver, name, arguments, e.span),
            ExprKind::Struct { ty, fields, rest } => self.structure(ty, fields, *rest, e.span),
            ExprKind::Array(elements) => self.array(elements, expected, e.span),
            ExprKind::Repeat(value, count) => {
                let part = expected.map(element);
                let value = self.expr_expecting(value, part.as_ref())?.decide(&I32);
                self.repeat(value, *count, e.span)
            }
            ExprKind::Cast(inner, ty) => {
                let value = self.expr(inner)?;
                self.cast(value, ty, e.span)
            }
            ExprKind::If { .. } | ExprKind::Match { .. } | ExprKind::Block(_) => self.branching(e, expected),
        }
    }

    /// Runs `e` for its effect.
    pub(super) fn effect(&mut self, e: &'static Expr) -> Lowered<()> {
        match &e.kind {
            ExprKind::Call(Callee::Function(def), arguments) => {
                self.call(def(), arguments, e.span).map(|_| ())
            }
            ExprKind::Call(Callee::Intrinsic(op), arguments) => {
                self.intrinsic(*op, arguments, None, e.span).map(|_| ())
            }
            _ => self.expr(e).map(|_| ()),
        }
    }

    /// A value that comes out of branches goes through a variable.
    fn branching(&mut self, e: &'static Expr, expected: Option<&TypeDef>) -> Lowered<Value> {
        // A block without statements around a value needs none.
        if let ExprKind::Block(block) = &e.kind
            && let ([], Some(value)) = (block.stmts, block.value)
        {
            return self.expr_expecting(value, expected);
        }
        let expected = expected.copied().or_else(|| self.peek(e));
        let mut sink = Sink::Variable { name: None, expected, place: None };
        self.expr_into(e, &mut sink)?;
        match sink {
            Sink::Variable { place: Some(place), .. } => Ok(self.load(place, e.span)),
            _ => Err(Fail::new(e.span, "this has no value")),
        }
    }

    /// The value as `ty`, or a type error.
    pub(super) fn fit(&mut self, value: Value, ty: &TypeDef, span: Span) -> Lowered<Value> {
        let value = value.decide(ty);
        if value.ty == *ty {
            return Ok(value);
        }
        Err(Fail::new(span, self.mismatch("expected", ", found", ty, &value.ty)))
    }

    /// `words a between b`, and the way out when an integer's type was assumed.
    pub(super) fn mismatch(&self, words: &str, between: &str, a: &TypeDef, b: &TypeDef) -> String {
        let space = if between.starts_with(',') { "" } else { " " };
        let message = format!("{words} {a}{space}{between} {b}");
        let kinds = [parts(a).map(|(_, s)| s), parts(b).map(|(_, s)| s)];
        if kinds != [Some(Scalar::I32), Some(Scalar::U32)] && kinds != [Some(Scalar::U32), Some(Scalar::I32)]
        {
            return message;
        }
        match &self.assumed[..] {
            [] => format!("{message}; an integer without suffix is taken as i32 here: write `1u32`"),
            names => format!(
                "{message}; `{}` was taken as i32, since its integer has no suffix: write `1u32`, or state \
                 the type in its `let`",
                names.join("`, `")
            ),
        }
    }

    /// The type of the memory that `e` names, before any of it is evaluated.
    pub(super) fn place_type(&self, e: &Expr) -> Lowered<Option<TypeDef>> {
        Ok(match &e.kind {
            ExprKind::Local(local) => match self.locals[*local as usize] {
                Local::Memory(place) => Some(place.ty),
                Local::Value(_) | Local::Unset => None,
            },
            ExprKind::Field(base, name) => match self.place_type(base)? {
                Some(ty) => Some(member(&ty, name, e.span)?.1),
                None => None,
            },
            ExprKind::Index(base, _) => self.place_type(base)?.map(|ty| element(&ty)),
            _ => None,
        })
    }

    // ---- places

    /// The memory that `e` names, if it names any.
    pub(super) fn place(&mut self, e: &'static Expr) -> Lowered<Option<Place>> {
        match &e.kind {
            ExprKind::Local(local) => Ok(match self.locals[*local as usize] {
                Local::Memory(place) => Some(place),
                Local::Value(_) | Local::Unset => None,
            }),
            ExprKind::Field(base, name) => {
                let Some(base_place) = self.place(base)? else { return Ok(None) };
                let (index, ty) = member(&base_place.ty, name, e.span)?;
                let access = Expression::AccessIndex { base: base_place.pointer, index };
                Ok(Some(Place { pointer: self.append(access, e.span), ty }))
            }
            ExprKind::Index(base, index) => {
                let Some(base_place) = self.place(base)? else { return Ok(None) };
                let index = self.expr_expecting(index, Some(&U32))?;
                let ty = indexed(&base_place.ty, &index, e.span)?;
                let access = self.access(base_place.pointer, index, e.span);
                Ok(Some(Place { pointer: self.append(access, e.span), ty }))
            }
            _ => Ok(None),
        }
    }

    fn access(&mut self, base: naga::Handle<Expression>, index: Value, span: Span) -> Expression {
        match index.repr {
            Repr::Literal(Lit::U32(index)) => Expression::AccessIndex { base, index },
            _ => Expression::Access { base, index: self.handle(index, span) },
        }
    }

    /// The value of a local, field or element.
    fn read(&mut self, e: &'static Expr) -> Lowered<Value> {
        if let Some(place) = self.place(e)? {
            return Ok(self.load(place, e.span));
        }
        match &e.kind {
            ExprKind::Local(local) => match self.locals[*local as usize] {
                Local::Value(value) => Ok(value),
                Local::Memory(place) => Ok(self.load(place, e.span)),
                Local::Unset => Err(Fail::new(e.span, "this variable has no value yet")),
            },
            ExprKind::Field(base, name) => {
                let base = self.expr(base)?;
                let (index, ty) = member(&base.ty, name, e.span)?;
                let base = self.handle(base, e.span);
                Ok(self.value(ty, Expression::AccessIndex { base, index }, e.span))
            }
            ExprKind::Index(base, index) => self.element_of_value(base, index, e.span),
            _ => Err(Fail::new(e.span, "this has no value")),
        }
    }

    fn element_of_value(&mut self, base: &'static Expr, index: &'static Expr, span: Span) -> Lowered<Value> {
        let base = self.expr(base)?;
        let index = self.expr_expecting(index, Some(&U32))?;
        let ty = indexed(&base.ty, &index, span)?;
        let is_vector = matches!(base.ty, TypeDef::Vector(..));
        if !is_vector && !matches!(index.repr, Repr::Literal(_)) {
            // naga indexes arrays and matrices by run-time values in memory only.
            let place = self.variable(None, &base.ty);
            self.store(place, base, span);
            let access = self.access(place.pointer, index, span);
            let pointer = self.append(access, span);
            return Ok(self.load(Place { pointer, ty }, span));
        }
        let base = self.handle(base, span);
        let access = self.access(base, index, span);
        Ok(self.value(ty, access, span))
    }

    // ---- composites

    fn structure(
        &mut self,
        ty: &TypeDef,
        fields: &'static [(&'static str, Expr)],
        rest: Option<&'static Expr>,
        span: Span,
    ) -> Lowered<Value> {
        let TypeDef::Struct(def) = *ty else {
            return Err(Fail::new(span, format!("{ty} is built by `{ty}::new(..)`")));
        };
        let def = def();
        // Values are evaluated as written, and composed as declared.
        let mut written = Vec::new();
        for (name, e) in fields {
            let (_, ty) = member(ty, name, e.span)?;
            let value = self.expr_expecting(e, Some(&ty))?;
            let value = self.fit(value, &ty, e.span)?;
            written.push((*name, self.handle(value, e.span)));
        }
        let rest = match rest {
            Some(rest) => {
                let value = self.expr(rest)?;
                Some(self.fit(value, ty, rest.span)?)
            }
            None => None,
        };
        let components = self.components(def, &written, rest, span)?;
        let naga_ty = self.modules.ty(ty);
        Ok(self.value(*ty, Expression::Compose { ty: naga_ty, components }, span))
    }

    fn components(
        &mut self,
        def: &'static StructDef,
        written: &[(&str, naga::Handle<Expression>)],
        rest: Option<Value>,
        span: Span,
    ) -> Lowered<Vec<naga::Handle<Expression>>> {
        let mut components = Vec::new();
        for (i, field) in def.fields.iter().enumerate() {
            let component = match (written.iter().find(|(name, _)| *name == field.name), rest) {
                (Some((_, handle)), _) => *handle,
                (None, Some(rest)) => {
                    let base = self.handle(rest, span);
                    self.append(Expression::AccessIndex { base, index: i as u32 }, span)
                }
                (None, None) => {
                    return Err(Fail::new(
                        span,
                        format!("the field `{}` of {} is missing", field.name, def.name),
                    ));
                }
            };
            components.push(component);
        }
        Ok(components)
    }

    fn array(&mut self, elements: &'static [Expr], expected: Option<&TypeDef>, span: Span) -> Lowered<Value> {
        let wanted = expected.map(element);
        let mut values = Vec::new();
        for e in elements {
            values.push(self.expr_expecting(e, wanted.as_ref())?);
        }
        let ty = values.iter().find(|v| !v.is_undecided()).map_or(I32, |v| v.ty);
        let mut components = Vec::new();
        for (value, e) in values.into_iter().zip(elements) {
            let value = self.fit(value, &ty, e.span)?;
            components.push(self.handle(value, e.span));
        }
        Ok(self.compose_array(ty, components, span))
    }

    fn repeat(&mut self, value: Value, count: u32, span: Span) -> Lowered<Value> {
        let handle = self.handle(value, span);
        Ok(self.compose_array(value.ty, vec![handle; count as usize], span))
    }

    fn compose_array(&mut self, ty: TypeDef, components: Vec<naga::Handle<Expression>>, span: Span) -> Value {
        // Definitions live as long as the program; so do the few array types that expressions make.
        let ty = TypeDef::Array(Box::leak(Box::new(ty)), components.len() as u32);
        let naga_ty = self.modules.ty(&ty);
        self.value(ty, Expression::Compose { ty: naga_ty, components }, span)
    }
}

fn int(value: u64, scalar: Option<Scalar>, span: Span) -> Lowered<Value> {
    let too_large = |ty| Fail::new(span, format!("{value} does not fit {ty}"));
    let lit = match scalar {
        Some(Scalar::I32) => Lit::I32(i32::try_from(value).map_err(|_| too_large("i32"))?),
        Some(Scalar::U32) => Lit::U32(u32::try_from(value).map_err(|_| too_large("u32"))?),
        _ => Lit::Int(u32::try_from(value).map_err(|_| too_large("u32"))?.into()),
    };
    Ok(Value::literal(lit))
}

/// Index and type of a named part.
pub(super) fn member(ty: &TypeDef, name: &str, span: Span) -> Lowered<(u32, TypeDef)> {
    let found = match *ty {
        TypeDef::Vector(n, s) => {
            position(&["x", "y", "z", "w"][..n.into()], name).map(|i| (i, TypeDef::Scalar(s)))
        }
        TypeDef::Matrix(c, r) => position(&["x_axis", "y_axis", "z_axis", "w_axis"][..c.into()], name)
            .map(|i| (i, TypeDef::Vector(r, Scalar::F32))),
        TypeDef::Struct(def) => {
            def().fields.iter().enumerate().find(|(_, f)| f.name == name).map(|(i, f)| (i as u32, f.ty))
        }
        TypeDef::Scalar(_) | TypeDef::Array(..) | TypeDef::Slice(_) | TypeDef::Atomic(_) => None,
    };
    found.ok_or_else(|| Fail::new(span, format!("{ty} has no part `{name}`")))
}

fn position(names: &[&str], name: &str) -> Option<u32> {
    names.iter().position(|n| *n == name).map(|i| i as u32)
}

/// Type of an element; a constant index must be inside.
fn indexed(ty: &TypeDef, index: &Value, span: Span) -> Lowered<TypeDef> {
    let count = match *ty {
        TypeDef::Vector(n, _) => Some(u32::from(n)),
        TypeDef::Array(_, n) => Some(n),
        TypeDef::Slice(_) => None,
        TypeDef::Matrix(..) => {
            return Err(Fail::new(span, "a matrix is taken apart with `.x_axis`, `.y_axis`, .."));
        }
        TypeDef::Scalar(_) | TypeDef::Atomic(_) | TypeDef::Struct(_) => {
            return Err(Fail::new(span, format!("{ty} has no elements")));
        }
    };
    match (index.repr, count) {
        (Repr::Literal(Lit::U32(i)), Some(n)) if i >= n => {
            Err(Fail::new(span, format!("index {i} is outside {ty}")))
        }
        _ if index.ty == U32 || index.ty == I32 => Ok(element(ty)),
        _ => Err(Fail::new(span, format!("an index is u32 or i32, this is {}", index.ty))),
    }
}

/// A float vector of `n` components, or the scalar for 1.
pub(super) fn float_of(n: u8) -> TypeDef {
    if n == 1 { F32 } else { TypeDef::Vector(n, Scalar::F32) }
}
