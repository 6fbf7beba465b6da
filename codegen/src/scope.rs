//! Two rules that naga states and does not check.
//!
//! An expression may be used where its value has been computed on every way there: an operand that
//! is emitted in one branch and used after it passes naga's validator, and comes out as WGSL with an
//! undefined name and as SPIR-V in which a use is not dominated.
//! And a function with a result must return one on each path.

use naga::{Block, Expression, Function, Handle, Module, Span, Statement};

/// Why a module that naga accepts has no meaning.
#[derive(Debug, thiserror::Error)]
pub enum ScopeError {
    /// An operand is computed in a block that does not enclose its use.
    #[error(
        "in `{function}`, expression {user:?} uses {operand:?}, which is computed in a block that may not run before"
    )]
    Undominated {
        /// Name of the function.
        function: String,
        /// The expression that uses it.
        user: Handle<Expression>,
        /// The expression that may not have been computed.
        operand: Handle<Expression>,
        /// Where the user stands.
        at: Span,
    },
    /// Control may reach the end of a function that has a result.
    #[error("a path through `{function}` returns no value")]
    MissingReturn {
        /// Name of the function.
        function: String,
    },
}

impl ScopeError {
    /// Name of the function that breaks the rule.
    pub fn function(&self) -> &str {
        match self {
            Self::Undominated { function, .. } | Self::MissingReturn { function } => function,
        }
    }

    /// Where the fault lies.
    pub fn span(&self) -> Span {
        match self {
            Self::Undominated { at, .. } => *at,
            Self::MissingReturn { .. } => Span::UNDEFINED,
        }
    }
}

/// Checks all functions and entry points.
///
/// # Errors
/// At the first function that breaks a rule.
pub fn check(module: &Module) -> Result<(), ScopeError> {
    module.functions.iter().try_for_each(|(_, f)| check_function(f))?;
    module.entry_points.iter().try_for_each(|e| check_function(&e.function))
}

fn check_function(function: &Function) -> Result<(), ScopeError> {
    let mut scope = Scope { function, visible: vec![false; function.expressions.len()], undo: Vec::new() };
    scope.block(&function.body)?;
    if function.result.is_some() && !ends(&function.body) {
        return Err(ScopeError::MissingReturn { function: name(function) });
    }
    Ok(())
}

fn name(function: &Function) -> String {
    function.name.clone().unwrap_or_else(|| "an entry point".to_owned())
}

struct Scope<'f> {
    function: &'f Function,
    visible: Vec<bool>,
    /// What became visible, in order.
    undo: Vec<Handle<Expression>>,
}

impl Scope<'_> {
    /// Checks a block; what it computes is visible to it alone.
    fn nested(&mut self, block: &Block) -> Result<(), ScopeError> {
        let mark = self.undo.len();
        self.block(block)?;
        self.forget(mark);
        Ok(())
    }

    fn forget(&mut self, mark: usize) {
        for handle in self.undo.drain(mark..) {
            self.visible[handle.index()] = false;
        }
    }

    fn show(&mut self, handle: Handle<Expression>) {
        self.visible[handle.index()] = true;
        self.undo.push(handle);
    }

    fn block(&mut self, block: &Block) -> Result<(), ScopeError> {
        block.iter().try_for_each(|statement| self.statement(statement))
    }

    fn statement(&mut self, statement: &Statement) -> Result<(), ScopeError> {
        match statement {
            Statement::Emit(range) => range.clone().try_for_each(|handle| self.emit(handle))?,
            Statement::Block(block) => self.nested(block)?,
            Statement::If { accept, reject, .. } => {
                self.nested(accept)?;
                self.nested(reject)?;
            }
            Statement::Switch { cases, .. } => cases.iter().try_for_each(|case| self.nested(&case.body))?,
            Statement::Loop { body, continuing, .. } => self.repeat(body, continuing)?,
            Statement::Call { result: Some(result), .. }
            | Statement::Atomic { result: Some(result), .. }
            | Statement::WorkGroupUniformLoad { result, .. }
            | Statement::SubgroupBallot { result, .. }
            | Statement::SubgroupGather { result, .. }
            | Statement::SubgroupCollectiveOperation { result, .. } => self.show(*result),
            Statement::RayQuery { fun: naga::RayQueryFunction::Proceed { result }, .. } => self.show(*result),
            Statement::Call { result: None, .. }
            | Statement::Atomic { result: None, .. }
            | Statement::RayQuery { .. }
            | Statement::RayPipelineFunction(_)
            | Statement::Break
            | Statement::Continue
            | Statement::Return { .. }
            | Statement::Kill
            | Statement::ControlBarrier(_)
            | Statement::MemoryBarrier(_)
            | Statement::Store { .. }
            | Statement::ImageStore { .. }
            | Statement::ImageAtomic { .. }
            | Statement::CooperativeStore { .. } => {}
        }
        Ok(())
    }

    /// `continuing` sees what the body computes, up to the first `continue`.
    fn repeat(&mut self, body: &Block, continuing: &Block) -> Result<(), ScopeError> {
        let mark = self.undo.len();
        let mut reached = None;
        for statement in body {
            if reached.is_none() && continues(statement) {
                reached = Some(self.undo.len());
            }
            self.statement(statement)?;
        }
        if let Some(mark) = reached {
            self.forget(mark);
        }
        self.block(continuing)?;
        self.forget(mark);
        Ok(())
    }

    fn emit(&mut self, handle: Handle<Expression>) -> Result<(), ScopeError> {
        let mut missing = None;
        operands(&self.function.expressions[handle], |operand| {
            let always = self.function.expressions[operand].needs_pre_emit();
            if !always && !self.visible[operand.index()] {
                missing = Some(operand);
            }
        });
        match missing {
            Some(operand) => Err(ScopeError::Undominated {
                function: name(self.function),
                user: handle,
                operand,
                at: self.function.expressions.get_span(handle),
            }),
            None => {
                self.show(handle);
                Ok(())
            }
        }
    }
}

/// Calls `visit` with each operand of an expression.
fn operands(expression: &Expression, mut visit: impl FnMut(Handle<Expression>)) {
    match *expression {
        Expression::Compose { ref components, .. } => components.iter().copied().for_each(visit),
        Expression::Access { base, index } => [base, index].into_iter().for_each(visit),
        Expression::AccessIndex { base: operand, .. }
        | Expression::Splat { value: operand, .. }
        | Expression::Swizzle { vector: operand, .. }
        | Expression::Load { pointer: operand }
        | Expression::Unary { expr: operand, .. }
        | Expression::Derivative { expr: operand, .. }
        | Expression::Relational { argument: operand, .. }
        | Expression::As { expr: operand, .. }
        | Expression::ArrayLength(operand)
        | Expression::RayQueryVertexPositions { query: operand, .. }
        | Expression::RayQueryGetIntersection { query: operand, .. } => visit(operand),
        Expression::Binary { left, right, .. } => [left, right].into_iter().for_each(visit),
        Expression::Select { condition, accept, reject } => {
            [condition, accept, reject].into_iter().for_each(visit);
        }
        Expression::Math { arg, arg1, arg2, arg3, .. } => {
            [Some(arg), arg1, arg2, arg3].into_iter().flatten().for_each(visit);
        }
        Expression::ImageSample { image, sampler, coordinate, array_index, offset, depth_ref, .. } => {
            [Some(image), Some(sampler), Some(coordinate), array_index, offset, depth_ref]
                .into_iter()
                .flatten()
                .for_each(visit);
        }
        Expression::ImageLoad { image, coordinate, array_index, sample, level } => {
            [Some(image), Some(coordinate), array_index, sample, level].into_iter().flatten().for_each(visit);
        }
        Expression::ImageQuery { image, query } => {
            visit(image);
            if let naga::ImageQuery::Size { level: Some(level) } = query {
                visit(level);
            }
        }
        Expression::CooperativeLoad { ref data, .. } => {
            [data.pointer, data.stride].into_iter().for_each(visit)
        }
        Expression::CooperativeMultiplyAdd { a, b, c } => [a, b, c].into_iter().for_each(visit),
        Expression::Literal(_)
        | Expression::Constant(_)
        | Expression::Override(_)
        | Expression::ZeroValue(_)
        | Expression::FunctionArgument(_)
        | Expression::GlobalVariable(_)
        | Expression::LocalVariable(_)
        | Expression::CallResult(_)
        | Expression::AtomicResult { .. }
        | Expression::WorkGroupUniformLoadResult { .. }
        | Expression::RayQueryProceedResult
        | Expression::SubgroupBallotResult
        | Expression::SubgroupOperationResult { .. } => {}
    }
}

/// Whether control never reaches the end of the block.
fn ends(block: &Block) -> bool {
    block.iter().any(|statement| match statement {
        Statement::Return { .. } | Statement::Kill | Statement::Break | Statement::Continue => true,
        Statement::Block(block) => ends(block),
        Statement::If { accept, reject, .. } => ends(accept) && ends(reject),
        Statement::Switch { cases, .. } => {
            cases.iter().all(|case| (case.fall_through || ends(&case.body)) && !breaks(&case.body))
        }
        Statement::Loop { body, break_if, .. } => break_if.is_none() && !breaks(body),
        Statement::Emit(_)
        | Statement::ControlBarrier(_)
        | Statement::MemoryBarrier(_)
        | Statement::Store { .. }
        | Statement::ImageStore { .. }
        | Statement::Atomic { .. }
        | Statement::ImageAtomic { .. }
        | Statement::WorkGroupUniformLoad { .. }
        | Statement::Call { .. }
        | Statement::RayQuery { .. }
        | Statement::RayPipelineFunction(_)
        | Statement::SubgroupBallot { .. }
        | Statement::SubgroupGather { .. }
        | Statement::SubgroupCollectiveOperation { .. }
        | Statement::CooperativeStore { .. } => false,
    })
}

/// Whether a `continue` inside goes on with the loop around this statement.
fn continues(statement: &Statement) -> bool {
    let any = |block: &Block| block.iter().any(continues);
    match statement {
        Statement::Continue => true,
        Statement::Block(block) => any(block),
        Statement::If { accept, reject, .. } => any(accept) || any(reject),
        Statement::Switch { cases, .. } => cases.iter().any(|case| any(&case.body)),
        // A `continue` in there goes on with that one.
        Statement::Loop { .. } => false,
        Statement::Emit(_)
        | Statement::Break
        | Statement::Return { .. }
        | Statement::Kill
        | Statement::ControlBarrier(_)
        | Statement::MemoryBarrier(_)
        | Statement::Store { .. }
        | Statement::ImageStore { .. }
        | Statement::Atomic { .. }
        | Statement::ImageAtomic { .. }
        | Statement::WorkGroupUniformLoad { .. }
        | Statement::Call { .. }
        | Statement::RayQuery { .. }
        | Statement::RayPipelineFunction(_)
        | Statement::SubgroupBallot { .. }
        | Statement::SubgroupGather { .. }
        | Statement::SubgroupCollectiveOperation { .. }
        | Statement::CooperativeStore { .. } => false,
    }
}

/// Whether a `break` inside leaves the statement around this block.
fn breaks(block: &Block) -> bool {
    block.iter().any(|statement| match statement {
        Statement::Break => true,
        Statement::Block(block) => breaks(block),
        Statement::If { accept, reject, .. } => breaks(accept) || breaks(reject),
        // A `break` in there leaves that one.
        Statement::Switch { .. } | Statement::Loop { .. } => false,
        Statement::Emit(_)
        | Statement::Continue
        | Statement::Return { .. }
        | Statement::Kill
        | Statement::ControlBarrier(_)
        | Statement::MemoryBarrier(_)
        | Statement::Store { .. }
        | Statement::ImageStore { .. }
        | Statement::Atomic { .. }
        | Statement::ImageAtomic { .. }
        | Statement::WorkGroupUniformLoad { .. }
        | Statement::Call { .. }
        | Statement::RayQuery { .. }
        | Statement::RayPipelineFunction(_)
        | Statement::SubgroupBallot { .. }
        | Statement::SubgroupGather { .. }
        | Statement::SubgroupCollectiveOperation { .. }
        | Statement::CooperativeStore { .. } => false,
    })
}
