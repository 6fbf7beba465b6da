//! Names of what lives within a function: the declared one when it is free, else one made from it.

use super::mark::{LENGTH, Role};
use super::words::{Word, Words};
use crate::names;
use naga::FastHashSet as HashSet;
use naga::{Expression, Function, Handle, Module, TypeInner};
use std::borrow::Cow;

/// Names that no local may have: those seen in the whole module, and whatever else the text says.
pub(super) type Taken<'a> = HashSet<Cow<'a, str>>;

/// Gives each local of an item its name, in two rounds: first come the declared names, in order of
/// appearance, so that a made name never takes one of them.
///
/// `item` are its words, by number.
pub(super) fn locals<'a>(
    item: &[u32],
    words: &'a Words<'a>,
    body: Option<(&'a Module, &'a Function)>,
    taken: &Taken<'a>,
) -> Vec<(u32, Cow<'a, str>)> {
    let mut wanted = Vec::new();
    let mut used: HashSet<Cow<'a, str>> = HashSet::with_capacity_and_hasher(item.len(), Default::default());
    for &number in item {
        let word = words.at(number);
        if let Some(wish) = wish(word, body) {
            wanted.push((number, wish));
        } else if let Some(mark) = word.mark {
            used.insert(Cow::Borrowed(&mark.exact));
        }
    }
    let mut out = Vec::with_capacity(wanted.len());
    let mut late = Vec::new();
    for (word, Wish { text, is_declared }) in wanted {
        if is_declared && is_free(&text, &used, taken) {
            used.insert(text.clone());
            out.push((word, text));
        } else {
            late.push((word, text));
        }
    }
    for (word, name) in late {
        let name = numbered(name, &used, taken);
        used.insert(name.clone());
        out.push((word, name));
    }
    out
}

fn is_free(name: &str, used: &HashSet<Cow<'_, str>>, taken: &Taken<'_>) -> bool {
    !used.contains(name) && !taken.contains(name) && names::check(name).is_ok()
}

/// The name if it is free, else with the first number that makes it so.
fn numbered<'a>(name: Cow<'a, str>, used: &HashSet<Cow<'_, str>>, taken: &Taken<'_>) -> Cow<'a, str> {
    if is_free(&name, used, taken) {
        return name;
    }
    let mut made = (1u32..).map(|number| format!("{name}_{number}"));
    made.find(|made| is_free(made, used, taken)).map_or(name, Cow::Owned)
}

/// The name that a local would like to have.
struct Wish<'a> {
    text: Cow<'a, str>,
    /// Somebody declared it; names that nobody did come after those.
    is_declared: bool,
}

impl<'a> Wish<'a> {
    fn made(text: &'a str) -> Self {
        Self { text: Cow::Borrowed(text), is_declared: false }
    }

    /// A declared name, less what no made name may have in it.
    fn declared(text: &'a str) -> Self {
        let text = match text.trim_matches('_') {
            "" => Cow::Borrowed("value"),
            name if name.contains("__") => Cow::Owned(name.replace("__", "_")),
            name => Cow::Borrowed(name),
        };
        Self { text, is_declared: true }
    }
}

/// The wish of a word, if it names a local.
fn wish<'a>(word: &'a Word<'a>, body: Option<(&'a Module, &'a Function)>) -> Option<Wish<'a>> {
    if let Some(mark) = word.mark {
        let is_whole = word.is_whole_mark();
        // A name that is written twice has a number behind its mark.
        if !is_whole && !is_number(word.text[LENGTH..].strip_prefix('_')?) {
            return None;
        }
        return match mark.role {
            Role::Local => Some(Wish { is_declared: is_whole, ..Wish::declared(&mark.exact) }),
            // The HLSL writer's variable for a structure that is returned.
            Role::Struct(_) if !is_whole && body.is_some() => Some(Wish::made("result")),
            _ => None,
        };
    }
    let (module, function) = body?;
    if let Some(index) = word.text.strip_prefix("_e").filter(|rest| is_number(rest)) {
        let (handle, _) = function.expressions.iter().nth(index.parse().ok()?)?;
        // Results of calls are written so even when they have a name.
        return Some(match function.named_expressions.get(&handle) {
            Some(name) => Wish::declared(name),
            None => Wish::made(hint(module, function, handle)),
        });
    }
    helper(word.text).map(Wish::made)
}

/// A name that the HLSL writer gives to a variable of its own, without the number behind it.
pub(super) fn helper(word: &str) -> Option<&'static str> {
    ["loop_init", "local_invocation_index"].into_iter().find(|helper| {
        let rest = word.strip_prefix(helper);
        rest.is_some_and(|rest| rest.is_empty() || rest.strip_prefix('_').is_some_and(is_number))
    })
}

fn is_number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit())
}

/// A name for a value that has none: after what it was read from, or what computed it.
fn hint<'a>(module: &'a Module, function: &'a Function, value: Handle<Expression>) -> &'a str {
    let name = match function.expressions[value] {
        Expression::Load { pointer } => place(module, function, pointer),
        Expression::CallResult(callee) => module.functions[callee].name.as_deref(),
        _ => None,
    };
    name.unwrap_or("value")
}

/// The name of what a pointer points at.
fn place<'a>(module: &'a Module, function: &'a Function, pointer: Handle<Expression>) -> Option<&'a str> {
    match function.expressions[pointer] {
        Expression::LocalVariable(local) => function.local_variables[local].name.as_deref(),
        Expression::GlobalVariable(global) => module.global_variables[global].name.as_deref(),
        Expression::FunctionArgument(i) => function.arguments.get(i as usize)?.name.as_deref(),
        Expression::Access { base, .. } => place(module, function, base),
        Expression::AccessIndex { base, index } => {
            member(module, function, base, index).or_else(|| place(module, function, base))
        }
        _ => None,
    }
}

/// The name of a member of the structure behind `base`.
fn member<'a>(
    module: &'a Module,
    function: &Function,
    base: Handle<Expression>,
    index: u32,
) -> Option<&'a str> {
    let ty = match function.expressions[base] {
        Expression::LocalVariable(local) => function.local_variables[local].ty,
        Expression::GlobalVariable(global) => module.global_variables[global].ty,
        _ => return None,
    };
    match &module.types[ty].inner {
        TypeInner::Struct { members, .. } => members.get(index as usize)?.name.as_deref(),
        _ => None,
    }
}
