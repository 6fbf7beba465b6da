//! What is too much to walk: known beforehand, so that it is refused at once.

use super::super::error::{InterpError, Res};
use super::scan::inner_blocks;
use lobe_codegen::module::Scope;
use naga::{Block, Function, Module, Statement};

/// Statements and expressions to walk, those of functions as often as they are called. One takes about a microsecond.
const WALK: usize = 1 << 22;

/// Blocks within blocks. WGSL asks for 127; walking takes a time that grows with the square.
const NESTING: usize = 512;

/// Checks that what `scope` calls for can be walked.
pub(super) fn check(module: &Module, scope: Scope) -> Res<()> {
    let mut walks = Vec::new();
    // Callees come first.
    for (handle, function) in module.functions.iter() {
        walks.push(walk(function, &walks));
        if scope == Scope::Function(handle) {
            return judge(module, function, &walks);
        }
    }
    match scope {
        Scope::Entry(index) => {
            module.entry_points.get(index).map_or(Ok(()), |entry| judge(module, &entry.function, &walks))
        }
        Scope::Function(_) | Scope::Global => Ok(()),
    }
}

/// Refuses `function`, or the first that it calls for, if that is too much.
fn judge(module: &Module, function: &Function, walks: &[Option<usize>]) -> Res<()> {
    let unsupported = |what: String, function: &Function| {
        let function = function.name.clone().unwrap_or_else(|| "entry point".to_owned());
        Err(InterpError::Unsupported { what, function, at: None })
    };
    match walk(function, walks) {
        Some(steps) if steps <= WALK => Ok(()),
        Some(_) => {
            unsupported(format!("calls that inline to more than {WALK} statements and expressions"), function)
        }
        None => {
            let callees = module.functions.iter().map(|(_, f)| f);
            let deepest = callees.chain([function]).find(|f| is_deep(&f.body, NESTING));
            unsupported(format!("blocks nested deeper than {NESTING}"), deepest.unwrap_or(function))
        }
    }
}

/// What walking a function takes; `None` if it, or what it calls, is nested too deeply.
fn walk(function: &Function, walks: &[Option<usize>]) -> Option<usize> {
    let own = function.expressions.len() + function.local_variables.len() + 1;
    if is_deep(&function.body, NESTING) {
        return None;
    }
    block(&function.body, walks).map(|steps| steps.saturating_add(own))
}

fn block(statements: &Block, walks: &[Option<usize>]) -> Option<usize> {
    statements.iter().try_fold(0_usize, |sum, statement| {
        let own = match statement {
            Statement::Call { function, .. } => walks.get(function.index()).copied().unwrap_or(Some(0))?,
            _ => 1,
        };
        let mut inner = inner_blocks(statement).into_iter();
        let inner = inner.try_fold(0_usize, |sum, inner| Some(sum.saturating_add(block(inner, walks)?)))?;
        Some(sum.saturating_add(own).saturating_add(inner))
    })
}

fn is_deep(statements: &Block, left: usize) -> bool {
    left == 0 || statements.iter().flat_map(inner_blocks).any(|inner| is_deep(inner, left - 1))
}
