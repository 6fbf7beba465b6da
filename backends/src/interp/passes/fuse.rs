//! Joins pairs of simple f32 operations into one: the value between them stays in a register of the machine.
//! Both are rounded, so nothing changes but the time.

use super::super::program::op::{FloatOp, Simple};
use super::super::program::{Args, Block, Eval, Op, Program, Reg, Scalar, Stmt, Value};
use super::uses;
use std::collections::HashMap;

pub(super) fn fuse(program: &mut Program) {
    let uses = uses(program);
    let mut body = std::mem::take(&mut program.body);
    fuse_block(&mut body, program, &uses);
    program.body = body;
}

/// An operation that can be the first of a pair; a square is a product.
fn simple(eval: &Eval) -> Option<(Simple, Value, Value)> {
    let (op, args) = match eval.op {
        Op::Float(Scalar::F32, op) => (op, eval.args),
        _ => return None,
    };
    match (op, &args[..]) {
        (FloatOp::Add, [a, b]) => Some((Simple::Add, *a, *b)),
        (FloatOp::Sub, [a, b]) => Some((Simple::Sub, *a, *b)),
        (FloatOp::Mul, [a, b]) => Some((Simple::Mul, *a, *b)),
        (FloatOp::Square, [a]) => Some((Simple::Mul, *a, *a)),
        _ => None,
    }
}

fn fuse_block(block: &mut Block, program: &Program, uses: &[u32]) {
    // Candidates computed in this very block, so that their operands still hold.
    let mut first: HashMap<Reg, (Simple, Value, Value)> = HashMap::new();
    for stmt in block {
        if let Stmt::Eval(eval) = stmt
            && program.varying(Value::Reg(eval.to))
            && let Some((op, a, b)) = simple(eval)
        {
            first.insert(eval.to, (op, a, b));
            let inner = |value: Value| match value {
                Value::Reg(reg) if uses[reg.0 as usize] == 1 => first.get(&reg).copied(),
                Value::Reg(_) | Value::Const(_) => None,
            };
            let pair = match (inner(a), inner(b)) {
                (Some(pair), _) => Some((pair, b, false)),
                (None, Some(pair)) => Some((pair, a, true)),
                (None, None) => None,
            };
            if let Some(((before, x, y), z, flipped)) = pair
                && (x, y) != (z, z)
            {
                first.remove(&eval.to);
                eval.op = Op::Fused { first: before, second: op, flipped };
                eval.args = Args::new(&[x, y, z]);
            }
        }
        stmt.blocks_mut().into_iter().flatten().for_each(|inner| fuse_block(inner, program, uses));
    }
}
