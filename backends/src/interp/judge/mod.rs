//! Runs programs as they are lowered, on whatever numbers a model has: the judge of what other executors return.
//!
//! [`Strict`](super::strict::Strict) gives what `fast` must give, bit for bit, by other code;
//! [`Shadow`](super::shadow::Shadow) gives bounds; [`Perturbed`](super::perturbed::Perturbed) is one driver.
//! All lanes of a batch take each statement together, those that are active in it.
//!
//! - `plan` says beforehand what blocks change; `flow` branches and loops; halves of
//!   lanes meet by `waiting`.
//! - `column` holds a scalar in all lanes; `eval` computes it, by `float`, [`integer`] and `cast`; `bits` is for
//!   what models have no numbers for.
//! - `memory` and `atomic` are what programs address; `subgroup` is what lanes exchange,
//!   `texture` what textures hold.
//! - [`watch`] looks for mistakes of the program.
//! - [`rows`] calls functions; [`dispatch`] runs entry points.

/// `$body` with `$m` the model for floats of a scalar's width.
macro_rules! by_width {
    ($model:expr, $scalar:expr, $m:ident => $body:expr) => {
        match $scalar {
            Scalar::F16 => {
                let $m = &$model.half();
                $body
            }
            Scalar::F64 => {
                let $m = &$model.double();
                $body
            }
            _ => {
                let $m = &$model;
                $body
            }
        }
    };
}

mod atomic;
mod bits;
mod cast;
mod column;
pub(super) mod dispatch;
mod eval;
mod float;
mod flow;
mod input;
pub(super) mod integer;
mod memory;
mod picture;
mod plan;
pub(super) mod rows;
mod shared;
mod subgroup;
mod texture;
mod waiting;
pub(super) mod watch;

use super::error::{InterpError, Res};
use super::mask::Mask;
use super::model::Model;
use super::program::{Block, Program, Stmt};
use crate::texture::Sampler;
use atomic::Order;
use column::{Column, Single};
use flow::Flow;
use input::Inputs;
use picture::Picture;
use plan::Plan;
use shared::Shared;
use std::sync::Arc;
use watch::Watch;

const MISMATCH: InterpError = InterpError::Malformed("a scalar of one kind is used as another");

/// A program that is ready to run.
pub(super) struct Code {
    pub(super) program: Program,
    plan: Arc<Plan>,
}

impl Code {
    pub(super) fn new(program: Program) -> Self {
        let plan = Arc::new(Plan::of(&program));
        Self { program, plan }
    }
}

/// What happened to lanes beside their values.
#[derive(Debug, Clone)]
struct Flags {
    /// Met an ambiguous decision that was joined.
    ambiguous: Vec<bool>,
    /// Lost: what the lane computes is no longer bounded.
    lost: Vec<bool>,
    /// An integer that is not known became a float, or an address.
    tainted: Vec<bool>,
}

/// A batch on its way through a program.
struct Machine<'c, M: Model> {
    program: &'c Program,
    plan: Arc<Plan>,
    model: M,
    lanes: usize,
    registers: Vec<Column<M>>,
    constants: Vec<Single<M>>,
    /// Memory of each lane; a cell is empty until something is stored to it.
    arrays: Vec<Vec<Column<M>>>,
    /// Memory that the lanes share.
    shared: Vec<Shared<M>>,
    order: Order,
    images: Vec<Picture>,
    samplers: Vec<Sampler>,
    inputs: Inputs<'c>,
    flow: Flow<M>,
    flags: Flags,
    /// Rounds of loops left.
    fuel: u64,
    /// Looks for mistakes.
    watch: Option<Watch>,
}

impl<'c, M: Model> Machine<'c, M> {
    fn new(code: &'c Code, model: M, inputs: Inputs<'c>, lanes: usize, fuel: u64) -> Self {
        let program = &code.program;
        let none = vec![false; lanes];
        Self {
            registers: program.registers.iter().map(|r| Column::zero(&model, r.scalar, lanes)).collect(),
            constants: program.constants.iter().map(|c| Single::constant(&model, c)).collect(),
            arrays: program.arrays.iter().map(|a| (0..a.len).map(|_| Column::default()).collect()).collect(),
            shared: Vec::new(),
            images: Vec::new(),
            samplers: Vec::new(),
            order: Order::default(),
            flow: Flow::new(lanes, Mask::all(lanes)),
            flags: Flags { ambiguous: none.clone(), lost: none.clone(), tainted: none },
            plan: code.plan.clone(),
            program,
            model,
            lanes,
            inputs,
            fuel,
            watch: None,
        }
    }

    /// Runs the program once.
    fn run(&mut self) -> Res<()> {
        self.block(&self.program.body)
    }

    /// Executes `block` in the active lanes, as long as there are any.
    fn block(&mut self, block: &Block) -> Res<()> {
        for stmt in block {
            if !self.flow.active.any() {
                break;
            }
            self.statement(stmt)?;
        }
        Ok(())
    }

    fn statement(&mut self, stmt: &Stmt) -> Res<()> {
        if self.watch.is_some() {
            self.watch_before(stmt)?;
        }
        self.execute(stmt)?;
        if let Stmt::Eval(eval) = stmt
            && self.watch.is_some()
        {
            self.watch_result(eval)?;
        }
        Ok(())
    }

    fn execute(&mut self, stmt: &Stmt) -> Res<()> {
        match stmt {
            Stmt::Eval(eval) => self.eval(eval),
            Stmt::Set { to, value } => {
                let mut column = std::mem::take(&mut self.registers[to.0 as usize]);
                let done = self.copy(*value, &mut column);
                self.registers[to.0 as usize] = column;
                done
            }
            Stmt::Store { place, value, .. } => self.store(*place, *value),
            Stmt::Atomic(atomic) => self.atomic(atomic),
            Stmt::If { condition, accept, reject } => self.branch(*condition, accept, reject),
            Stmt::Loop { label, body, function, at } => self.repeat(*label, body, (*function, *at)),
            Stmt::Scope { label, body } => self.scope(*label, body),
            Stmt::Leave(label) => self.leave(*label),
            Stmt::Barrier { function, .. } => self.barrier(*function),
            Stmt::Subgroup(subgroup) => self.exchange(subgroup),
            Stmt::Texture(access) => self.texture(access),
        }
    }

    /// All invocations of a workgroup must arrive together; rows of a call are on their own.
    fn barrier(&mut self, function: u32) -> Res<()> {
        if self.inputs.workgroup() && !self.flow.active.every() && self.watch.is_none() {
            return Err(InterpError::NonUniformBarrier { function: self.function(function) });
        }
        self.order.passed += 1;
        Ok(())
    }

    /// The name of an inlined function.
    fn function(&self, index: u32) -> String {
        self.program.functions.get(index as usize).cloned().unwrap_or_default()
    }

    fn refuse(&self, what: String) -> InterpError {
        InterpError::Unsupported { what, function: self.function(0), at: None }
    }
}
