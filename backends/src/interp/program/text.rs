//! Programs as text, for tests and for those who look for what went wrong.

use super::{Block, Program, Stmt, Value};
use std::fmt::{Display, Formatter, Result, Write};

impl Display for Program {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        block(self, &self.body, 0, f)?;
        writeln!(f, "results {}", list(self, &self.results))
    }
}

fn name(program: &Program, value: Value) -> String {
    match value {
        Value::Const(id) => {
            let constant = program.constants[id as usize];
            if constant.scalar.float() { constant.exact.to_string() } else { constant.bits.to_string() }
        }
        Value::Reg(reg) => {
            format!("{}{}", if program.varying(value) { "r" } else { "u" }, reg.0)
        }
    }
}

fn list(program: &Program, values: &[Value]) -> String {
    values.iter().map(|v| name(program, *v)).collect::<Vec<_>>().join(" ")
}

fn block(program: &Program, stmts: &Block, depth: usize, f: &mut Formatter<'_>) -> Result {
    for stmt in stmts {
        (0..depth).try_for_each(|_| f.write_str("  "))?;
        statement(program, stmt, f)?;
        for inner in stmt.blocks().into_iter().flatten() {
            block(program, inner, depth + 1, f)?;
            (0..depth).try_for_each(|_| f.write_str("  "))?;
            f.write_str("end\n")?;
        }
    }
    Ok(())
}

fn statement(program: &Program, stmt: &Stmt, f: &mut Formatter<'_>) -> Result {
    let targets: Vec<Value> = stmt.targets().map(Value::Reg).collect();
    if !targets.is_empty() {
        write!(f, "{} = ", list(program, &targets))?;
    }
    match stmt {
        Stmt::Eval(eval) => write!(f, "{:?} {}", eval.op, list(program, &eval.args))?,
        Stmt::Set { value, .. } => write!(f, "set {}", name(program, *value))?,
        Stmt::Store { place, value, .. } => write!(f, "store {place:?} {}", name(program, *value))?,
        Stmt::Atomic(atomic) => {
            write!(f, "atomic {:?} {:?} {}", atomic.fun, atomic.place, name(program, atomic.value))?;
        }
        Stmt::Texture(access) => {
            let mut operands = Vec::new();
            access.operands.map(|v| operands.push(v));
            write!(f, "texture {} {:?} {}", access.image, access.op, list(program, &operands))?;
        }
        Stmt::Subgroup(s) => write!(f, "subgroup {:?} {}", s.op, name(program, s.value))?,
        Stmt::If { condition, .. } => write!(f, "if {}", name(program, *condition))?,
        Stmt::Loop { label, .. } => write!(f, "loop {}", label.0)?,
        Stmt::Scope { label, .. } => write!(f, "scope {}", label.0)?,
        Stmt::Leave(label) => write!(f, "leave {}", label.0)?,
        Stmt::Barrier { .. } => f.write_str("barrier")?,
    }
    f.write_char('\n')
}
