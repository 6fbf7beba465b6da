//! Puts a uniform operand second where operands can change places, so that fewer forms are needed.

use super::super::program::op::{Comparison, FloatOp, IntOp, LogicOp};
use super::super::program::{Block, Op, Program, Stmt};

pub(super) fn order(program: &mut Program) {
    let mut body = std::mem::take(&mut program.body);
    order_block(&mut body, program);
    program.body = body;
}

fn order_block(block: &mut Block, program: &Program) {
    for stmt in block {
        if let Stmt::Eval(eval) = stmt
            && commutes(eval.op)
            && !program.varying(eval.args[0])
            && program.varying(eval.args[1])
        {
            eval.args.swap(0, 1);
        }
        stmt.blocks_mut().into_iter().flatten().for_each(|inner| order_block(inner, program));
    }
}

fn commutes(op: Op) -> bool {
    match op {
        Op::Float(_, op) => matches!(op, FloatOp::Add | FloatOp::Mul),
        Op::Int(_, op) => matches!(
            op,
            IntOp::Add | IntOp::Mul | IntOp::And | IntOp::Or | IntOp::Xor | IntOp::Min | IntOp::Max
        ),
        Op::Logic(op) => matches!(op, LogicOp::And | LogicOp::Or | LogicOp::Xor | LogicOp::Same),
        Op::Compare(_, op) => matches!(op, Comparison::Equal | Comparison::NotEqual),
        Op::Copy(_)
        | Op::Input(..)
        | Op::IsNan(_)
        | Op::IsInf(_)
        | Op::Select(_)
        | Op::Convert(..)
        | Op::Bitcast(..)
        | Op::Exponent(_)
        | Op::Ldexp(_)
        | Op::Index { .. }
        | Op::IndexWithin { .. }
        | Op::Length { .. }
        | Op::Mark(..)
        | Op::Load { .. }
        | Op::Fused { .. }
        | Op::Horner { .. } => false,
    }
}
