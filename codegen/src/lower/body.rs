//! One function under construction: the arena, emission, blocks, locals.

use super::contract;
use super::error::{Fail, LowerError, Lowered};
use super::module::{ExactLiteral, ModuleBuilder, builtin};
use super::source::Spans;
use super::value::{Lit, Place, Repr, Sink, U32, Value};
use crate::def::{Binding, Builtin, FunctionDef, Param, Scalar, Span, TypeDef};
use naga::{Expression, Handle, Statement};

/// What a local stands for.
#[derive(Debug, Clone, Copy)]
pub(super) enum Local {
    /// Declared without a value, or not yet declared.
    Unset,
    /// A value that never changes.
    Value(Value),
    /// A variable or a binding.
    Memory(Place),
}

/// Builds the body of one function.
pub(super) struct BodyBuilder<'m> {
    pub(super) modules: &'m mut ModuleBuilder,
    pub(super) def: &'static FunctionDef,
    pub(super) function: naga::Function,
    pub(super) locals: Vec<Local>,
    /// Enclosing loops and switches, innermost last.
    pub(super) nesting: Vec<Nesting>,
    /// Flags of the innermost loop, to be cleared before it starts.
    pub(super) resets: Vec<Place>,
    /// The statement being lowered.
    pub(super) at: Span,
    spans: Spans,
    blocks: Vec<Open>,
    /// Expressions appended and not yet in an `Emit` statement: first and last.
    pending: Option<(Handle<Expression>, Handle<Expression>)>,
    exact: Vec<ExactLiteral>,
    /// Variables whose type is the default of an integer without suffix.
    pub(super) assumed: Vec<&'static str>,
    /// An error of a callee, which has its own source.
    foreign: Option<LowerError>,
}

/// A block under construction.
#[derive(Default)]
struct Open {
    block: naga::Block,
    /// Whether control never reaches its end.
    ended: bool,
}

/// What `break` would leave.
#[derive(Debug, Clone, Copy)]
pub(super) enum Nesting {
    Loop {
        /// Whether a `break` leaves it.
        left: bool,
    },
    /// naga's `Break` leaves the switch only; `leave` is the variable that passes it on to the loop.
    Switch { leave: Option<Handle<Expression>> },
}

impl<'m> BodyBuilder<'m> {
    pub(super) fn lower(
        modules: &'m mut ModuleBuilder,
        def: &'static FunctionDef,
        spans: Spans,
    ) -> Result<(naga::Function, Vec<ExactLiteral>), LowerError> {
        let mut builder = Self {
            modules,
            def,
            function: naga::Function { name: Some(def.name.to_owned()), ..naga::Function::default() },
            locals: vec![Local::Unset; def.locals.len()],
            nesting: Vec::new(),
            resets: Vec::new(),
            at: def.span,
            spans,
            blocks: vec![Open::default()],
            pending: None,
            exact: Vec::new(),
            assumed: Vec::new(),
            foreign: None,
        };
        match builder.whole() {
            Ok(()) => Ok(builder.finish()),
            Err(fail) => Err(builder.foreign.take().unwrap_or_else(|| fail.in_function(def))),
        }
    }

    fn whole(&mut self) -> Lowered<()> {
        self.def.params.iter().try_for_each(check_builtin)?;
        contract::check(self.def)?;
        self.parameters();
        if let Some(ret) = &self.def.ret {
            let ty = self.modules.ty(ret);
            self.function.result = Some(naga::FunctionResult { ty, binding: None });
        }
        let mut sink = if self.def.ret.is_some() { Sink::Return } else { Sink::Discard };
        self.block_into(&self.def.body, &mut sink)?;
        if self.def.ret.is_some() && !self.ended() {
            return Err(Fail::new(self.def.span, "a path through this function returns no value"));
        }
        if let Some(ret) = &self.def.ret {
            self.return_after_loops(ret);
        }
        Ok(())
    }

    /// A loop that only `return` leaves ends the function for Rust; naga's WGSL front end, and HLSL
    /// compilers, want a `return` below it that is never reached.
    fn return_after_loops(&mut self, ret: &TypeDef) {
        self.flush();
        let Some(mut open) = self.blocks.pop() else { return };
        if ends_in_loop(&open.block) {
            let zero = Expression::ZeroValue(self.modules.ty(ret));
            let zero = self.append(zero, self.def.span);
            let span = self.spans.naga(self.def.span);
            append_return(&mut open.block, zero, span);
        }
        self.blocks.push(open);
    }

    fn parameters(&mut self) {
        for (i, param) in self.def.params.iter().enumerate() {
            let local = match self.modules.global(self.def, param) {
                Some(global) => {
                    let pointer = self.append(Expression::GlobalVariable(global), param.span);
                    Local::Memory(Place { pointer, ty: param.ty })
                }
                None => Local::Value(self.argument(i)),
            };
            self.locals[i] = local;
        }
        // Parameters that change, or are indexed by values not known now, are copied to variables.
        for (i, param) in self.def.params.iter().enumerate() {
            let is_array = matches!(param.ty, TypeDef::Array(..));
            if let Local::Value(value) = self.locals[i]
                && (self.def.locals[i].mutable || is_array)
            {
                let place = self.variable(Some(param.name), &param.ty);
                self.store(place, value, param.span);
                self.locals[i] = Local::Memory(place);
            }
        }
    }

    fn argument(&mut self, i: usize) -> Value {
        let param = &self.def.params[i];
        let ty = self.modules.ty(&param.ty);
        let binding = match param.binding {
            Binding::Builtin(b) => Some(builtin(b)),
            Binding::Value | Binding::Storage { .. } | Binding::Uniform { .. } | Binding::Workgroup => None,
        };
        let index = self.function.arguments.len() as u32;
        self.function.arguments.push(naga::FunctionArgument {
            name: Some(param.name.to_owned()),
            ty,
            binding,
        });
        Value::expr(param.ty, self.append(Expression::FunctionArgument(index), param.span))
    }

    fn finish(mut self) -> (naga::Function, Vec<ExactLiteral>) {
        self.flush();
        if let Some(open) = self.blocks.pop() {
            self.function.body = open.block;
        }
        (self.function, self.exact)
    }

    /// Reports a callee's error as it is; the returned value stops this function.
    pub(super) fn stop(&mut self, error: LowerError) -> Fail {
        self.foreign = Some(error);
        Fail::new(self.def.span, "")
    }

    // ---- expressions

    /// Appends an expression; it is evaluated here.
    pub(super) fn append(&mut self, expression: Expression, span: Span) -> Handle<Expression> {
        let at_once = expression.needs_pre_emit();
        if at_once || matches!(expression, Expression::CallResult(_) | Expression::AtomicResult { .. }) {
            self.flush();
            return self.function.expressions.append(expression, self.spans.naga(span));
        }
        let handle = self.function.expressions.append(expression, self.spans.naga(span));
        self.pending = Some((self.pending.map_or(handle, |(first, _)| first), handle));
        handle
    }

    /// The expression of a value; a literal gets one now.
    pub(super) fn handle(&mut self, value: Value, span: Span) -> Handle<Expression> {
        match value.repr {
            Repr::Expr(handle) => handle,
            Repr::Literal(lit) => {
                let handle = self.append(Expression::Literal(lit.naga()), span);
                if let Lit::F32(value, exact) = lit
                    && f64::from(value) != exact
                {
                    self.exact.push((handle, exact));
                }
                handle
            }
        }
    }

    /// An expression of type `ty`, as a value.
    pub(super) fn value(&mut self, ty: TypeDef, expression: Expression, span: Span) -> Value {
        Value::expr(ty, self.append(expression, span))
    }

    /// Reads a place.
    pub(super) fn load(&mut self, place: Place, span: Span) -> Value {
        self.value(place.ty, Expression::Load { pointer: place.pointer }, span)
    }

    /// Ends the range of expressions evaluated so far.
    pub(super) fn flush(&mut self) {
        if let Some((first, last)) = self.pending.take() {
            let span = self.function.expressions.get_span(last);
            let emit = Statement::Emit(naga::Range::new_from_bounds(first, last));
            if let Some(open) = self.blocks.last_mut() {
                open.block.push(emit, span);
            }
        }
    }

    // ---- statements

    /// Adds a statement.
    pub(super) fn push(&mut self, statement: Statement, span: Span) {
        self.flush();
        let span = self.spans.naga(span);
        if let Some(open) = self.blocks.last_mut() {
            open.ended |=
                matches!(statement, Statement::Return { .. } | Statement::Break | Statement::Continue);
            open.block.push(statement, span);
        }
    }

    /// Writes a place.
    pub(super) fn store(&mut self, place: Place, value: Value, span: Span) {
        let value = self.handle(value.decide(&place.ty), span);
        self.push(Statement::Store { pointer: place.pointer, value }, span);
    }

    /// Whether control never gets here.
    pub(super) fn ended(&self) -> bool {
        self.blocks.last().is_some_and(|open| open.ended)
    }

    /// Notes that control never gets past the statement just added.
    pub(super) fn end(&mut self) {
        if let Some(open) = self.blocks.last_mut() {
            open.ended = true;
        }
    }

    /// Builds a block of its own; says whether control never reaches its end.
    pub(super) fn nested(
        &mut self,
        build: impl FnOnce(&mut Self) -> Lowered<()>,
    ) -> Lowered<(naga::Block, bool)> {
        self.flush();
        self.blocks.push(Open::default());
        let built = build(self);
        self.flush();
        let open = self.blocks.pop().unwrap_or_default();
        built.map(|()| (open.block, open.ended))
    }

    // ---- variables

    /// A new variable of the function.
    pub(super) fn variable(&mut self, name: Option<&str>, ty: &TypeDef) -> Place {
        let naga_ty = self.modules.ty(ty);
        let variable = naga::LocalVariable { name: name.map(str::to_owned), ty: naga_ty, init: None };
        let span = self.spans.naga(self.at);
        let handle = self.function.local_variables.append(variable, span);
        let pointer = self.append(Expression::LocalVariable(handle), self.at);
        Place { pointer, ty: *ty }
    }

    /// Declares the `let` or parameter `local` as `value`, in a variable if it may change.
    pub(super) fn bind(&mut self, local: u32, value: Value, span: Span) {
        let declared = &self.def.locals[local as usize];
        let bound = if declared.mutable || matches!(value.ty, TypeDef::Array(..)) {
            if value.is_undecided() {
                self.assumed.push(declared.name);
            }
            let place = self.variable(Some(declared.name), &value.ty);
            self.store(place, value, span);
            Local::Memory(place)
        } else {
            self.name(value, declared.name);
            Local::Value(value)
        };
        self.locals[local as usize] = bound;
    }

    /// Gives the value of a `let` its name in the output.
    fn name(&mut self, value: Value, name: &str) {
        let Repr::Expr(handle) = value.repr else { return };
        let is_item = self.function.expressions[handle].needs_pre_emit();
        if !is_item && !self.function.named_expressions.contains_key(&handle) {
            self.function.named_expressions.insert(handle, name.to_owned());
        }
    }
}

/// Whether a built-in input has the type that it is declared with.
fn check_builtin(param: &Param) -> Lowered<()> {
    let Binding::Builtin(b) = param.binding else { return Ok(()) };
    let (name, ty) = match b {
        Builtin::GlobalInvocationId => ("global_invocation_id", UVEC3),
        Builtin::LocalInvocationId => ("local_invocation_id", UVEC3),
        Builtin::LocalInvocationIndex => ("local_invocation_index", U32),
        Builtin::WorkgroupId => ("workgroup_id", UVEC3),
        Builtin::NumWorkgroups => ("num_workgroups", UVEC3),
    };
    if param.ty == ty {
        return Ok(());
    }
    Err(Fail::new(param.span, format!("`{name}` is a {ty}, this parameter a {}", param.ty)))
}

const UVEC3: TypeDef = TypeDef::Vector(3, Scalar::U32);

/// Whether control comes to the end of `block` inside a loop, on some path.
fn ends_in_loop(block: &naga::Block) -> bool {
    match block.last() {
        Some(Statement::Loop { .. }) => true,
        Some(Statement::If { accept, reject, .. }) => ends_in_loop(accept) || ends_in_loop(reject),
        Some(Statement::Switch { cases, .. }) => cases.iter().any(|c| ends_in_loop(&c.body)),
        Some(Statement::Block(block)) => ends_in_loop(block),
        _ => false,
    }
}

/// Puts `return value` below each loop that [`ends_in_loop`] finds.
fn append_return(block: &mut naga::Block, value: Handle<Expression>, span: naga::Span) {
    match block.last_mut() {
        Some(Statement::Loop { .. }) => block.push(Statement::Return { value: Some(value) }, span),
        Some(Statement::If { accept, reject, .. }) => {
            append_return(accept, value, span);
            append_return(reject, value, span);
        }
        Some(Statement::Switch { cases, .. }) => {
            cases.iter_mut().for_each(|c| append_return(&mut c.body, value, span));
        }
        Some(Statement::Block(block)) => append_return(block, value, span),
        _ => {}
    }
}
