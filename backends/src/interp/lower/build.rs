//! Writes a program, statement by statement; an operation that was written already is not written again.

use super::super::program::op::{FloatOp, IntOp, LogicOp};
use super::super::program::{
    Args, Block, Constant, Count, Eval, Label, LaneArray, Op, Place, Program, Reg, Register, Scalar, Stmt,
    Value,
};
use super::super::scalar::eval::eval;
use naga::Span;
use std::collections::HashMap;

/// A program in the making.
pub(crate) struct Builder {
    pub(crate) program: Program,
    constants: HashMap<(Scalar, u64, u64), u32>,
    seen: HashMap<(Op, Args), Reg>,
    /// What was added to `seen`, in order, so that the end of a block can forget it.
    log: Vec<(Op, Args)>,
    /// The blocks that are open, outermost first, with the length of `log` at their begin.
    open: Vec<(Block, usize)>,
    labels: u32,
    /// Counts what may change memory; see [`Op::Load`].
    epoch: u32,
    /// Whether operations that may err are written as often as the source has them: each errs on its own.
    pub(crate) repeat: bool,
    /// Statements written so far.
    pub(crate) size: usize,
    pub(crate) at: Span,
}

impl Builder {
    pub(crate) fn new() -> Self {
        Self {
            program: Program {
                functions: Vec::new(),
                registers: Vec::new(),
                constants: Vec::new(),
                arrays: Vec::new(),
                buffers: Vec::new(),
                images: Vec::new(),
                samplers: Vec::new(),
                body: Block::new(),
                results: Vec::new(),
                columns: 0,
                truths: Vec::new(),
                cooperative: false,
            },
            constants: HashMap::new(),
            seen: HashMap::new(),
            log: Vec::new(),
            open: vec![(Block::new(), 0)],
            labels: 0,
            epoch: 0,
            repeat: false,
            size: 0,
            at: Span::UNDEFINED,
        }
    }

    /// The finished program.
    pub(crate) fn finish(mut self, results: Vec<Value>) -> Program {
        self.program.body = self.open.pop().map(|(block, _)| block).unwrap_or_default();
        self.program.results = results;
        self.program
    }

    pub(crate) fn label(&mut self) -> Label {
        self.labels += 1;
        Label(self.labels)
    }

    pub(crate) fn scalar(&self, value: Value) -> Scalar {
        self.program.scalar(value)
    }

    /// A constant by its bits.
    pub(crate) fn bits(&mut self, scalar: Scalar, bits: u64, exact: f64) -> Value {
        let constants = &mut self.program.constants;
        let id = *self.constants.entry((scalar, bits, exact.to_bits())).or_insert_with(|| {
            constants.push(Constant { scalar, bits, exact });
            constants.len() as u32 - 1
        });
        Value::Const(id)
    }

    pub(crate) fn u32(&mut self, value: u32) -> Value {
        self.bits(Scalar::U32, value.into(), value.into())
    }

    /// A float constant of the scalar's width.
    pub(crate) fn float(&mut self, scalar: Scalar, value: f32) -> Value {
        let bits = if scalar == Scalar::F64 { f64::from(value).to_bits() } else { value.to_bits().into() };
        self.bits(scalar, bits, value.into())
    }

    pub(crate) fn zero(&mut self, scalar: Scalar) -> Value {
        self.bits(scalar, 0, 0.0)
    }

    /// The number that `value` is, if it is a constant.
    pub(crate) fn known(&self, value: Value) -> Option<u64> {
        match value {
            Value::Const(id) => Some(self.program.constants[id as usize].bits),
            Value::Reg(_) => None,
        }
    }

    /// A register that nothing computes yet.
    pub(crate) fn register(&mut self, scalar: Scalar) -> Reg {
        self.program.registers.push(Register { scalar, varying: false });
        Reg(self.program.registers.len() as u32 - 1)
    }

    pub(crate) fn push(&mut self, stmt: Stmt) {
        self.size += 1;
        if let Some((block, _)) = self.open.last_mut() {
            block.push(stmt);
        }
    }

    /// Opens a block; what is computed in it is forgotten at its end.
    pub(crate) fn begin(&mut self) {
        self.open.push((Block::new(), self.log.len()));
    }

    /// Closes the innermost block.
    pub(crate) fn end(&mut self) -> Block {
        let (block, known) = self.open.pop().unwrap_or_default();
        for key in self.log.drain(known..) {
            self.seen.remove(&key);
        }
        block
    }

    /// Memory may have changed.
    pub(crate) fn touch(&mut self) {
        self.epoch += 1;
    }

    /// Computes `op` of `args`, unless that is known.
    pub(crate) fn eval(&mut self, op: Op, args: &[Value]) -> Value {
        if let Some(known) = self.folded(op, args) {
            return known;
        }
        let args = Args::new(args);
        if self.repeat && errs(op) {
            return self.compute(op, args);
        }
        if let Some(reg) = self.seen.get(&(op, args)) {
            return Value::Reg(*reg);
        }
        let value = self.compute(op, args);
        if let Value::Reg(to) = value {
            self.seen.insert((op, args), to);
            self.log.push((op, args));
        }
        value
    }

    /// Writes an operation.
    fn compute(&mut self, op: Op, args: Args) -> Value {
        let to = self.register(op.result());
        self.push(Stmt::Eval(Eval { to, op, args, at: self.at }));
        Value::Reg(to)
    }

    /// The result of an exact operation on constants. Those on floats stay: their errors are what others look for.
    fn folded(&mut self, op: Op, args: &[Value]) -> Option<Value> {
        let exact = match op {
            Op::Int(..) | Op::Logic(_) => true,
            Op::Compare(scalar, _) => !scalar.float(),
            Op::Convert(from, to) | Op::Bitcast(from, to) => !from.float() && !to.float(),
            Op::Copy(_)
            | Op::Input(..)
            | Op::Float(..)
            | Op::IsNan(_)
            | Op::IsInf(_)
            | Op::Select(_)
            | Op::Exponent(_)
            | Op::Ldexp(_)
            | Op::Index { .. }
            | Op::IndexWithin { .. }
            | Op::Length { .. }
            | Op::Load { .. }
            | Op::Mark(..)
            | Op::Fused { .. }
            | Op::Horner { .. } => false,
        };
        let known = args.iter().map(|a| self.known(*a)).collect::<Option<Vec<_>>>().filter(|_| exact)?;
        let bits = eval(op, &known)?;
        let exact = f64::from_bits(eval(Op::Convert(op.result(), Scalar::F64), &[bits])?);
        Some(self.bits(op.result(), bits, exact))
    }

    /// An operation on floats; a number times itself is a square.
    pub(crate) fn float_op(&mut self, op: FloatOp, args: &[Value]) -> Value {
        let scalar = self.scalar(args[0]);
        match (op, args) {
            (FloatOp::Mul, [a, b]) if a == b => self.eval(Op::Float(scalar, FloatOp::Square), &[*a]),
            _ => self.eval(Op::Float(scalar, op), args),
        }
    }

    pub(crate) fn int_op(&mut self, op: IntOp, args: &[Value]) -> Value {
        let scalar = self.scalar(args[0]);
        self.eval(Op::Int(scalar, op), args)
    }

    pub(crate) fn not(&mut self, a: Value) -> Value {
        self.eval(Op::Logic(LogicOp::Not), &[a])
    }

    /// `accept` where `condition` holds.
    pub(crate) fn select(&mut self, condition: Value, accept: Value, reject: Value) -> Value {
        if accept == reject {
            return accept;
        }
        let scalar = self.scalar(accept);
        self.eval(Op::Select(scalar), &[condition, accept, reject])
    }

    /// `base + min(index, count - 1) * stride`
    pub(crate) fn index(&mut self, base: Option<Value>, index: Value, count: Count, stride: u32) -> Value {
        let op = Op::Index { count, stride };
        match base {
            Some(base) => self.eval(op, &[index, base]),
            None => self.eval(op, &[index]),
        }
    }

    pub(crate) fn load(&mut self, place: Place, scalar: Scalar) -> Value {
        let changes = place.buffer().is_none_or(|buffer| self.program.buffers[buffer as usize].writable);
        let epoch = if changes { self.epoch } else { 0 };
        self.eval(Op::Load { place, scalar, epoch }, &[])
    }

    pub(crate) fn store(&mut self, place: Place, value: Value) {
        if let Some(buffer) = place.buffer() {
            self.program.buffers[buffer as usize].written = true;
        }
        self.touch();
        self.push(Stmt::Store { place, value, at: self.at });
    }

    /// Memory of each lane for these scalars.
    pub(crate) fn array(&mut self, scalars: &[Scalar]) -> u32 {
        let wide = scalars.iter().any(|s| s.wide());
        self.program.arrays.push(LaneArray { len: scalars.len() as u32, wide });
        self.program.arrays.len() as u32 - 1
    }
}

/// Whether drivers may differ in it.
fn errs(op: Op) -> bool {
    match op {
        Op::Float(..) | Op::Convert(..) | Op::Ldexp(_) => true,
        Op::Copy(_)
        | Op::Input(..)
        | Op::Int(..)
        | Op::Compare(..)
        | Op::Logic(_)
        | Op::IsNan(_)
        | Op::IsInf(_)
        | Op::Select(_)
        | Op::Bitcast(..)
        | Op::Exponent(_)
        | Op::Index { .. }
        | Op::IndexWithin { .. }
        | Op::Length { .. }
        | Op::Load { .. }
        | Op::Mark(..)
        | Op::Fused { .. }
        | Op::Horner { .. } => false,
    }
}
