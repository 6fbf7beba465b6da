//! What functions do to variables, found before they are lowered.
//!
//! A variable that is indexed dynamically lies in memory; all others are registers.
//! A loop keeps the variables that it writes; see `control`.

use naga::{Block, Expression, Function, Handle, Statement};
use std::collections::BTreeSet;

/// The variable that a pointer leads into.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Variable {
    Local(usize),
    /// Behind a pointer parameter.
    Parameter(u32),
    Global(usize),
}

/// Facts about one function.
#[derive(Debug, Clone, Default)]
pub(crate) struct Facts {
    /// Variables that are indexed dynamically, here or in a callee.
    pub(crate) indexed: BTreeSet<Variable>,
    /// Variables that are written, here or in a callee.
    pub(crate) written: BTreeSet<Variable>,
}

/// Facts about all functions of a module.
#[derive(Debug, Default)]
pub(crate) struct Scan {
    functions: Vec<Facts>,
    /// Globals that some function indexes dynamically.
    pub(crate) indexed_globals: BTreeSet<usize>,
}

/// The variable behind a pointer expression.
pub(crate) fn variable(function: &Function, pointer: Handle<Expression>) -> Option<Variable> {
    let mut at = pointer;
    loop {
        if let Expression::Access { base, .. } | Expression::AccessIndex { base, .. } =
            function.expressions[at]
        {
            at = base;
        } else if let Expression::LocalVariable(local) = function.expressions[at] {
            return Some(Variable::Local(local.index()));
        } else if let Expression::GlobalVariable(global) = function.expressions[at] {
            return Some(Variable::Global(global.index()));
        } else if let Expression::FunctionArgument(index) = function.expressions[at] {
            return Some(Variable::Parameter(index));
        } else {
            return None;
        }
    }
}

/// Whether an index is known before the program runs.
pub(crate) fn is_static(function: &Function, index: Handle<Expression>) -> bool {
    matches!(function.expressions[index], Expression::Literal(_) | Expression::Constant(_))
}

impl Scan {
    pub(crate) fn of(module: &naga::Module) -> Self {
        let mut scan = Self::default();
        // Callees come first.
        for (_, function) in module.functions.iter() {
            let facts = scan.facts(function);
            scan.functions.push(facts);
        }
        for entry in &module.entry_points {
            scan.facts(&entry.function);
        }
        scan
    }

    /// Facts about a function whose callees are known.
    pub(crate) fn facts(&mut self, function: &Function) -> Facts {
        let mut facts = Facts { written: self.written(function, &function.body), ..Facts::default() };
        for (_, expression) in function.expressions.iter() {
            if let Expression::Access { base, index } = *expression
                && !is_static(function, index)
            {
                facts.indexed.extend(variable(function, base));
            }
        }
        self.each_call(&function.body, &mut |scan, callee, arguments| {
            facts.indexed.extend(scan.behind(function, callee, arguments, |f| &f.indexed));
        });
        self.indexed_globals.extend(facts.indexed.iter().filter_map(|v| match v {
            Variable::Global(index) => Some(*index),
            Variable::Local(_) | Variable::Parameter(_) => None,
        }));
        facts
    }

    fn each_call(&self, block: &Block, f: &mut impl FnMut(&Self, Handle<Function>, &[Handle<Expression>])) {
        for statement in block {
            if let Statement::Call { function, arguments, .. } = statement {
                f(self, *function, arguments);
            }
            for inner in inner_blocks(statement) {
                self.each_call(inner, f);
            }
        }
    }

    /// The caller's variables among those of a callee.
    fn behind(
        &self,
        caller: &Function,
        callee: Handle<Function>,
        arguments: &[Handle<Expression>],
        set: impl Fn(&Facts) -> &BTreeSet<Variable>,
    ) -> Vec<Variable> {
        let facts = &self.functions[callee.index()];
        let outer = |v: &Variable| match *v {
            Variable::Parameter(index) => arguments.get(index as usize).and_then(|a| variable(caller, *a)),
            Variable::Global(index) => Some(Variable::Global(index)),
            Variable::Local(_) => None,
        };
        set(facts).iter().filter_map(outer).collect()
    }

    /// The variables that `block` writes.
    pub(crate) fn written(&self, function: &Function, block: &Block) -> BTreeSet<Variable> {
        let mut out = BTreeSet::new();
        self.add_written(function, block, &mut out);
        out
    }

    fn add_written(&self, function: &Function, block: &Block, out: &mut BTreeSet<Variable>) {
        for statement in block {
            if let Statement::Store { pointer, .. } = statement {
                out.extend(variable(function, *pointer));
            } else if let Statement::Call { function: callee, arguments, .. } = statement {
                out.extend(self.behind(function, *callee, arguments, |f| &f.written));
            }
            for inner in inner_blocks(statement) {
                self.add_written(function, inner, out);
            }
        }
    }
}

/// The blocks within a statement.
pub(crate) fn inner_blocks(statement: &Statement) -> Vec<&Block> {
    match statement {
        Statement::Block(block) => vec![block],
        Statement::If { accept, reject, .. } => vec![accept, reject],
        Statement::Switch { cases, .. } => cases.iter().map(|c| &c.body).collect(),
        Statement::Loop { body, continuing, .. } => vec![body, continuing],
        Statement::Emit(_)
        | Statement::Break
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
        | Statement::CooperativeStore { .. } => Vec::new(),
    }
}

/// Whether a statement within `block` is as wanted; the blocks of loops and switches count if `enter` says so.
fn any(
    block: &[Statement],
    enter: &impl Fn(&Statement) -> bool,
    wanted: &impl Fn(&Statement) -> bool,
) -> bool {
    block.iter().any(|s| {
        wanted(s) || (enter(s) && inner_blocks(s).into_iter().any(|inner| any(inner, enter, wanted)))
    })
}

/// Whether some lane may return within.
pub(crate) fn returns(block: &[Statement]) -> bool {
    any(block, &|_| true, &|s| matches!(s, Statement::Return { .. }))
}

/// Whether a `continue` within means the loop around `block`.
pub(crate) fn continues(block: &[Statement]) -> bool {
    any(block, &|s| !matches!(s, Statement::Loop { .. }), &|s| matches!(s, Statement::Continue))
}

/// Whether a `break` within means the construct around `block`.
pub(crate) fn breaks(block: &[Statement]) -> bool {
    let enter = |s: &Statement| !matches!(s, Statement::Loop { .. } | Statement::Switch { .. });
    any(block, &enter, &|s| matches!(s, Statement::Break))
}

/// Whether all lanes return within.
pub(crate) fn always_returns(block: &[Statement]) -> bool {
    block.last().is_some_and(|last| match last {
        Statement::Return { .. } => true,
        Statement::Block(inner) => always_returns(inner),
        Statement::If { accept, reject, .. } => always_returns(accept) && always_returns(reject),
        Statement::Switch { .. }
        | Statement::Loop { .. }
        | Statement::Emit(_)
        | Statement::Break
        | Statement::Continue
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

/// Whether every return of `block` ends its function once what follows a branch, one arm of which always
/// returns, is moved into the other arm: then returns are branches, and no lane ever has to wait.
pub(crate) fn returns_last(block: &[Statement], tail: bool) -> bool {
    let end = block.len().saturating_sub(1);
    block.iter().enumerate().all(|(at, statement)| {
        let tail = tail && at == end;
        if !returns(std::slice::from_ref(statement)) {
            true
        } else if let Statement::Return { .. } = statement {
            true
        } else if let Statement::If { accept, reject, .. } = statement {
            (tail || always_returns(accept) || always_returns(reject))
                && returns_last(accept, tail)
                && returns_last(reject, tail)
        } else if let Statement::Block(inner) = statement {
            returns_last(inner, tail)
        } else {
            false
        }
    })
}
