//! Addresses within elements of binding arrays, spelt out: they are too rare for steps of their own.

use super::super::program::op::IntOp;
use super::super::program::{Args, Block, Constant, Eval, Op, Program, Reg, Register, Scalar, Stmt, Value};

/// Replaces each [`Op::IndexWithin`] by operations on integers.
pub(super) fn spell_out(program: &mut Program) {
    let mut body = std::mem::take(&mut program.body);
    rewrite(&mut body, program);
    program.body = body;
}

fn rewrite(block: &mut Block, program: &mut Program) {
    let mut out = Block::with_capacity(block.len());
    for mut stmt in std::mem::take(block) {
        stmt.blocks_mut().into_iter().flatten().for_each(|inner| rewrite(inner, program));
        match stmt {
            Stmt::Eval(eval) => match (eval.op, &eval.args[..]) {
                (Op::IndexWithin { stride }, &[index, base, count]) => {
                    out.extend(spelt(program, &eval, stride, [index, base, count]).map(Stmt::Eval));
                }
                _ => out.push(Stmt::Eval(eval)),
            },
            other => out.push(other),
        }
    }
    *block = out;
}

/// `base + min(index, count - 1) * stride`
fn spelt(program: &mut Program, eval: &Eval, stride: u32, [index, base, count]: [Value; 3]) -> [Eval; 5] {
    let (one, stride) = (constant(program, 1), constant(program, stride));
    let from = program.scalar(index);
    let op = |to: Reg, op: Op, args: &[Value]| Eval { to, op, args: Args::new(args), at: eval.at };
    let int = |op| Op::Int(Scalar::U32, op);
    let [number, last, inside, scaled] = [(); 4].map(|()| register(program));
    // No array is empty: a buffer has room for one element of it.
    [
        op(
            number,
            if from == Scalar::U32 { Op::Copy(from) } else { Op::Bitcast(from, Scalar::U32) },
            &[index],
        ),
        op(last, int(IntOp::Sub), &[count, one]),
        op(inside, int(IntOp::Min), &[Value::Reg(number), Value::Reg(last)]),
        op(scaled, int(IntOp::Mul), &[Value::Reg(inside), stride]),
        op(eval.to, int(IntOp::Add), &[Value::Reg(scaled), base]),
    ]
}

fn constant(program: &mut Program, value: u32) -> Value {
    let bits = u64::from(value);
    program.constants.push(Constant { scalar: Scalar::U32, bits, exact: value.into() });
    Value::Const(program.constants.len() as u32 - 1)
}

fn register(program: &mut Program) -> Reg {
    program.registers.push(Register { scalar: Scalar::U32, varying: false });
    Reg(program.registers.len() as u32 - 1)
}
