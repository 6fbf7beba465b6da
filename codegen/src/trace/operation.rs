//! One operation of a kernel, alone.

use super::TraceError;
use super::handles::operands_mut;
use super::pen;
use super::rewrite::scalars;
use crate::ValidModule;
use crate::module::{Meta, Scope};
use crate::validate::validate;
use naga::{Block, Expression, Function, FunctionResult, Handle, Module, Range, Statement};
use std::collections::HashMap;

/// What an operation reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Operand {
    /// The expression, in the kernel's function.
    pub expression: Handle<Expression>,
    /// Its scalars.
    pub width: u32,
}

/// An operation as a function of its operands.
#[derive(Debug, Clone)]
pub struct Operation {
    /// A module that holds nothing else.
    pub module: ValidModule,
    /// The function: a parameter for each operand, in their order, and the operation's value for its result.
    pub function: Handle<Function>,
    /// What the parameters stand for.
    pub operands: Vec<Operand>,
}

/// The operation `expression` of `function`.
///
/// `None` of what reads memory, or an operand that is no scalar, vector or matrix, and of what is no such value.
///
/// # Errors
/// When the function does not stand alone, which is a defect.
pub fn operation(
    module: &ValidModule,
    function: Handle<Function>,
    expression: Handle<Expression>,
) -> Result<Option<Operation>, TraceError> {
    let mut built = Module { functions: Default::default(), doc_comments: None, ..module.module().clone() };
    let mut one = Alone {
        from: module,
        function,
        made: Function { name: Some("operation".to_owned()), ..Function::default() },
        types: &mut built,
        map: HashMap::new(),
        operands: Vec::new(),
        exact: Vec::new(),
    };
    let Some(value) = one.copy(expression) else { return Ok(None) };
    let Some(ty) = one.ty(expression) else { return Ok(None) };
    let Alone { mut made, operands, exact, .. } = one;
    made.result = Some(FunctionResult { ty, binding: None });
    made.body.push(Statement::Return { value: Some(value) }, naga::Span::UNDEFINED);
    let function = built.functions.append(made, naga::Span::UNDEFINED);
    let global = module.meta().exact.iter().filter(|((scope, _), _)| *scope == Scope::Global);
    let mut meta = Meta { exact: global.map(|(at, x)| (*at, *x)).collect(), ..Meta::default() };
    meta.exact.extend(exact.into_iter().map(|(at, x)| ((Scope::Function(function), at), x)));
    Ok(Some(Operation { module: validate(built, meta)?, function, operands }))
}

/// A function of one operation in the making.
struct Alone<'a> {
    from: &'a ValidModule,
    function: Handle<Function>,
    made: Function,
    types: &'a mut Module,
    map: HashMap<Handle<Expression>, Handle<Expression>>,
    operands: Vec<Operand>,
    exact: Vec<(Handle<Expression>, f64)>,
}

impl Alone<'_> {
    /// The expression itself, on its operands.
    fn copy(&mut self, old: Handle<Expression>) -> Option<Handle<Expression>> {
        let function = &self.from.module().functions[self.function];
        let expression = &function.expressions[old];
        let reads_memory = matches!(expression, Expression::Load { .. } | Expression::ArrayLength(_));
        if expression.needs_pre_emit() || reads_memory {
            return None;
        }
        let mut copy = expression.clone();
        for operand in operands_mut(&mut copy)? {
            *operand = self.operand(*operand)?;
        }
        let new = self.made.expressions.append(copy, naga::Span::UNDEFINED);
        self.made.body.append(&mut Block::from_vec(vec![Statement::Emit(Range::new_from_bounds(new, new))]));
        Some(new)
    }

    /// A constant, or a parameter.
    fn operand(&mut self, old: Handle<Expression>) -> Option<Handle<Expression>> {
        if let Some(known) = self.map.get(&old) {
            return Some(*known);
        }
        let expression = &self.from.module().functions[self.function].expressions[old];
        let is_constant =
            matches!(expression, Expression::Literal(_) | Expression::Constant(_) | Expression::ZeroValue(_));
        let new = if is_constant {
            expression.clone()
        } else {
            let (width, _) = scalars(self.inner(old))?;
            let ty = self.ty(old)?;
            self.made.arguments.push(pen::parameter(&format!("x{}", self.operands.len()), ty));
            self.operands.push(Operand { expression: old, width });
            Expression::FunctionArgument(self.operands.len() as u32 - 1)
        };
        let new = self.made.expressions.append(new, naga::Span::UNDEFINED);
        let exact = self.from.meta().exact.get(&(Scope::Function(self.function), old));
        self.exact.extend(exact.map(|x| (new, *x)));
        self.map.insert(old, new);
        Some(new)
    }

    fn inner(&self, old: Handle<Expression>) -> &naga::TypeInner {
        self.from.info()[self.function][old].ty.inner_with(&self.from.module().types)
    }

    /// The type of a scalar, vector or matrix.
    fn ty(&mut self, old: Handle<Expression>) -> Option<Handle<naga::Type>> {
        let inner = self.inner(old).clone();
        scalars(&inner)?;
        let known = self.from.info()[self.function][old].ty.handle();
        Some(known.unwrap_or_else(|| pen::type_of(self.types, inner)))
    }
}
