//! Names of what lives within a function: the declared one when it is free, else one made from it.

use super::mark::{LENGTH, Marks, Role};
use super::scan::{Piece, PieceKind};
use crate::names;
use naga::{Expression, Function, Handle, Module, TypeInner};
use naga::{FastHashMap as HashMap, FastHashSet as HashSet};

/// Names that no local may have: those seen in the whole module, and whatever else the text says.
pub(super) type Taken = HashSet<String>;

/// Gives each local of an item its name, in two rounds: first come the declared names, in order of
/// appearance, so that a made name never takes one of them.
pub(super) fn locals<'a>(
    item: &[Piece<'a>],
    marks: &Marks,
    body: Option<(&Module, &Function)>,
    taken: &Taken,
) -> HashMap<&'a str, String> {
    let mut wanted: Vec<(&'a str, Wish)> = Vec::new();
    let mut seen = HashSet::default();
    let mut used = HashSet::default();
    for piece in item.iter().filter(|p| p.kind == PieceKind::Word && seen.insert(p.text)) {
        if let Some(name) = wish(piece.text, marks, body) {
            wanted.push((piece.text, name));
        } else if let Some(mark) = marks.at(piece.text) {
            used.insert(mark.exact.clone());
        }
    }
    let mut out = HashMap::default();
    let is_free = |name: &str, used: &HashSet<String>| {
        !used.contains(name) && !taken.contains(name) && names::check(name).is_ok()
    };
    let mut late = Vec::new();
    for (word, name) in wanted {
        if name.is_declared && is_free(&name.text, &used) {
            used.insert(name.text.clone());
            out.insert(word, name.text);
        } else {
            late.push((word, name.text));
        }
    }
    for (word, name) in late {
        let made = std::iter::once(name.clone()).chain((1u32..).map(|i| format!("{name}_{i}")));
        if let Some(free) = made.into_iter().find(|n| is_free(n, &used)) {
            used.insert(free.clone());
            out.insert(word, free);
        }
    }
    out
}

/// The name that a local would like to have.
struct Wish {
    text: String,
    /// Somebody declared it; names that nobody did come after those.
    is_declared: bool,
}

impl Wish {
    fn made(text: &str) -> Self {
        Self { text: text.to_owned(), is_declared: false }
    }

    /// A declared name, less what no made name may have in it.
    fn declared(text: &str) -> Self {
        let name = text.trim_matches('_');
        let text = if name.is_empty() { "value".to_owned() } else { name.replace("__", "_") };
        Self { text, is_declared: true }
    }
}

/// The wish of a word, if it names a local.
fn wish(word: &str, marks: &Marks, body: Option<(&Module, &Function)>) -> Option<Wish> {
    if let Some(mark) = marks.at(word) {
        let is_whole = word.len() == LENGTH;
        // A name that is written twice has a number behind its mark.
        if !is_whole && !is_number(word[LENGTH..].strip_prefix('_')?) {
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
    if let Some(index) = word.strip_prefix("_e").filter(|rest| is_number(rest)) {
        let (handle, _) = function.expressions.iter().nth(index.parse().ok()?)?;
        // Results of calls are written so even when they have a name.
        return Some(match function.named_expressions.get(&handle) {
            Some(name) => Wish::declared(name),
            None => Wish::made(&hint(module, function, handle)),
        });
    }
    helper(word).map(Wish::made)
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
fn hint(module: &Module, function: &Function, value: Handle<Expression>) -> String {
    let name = match function.expressions[value] {
        Expression::Load { pointer } => place(module, function, pointer),
        Expression::CallResult(callee) => module.functions[callee].name.clone(),
        _ => None,
    };
    name.unwrap_or_else(|| "value".to_owned())
}

/// The name of what a pointer points at.
fn place(module: &Module, function: &Function, pointer: Handle<Expression>) -> Option<String> {
    match function.expressions[pointer] {
        Expression::LocalVariable(local) => function.local_variables[local].name.clone(),
        Expression::GlobalVariable(global) => module.global_variables[global].name.clone(),
        Expression::FunctionArgument(i) => function.arguments.get(i as usize)?.name.clone(),
        Expression::Access { base, .. } => place(module, function, base),
        Expression::AccessIndex { base, index } => {
            member(module, function, base, index).or_else(|| place(module, function, base))
        }
        _ => None,
    }
}

/// The name of a member of the structure behind `base`.
fn member(module: &Module, function: &Function, base: Handle<Expression>, index: u32) -> Option<String> {
    let ty = match function.expressions[base] {
        Expression::LocalVariable(local) => function.local_variables[local].ty,
        Expression::GlobalVariable(global) => module.global_variables[global].ty,
        _ => return None,
    };
    match &module.types[ty].inner {
        TypeInner::Struct { members, .. } => members.get(index as usize)?.name.clone(),
        _ => None,
    }
}
