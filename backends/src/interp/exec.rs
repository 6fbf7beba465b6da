//! Statements over all lanes at once.
//!
//! Lanes are masked, not branched: [`Frame::live`] says which of them execute a statement.
//! Pure expressions are computed for all lanes; stores, returns, calls and atomics obey the mask.

use super::error::{Fault, Internal, InterpError, Result};
use super::join::Returns;
use super::memory::Shared;
use super::model::Model;
use super::value::{Column, Pointee, Pointer, Root, Slot, Value, kinds};
use lobe_codegen::ValidModule;
use lobe_codegen::module::Scope;
use naga::valid::FunctionInfo;
use naga::{Block, Expression, Function, Handle, Statement};
use std::rc::Rc;

/// Rounds after which a loop is taken to be endless.
const FUEL: u64 = 1 << 24;

/// Runs functions over a batch of lanes.
pub(super) struct Executor<'m, M: Model> {
    pub(super) module: &'m ValidModule,
    pub(super) lanes: usize,
    /// Variables of all functions being executed; each lane has its own.
    pub(super) private: Vec<Vec<Column<M>>>,
    /// Memory that the lanes share.
    pub(super) shared: Shared<M>,
    /// Built-in inputs of the entry point, in the order of its arguments.
    pub(super) notes: Notes,
    fuel: u64,
}

/// What the shadow lane notes of each lane beside its values.
#[derive(Debug, Clone)]
pub(super) struct Notes {
    /// It met a condition that may come out either way.
    pub(super) ambiguous: Vec<bool>,
    /// It has no bound, for a reason other than arithmetic.
    pub(super) indeterminate: Vec<bool>,
}

/// A function being executed.
pub(super) struct Frame<'m, M: Model> {
    pub(super) function: &'m Function,
    pub(super) info: &'m FunctionInfo,
    pub(super) scope: Scope,
    pub(super) arguments: Vec<Slot<M>>,
    pub(super) values: Vec<Option<Slot<M>>>,
    /// Index of its first variable in [`Executor::private`].
    pub(super) first_private: usize,
    pub(super) flow: Flow<M>,
}

/// Where the lanes of a frame are.
#[derive(Debug, Clone)]
pub(super) struct Flow<M: Model> {
    /// They execute the next statement.
    pub(super) live: Vec<bool>,
    pub(super) returns: Returns<M>,
    /// Lanes that left, one mask for each enclosing loop and switch.
    pub(super) broken: Vec<Vec<bool>>,
    /// Lanes that go on with the next round, one mask for each enclosing loop.
    pub(super) continued: Vec<Vec<bool>>,
}

pub(super) fn any(mask: &[bool]) -> bool {
    mask.iter().any(|&on| on)
}

pub(super) fn and_not(a: &[bool], b: &[bool]) -> Vec<bool> {
    a.iter().zip(b).map(|(&a, &b)| a && !b).collect()
}

pub(super) fn merge(to: &mut [bool], from: &[bool]) {
    for (to, &from) in to.iter_mut().zip(from) {
        *to |= from;
    }
}

impl<'m, M: Model> Executor<'m, M> {
    pub(super) fn new(module: &'m ValidModule, lanes: usize) -> Self {
        let notes = Notes { ambiguous: vec![false; lanes], indeterminate: vec![false; lanes] };
        Self { module, lanes, private: Vec::new(), shared: Shared::default(), notes, fuel: FUEL }
    }

    /// Calls a function in the lanes of `live`.
    pub(super) fn call(
        &mut self,
        handle: Handle<Function>,
        arguments: Vec<Slot<M>>,
        live: &[bool],
    ) -> Result<Option<Value<M>>> {
        let module = self.module;
        let function = &module.module().functions[handle];
        let info = &module.info()[handle];
        let returned = self
            .body(function, info, Scope::Function(handle), arguments.clone(), live)
            .map_err(|fault| Fault::Known(fault.within(function.name.as_deref().unwrap_or("a function"))))?;
        match (returned, module.meta().truths.get(&handle)) {
            (Some(columns), Some(truth)) => with_truth::<M>(columns, *truth, &arguments).map(Some),
            (columns, _) => Ok(columns.map(Rc::new)),
        }
    }

    /// Executes a function's or an entry point's body.
    pub(super) fn body(
        &mut self,
        function: &'m Function,
        info: &'m FunctionInfo,
        scope: Scope,
        arguments: Vec<Slot<M>>,
        live: &[bool],
    ) -> Result<Option<Vec<Column<M>>>> {
        let first_private = self.private.len();
        let mut frame = Frame {
            function,
            info,
            scope,
            arguments,
            values: vec![None; function.expressions.len()],
            first_private,
            flow: Flow {
                live: live.to_vec(),
                returns: Returns::new(self.lanes),
                broken: Vec::new(),
                continued: Vec::new(),
            },
        };
        for (_, variable) in function.local_variables.iter() {
            let mut variable_kinds = Vec::new();
            kinds(self.module.module(), &self.module.module().types[variable.ty].inner, &mut variable_kinds)?;
            self.private.push(variable_kinds.iter().map(|k| Column::zero(*k, self.lanes)).collect());
        }
        for (i, (_, variable)) in function.local_variables.iter().enumerate() {
            if let Some(init) = variable.init {
                let value = self.value(&mut frame, init)?;
                self.private[first_private + i] = (*value).clone();
            }
        }
        self.block(&mut frame, &function.body)?;
        self.private.truncate(first_private);
        Ok(frame.flow.returns.value)
    }

    /// Executes statements while any lane is live.
    pub(super) fn block(&mut self, frame: &mut Frame<'m, M>, block: &'m Block) -> Result<()> {
        for statement in block {
            if !any(&frame.flow.live) {
                return Ok(());
            }
            self.statement(frame, statement)?;
        }
        Ok(())
    }

    fn statement(&mut self, frame: &mut Frame<'m, M>, statement: &'m Statement) -> Result<()> {
        match statement {
            Statement::Emit(range) => {
                for handle in range.clone() {
                    let slot = self.evaluate(frame, handle)?;
                    frame.values[handle.index()] = Some(slot);
                }
                Ok(())
            }
            Statement::Block(block) => self.block(frame, block),
            Statement::If { condition, accept, reject } => self.if_else(frame, *condition, accept, reject),
            Statement::Switch { selector, cases } => self.switch(frame, *selector, cases),
            Statement::Loop { body, continuing, break_if } => self.repeat(frame, body, continuing, *break_if),
            Statement::Break => {
                let live = std::mem::replace(&mut frame.flow.live, vec![false; self.lanes]);
                frame
                    .flow
                    .broken
                    .last_mut()
                    .map(|broken| merge(broken, &live))
                    .ok_or_else(|| Internal::NotEvaluated.into())
            }
            Statement::Continue => {
                let live = std::mem::replace(&mut frame.flow.live, vec![false; self.lanes]);
                frame
                    .flow
                    .continued
                    .last_mut()
                    .map(|c| merge(c, &live))
                    .ok_or_else(|| Internal::NotEvaluated.into())
            }
            Statement::Return { value } => {
                let value = value.map(|handle| self.value(frame, handle)).transpose()?;
                let live = std::mem::replace(&mut frame.flow.live, vec![false; self.lanes]);
                frame.flow.returns.put(value.as_ref(), &live)
            }
            Statement::Store { pointer, value } => {
                let pointer = self.pointer(frame, *pointer)?;
                let value = self.value(frame, *value)?;
                self.store(&pointer, &value, &frame.flow.live)
            }
            Statement::Call { function, arguments, result } => {
                let arguments = arguments.iter().map(|a| self.slot(frame, *a)).collect::<Result<Vec<_>>>()?;
                let returned = self.call(*function, arguments, &frame.flow.live)?;
                if let (Some(result), Some(value)) = (result, returned) {
                    frame.values[result.index()] = Some(Slot::Value(value));
                }
                Ok(())
            }
            Statement::Atomic { pointer, fun, value: value_handle, result } => {
                let pointer = self.pointer(frame, *pointer)?;
                let value = self.value(frame, *value_handle)?;
                let signed = self.is_signed(frame, *value_handle);
                let old = self.atomic(frame, &pointer, fun, &value, signed)?;
                if let Some(result) = result {
                    frame.values[result.index()] = Some(Slot::Value(old));
                }
                Ok(())
            }
            Statement::ControlBarrier(_) | Statement::MemoryBarrier(_) => self.barrier(frame),
            Statement::WorkGroupUniformLoad { pointer, result } => {
                self.barrier(frame)?;
                let pointer = self.pointer(frame, *pointer)?;
                let value = self.load(&pointer)?;
                frame.values[result.index()] = Some(Slot::Value(value));
                Ok(())
            }
            Statement::Kill
            | Statement::ImageStore { .. }
            | Statement::ImageAtomic { .. }
            | Statement::RayQuery { .. }
            | Statement::RayPipelineFunction(_)
            | Statement::SubgroupBallot { .. }
            | Statement::SubgroupGather { .. }
            | Statement::SubgroupCollectiveOperation { .. }
            | Statement::CooperativeStore { .. } => {
                Err(Fault::Unsupported(format!("the statement {}", first_word(&format!("{statement:?}")))))
            }
        }
    }

    /// All lanes run in step, so a barrier has nothing to do; but all of them must get there.
    fn barrier(&self, frame: &Frame<'m, M>) -> Result<()> {
        let reached = frame.flow.live.iter().filter(|&&on| on).count();
        if reached == self.lanes {
            return Ok(());
        }
        let function = frame.function.name.clone().unwrap_or_else(|| "the entry point".to_owned());
        Err(Fault::Known(InterpError::NonUniformBarrier { function, reached, lanes: self.lanes }))
    }

    /// Counts a round of a loop.
    pub(super) fn burn(&mut self, frame: &Frame<'m, M>) -> Result<()> {
        self.fuel -= 1;
        if self.fuel > 0 {
            return Ok(());
        }
        let function = frame.function.name.clone().unwrap_or_else(|| "the entry point".to_owned());
        Err(Fault::Known(InterpError::OutOfFuel { function, rounds: FUEL }))
    }

    // ---- operands

    /// What an expression stands for; those that need no emission are made here.
    pub(super) fn slot(&mut self, frame: &mut Frame<'m, M>, handle: Handle<Expression>) -> Result<Slot<M>> {
        if let Some(slot) = &frame.values[handle.index()] {
            return Ok(slot.clone());
        }
        if !frame.function.expressions[handle].needs_pre_emit() {
            return Err(Internal::NotEvaluated.into());
        }
        let slot = self.evaluate(frame, handle)?;
        frame.values[handle.index()] = Some(slot.clone());
        Ok(slot)
    }

    /// The value of an expression.
    pub(super) fn value(&mut self, frame: &mut Frame<'m, M>, handle: Handle<Expression>) -> Result<Value<M>> {
        match self.slot(frame, handle)? {
            Slot::Value(value) => Ok(value),
            Slot::Pointer(_) => Err(Internal::Kind.into()),
        }
    }

    /// The pointer that an expression is.
    pub(super) fn pointer(
        &mut self,
        frame: &mut Frame<'m, M>,
        handle: Handle<Expression>,
    ) -> Result<Pointer> {
        match self.slot(frame, handle)? {
            Slot::Pointer(pointer) => Ok(pointer),
            Slot::Value(_) => Err(Internal::Kind.into()),
        }
    }

    /// A pointer to a whole variable of the frame.
    pub(super) fn local(frame: &Frame<'m, M>, handle: Handle<naga::LocalVariable>) -> Pointer {
        Pointer {
            root: Root::Private(frame.first_private + handle.index()),
            offset: super::value::Offset::Same(0),
            ty: Pointee::Type(frame.function.local_variables[handle].ty),
        }
    }
}

/// The name of a variant in its `Debug` form.
pub(super) fn first_word(text: &str) -> String {
    text.chars().take_while(|c| c.is_alphanumeric()).collect()
}

fn with_truth<M: Model>(
    mut columns: Vec<Column<M>>,
    truth: lobe_codegen::def::Truth,
    arguments: &[Slot<M>],
) -> Result<Value<M>> {
    let mut inputs = Vec::new();
    for argument in arguments {
        if let Slot::Value(value) = argument {
            inputs.push(value.first().ok_or(Internal::Kind)?.floats()?);
        }
    }
    if let [Column::F(lanes)] = &mut columns[..] {
        for (i, lane) in lanes.iter_mut().enumerate() {
            let here: Vec<M::F> = inputs.iter().map(|column| column[i]).collect();
            *lane = M::with_truth(*lane, truth, &here);
        }
    }
    Ok(Rc::new(columns))
}
