//! Computes both arms of a cheap branch: masks and jumps cost more than some operations.
//!
//! Operations are pure and total and selects take the results, so an arm of nothing but operations can
//! run for lanes that did not choose it.

use super::super::program::op::{FloatOp, IntOp};
use super::super::program::{Block, Op, Program, Stmt};

/// Cost, in simple operations, up to which both arms are computed.
const CHEAP: u32 = 64;

pub(super) fn flatten(program: &mut Program) {
    flatten_block(&mut program.body);
}

fn flatten_block(block: &mut Block) {
    let mut out = Block::with_capacity(block.len());
    for mut stmt in std::mem::take(block) {
        stmt.blocks_mut().into_iter().flatten().for_each(flatten_block);
        match stmt {
            Stmt::If { accept, reject, .. }
                if cost(&accept).zip(cost(&reject)).is_some_and(|(a, r)| a + r <= CHEAP) =>
            {
                out.extend(accept);
                out.extend(reject);
            }
            other @ (Stmt::If { .. }
            | Stmt::Eval(_)
            | Stmt::Set { .. }
            | Stmt::Store { .. }
            | Stmt::Atomic(_)
            | Stmt::Texture(_)
            | Stmt::Subgroup(_)
            | Stmt::Loop { .. }
            | Stmt::Scope { .. }
            | Stmt::Leave(_)
            | Stmt::Barrier { .. }) => out.push(other),
        }
    }
    *block = out;
}

/// The cost of a block that only computes.
fn cost(block: &Block) -> Option<u32> {
    block.iter().try_fold(0, |sum, stmt| match stmt {
        Stmt::Eval(eval) => Some(sum + weight(eval.op)),
        Stmt::Set { .. }
        | Stmt::Store { .. }
        | Stmt::Atomic(_)
        | Stmt::Texture(_)
        | Stmt::Subgroup(_)
        | Stmt::If { .. }
        | Stmt::Loop { .. }
        | Stmt::Scope { .. }
        | Stmt::Leave(_)
        | Stmt::Barrier { .. } => None,
    })
}

fn weight(op: Op) -> u32 {
    match op {
        Op::Float(_, op) => float_weight(op),
        Op::Int(_, IntOp::Div | IntOp::Rem) | Op::Load { .. } | Op::Exponent(_) | Op::Ldexp(_) => 16,
        Op::Int(..)
        | Op::Copy(_)
        | Op::Input(..)
        | Op::Compare(..)
        | Op::Logic(_)
        | Op::IsNan(_)
        | Op::IsInf(_)
        | Op::Select(_)
        | Op::Convert(..)
        | Op::Bitcast(..)
        | Op::Index { .. }
        | Op::IndexWithin { .. }
        | Op::Length { .. }
        | Op::Mark(..)
        | Op::Fused { .. }
        | Op::Horner { .. } => 1,
    }
}

fn float_weight(op: FloatOp) -> u32 {
    use FloatOp as F;
    match op {
        F::Add
        | F::Sub
        | F::Mul
        | F::Neg
        | F::Square
        | F::Nonnegative
        | F::Abs
        | F::Min
        | F::Max
        | F::Sign
        | F::Ceil
        | F::Floor
        | F::Round
        | F::Trunc
        | F::Fract
        | F::Step
        | F::Clamp
        | F::Saturate
        | F::Degrees
        | F::Radians
        | F::Length
        | F::Fma
        | F::Mix => 1,
        F::Div | F::Sqrt | F::SmoothStep => 5,
        F::Exp | F::Exp2 | F::Log | F::Log2 | F::InverseSqrt => 8,
        F::Rem
        | F::Pow
        | F::Significand
        | F::Sin
        | F::Cos
        | F::Tan
        | F::Asin
        | F::Acos
        | F::Atan
        | F::Atan2
        | F::Sinh
        | F::Cosh
        | F::Tanh
        | F::Asinh
        | F::Acosh
        | F::Atanh => 20,
    }
}
