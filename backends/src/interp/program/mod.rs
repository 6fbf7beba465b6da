//! Lowered programs: a function or an entry point as operations on scalars, with structured control flow.
//!
//! `lower` makes them from naga's IR, once; `passes` rewrite them; `fast` links them into code and runs it.
//! `judge` runs them as they are lowered, on whatever numbers a model has.
//! Nothing here knows naga's expressions, lanes or instruction sets.
//!
//! - Vectors, matrices, arrays and structures are their scalars; calls are inlined; pointers are resolved.
//! - A [`Value`] is a constant or a register. A register is computed by one statement: by [`Stmt::Eval`] in all lanes,
//!   needed or not, since operations are pure and total; by [`Stmt::Atomic`], [`Stmt::Texture`] and
//!   [`Stmt::Subgroup`] in the active lanes. Or it is *kept* across the rounds of a loop and assigned by
//!   [`Stmt::Set`], in the active lanes only.
//! - Where two ways of a branch meet, [`Op::Select`] takes each lane's value from the arm that it took.
//!   The other arm may not have run at all; what its registers then hold does not matter.
//! - A register is *uniform* or *varying* (`passes::uniform`): the same in all lanes that a batch runs, or one
//!   value a lane. Uniform values are computed once a batch.
//!
//! [`op`] is the table of operations, [`text`] prints programs for those who look for what went wrong.

pub(crate) mod memory;
pub(crate) mod op;
pub(crate) mod subgroup;
pub(crate) mod text;
pub(crate) mod texture;

pub(crate) use memory::{BindingArray, Buffer, Content, Count, LaneArray, Place};
pub(crate) use op::{Op, Scalar};
pub(crate) use subgroup::Subgroup;
pub(crate) use texture::{Access, Image, SamplerVariable};

use naga::Span;

/// A register, by index into [`Program::registers`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Reg(pub(crate) u32);

/// An operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Value {
    /// Of [`Program::constants`].
    Const(u32),
    /// Computed.
    Reg(Reg),
}

/// A number that is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Constant {
    /// What it is.
    pub(crate) scalar: Scalar,
    /// Its bits as registers hold them: a boolean is all ones or zero, an f16 is held as f32.
    pub(crate) bits: u64,
    /// Of a float, the value that the source states, which `bits` may round.
    pub(crate) exact: f64,
}

/// What is known of a register.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Register {
    /// What it holds.
    pub(crate) scalar: Scalar,
    /// Whether lanes may differ in it.
    pub(crate) varying: bool,
}

/// Where lanes that leave a construct meet again: its end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Label(pub(crate) u32);

/// Operands of an operation; none has more than four.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Args {
    list: [Value; 4],
    len: u8,
}

impl Args {
    pub(crate) fn new(args: &[Value]) -> Self {
        let mut list = [Value::Const(0); 4];
        list[..args.len()].copy_from_slice(args);
        Self { list, len: args.len() as u8 }
    }
}

impl std::ops::Deref for Args {
    type Target = [Value];
    fn deref(&self) -> &[Value] {
        &self.list[..usize::from(self.len)]
    }
}

impl std::ops::DerefMut for Args {
    fn deref_mut(&mut self) -> &mut [Value] {
        &mut self.list[..usize::from(self.len)]
    }
}

/// A pure operation and the register that takes its result.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Eval {
    pub(crate) to: Reg,
    pub(crate) op: Op,
    pub(crate) args: Args,
    /// Where the source has it.
    pub(crate) at: Span,
}

/// A sequence of statements.
pub(crate) type Block = Vec<Stmt>;

/// What a program does.
#[derive(Debug, Clone)]
pub(crate) enum Stmt {
    /// Computes a register.
    Eval(Eval),
    /// Assigns a kept register in the active lanes.
    Set { to: Reg, value: Value },
    /// Writes memory in the active lanes, one after the other.
    Store {
        place: Place,
        value: Value,
        /// Where the source has it.
        at: Span,
    },
    /// Replaces a word of memory in the active lanes, one after the other; `old` takes what it was.
    Atomic(Atomic),
    /// Uses a texture in the active lanes, one after the other.
    Texture(Box<Access>),
    /// The active lanes of each subgroup exchange values.
    Subgroup(Subgroup),
    /// The active lanes run one arm or the other.
    If { condition: Value, accept: Block, reject: Block },
    /// Repeats `body` until no lane is left in it; [`Stmt::Leave`] leaves. `function` names it in messages.
    Loop {
        label: Label,
        body: Block,
        function: u32,
        /// Where the source has it.
        at: Span,
    },
    /// Runs `body` once; lanes may leave it early.
    Scope { label: Label, body: Block },
    /// The active lanes go to the end of an enclosing loop or scope. The last statement of its block.
    Leave(Label),
    /// All invocations of the workgroup meet.
    Barrier {
        function: u32,
        /// Where the source has it.
        at: Span,
    },
}

/// An atomic update of one 32- or 64-bit word.
#[derive(Debug, Clone)]
pub(crate) struct Atomic {
    pub(crate) place: Place,
    pub(crate) fun: Update,
    pub(crate) value: Value,
    /// Of a compare-exchange.
    pub(crate) expected: Option<Value>,
    /// Takes the former word.
    pub(crate) old: Option<Reg>,
    /// Where the source has it.
    pub(crate) at: Span,
}

/// What an atomic does with the former word and its operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Update {
    Add,
    Subtract,
    And,
    Xor,
    Or,
    Min,
    Max,
    Exchange,
    /// Exchanges if the former word is the expected one.
    CompareExchange,
}

/// A lowered function or entry point.
#[derive(Debug, Clone)]
pub(crate) struct Program {
    /// The functions that were inlined, by the index that statements carry.
    pub(crate) functions: Vec<String>,
    pub(crate) registers: Vec<Register>,
    pub(crate) constants: Vec<Constant>,
    /// Memory of each lane that is indexed dynamically.
    pub(crate) arrays: Vec<LaneArray>,
    /// Memory that lanes share.
    pub(crate) buffers: Vec<Buffer>,
    pub(crate) images: Vec<Image>,
    pub(crate) samplers: Vec<SamplerVariable>,
    pub(crate) body: Block,
    /// The result's scalars.
    pub(crate) results: Vec<Value>,
    /// Columns of a function's arguments.
    pub(crate) columns: usize,
    /// The exact functions that marks name.
    pub(crate) truths: Vec<lobe_codegen::def::Truth>,
    /// Whether invocations of a workgroup depend on each other: barriers, workgroup memory,
    /// subgroups.
    pub(crate) cooperative: bool,
}

impl Program {
    /// What a value is.
    pub(crate) fn scalar(&self, value: Value) -> Scalar {
        match value {
            Value::Const(id) => self.constants[id as usize].scalar,
            Value::Reg(reg) => self.registers[reg.0 as usize].scalar,
        }
    }

    /// Whether lanes may differ in it.
    pub(crate) fn varying(&self, value: Value) -> bool {
        match value {
            Value::Const(_) => false,
            Value::Reg(reg) => self.registers[reg.0 as usize].varying,
        }
    }
}

impl Stmt {
    /// Calls `f` on each operand of this statement itself, not of those within it.
    pub(crate) fn operands(&self, f: &mut impl FnMut(Value)) {
        let place = |p: &Place, f: &mut dyn FnMut(Value)| p.index().into_iter().for_each(f);
        match self {
            Self::Eval(eval) => {
                eval.args.iter().for_each(|a| f(*a));
                if let Some(p) = eval.op.place() {
                    place(&p, f);
                }
            }
            Self::Set { value, .. } => f(*value),
            Self::Store { place: p, value, .. } => {
                place(p, f);
                f(*value);
            }
            Self::Atomic(atomic) => {
                place(&atomic.place, f);
                f(atomic.value);
                atomic.expected.into_iter().for_each(f);
            }
            Self::Texture(access) => {
                access.operands.map(f);
            }
            Self::Subgroup(subgroup) => {
                f(subgroup.value);
                subgroup.index.into_iter().for_each(f);
            }
            Self::If { condition, .. } => f(*condition),
            Self::Loop { .. } | Self::Scope { .. } | Self::Leave(_) | Self::Barrier { .. } => {}
        }
    }

    /// The same, to be changed.
    pub(crate) fn operands_mut(&mut self, f: &mut impl FnMut(&mut Value)) {
        match self {
            Self::Eval(eval) => {
                eval.args.iter_mut().for_each(&mut *f);
                if let Op::Load { place, .. } = &mut eval.op {
                    place.index_mut().into_iter().for_each(f);
                }
            }
            Self::Set { value, .. } => f(value),
            Self::Store { place, value, .. } => {
                place.index_mut().into_iter().for_each(&mut *f);
                f(value);
            }
            Self::Atomic(atomic) => {
                atomic.place.index_mut().into_iter().for_each(&mut *f);
                f(&mut atomic.value);
                atomic.expected.iter_mut().for_each(f);
            }
            Self::Texture(access) => {
                access.operands = access.operands.map(|mut value| {
                    f(&mut value);
                    value
                });
            }
            Self::Subgroup(subgroup) => {
                f(&mut subgroup.value);
                subgroup.index.iter_mut().for_each(f);
            }
            Self::If { condition, .. } => f(condition),
            Self::Loop { .. } | Self::Scope { .. } | Self::Leave(_) | Self::Barrier { .. } => {}
        }
    }

    /// The registers that it computes or assigns.
    pub(crate) fn targets(&self) -> impl Iterator<Item = Reg> {
        let one = |reg| [reg, None, None, None];
        let targets = match self {
            Self::Eval(eval) => one(Some(eval.to)),
            Self::Set { to, .. } => one(Some(*to)),
            Self::Atomic(atomic) => one(atomic.old),
            Self::Texture(access) => access.to,
            Self::Subgroup(subgroup) => one(Some(subgroup.to)),
            Self::Store { .. }
            | Self::If { .. }
            | Self::Loop { .. }
            | Self::Scope { .. }
            | Self::Leave(_)
            | Self::Barrier { .. } => [None; 4],
        };
        targets.into_iter().flatten()
    }

    /// The blocks within it.
    pub(crate) fn blocks(&self) -> [Option<&Block>; 2] {
        match self {
            Self::If { accept, reject, .. } => [Some(accept), Some(reject)],
            Self::Loop { body, .. } | Self::Scope { body, .. } => [Some(body), None],
            Self::Eval(_)
            | Self::Set { .. }
            | Self::Store { .. }
            | Self::Atomic(_)
            | Self::Texture(_)
            | Self::Subgroup(_)
            | Self::Leave(_)
            | Self::Barrier { .. } => [None, None],
        }
    }

    /// The blocks within it, to be changed.
    pub(crate) fn blocks_mut(&mut self) -> [Option<&mut Block>; 2] {
        match self {
            Self::If { accept, reject, .. } => [Some(accept), Some(reject)],
            Self::Loop { body, .. } | Self::Scope { body, .. } => [Some(body), None],
            Self::Eval(_)
            | Self::Set { .. }
            | Self::Store { .. }
            | Self::Atomic(_)
            | Self::Texture(_)
            | Self::Subgroup(_)
            | Self::Leave(_)
            | Self::Barrier { .. } => [None, None],
        }
    }
}
