//! Joins a product and a sum with a constant, again and again with the same factor, into a polynomial: what is between
//! stays in a register of the machine. All are rounded, so nothing changes but the time.

use super::super::program::op::Simple;
use super::super::program::{Args, Block, Constant, Eval, Op, Program, Reg, Stmt, Value};
use super::uses;
use std::collections::HashMap;

/// Coefficients of a polynomial that has a form of its own.
const MOST: usize = 10;

pub(super) fn horner(program: &mut Program) {
    let uses = uses(program);
    let mut body = std::mem::take(&mut program.body);
    horner_block(&mut body, program, &uses);
    program.body = body;
}

/// A polynomial in the making, in `x`: from `begin` on if that is no constant.
#[derive(Debug, Clone)]
struct Chain {
    x: Value,
    begin: Option<Value>,
    coefficients: Vec<Constant>,
}

/// `a * b + c`, `c` a constant.
struct Step {
    a: Value,
    b: Value,
    c: Constant,
}

fn step(eval: &Eval, program: &Program) -> Option<Step> {
    let Op::Fused { first: Simple::Mul, second, flipped } = eval.op else {
        return None;
    };
    let [a, b, Value::Const(c)] = eval.args[..] else {
        return None;
    };
    let c = program.constants[c as usize];
    let c = match (second, flipped) {
        (Simple::Add, _) => c,
        // Taking away is adding the negative.
        (Simple::Sub, false) => Constant { bits: c.bits ^ (1 << 31), exact: -c.exact, ..c },
        (Simple::Sub, true) | (Simple::Mul, _) => return None,
    };
    Some(Step { a, b, c })
}

fn horner_block(block: &mut Block, program: &mut Program, uses: &[u32]) {
    // Computed in this very block, so that their operands still hold.
    let mut chains: HashMap<Value, Chain> = HashMap::new();
    for stmt in block {
        if let Stmt::Eval(eval) = stmt
            && program.varying(Value::Reg(eval.to))
            && let Some(step) = step(eval, program)
            && let Some(chain) = extended(&step, &chains, program, uses)
        {
            write(eval, &chain, program);
            chains.insert(Value::Reg(eval.to), chain);
        }
        stmt.blocks_mut().into_iter().flatten().for_each(|inner| horner_block(inner, program, uses));
    }
}

/// The chain that a step goes on with, or a new one.
fn extended(step: &Step, chains: &HashMap<Value, Chain>, program: &Program, uses: &[u32]) -> Option<Chain> {
    let once = |value: Value| matches!(value, Value::Reg(Reg(at)) if uses[at as usize] == 1);
    let follow = |x: Value, sum: Value| {
        let chain = chains.get(&sum).filter(|c| once(sum) && c.coefficients.len() < MOST)?;
        let chain = if chain.x == x { chain.clone() } else { chain.turned()? };
        (chain.x == x).then_some(chain)
    };
    let varying = |value: &Value| program.varying(*value);
    let mut chain = match follow(step.a, step.b).or_else(|| follow(step.b, step.a)) {
        Some(chain) => chain,
        None => match (step.a, step.b) {
            (x, Value::Const(c)) if varying(&x) => {
                Chain { x, begin: None, coefficients: vec![program.constants[c as usize]] }
            }
            (x, begin) if varying(&x) && varying(&begin) => {
                Chain { x, begin: Some(begin), coefficients: Vec::new() }
            }
            _ => return None,
        },
    };
    chain.coefficients.push(step.c);
    Some(chain)
}

impl Chain {
    /// A single product with its factors exchanged.
    fn turned(&self) -> Option<Self> {
        let begin = self.begin.filter(|_| self.coefficients.len() == 1)?;
        Some(Self { x: begin, begin: Some(self.x), coefficients: self.coefficients.clone() })
    }
}

/// Makes the operation a polynomial if it has at least two products.
fn write(eval: &mut Eval, chain: &Chain, program: &mut Program) {
    let products = chain.coefficients.len() - usize::from(chain.begin.is_none());
    if products < 2 {
        return;
    }
    let first = program.constants.len() as u32;
    program.constants.extend(&chain.coefficients);
    let begun = chain.begin.is_some();
    eval.op = Op::Horner { first, count: chain.coefficients.len() as u32, begun };
    eval.args = match chain.begin {
        Some(begin) => Args::new(&[chain.x, begin]),
        None => Args::new(&[chain.x]),
    };
}
