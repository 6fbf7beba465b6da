//! Remainders of signed numbers.
//!
//! naga writes `%`, which GLSL leaves undefined where an operand is negative, and drivers differ there.
//! The writer is given another operation in its place, whose name in the text then becomes that of a function of ours.

use naga::valid::{FunctionInfo, ModuleInfo};
use naga::{
    BinaryOperator, Expression, Function, MathFunction, Module, ScalarKind, Type, TypeInner, UniqueArena,
};
use std::collections::BTreeSet;

/// What the writer calls the operation that stands in; a call, so nothing else is spelt so.
const STAND_IN: &str = "outerProduct(";
/// What the function is called.
const NAME: &str = "lobe_remainder";

/// Puts the stand-in into the module; returns the types of its operands, in GLSL, and nothing when there is none.
///
/// # Errors
/// When the module has the operation itself, besides remainders.
pub(super) fn replace(module: &mut Module, info: &ModuleInfo) -> Result<BTreeSet<String>, String> {
    let mut types = BTreeSet::new();
    let mut outer = false;
    for (handle, function) in module.functions.iter_mut() {
        outer |= in_function(&module.types, function, &info[handle], &mut types);
    }
    for (index, entry) in module.entry_points.iter_mut().enumerate() {
        outer |= in_function(&module.types, &mut entry.function, info.get_entry_point(index), &mut types);
    }
    match outer && !types.is_empty() {
        true => Err("outer products beside remainders of signed numbers".to_owned()),
        false => Ok(types),
    }
}

/// Whether the function has the operation itself.
fn in_function(
    known: &UniqueArena<Type>,
    function: &mut Function,
    info: &FunctionInfo,
    types: &mut BTreeSet<String>,
) -> bool {
    let mut outer = false;
    for (handle, expression) in function.expressions.iter_mut() {
        outer |= matches!(expression, Expression::Math { fun: MathFunction::Outer, .. });
        let Expression::Binary { op: BinaryOperator::Modulo, left, right } = *expression else { continue };
        let Some(name) = signed(info[handle].ty.inner_with(known)) else { continue };
        types.insert(name);
        *expression = Expression::Math {
            fun: MathFunction::Outer,
            arg: left,
            arg1: Some(right),
            arg2: None,
            arg3: None,
        };
    }
    outer
}

/// The name of a type of signed numbers.
fn signed(ty: &TypeInner) -> Option<String> {
    match ty {
        TypeInner::Scalar(scalar) if scalar.kind == ScalarKind::Sint => Some("int".to_owned()),
        TypeInner::Vector { size, scalar } if scalar.kind == ScalarKind::Sint => {
            Some(format!("ivec{}", *size as u8))
        }
        _ => None,
    }
}

/// The text with the function, for each of these types, before the first that may call it.
pub(super) fn define(raw: String, types: &BTreeSet<String>) -> String {
    if types.is_empty() {
        return raw;
    }
    let functions: String = types
        .iter()
        .map(|ty| format!("{ty} {NAME}({ty} dividend, {ty} divisor) {{\n    return dividend - divisor * (dividend / divisor);\n}}\n\n"))
        .collect();
    let raw = raw.replace(STAND_IN, &format!("{NAME}("));
    let at = first_function(&raw);
    format!("{}{functions}{}", &raw[..at], &raw[at..])
}

/// Where the first function begins: a line that opens a brace behind parameters.
fn first_function(raw: &str) -> usize {
    let mut at = 0;
    for line in raw.split_inclusive('\n') {
        if line.trim_end().ends_with(") {") && !line.starts_with([' ', '#', '/']) {
            break;
        }
        at += line.len();
    }
    at
}

#[cfg(test)]
mod tests {
    use crate::emit::{Options, Target, emit};
    use crate::validate::from_wgsl;

    #[test]
    fn remainders_of_signed_numbers_go_by_a_division() {
        let text = "
            fn plain(a: u32, b: u32) -> u32 { return a % b; }
            fn each(a: vec2i, b: vec2i) -> vec2i { return a % b; }
            fn one(a: i32, b: i32) -> i32 { return (a % b) % 7i; }";
        let artifact = emit(&from_wgsl(text).unwrap(), Target::Glsl, &Options::default()).unwrap();
        let glsl = artifact.content.text().unwrap();
        for part in [
            "int lobe_remainder(int dividend, int divisor) {\n    return dividend - divisor * (dividend / divisor);\n}",
            "ivec2 lobe_remainder(ivec2 dividend, ivec2 divisor)",
            "return a % b;",
            "return lobe_remainder(a, b);",
            "return lobe_remainder(lobe_remainder(a, b), 7);",
        ] {
            assert!(glsl.contains(part), "{part}\n{glsl}");
        }
        let first = glsl.find("lobe_remainder(").unwrap();
        assert!(first < glsl.find("plain(").unwrap(), "{glsl}");
        assert!(!glsl.contains("outerProduct"), "{glsl}");
    }
}
