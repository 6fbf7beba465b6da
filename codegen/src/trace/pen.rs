//! Writes expressions and statements of a function, and types of its module.

use naga::{
    AddressSpace, Block, Expression, Function, GlobalVariable, Handle, Literal, Module, Range, Scalar, Span,
    Statement, Type, TypeInner,
};

/// A function in the making, and the block that is being written.
pub(super) struct Pen<'f> {
    pub(super) function: &'f mut Function,
    pub(super) block: Block,
}

impl<'f> Pen<'f> {
    pub(super) fn new(function: &'f mut Function) -> Self {
        Self { function, block: Block::new() }
    }

    /// An expression that needs no evaluation.
    pub(super) fn declare(&mut self, expression: Expression) -> Handle<Expression> {
        self.function.expressions.append(expression, Span::UNDEFINED)
    }

    /// An expression that is evaluated here.
    pub(super) fn compute(&mut self, expression: Expression) -> Handle<Expression> {
        let handle = self.declare(expression);
        self.push(Statement::Emit(Range::new_from_bounds(handle, handle)));
        handle
    }

    pub(super) fn literal(&mut self, number: u32) -> Handle<Expression> {
        self.declare(Expression::Literal(Literal::U32(number)))
    }

    pub(super) fn load(&mut self, pointer: Handle<Expression>) -> Handle<Expression> {
        self.compute(Expression::Load { pointer })
    }

    pub(super) fn binary(
        &mut self,
        op: naga::BinaryOperator,
        left: Handle<Expression>,
        right: Handle<Expression>,
    ) -> Handle<Expression> {
        self.compute(Expression::Binary { op, left, right })
    }

    /// Part `index` of `base`.
    pub(super) fn part(&mut self, base: Handle<Expression>, index: u32) -> Handle<Expression> {
        self.compute(Expression::AccessIndex { base, index })
    }

    pub(super) fn store(&mut self, pointer: Handle<Expression>, value: Handle<Expression>) {
        self.push(Statement::Store { pointer, value });
    }

    pub(super) fn push(&mut self, statement: Statement) {
        self.block.push(statement, Span::UNDEFINED);
    }

    /// Writes `inside` as a branch on `condition`.
    pub(super) fn when(&mut self, condition: Handle<Expression>, inside: impl FnOnce(&mut Self)) {
        let outer = std::mem::take(&mut self.block);
        inside(self);
        let accept = std::mem::replace(&mut self.block, outer);
        self.push(Statement::If { condition, accept, reject: Block::new() });
    }

    /// Gives the function its body.
    pub(super) fn finish(self) {
        self.function.body = self.block;
    }
}

pub(super) fn scalar_type(module: &mut Module, scalar: Scalar) -> Handle<Type> {
    type_of(module, TypeInner::Scalar(scalar))
}

pub(super) fn type_of(module: &mut Module, inner: TypeInner) -> Handle<Type> {
    module.types.insert(Type { name: None, inner }, Span::UNDEFINED)
}

/// A variable of the module, without a value to begin with.
pub(super) fn variable(
    module: &mut Module,
    name: &str,
    space: AddressSpace,
    binding: Option<naga::ResourceBinding>,
    ty: Handle<Type>,
) -> Handle<GlobalVariable> {
    let global = GlobalVariable {
        name: Some(name.to_owned()),
        space,
        binding,
        ty,
        init: None,
        memory_decorations: Default::default(),
    };
    module.global_variables.append(global, Span::UNDEFINED)
}

/// A parameter.
pub(super) fn parameter(name: &str, ty: Handle<Type>) -> naga::FunctionArgument {
    naga::FunctionArgument { name: Some(name.to_owned()), ty, binding: None }
}
