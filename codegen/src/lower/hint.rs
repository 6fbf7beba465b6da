//! A look ahead at types, so that an integer without suffix can take the type of what follows it.
//!
//! Rust infers in both directions; lowering goes from left to right.
//! What is looked up here emits nothing and may not know.

use super::body::{BodyBuilder, Local};
use super::expr::member;
use super::module::element;
use super::value::{BOOL, F32, U32};
use crate::def::{BinaryOp, Block, Callee, Expr, ExprKind, TypeDef};
use crate::intrinsics::Shape;

impl BodyBuilder<'_> {
    /// The type of both operands of `left op right`, as far as the right one tells.
    pub(super) fn peek_pair(&self, op: BinaryOp, left: &Expr, right: &Expr) -> Option<TypeDef> {
        if matches!(op, BinaryOp::ShiftLeft | BinaryOp::ShiftRight) || self.peek(left).is_some() {
            return None;
        }
        self.peek(right)
    }

    /// The type of `e`, if it is plain to see.
    pub(super) fn peek(&self, e: &Expr) -> Option<TypeDef> {
        match &e.kind {
            ExprKind::Float(..) => Some(F32),
            ExprKind::Int(_, scalar) => scalar.map(TypeDef::Scalar),
            ExprKind::Bool(_) => Some(BOOL),
            ExprKind::Local(local) => match self.locals[*local as usize] {
                Local::Memory(place) => Some(place.ty),
                Local::Value(value) => (!value.is_undecided()).then_some(value.ty),
                Local::Unset => None,
            },
            ExprKind::Constant(def) => Some(def().ty),
            ExprKind::TypeConstant(ty, _) | ExprKind::TypeCall(ty, ..) | ExprKind::Cast(_, ty) => Some(*ty),
            ExprKind::Struct { ty, .. } => Some(*ty),
            ExprKind::Unary(_, inner) => self.peek(inner),
            ExprKind::Binary(op, left, right) => self.peek_binary(*op, left, right),
            ExprKind::Call(Callee::Function(def), _) => def().ret,
            ExprKind::Call(Callee::Intrinsic(op), arguments) => match op.row().shape {
                Shape::Reduce(_) => Some(F32),
                Shape::Relational => Some(BOOL),
                Shape::Select => arguments[..2].iter().find_map(|a| self.peek(a)),
                _ => arguments.iter().find_map(|a| self.peek(a)),
            },
            ExprKind::Method(receiver, name, _) => self.peek_method(receiver, name),
            ExprKind::Field(base, name) => {
                self.peek(base).and_then(|ty| member(&ty, name, e.span).ok()).map(|(_, ty)| ty)
            }
            ExprKind::Index(base, _) => self.peek(base).map(|ty| element(&ty)),
            ExprKind::If { accept, reject, .. } => {
                self.peek_block(accept).or_else(|| reject.as_ref().and_then(|b| self.peek_block(b)))
            }
            ExprKind::Match { arms, .. } => arms.iter().find_map(|arm| self.peek_block(&arm.body)),
            ExprKind::Block(block) => self.peek_block(block),
            ExprKind::Array(_) | ExprKind::Repeat(..) => None,
        }
    }

    /// The value of a block, unless it hangs on names that the block declares.
    fn peek_block(&self, block: &Block) -> Option<TypeDef> {
        block.value.and_then(|value| self.peek(value))
    }

    fn peek_binary(&self, op: BinaryOp, left: &Expr, right: &Expr) -> Option<TypeDef> {
        match op {
            BinaryOp::Equal
            | BinaryOp::NotEqual
            | BinaryOp::Less
            | BinaryOp::LessEqual
            | BinaryOp::Greater
            | BinaryOp::GreaterEqual
            | BinaryOp::LogicalAnd
            | BinaryOp::LogicalOr => Some(BOOL),
            BinaryOp::ShiftLeft | BinaryOp::ShiftRight => self.peek(left),
            BinaryOp::Add
            | BinaryOp::Subtract
            | BinaryOp::Multiply
            | BinaryOp::Divide
            | BinaryOp::Remainder
            | BinaryOp::And
            | BinaryOp::Or
            | BinaryOp::Xor => match (self.peek(left), self.peek(right)) {
                // A scalar operand does not tell the type of the whole.
                (Some(TypeDef::Scalar(_)), Some(right)) => Some(right),
                (left, right) => left.or(right),
            },
        }
    }

    fn peek_method(&self, receiver: &Expr, name: &str) -> Option<TypeDef> {
        match name {
            "abs" | "wrapping_add" | "wrapping_mul" | "wrapping_sub" => self.peek(receiver),
            "to_bits" | "len" => Some(U32),
            _ => None,
        }
    }
}
