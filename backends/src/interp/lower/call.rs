//! Functions are walked where they are called.

use super::super::error::{InterpError, Res};
use super::super::program::{Scalar, Stmt, Value};
use super::control::{Flow, Purpose};
use super::frame::{Frame, Item, Pointer, Returning, Root};
use super::layout::Shape;
use super::scan::{self, Variable};
use super::{LARGEST, Lowerer, MANY, malformed};
use lobe_codegen::module::Scope;
use naga::{Expression, Function, Handle, LocalVariable};

impl<'m> Lowerer<'m> {
    /// A call statement.
    pub(crate) fn call(
        &mut self,
        frame: &mut Frame<'m>,
        function: Handle<Function>,
        arguments: &[Handle<Expression>],
        result: Option<Handle<Expression>>,
    ) -> Res<Flow> {
        let argument = |h: &Handle<Expression>| {
            frame.values[h.index()].clone().ok_or(malformed("an argument is not emitted"))
        };
        let arguments = arguments.iter().map(argument).collect::<Res<Vec<_>>>()?;
        let values = self.invoke(Scope::Function(function), arguments)?;
        if let Some(result) = result {
            frame.values[result.index()] = Some(Item::values(values));
        }
        Ok(Flow::Falls)
    }

    /// Walks a function; returns the scalars of its result.
    pub(crate) fn invoke(&mut self, scope: Scope, arguments: Vec<Item>) -> Res<Vec<Value>> {
        let outer = self.variables.len();
        let mut frame = self.enter(scope, arguments)?;
        self.note_spans(&frame);
        if self.b.size > LARGEST {
            return Err(frame.unsupported("calls that inline to so many statements"));
        }
        self.prepare(&mut frame)?;
        self.local_variables(&mut frame)?;
        let function = frame.function;
        if scan::returns_last(&function.body, true) {
            self.sequence(&mut frame, &function.body, None)?;
        } else {
            self.leave_early(&mut frame)?;
        }
        let results = self.variables[frame.result..].iter().take(self.result_count(function)?);
        let results = results.copied().collect();
        self.variables.truncate(outer);
        Ok(self.marked(&frame, results))
    }

    /// Walks the body of a function with returns in its midst.
    fn leave_early(&mut self, frame: &mut Frame<'m>) -> Res<()> {
        let function = frame.function;
        let mut written = self.scan.written(function, &function.body);
        written.retain(|v| !matches!(v, Variable::Local(_)));
        let mut scalars = self.scalars_of(frame, &written)?;
        scalars.extend(frame.result..frame.result + self.result_count(function)?);
        let kept = self.keep(scalars);
        let (label, body) = self.within(Purpose::Return, kept, frame, |this, frame, exit| {
            frame.returning = Returning::Early(exit);
            this.sequence(frame, &function.body, None)
        })?;
        self.b.push(Stmt::Scope { label, body });
        Ok(())
    }

    fn result_count(&self, function: &Function) -> Res<usize> {
        Ok(match &function.result {
            Some(result) => self.types().count(Shape::Type(result.ty))? as usize,
            None => 0,
        })
    }

    fn enter(&mut self, scope: Scope, arguments: Vec<Item>) -> Res<Frame<'m>> {
        let module = self.module.module();
        let (function, info) = match scope {
            Scope::Function(handle) => (&module.functions[handle], &self.module.info()[handle]),
            Scope::Entry(index) => {
                let entry = module.entry_points.get(index).ok_or(InterpError::NoEntryPoint(index))?;
                (&entry.function, self.module.info().get_entry_point(index))
            }
            Scope::Global => return Err(malformed("global expressions are no function")),
        };
        let scalars = match &function.result {
            Some(result) => self.types().kinds(Shape::Type(result.ty))?,
            None => Vec::new(),
        };
        let result = self.variables.len();
        let zeros = self.zeros(&scalars);
        self.variables.extend(zeros);
        let mut frame = Frame {
            scope,
            function,
            info,
            arguments,
            values: vec![None; function.expressions.len()],
            locals: Vec::new(),
            result,
            returning: Returning::Last,
            name: 0,
        };
        frame.name = self.name(frame.display_name());
        Ok(frame)
    }

    /// The index of a function's name.
    fn name(&mut self, name: String) -> u32 {
        let names = &mut self.b.program.functions;
        let at = names.iter().position(|n| *n == name).unwrap_or_else(|| {
            names.push(name);
            names.len() - 1
        });
        at as u32
    }

    /// Makes the local variables, with their first values.
    fn local_variables(&mut self, frame: &mut Frame<'m>) -> Res<()> {
        let facts = self.scan.facts(frame.function);
        for (handle, variable) in frame.function.local_variables.iter() {
            let values = self.first_values(frame, variable)?;
            let indexed = facts.indexed.contains(&Variable::Local(handle.index()));
            let pointer = self.variable(Shape::Type(variable.ty), values, indexed)?;
            frame.locals.push(pointer);
        }
        for (handle, expression) in frame.function.expressions.iter() {
            if let Expression::LocalVariable(local) = *expression {
                frame.values[handle.index()] = Some(Item::Pointer(frame.locals[local.index()]));
            }
        }
        Ok(())
    }

    fn first_values(&mut self, frame: &mut Frame<'m>, variable: &LocalVariable) -> Res<Vec<Value>> {
        match variable.init {
            Some(init) => {
                self.ensure(frame, init)?;
                Ok(frame.data(init)?.to_vec())
            }
            None => {
                let scalars = self.types().kinds(Shape::Type(variable.ty))?;
                Ok(self.unwritten(&scalars))
            }
        }
    }

    /// A variable of each lane.
    pub(crate) fn variable(&mut self, shape: Shape, values: Vec<Value>, indexed: bool) -> Res<Pointer> {
        let pointer = |root| Pointer { root, offset: 0, index: None, end: None, shape };
        if !indexed && values.len() <= MANY {
            let first = self.variables.len();
            self.variables.extend(values);
            return Ok(pointer(Root::Registers(first)));
        }
        let scalars: Vec<Scalar> = values.iter().map(|v| self.b.scalar(*v)).collect();
        let pointer = pointer(Root::Lane(self.b.array(&scalars)));
        self.store(pointer, &values)?;
        Ok(pointer)
    }
}
