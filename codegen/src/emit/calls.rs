//! Calls that naga's SPIR-V writer panics on.

use super::{EmitError, Target};
use naga::{AddressSpace, Block, Expression, Function, Handle, Module, Statement};

/// Checks that no function is handed a pointer to a part of a variable: SPIR-V's pointers in calls are to whole
/// variables, and naga's writer does not copy.
///
/// # Errors
/// When one is.
pub fn check_calls(module: &Module) -> Result<(), EmitError> {
    let functions = module.functions.iter().map(|(_, f)| f);
    for function in functions.chain(module.entry_points.iter().map(|p| &p.function)) {
        if let Some(callee) = faulty(module, function, &function.body) {
            let name = |f: &Function| f.name.clone().unwrap_or_default();
            let message = format!(
                "`{}` calls `{}` with a pointer to a part of a variable",
                name(function),
                name(&module.functions[callee])
            );
            return Err(EmitError::Writer { target: Target::Spirv, message });
        }
    }
    Ok(())
}

/// What is called so in a block.
fn faulty(module: &Module, function: &Function, block: &Block) -> Option<Handle<Function>> {
    // A part of a value is no pointer, and is loaded.
    let is_part = |e: &Handle<Expression>| {
        let mut base = *e;
        while let Expression::Access { base: of, .. } | Expression::AccessIndex { base: of, .. } =
            function.expressions[base]
        {
            base = of;
        }
        let is_pointer = match function.expressions[base] {
            Expression::LocalVariable(_) => true,
            Expression::GlobalVariable(variable) => {
                module.global_variables[variable].space != AddressSpace::Handle
            }
            Expression::FunctionArgument(at) => {
                module.types[function.arguments[at as usize].ty].inner.pointer_space().is_some()
            }
            _ => false,
        };
        base != *e && is_pointer
    };
    let inside = |block| faulty(module, function, block);
    block.iter().find_map(|statement| match statement {
        Statement::Call { function: callee, arguments, .. } => {
            arguments.iter().any(is_part).then_some(*callee)
        }
        Statement::Block(block) => inside(block),
        Statement::If { accept, reject, .. } => inside(accept).or_else(|| inside(reject)),
        Statement::Switch { cases, .. } => cases.iter().find_map(|case| inside(&case.body)),
        Statement::Loop { body, continuing, .. } => inside(body).or_else(|| inside(continuing)),
        _ => None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validate::foreign_wgsl;

    fn check(argument: &str, parameter: &str) -> Result<(), EmitError> {
        let text = format!(
            "struct Pair {{ a: u32, b: array<u32, 2> }}
            @group(0) @binding(0) var<storage, read_write> out: u32;
            fn f(x: {parameter}) {{ }}
            fn g(p: Pair) {{ h(p.a); }}
            fn h(x: u32) {{ }}
            @compute @workgroup_size(1)
            fn main() {{ var p: Pair; if out > 1u {{ loop {{ f({argument}); break; }} }} }}"
        );
        check_calls(foreign_wgsl(&text).unwrap().module())
    }

    #[test]
    fn a_pointer_to_a_part_is_refused() {
        for (argument, parameter) in [("&p", "ptr<function, Pair>"), ("p.a", "u32"), ("p.b[out]", "u32")] {
            check(argument, parameter).unwrap_or_else(|e| panic!("{argument}: {e}"));
        }
        for (argument, parameter) in [("&p.a", "ptr<function, u32>"), ("&p.b[out]", "ptr<function, u32>")] {
            let message = check(argument, parameter).unwrap_err().to_string();
            assert!(message.contains("`main` calls `f` with a pointer to a part"), "{message}");
        }
    }
}
