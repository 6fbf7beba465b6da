//! Function calls.

use super::super::error::{InterpError, Res};
use super::super::layout::Pointee;
use super::super::leaf::Leaf;
use super::super::mask::Mask;
use super::super::model::Model;
use super::{Flow, Frame, Machine, Value};
use lobe_codegen::def::Truth;
use lobe_codegen::module::Scope;
use naga::{Expression, Function, Handle};

impl<'m, M: Model> Machine<'m, M> {
    pub(super) fn call(
        &mut self,
        frame: &mut Frame<'m, M>,
        function: Handle<Function>,
        arguments: &[Handle<Expression>],
        result: Option<Handle<Expression>>,
    ) -> Res<()> {
        let argument = |h: &Handle<Expression>| {
            frame.values[h.index()].clone().ok_or(InterpError::Malformed("an argument is not emitted"))
        };
        let arguments = arguments.iter().map(argument).collect::<Res<Vec<_>>>()?;
        let leaves = self.invoke(Scope::Function(function), arguments, frame.flow.active.clone())?;
        if let Some(result) = result {
            frame.values[result.index()] = Some(Value::data(leaves));
        }
        Ok(())
    }

    /// Runs a function in the lanes of `active`; returns its result, zero in the other lanes.
    pub(in super::super) fn invoke(
        &mut self,
        scope: Scope,
        arguments: Vec<Value<M>>,
        active: Mask,
    ) -> Res<Vec<Leaf<M>>> {
        let mut frame = self.enter(scope, arguments, active)?;
        self.prepare(&mut frame)?;
        self.local_values(&frame)?;
        let function = frame.function;
        self.block(&mut frame, &function.body)?;
        self.memory.lane.truncate(frame.locals);
        let mut result = frame.flow.result;
        if let Scope::Function(function) = scope
            && M::SHADOW
            && let Some(truth) = self.module.meta().truths.get(&function)
        {
            self.tell_truth(*truth, &frame.arguments, &mut result)?;
        }
        if M::SHADOW { self.settle(result) } else { Ok(result) }
    }

    fn settle(&self, result: Vec<Leaf<M>>) -> Res<Vec<Leaf<M>>> {
        let settled = |leaf: Leaf<M>| match leaf {
            Leaf::Float(_) => self.map_f(&leaf, |a| self.model.settled(a)),
            Leaf::Word(_) | Leaf::Bool(_) => Ok(leaf),
        };
        result.into_iter().map(settled).collect()
    }

    fn enter(&mut self, scope: Scope, arguments: Vec<Value<M>>, active: Mask) -> Res<Frame<'m, M>> {
        let module = self.module.module();
        let (function, info) = match scope {
            Scope::Function(handle) => (&module.functions[handle], &self.module.info()[handle]),
            Scope::Entry(index) => {
                let entry = module.entry_points.get(index).ok_or(InterpError::NoEntryPoint(index))?;
                (&entry.function, self.module.info().get_entry_point(index))
            }
            Scope::Global => return Err(InterpError::Malformed("global expressions are no function")),
        };
        let kinds = match &function.result {
            Some(result) => self.types().kinds(Pointee::Type(result.ty))?,
            None => Vec::new(),
        };
        let none = Mask::none(self.lanes);
        Ok(Frame {
            scope,
            function,
            info,
            arguments,
            values: (0..function.expressions.len()).map(|_| None).collect(),
            locals: self.memory.lane.len(),
            flow: Flow {
                active,
                broke: none.clone(),
                continued: none.clone(),
                result: self.zeros(&kinds),
                returned: none.clone(),
                value_returned: none.clone(),
                exact_returned: none,
            },
        })
    }

    /// Makes the local variables, with their first values.
    fn local_values(&mut self, frame: &Frame<'m, M>) -> Res<()> {
        for (_, variable) in frame.function.local_variables.iter() {
            let value = match variable.init {
                Some(init) => self.constant_expression(frame, init)?,
                None => self.zeros(&self.types().kinds(Pointee::Type(variable.ty))?),
            };
            self.memory.lane.push(value);
        }
        Ok(())
    }

    /// The first value of a variable; naga permits only constant expressions there.
    fn constant_expression(&mut self, frame: &Frame<'m, M>, init: Handle<Expression>) -> Res<Vec<Leaf<M>>> {
        if frame.values[init.index()].is_some() {
            return Ok(frame.data(init)?.to_vec());
        }
        let expression = &frame.function.expressions[init];
        if let Expression::Compose { components, .. } = expression {
            let parts = components.iter().map(|c| self.constant_expression(frame, *c));
            Ok(parts.collect::<Res<Vec<_>>>()?.concat())
        } else if let Expression::Splat { size, value } = expression {
            let value = self.constant_expression(frame, *value)?;
            Ok(std::iter::repeat_n(value, *size as usize).flatten().collect())
        } else {
            Err(frame.unsupported(format!("{expression:?} as the first value of a local variable")))
        }
    }

    /// The function stands for an exact one: that one's values are exact, the difference is an error.
    fn tell_truth(&self, truth: Truth, arguments: &[Value<M>], result: &mut [Leaf<M>]) -> Res<()> {
        let mut floats = Vec::new();
        for argument in arguments {
            if let Value::Data(leaves) = argument {
                for leaf in leaves.iter().filter(|leaf| matches!(leaf, Leaf::Float(_))) {
                    floats.push(leaf.floats()?);
                }
            }
        }
        let exact = |argument: usize, lane: usize| {
            floats.get(argument).map_or(f64::NAN, |lanes| self.model.exact(lanes[lane]))
        };
        if let Some(leaf @ Leaf::Float(_)) = result.first_mut() {
            let told = leaf.floats()?.iter().enumerate().map(|(lane, body)| {
                let truth = match truth {
                    Truth::Unary(f) => f(exact(0, lane)),
                    Truth::Binary(f) => f(exact(0, lane), exact(1, lane)),
                };
                self.model.with_truth(*body, truth)
            });
            *leaf = Leaf::from_floats(told.collect());
        }
        Ok(())
    }
}
