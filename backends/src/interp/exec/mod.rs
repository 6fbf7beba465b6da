//! Statements and expressions, for any [`Model`], all lanes of a batch at once.
//!
//! Expressions are pure, so an `Emit` computes them in every lane, needed or not; whatever has an effect
//! (stores, returns, calls, atomics) obeys the mask of active lanes.
//! The choice of what to do is made once a batch, outside the loop over lanes.

mod access;
mod atomic;
mod binary;
mod block;
mod branch;
mod call;
mod cast;
mod constant;
mod expression;
mod geometry;
mod integer;
mod lanes;
mod math;
mod matrix;
mod repeat;

use super::error::{InterpError, Res};
use super::layout::{Kind, Types};
use super::leaf::Leaf;
use super::mask::Mask;
use super::memory::{Memory, Pointer, Root};
use super::model::Model;
use lobe_codegen::ValidModule;
use lobe_codegen::module::Scope;
use naga::{Expression, Handle};
use std::rc::Rc;

/// What an expression holds.
pub(super) enum Value<M: Model> {
    /// One column for each scalar.
    Data(Rc<[Leaf<M>]>),
    /// A place in memory.
    Pointer(Pointer),
}

impl<M: Model> Clone for Value<M> {
    fn clone(&self) -> Self {
        match self {
            Self::Data(leaves) => Self::Data(leaves.clone()),
            Self::Pointer(pointer) => Self::Pointer(pointer.clone()),
        }
    }
}

impl<M: Model> Value<M> {
    pub(super) fn data(leaves: Vec<Leaf<M>>) -> Self {
        Self::Data(leaves.into())
    }
}

/// What happened to rows beside their values.
#[derive(Debug, Clone)]
pub(super) struct Flags {
    /// Met an ambiguous decision that was joined.
    pub(super) ambiguous: Vec<bool>,
    /// Lost: what the row computes is no longer bounded, as after an ambiguous exit of a loop.
    pub(super) lost: Vec<bool>,
    /// An integer that is not known was turned to a float.
    pub(super) tainted: Vec<bool>,
}

/// A batch on its way through a module.
pub(super) struct Machine<'m, M: Model> {
    pub(super) module: &'m ValidModule,
    pub(super) model: M,
    pub(super) lanes: usize,
    pub(super) memory: Memory<M>,
    /// Where the global variables lie, by index.
    pub(super) globals: Vec<Option<Root>>,
    pub(super) flags: Flags,
    /// Rounds of loops left.
    pub(super) fuel: u64,
    /// Whether the lanes are a workgroup, so that barriers bind them.
    pub(super) workgroup: bool,
}

/// Where the lanes of a function are.
pub(super) struct Flow<M: Model> {
    /// Execute here.
    pub(super) active: Mask,
    /// Left the innermost loop or switch.
    pub(super) broke: Mask,
    /// Wait for the end of the innermost loop's body.
    pub(super) continued: Mask,
    /// Values returned so far.
    pub(super) result: Vec<Leaf<M>>,
    /// Lanes that have one. Where decisions are ambiguous, such a lane may still execute.
    pub(super) returned: Mask,
    /// Lanes whose f32 decisions led to the return.
    pub(super) value_returned: Mask,
    /// Lanes whose exact decisions led to the return.
    pub(super) exact_returned: Mask,
}

impl<M: Model> Clone for Flow<M> {
    fn clone(&self) -> Self {
        Self {
            active: self.active.clone(),
            broke: self.broke.clone(),
            continued: self.continued.clone(),
            result: self.result.clone(),
            returned: self.returned.clone(),
            value_returned: self.value_returned.clone(),
            exact_returned: self.exact_returned.clone(),
        }
    }
}

/// A function being executed.
pub(super) struct Frame<'m, M: Model> {
    pub(super) scope: Scope,
    pub(super) function: &'m naga::Function,
    pub(super) info: &'m naga::valid::FunctionInfo,
    pub(super) arguments: Vec<Value<M>>,
    pub(super) values: Vec<Option<Value<M>>>,
    /// Where the local variables lie: the first one; the others follow.
    pub(super) locals: usize,
    pub(super) flow: Flow<M>,
}

impl<'m, M: Model> Machine<'m, M> {
    /// A batch of `lanes`; private variables have their first values, other globals are not there yet.
    pub(super) fn new(module: &'m ValidModule, model: M, lanes: usize, fuel: u64) -> Res<Self> {
        let none = vec![false; lanes];
        let mut machine = Self {
            module,
            model,
            lanes,
            memory: Memory::new(),
            globals: vec![None; module.module().global_variables.len()],
            flags: Flags { ambiguous: none.clone(), lost: none.clone(), tainted: none },
            fuel,
            workgroup: false,
        };
        for (handle, variable) in module.module().global_variables.iter() {
            if variable.space == naga::AddressSpace::Private {
                let value = machine.initial(variable.ty, variable.init)?;
                machine.memory.lane.push(value);
                machine.globals[handle.index()] = Some(Root::Lane(machine.memory.lane.len() - 1));
            }
        }
        Ok(machine)
    }

    pub(super) fn types(&self) -> Types<'m> {
        Types(&self.module.module().types)
    }

    /// Zero of these kinds.
    pub(super) fn zeros(&self, kinds: &[Kind]) -> Vec<Leaf<M>> {
        kinds.iter().map(|kind| Leaf::zero(&self.model, *kind, self.lanes)).collect()
    }
}

impl<M: Model> Frame<'_, M> {
    /// The columns of an expression.
    pub(super) fn data(&self, expression: Handle<Expression>) -> Res<&[Leaf<M>]> {
        match &self.values[expression.index()] {
            Some(Value::Data(leaves)) => Ok(leaves),
            Some(Value::Pointer(_)) => Err(InterpError::Malformed("a pointer is used as a value")),
            None => Err(self.missing(expression)),
        }
    }

    /// The only column of a scalar expression.
    pub(super) fn scalar(&self, expression: Handle<Expression>) -> Res<&Leaf<M>> {
        self.data(expression)?.first().ok_or(InterpError::Malformed("a value without scalars is used as one"))
    }

    pub(super) fn pointer(&self, expression: Handle<Expression>) -> Res<&Pointer> {
        match &self.values[expression.index()] {
            Some(Value::Pointer(pointer)) => Ok(pointer),
            Some(Value::Data(_)) => Err(InterpError::Malformed("a value is used as a pointer")),
            None => Err(self.missing(expression)),
        }
    }

    /// Why an expression has no value.
    fn missing(&self, expression: Handle<Expression>) -> InterpError {
        if let Expression::GlobalVariable(_) = self.function.expressions[expression] {
            self.unsupported("a buffer or workgroup memory outside of a dispatch")
        } else {
            InterpError::Malformed("an expression is used before it is emitted")
        }
    }

    pub(super) fn name(&self) -> String {
        self.function.name.clone().unwrap_or_else(|| "entry point".to_owned())
    }

    pub(super) fn unsupported(&self, what: impl Into<String>) -> InterpError {
        InterpError::Unsupported { what: what.into(), function: self.name() }
    }
}
