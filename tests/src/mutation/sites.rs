//! Where a kernel's IR can be wrong.

use super::fault::{Edit, Kind, Mutant};
use super::operator;
use lobe_backends::executor::Program;
use lobe_kernels::registry::KERNELS;
use naga::{Block, Function, Handle, Span, Statement};

/// Every fault of a kernel's own code: of itself, and of what it calls that is no kernel of the library.
#[must_use]
pub fn faults(program: &Program) -> Vec<Mutant> {
    let module = program.module().module();
    let is_own = |name: &str| name == program.name() || !KERNELS.iter().any(|k| k().name == name);
    let own = module.functions.iter().filter(|(_, f)| f.name.as_deref().is_none_or(is_own));
    own.flat_map(|(handle, function)| {
        let mut all = of_expressions(program, handle, function);
        all.extend(of_statements(program, handle, function));
        all
    })
    .collect()
}

fn of_expressions(program: &Program, handle: Handle<Function>, function: &Function) -> Vec<Mutant> {
    let module = program.module().module();
    let used = function.expressions.iter();
    used.flat_map(|(at, expression)| {
        let span = function.expressions.get_span(at);
        let mistakes = operator::mistakes(module, function, expression);
        mistakes.into_iter().map(move |(kind, to)| {
            let change = format!("{} becomes {}", shown(expression), shown(&to));
            mutant(program, function, span, kind, change, Edit::Expression { function: handle, at, to })
        })
    })
    .collect()
}

fn of_statements(program: &Program, handle: Handle<Function>, function: &Function) -> Vec<Mutant> {
    let mut paths = Vec::new();
    walk(&function.body, &mut Vec::new(), &mut paths);
    paths
        .into_iter()
        .map(|(path, span, what)| {
            let edit = Edit::Statement { function: handle, path };
            let change = format!("{what} is gone");
            mutant(program, function, span, Kind::RemovedStatement, change, edit)
        })
        .collect()
}

fn mutant(
    program: &Program,
    function: &Function,
    span: Span,
    kind: Kind,
    change: String,
    edit: Edit,
) -> Mutant {
    let place = program.module().meta().sources.place(span);
    Mutant { kind, function: function.name.clone().unwrap_or_default(), place, change, edit }
}

/// The way to each statement that can be left out, its span, and what it is.
fn walk(block: &Block, way: &mut Vec<usize>, found: &mut Vec<(Vec<usize>, Span, &'static str)>) {
    for (at, (statement, span)) in block.span_iter().enumerate() {
        way.push(at);
        let what = match statement {
            Statement::Store { .. } => Some("a store"),
            Statement::If { accept, .. } if !accept.is_empty() => Some("a branch"),
            _ => None,
        };
        found.extend(what.map(|what| (way.clone(), *span, what)));
        for (inner, block) in blocks(statement).into_iter().enumerate() {
            way.push(inner);
            walk(block, way, found);
            way.pop();
        }
        way.pop();
    }
}

fn blocks(statement: &Statement) -> Vec<&Block> {
    match statement {
        Statement::Block(block) => vec![block],
        Statement::If { accept, reject, .. } => vec![accept, reject],
        Statement::Switch { cases, .. } => cases.iter().map(|case| &case.body).collect(),
        Statement::Loop { body, continuing, .. } => vec![body, continuing],
        _ => Vec::new(),
    }
}

/// The blocks within a statement, in the order of [`walk`].
pub(super) fn blocks_mut(statement: &mut Statement) -> Vec<&mut Block> {
    match statement {
        Statement::Block(block) => vec![block],
        Statement::If { accept, reject, .. } => vec![accept, reject],
        Statement::Switch { cases, .. } => cases.iter_mut().map(|case| &mut case.body).collect(),
        Statement::Loop { body, continuing, .. } => vec![body, continuing],
        _ => Vec::new(),
    }
}

/// An expression without the handles in it.
fn shown(expression: &naga::Expression) -> String {
    match expression {
        naga::Expression::Literal(literal) => format!("{literal:?}"),
        naga::Expression::Binary { op, left, right } => format!("{left:?} {op:?} {right:?}"),
        naga::Expression::Math { fun, arg, arg1, arg2, .. } => {
            let args = [Some(*arg), *arg1, *arg2].into_iter().flatten();
            let args: Vec<String> = args.map(|a| format!("{a:?}")).collect();
            format!("{fun:?}({})", args.join(", "))
        }
        naga::Expression::AccessIndex { base, index } => format!("{base:?}.{index}"),
        other => format!("{other:?}"),
    }
}
