//! Temporaries that are used once are written where they are used.
//!
//! naga's writers give every call and every load a variable of its own, `_e7`; in Rust most of them stood in the
//! expression that uses them.
//! One is moved only past declarations, and only if it is a load of a local variable or a call of a function that
//! reads and writes nothing but its values: so nothing that it depends on can change on the way.

use crate::emit::mark::{self, Marks, Role};
use crate::emit::scan::{self, PieceKind};
use crate::emit::tidy::collect_calls;
use naga::{Expression, Function, Handle, Module, TypeInner};
use naga::{FastHashMap as HashMap, FastHashSet as HashSet};
use std::borrow::Cow;

/// The text of `function` with its temporaries in their places.
pub(super) fn inline(text: &str, module: &Module, function: &Function, marks: &Marks) -> String {
    let movable = movable(module, function);
    let mut lines: Vec<Cow<'_, str>> = text.lines().map(Cow::Borrowed).collect();
    let mut uses = uses(&lines);
    for i in 0..lines.len() {
        let Some((name, value, at)) = target(&lines, i, &uses, &movable, (module, marks)) else { continue };
        let (written, moved) = (with_value(&lines[at], name, value), temporaries(value).map(str::to_owned));
        // What the value uses is used there from now on.
        for temporary in moved.collect::<Vec<_>>() {
            uses.entry(temporary).and_modify(|(_, line)| *line = at);
        }
        lines[at] = Cow::Owned(written);
        lines[i] = Cow::Borrowed(GONE);
    }
    let mut kept = lines.iter().filter(|line| line.as_ref() != GONE);
    let mut out = kept.next().map(|line| line.clone().into_owned()).unwrap_or_default();
    for line in kept {
        out.push('\n');
        out.push_str(line);
    }
    out
}

/// What stands for a line that was moved; no writer writes one of these.
const GONE: &str = "\0";

/// How often each temporary is used, and in which line last.
type Uses = HashMap<String, (usize, usize)>;

fn uses(lines: &[Cow<'_, str>]) -> Uses {
    let mut uses = Uses::default();
    for (i, line) in lines.iter().enumerate() {
        let declared = declaration(line).map(|(name, _)| name);
        for name in temporaries(line) {
            let (count, last) = uses.entry(name.to_owned()).or_insert((0, i));
            // The line that declares it is no use of it.
            *count += usize::from(declared != Some(name));
            *last = i;
        }
    }
    uses
}

/// The words that writers give to temporaries, `_e7`.
fn temporaries(text: &str) -> impl Iterator<Item = &str> {
    let is_word = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_';
    let bytes = text.as_bytes();
    let begins = move |at: &usize| bytes[*at..].starts_with(b"_e") && (*at == 0 || !is_word(bytes[at - 1]));
    (0..bytes.len()).filter(begins).map(move |at| {
        let length = bytes[at..].iter().position(|&byte| !is_word(byte)).unwrap_or(bytes.len() - at);
        &text[at..at + length]
    })
}

/// What line `i` declares, its value, and the later line that it can be moved to.
fn target<'l>(
    lines: &'l [Cow<'_, str>],
    i: usize,
    uses: &Uses,
    movable: &HashSet<String>,
    (module, marks): (&Module, &Marks),
) -> Option<(&'l str, &'l str, usize)> {
    let (name, value) = declaration(&lines[i])?;
    let at = if movable.contains(name) {
        let &(count, at) = uses.get(name)?;
        (count == 1).then_some(at)?
    } else {
        let is_returned = || lines.get(i + 1).is_some_and(|l| l.trim() == format!("return {name};"));
        (is_result(name, marks) && is_returned()).then_some(i + 1)?
    };
    let may_pass = |line: &Cow<'_, str>| line.as_ref() == GONE || is_pure(line, module, marks);
    (at > i && lines[i + 1..at].iter().all(may_pass)).then_some((name, value, at))
}

/// Whether it is the variable that naga's HLSL has for a structure that is returned: called after the structure, with
/// a number behind it.
fn is_result(name: &str, marks: &Marks) -> bool {
    name.len() > mark::LENGTH && marks.at(name).is_some_and(|mark| matches!(mark.role, Role::Struct(_)))
}

/// `let NAME = VALUE;`, `float NAME = VALUE;`
fn declaration(line: &str) -> Option<(&str, &str)> {
    let (left, value) = line.trim().strip_suffix(';')?.split_once(" = ")?;
    let (before, name) = left.rsplit_once(' ')?;
    (!before.is_empty() && !left.contains(['(', '{', '['])).then_some((name, value))
}

/// Whether a line declares a value, and no call in it changes anything.
fn is_pure(line: &str, module: &Module, marks: &Marks) -> bool {
    let Some((_, value)) = declaration(line) else { return false };
    scan::pieces(value).iter().all(|piece| match marks.at(piece.text).map(|mark| mark.role) {
        Some(Role::Function(callee)) => is_function_of_values(module, callee),
        _ => !matches!(piece.text, "{" | "}"),
    })
}

fn with_value(line: &str, name: &str, value: &str) -> String {
    let is_it = |p: &scan::Piece<'_>| p.kind == PieceKind::Word && p.text == name;
    scan::pieces(line).iter().map(|p| if is_it(p) { value } else { p.text }).collect()
}

/// The names of temporaries that nothing else can change.
fn movable(module: &Module, function: &Function) -> HashSet<String> {
    let is_free = |expression: &Expression| match expression {
        Expression::CallResult(callee) => is_function_of_values(module, *callee),
        Expression::Load { pointer } => is_local(function, *pointer),
        _ => false,
    };
    let mut found = HashSet::default();
    for (handle, expression) in function.expressions.iter() {
        if is_free(expression) && !function.named_expressions.contains_key(&handle) {
            found.insert(format!("_e{}", handle.index()));
        }
    }
    found
}

/// Whether a pointer leads to a variable of the function.
fn is_local(function: &Function, pointer: Handle<Expression>) -> bool {
    match function.expressions[pointer] {
        Expression::LocalVariable(_) => true,
        Expression::AccessIndex { base, .. } | Expression::Access { base, .. } => is_local(function, base),
        _ => false,
    }
}

/// Whether a function reads and writes nothing but its arguments, which are values, and its result.
fn is_function_of_values(module: &Module, function: Handle<Function>) -> bool {
    let function = &module.functions[function];
    let is_value = |ty: Handle<naga::Type>| {
        !matches!(module.types[ty].inner, TypeInner::Pointer { .. } | TypeInner::ValuePointer { .. })
    };
    let is_global = |expression: &Expression| matches!(expression, Expression::GlobalVariable(_));
    let mut called = HashSet::default();
    collect_calls(&function.body, &mut called);
    function.result.is_some()
        && function.arguments.iter().all(|argument| is_value(argument.ty))
        && !function.expressions.iter().any(|(_, expression)| is_global(expression))
        && called.into_iter().all(|callee| is_function_of_values(module, callee))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validate::foreign_wgsl;

    const SHADER: &str = "
        var<private> counter: f32;
        fn value(x: f32) -> f32 { return x * 2.0; }
        fn change(x: ptr<function, f32>) -> f32 { *x = 1.0; return 2.0; }
        fn count() -> f32 { counter += 1.0; return counter; }
        fn outer(x: f32) -> f32 { var y = x; let a = value(y) + value(2.0); let b = change(&y); return a + b + count(); }";

    /// The text with temporaries in their places; `_e7` and the like are those of `outer`.
    fn inlined(lines: &str) -> String {
        let module = foreign_wgsl(SHADER).unwrap();
        let marked = mark::mark(module.module());
        let (_, outer) = module.module().functions.iter().nth(3).unwrap();
        let mut text = lines.to_owned();
        for (i, name) in ["value", "change", "count"].into_iter().enumerate() {
            let mark = marked.module.functions.iter().nth(i).unwrap().1.name.clone().unwrap();
            text = text.replace(name, &mark);
        }
        let mut calls = outer.expressions.iter().filter(|(_, e)| matches!(e, Expression::CallResult(_)));
        let load = outer.expressions.iter().find(|(_, e)| matches!(e, Expression::Load { .. })).unwrap().0;
        text = text.replace("LOAD", &format!("_e{}", load.index()));
        for name in ["FIRST", "SECOND"] {
            text = text.replace(name, &format!("_e{}", calls.next().unwrap().0.index()));
        }
        let mut done = inline(&text, module.module(), outer, &marked.marks);
        for (i, name) in ["value", "change", "count"].into_iter().enumerate() {
            let mark = marked.module.functions.iter().nth(i).unwrap().1.name.clone().unwrap();
            done = done.replace(&mark, name);
        }
        done
    }

    #[test]
    fn what_is_used_once_is_written_there() {
        let calls = "let FIRST = value(1.0);\nlet SECOND = value(FIRST);\nlet a = SECOND * b;";
        assert_eq!(inlined(calls), "let a = value(value(1.0)) * b;");
        assert_eq!(inlined("let LOAD = y;\nif (LOAD > 1.0) {\n}"), "if (y > 1.0) {\n}");
        assert_eq!(inlined("let LOAD = y;\nlet FIRST = value(LOAD);\ny = FIRST;"), "y = value(y);");
    }

    #[test]
    fn nothing_is_moved_past_what_may_change_it() {
        for kept in [
            "let LOAD = y;\ny = 1.0;\nlet a = (LOAD + 1.0);",
            "let LOAD = y;\nlet b = change(&y);\nlet a = (LOAD + 1.0);",
            "let LOAD = y;\nlet b = count();\nlet a = (LOAD + b);",
            "let LOAD = y;\nif (c) {\nlet a = (LOAD + b);\n}",
            "let LOAD = y;\nlet a = (LOAD + LOAD);",
            "let FIRST = value(x);\nlet a = FIRST;\nlet b = FIRST;",
            "let _e99 = value(x);\nlet a = _e99;",
        ] {
            let names = inlined(kept);
            assert_eq!(names.lines().count(), kept.lines().count(), "{names}");
        }
    }
}
