//! A function being walked.

use super::super::error::{InterpError, Res};
use super::super::program::{Count, Value};
use super::layout::Shape;
use super::malformed;
use lobe_codegen::module::Scope;
use naga::{Expression, Function, Handle};
use std::rc::Rc;

/// What an expression is while programs are made.
#[derive(Debug, Clone)]
pub(crate) enum Item {
    /// One value for each scalar.
    Values(Rc<[Value]>),
    /// A place in memory.
    Pointer(Pointer),
    /// A texture, of [`super::Program::images`].
    Image(Choice),
    /// A sampler, of [`super::Program::samplers`].
    Sampler(Choice),
}

/// A texture or a sampler.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Choice {
    /// The variable.
    pub(crate) variable: u32,
    /// Of a binding array: the number of the element among the dispatch's; `None`: the array itself.
    pub(crate) element: Option<Value>,
}

impl Item {
    pub(crate) fn values(values: Vec<Value>) -> Self {
        Self::Values(values.into())
    }
}

/// What a pointer leads into.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Root {
    /// Scalars of variables, from this one on; places are known.
    Registers(usize),
    /// Memory of each lane.
    Lane(u32),
    /// Memory that lanes share.
    Buffer(u32),
}

/// A resolved pointer: root, known units, computed units.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pointer {
    pub(crate) root: Root,
    pub(crate) offset: u32,
    pub(crate) index: Option<Value>,
    /// Where the element of a binding array ends that it leads into.
    pub(crate) end: Option<Value>,
    pub(crate) shape: Shape,
}

/// How a function returns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Returning {
    /// Returns are where the function ends; see `scan::returns_last`.
    Last,
    /// Lanes leave to the function's end, the exit of this index.
    Early(usize),
}

/// A function being walked.
pub(crate) struct Frame<'m> {
    pub(crate) scope: Scope,
    pub(crate) function: &'m Function,
    pub(crate) info: &'m naga::valid::FunctionInfo,
    pub(crate) arguments: Vec<Item>,
    pub(crate) values: Vec<Option<Item>>,
    /// Where the local variables lie, by index.
    pub(crate) locals: Vec<Pointer>,
    /// The first scalar of the result among the variables.
    pub(crate) result: usize,
    pub(crate) returning: Returning,
    /// Index of its name.
    pub(crate) name: u32,
}

impl<'m> Frame<'m> {
    /// The scalars of an expression.
    pub(crate) fn data(&self, expression: Handle<Expression>) -> Res<Rc<[Value]>> {
        match &self.values[expression.index()] {
            Some(Item::Values(values)) => Ok(values.clone()),
            Some(Item::Pointer(_) | Item::Image(_) | Item::Sampler(_)) => {
                Err(malformed("a pointer or a texture is used as a value"))
            }
            None => Err(self.missing(expression)),
        }
    }

    /// The only scalar of an expression.
    pub(crate) fn single(&self, expression: Handle<Expression>) -> Res<Value> {
        self.data(expression)?.first().copied().ok_or(malformed("a value without scalars is used as one"))
    }

    pub(crate) fn pointer(&self, expression: Handle<Expression>) -> Res<Pointer> {
        match &self.values[expression.index()] {
            Some(Item::Pointer(pointer)) => Ok(*pointer),
            Some(Item::Values(_) | Item::Image(_) | Item::Sampler(_)) => {
                Err(malformed("a value or a texture is used as a pointer"))
            }
            None => Err(self.missing(expression)),
        }
    }

    pub(crate) fn image(&self, expression: Handle<Expression>) -> Res<Choice> {
        match &self.values[expression.index()] {
            Some(Item::Image(image)) => Ok(*image),
            Some(Item::Values(_) | Item::Pointer(_) | Item::Sampler(_)) => {
                Err(malformed("something else is used as a texture"))
            }
            None => Err(self.missing(expression)),
        }
    }

    pub(crate) fn sampler(&self, expression: Handle<Expression>) -> Res<Choice> {
        match &self.values[expression.index()] {
            Some(Item::Sampler(sampler)) => Ok(*sampler),
            Some(Item::Values(_) | Item::Pointer(_) | Item::Image(_)) => {
                Err(malformed("something else is used as a sampler"))
            }
            None => Err(self.missing(expression)),
        }
    }

    fn missing(&self, expression: Handle<Expression>) -> InterpError {
        if let Expression::GlobalVariable(_) = self.function.expressions[expression] {
            self.unsupported("a buffer, a texture or workgroup memory outside of a dispatch")
        } else {
            malformed("an expression is used before it is emitted")
        }
    }

    pub(crate) fn display_name(&self) -> String {
        self.function.name.clone().unwrap_or_else(|| "entry point".to_owned())
    }

    pub(crate) fn unsupported(&self, what: impl Into<String>) -> InterpError {
        InterpError::Unsupported { what: what.into(), function: self.display_name(), at: None }
    }
}

impl Pointer {
    /// A count that the buffer's length says, of the array that this pointer leads to.
    pub(crate) fn runtime(&self) -> Res<Count> {
        match (self.root, self.index) {
            (Root::Buffer(buffer), None) => Ok(Count::Runtime { buffer, begin: self.offset }),
            (Root::Buffer(_) | Root::Registers(_) | Root::Lane(_), _) => {
                Err(malformed("a runtime-sized array lies at the end of a buffer"))
            }
        }
    }
}
