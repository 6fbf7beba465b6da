//! A module in which something happens after each value.

use super::handles::{kind, operands_mut};
use super::pen::{self, Pen};
use super::{Origin, Site, TraceError};
use crate::ValidModule;
use crate::module::{Meta, Scope};
use naga::{Block, Expression, Function, Handle, Module, Range, Statement, TypeInner};
use std::collections::HashMap;

/// What happens after a value.
pub(super) trait Probe {
    /// Writes what happens once `value` is known, and returns what later expressions read in its place.
    fn after(&self, pen: &mut Pen<'_>, value: &Known<'_>) -> Handle<Expression>;
}

/// A value that was computed.
pub(super) struct Known<'t> {
    pub(super) value: Handle<Expression>,
    /// Its type, in the module that is made.
    pub(super) ty: Handle<naga::Type>,
    pub(super) inner: &'t TypeInner,
    /// The number of its first scalar's site.
    pub(super) first: u32,
    pub(super) origin: Origin,
}

/// A module rewritten.
pub(super) struct Rewritten {
    pub(super) module: Module,
    pub(super) meta: Meta,
    pub(super) sites: Vec<Site>,
    /// Where each function went.
    pub(super) functions: HashMap<Handle<Function>, Handle<Function>>,
}

/// The scalars of a value; `None` of one that is no scalar, vector or matrix of 32-bit numbers or booleans.
pub(super) fn scalars(inner: &TypeInner) -> Option<(u32, naga::ScalarKind)> {
    let (count, scalar) = match *inner {
        TypeInner::Scalar(scalar) => (1, scalar),
        TypeInner::Vector { size, scalar } => (size as u32, scalar),
        TypeInner::Matrix { columns, rows, scalar } => (columns as u32 * rows as u32, scalar),
        _ => return None,
    };
    (scalar.width == 4 || scalar.kind == naga::ScalarKind::Bool).then_some((count, scalar.kind))
}

/// Rewrites all functions of `from`, after those that `module` holds already (what probes call).
pub(super) fn rewrite(
    from: &ValidModule,
    module: Module,
    probe: &dyn Probe,
) -> Result<Rewritten, TraceError> {
    let mut out = Rewritten {
        module,
        meta: Meta { sources: from.meta().sources.clone(), ..Meta::default() },
        sites: Vec::new(),
        functions: HashMap::new(),
    };
    for (handle, function) in from.module().functions.iter() {
        let mut one =
            One { from, handle, function, out: &mut out, probe, map: HashMap::new(), after: HashMap::new() };
        let (made, exact) = one.function()?;
        let new = out.module.functions.append(made, from.module().functions.get_span(handle));
        out.functions.insert(handle, new);
        out.meta.exact.extend(exact.into_iter().map(|(e, x)| ((Scope::Function(new), e), x)));
        out.meta.truths.extend(from.meta().truths.get(&handle).map(|t| (new, *t)));
        out.meta.definitions.extend(from.meta().definitions.get(&handle).map(|d| (new, *d)));
    }
    let global = from.meta().exact.iter().filter(|((scope, _), _)| *scope == Scope::Global);
    out.meta.exact.extend(global.map(|(at, x)| (*at, *x)));
    Ok(out)
}

/// One function.
struct One<'a> {
    from: &'a ValidModule,
    handle: Handle<Function>,
    function: &'a Function,
    out: &'a mut Rewritten,
    probe: &'a dyn Probe,
    /// What stands in the place of each expression.
    map: HashMap<Handle<Expression>, Handle<Expression>>,
    /// The expression itself, and what happens after it.
    after: HashMap<Handle<Expression>, (Handle<Expression>, Block)>,
}

type Exact = Vec<(Handle<Expression>, f64)>;

impl One<'_> {
    fn function(&mut self) -> Result<(Function, Exact), TraceError> {
        let mut made = Function {
            name: self.function.name.clone(),
            arguments: self.function.arguments.clone(),
            result: self.function.result.clone(),
            diagnostic_filter_leaf: None,
            ..Function::default()
        };
        let mut exact = Exact::new();
        for (old, expression) in self.function.expressions.iter() {
            let (itself, value) = self.expression(&mut made, old, expression)?;
            let known = self.from.meta().exact.get(&(Scope::Function(self.handle), old));
            exact.extend(known.map(|x| (itself, *x)));
            self.map.insert(old, value);
        }
        for (handle, variable) in self.function.local_variables.iter() {
            let init = variable.init.map(|init| self.map[&init]);
            let span = self.function.local_variables.get_span(handle);
            made.local_variables.append(naga::LocalVariable { init, ..variable.clone() }, span);
        }
        let mut body = Block::new();
        for (old, expression) in self.function.expressions.iter() {
            if matches!(expression, Expression::FunctionArgument(_)) {
                body.append(&mut self.probes(old));
            }
        }
        body.append(&mut self.block(&self.function.body)?);
        made.body = body;
        Ok((made, exact))
    }

    /// The expression, and what stands in its place.
    fn expression(
        &mut self,
        made: &mut Function,
        old: Handle<Expression>,
        expression: &Expression,
    ) -> Result<(Handle<Expression>, Handle<Expression>), TraceError> {
        let mut copy = expression.clone();
        let operands = operands_mut(&mut copy).ok_or_else(|| self.unsupported(kind(expression)))?;
        operands.into_iter().for_each(|operand| *operand = self.map[operand]);
        if let Expression::CallResult(function) = &mut copy {
            *function = self.out.functions[function];
        }
        let itself = made.expressions.append(copy, self.function.expressions.get_span(old));
        let origin = match expression {
            Expression::FunctionArgument(_) => Origin::Argument,
            Expression::CallResult(_) => Origin::Call,
            other if other.needs_pre_emit() => return Ok((itself, itself)),
            _ => Origin::Value,
        };
        let resolution = &self.from.info()[self.handle][old].ty;
        let inner = resolution.inner_with(&self.from.module().types);
        let Some((width, kind)) = scalars(inner) else { return Ok((itself, itself)) };
        let first = self.out.sites.len() as u32;
        self.out.sites.extend((0..width).map(|component| Site {
            function: self.handle,
            expression: old,
            component,
            width,
            kind,
            origin,
        }));
        let mut pen = Pen::new(made);
        let ty = resolution.handle().unwrap_or_else(|| pen::type_of(&mut self.out.module, inner.clone()));
        let value = self.probe.after(&mut pen, &Known { value: itself, ty, inner, first, origin });
        self.after.insert(old, (itself, pen.block));
        Ok((itself, value))
    }

    fn probes(&mut self, old: Handle<Expression>) -> Block {
        self.after.get(&old).map(|(_, block)| block.clone()).unwrap_or_default()
    }

    fn block(&mut self, block: &Block) -> Result<Block, TraceError> {
        let mut made = Block::new();
        for (statement, span) in block.span_iter() {
            match statement {
                Statement::Emit(range) => {
                    for old in range.clone() {
                        let itself = self.after.get(&old).map_or(self.map[&old], |(itself, _)| *itself);
                        made.push(Statement::Emit(Range::new_from_bounds(itself, itself)), *span);
                        made.append(&mut self.probes(old));
                    }
                }
                Statement::Call { function, arguments, result } => {
                    let itself =
                        |old: &Handle<Expression>| self.after.get(old).map_or(self.map[old], |(e, _)| *e);
                    let call = Statement::Call {
                        function: self.out.functions[function],
                        arguments: arguments.iter().map(|a| self.map[a]).collect(),
                        result: result.as_ref().map(itself),
                    };
                    made.push(call, *span);
                    if let Some(old) = result {
                        made.append(&mut self.probes(*old));
                    }
                }
                other => made.push(self.statement(other)?, *span),
            }
        }
        Ok(made)
    }

    fn statement(&mut self, statement: &Statement) -> Result<Statement, TraceError> {
        Ok(match statement {
            Statement::Block(block) => Statement::Block(self.block(block)?),
            Statement::If { condition, accept, reject } => Statement::If {
                condition: self.map[condition],
                accept: self.block(accept)?,
                reject: self.block(reject)?,
            },
            Statement::Switch { selector, cases } => {
                let mut made = Vec::with_capacity(cases.len());
                for case in cases {
                    made.push(naga::SwitchCase { body: self.block(&case.body)?, ..case.clone() });
                }
                Statement::Switch { selector: self.map[selector], cases: made }
            }
            Statement::Loop { body, continuing, break_if } => Statement::Loop {
                body: self.block(body)?,
                continuing: self.block(continuing)?,
                break_if: break_if.map(|condition| self.map[&condition]),
            },
            Statement::Return { value } => Statement::Return { value: value.map(|value| self.map[&value]) },
            Statement::Store { pointer, value } => {
                Statement::Store { pointer: self.map[pointer], value: self.map[value] }
            }
            Statement::Break => Statement::Break,
            Statement::Continue => Statement::Continue,
            other => return Err(self.unsupported(format!("the statement {other:?}"))),
        })
    }

    fn unsupported(&self, what: String) -> TraceError {
        TraceError::Unsupported { function: self.function.name.clone().unwrap_or_default(), what }
    }
}
