//! Unique names of our own for everything that a writer names.
//!
//! A mark is `lobeq` and five letters: lower case (the HLSL writer lowers the case of names that it
//! builds others from), of one length (so that it is found inside `GetMat..On..`), no word of any
//! language, and ending in no digit.
//! naga's namer lets it through as it is.

use naga::{Function, Handle, Module, TypeInner};

/// Begin of every mark.
pub(super) const PREFIX: &str = "lobeq";
const LETTERS: usize = 5;
/// Length of every mark.
pub(super) const LENGTH: usize = PREFIX.len() + LETTERS;

/// What a mark stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    /// A function.
    Function(Handle<Function>),
    /// An entry point, by index.
    Entry(usize),
    /// A structure.
    Struct(Handle<naga::Type>),
    /// A structure's member, by index.
    Member(Handle<naga::Type>, usize),
    /// A constant.
    Constant(Handle<naga::Constant>),
    /// A global variable.
    Global(Handle<naga::GlobalVariable>),
    /// A parameter of a function or entry point.
    Argument,
    /// A variable or named value within a function: the only ones that may get another name.
    Local,
}

impl Role {
    /// Whether it is seen in the whole module.
    pub(super) fn is_module_wide(self) -> bool {
        match self {
            Self::Function(_) | Self::Entry(_) | Self::Struct(_) | Self::Constant(_) | Self::Global(_) => {
                true
            }
            Self::Member(..) | Self::Argument | Self::Local => false,
        }
    }
}

/// A mark's meaning.
#[derive(Debug, Clone)]
pub(super) struct Mark {
    /// The declared name.
    pub(super) exact: String,
    /// What has it.
    pub(super) role: Role,
}

/// All marks of a module; a mark's letters are its index.
#[derive(Debug, Default)]
pub(super) struct Marks(Vec<Mark>);

impl Marks {
    fn push(&mut self, exact: String, role: Role) -> String {
        self.0.push(Mark { exact, role });
        spell(self.0.len() - 1)
    }

    /// Puts a mark in the place of a name; what has none was called `otherwise`.
    fn replace(&mut self, name: &mut Option<String>, otherwise: &str, role: Role) {
        let exact = name.take().unwrap_or_else(|| otherwise.to_owned());
        *name = Some(self.push(exact, role));
    }

    /// The mark that `word` begins with.
    pub(super) fn at(&self, word: &str) -> Option<&Mark> {
        let letters = word.strip_prefix(PREFIX)?.as_bytes().get(..LETTERS)?;
        let digit = |value: usize, &letter: &u8| match letter {
            b'a'..=b'z' => Some(value * 26 + usize::from(letter - b'a')),
            _ => None,
        };
        self.0.get(letters.iter().try_fold(0, digit)?)
    }

    /// All marks.
    pub(super) fn iter(&self) -> impl Iterator<Item = &Mark> {
        self.0.iter()
    }
}

/// The name with this index.
fn spell(index: usize) -> String {
    let mut letters = [b'a'; LETTERS];
    let mut rest = index;
    for letter in letters.iter_mut().rev() {
        *letter += (rest % 26) as u8;
        rest /= 26;
    }
    let mut name = String::with_capacity(LENGTH);
    name.push_str(PREFIX);
    name.push_str(std::str::from_utf8(&letters).unwrap_or_default());
    name
}

/// A module whose names are marks, and their meaning.
pub(super) struct Marked {
    /// The module; its handles are those that it had, so that its validation holds still.
    pub(super) module: Module,
    /// What the names stand for.
    pub(super) marks: Marks,
}

/// A copy of all that a writer reads, which is not the documentation.
pub(super) fn copy(original: &Module) -> Module {
    Module {
        types: original.types.clone(),
        special_types: original.special_types.clone(),
        constants: original.constants.clone(),
        overrides: original.overrides.clone(),
        global_variables: original.global_variables.clone(),
        global_expressions: original.global_expressions.clone(),
        functions: original.functions.clone(),
        entry_points: original.entry_points.clone(),
        diagnostic_filters: original.diagnostic_filters.clone(),
        diagnostic_filter_leaf: original.diagnostic_filter_leaf,
        doc_comments: None,
    }
}

/// Gives everything in a module a mark.
pub(super) fn mark(mut module: Module) -> Marked {
    let mut marks = Marks::default();
    mark_types(&mut module, &mut marks);
    for (handle, constant) in module.constants.iter_mut() {
        // Constants without a name are written where they are used.
        if constant.name.is_some() {
            marks.replace(&mut constant.name, "", Role::Constant(handle));
        }
    }
    for (handle, global) in module.global_variables.iter_mut() {
        marks.replace(&mut global.name, "unnamed", Role::Global(handle));
    }
    for (handle, function) in module.functions.iter_mut() {
        marks.replace(&mut function.name, "unnamed", Role::Function(handle));
        mark_function(function, &mut marks);
    }
    for (index, entry) in module.entry_points.iter_mut().enumerate() {
        entry.name = marks.push(std::mem::take(&mut entry.name), Role::Entry(index));
        mark_function(&mut entry.function, &mut marks);
    }
    Marked { module, marks }
}

/// Whether naga made this structure for the result of a built-in function.
pub(super) fn is_predeclared(module: &Module, ty: Handle<naga::Type>) -> bool {
    module.special_types.predeclared_types.values().any(|&t| t == ty)
}

fn mark_types(module: &mut Module, marks: &mut Marks) {
    let is_named = |ty: &Handle<naga::Type>| {
        matches!(module.types[*ty].inner, TypeInner::Struct { .. }) && !is_predeclared(module, *ty)
    };
    let structures: Vec<_> = module.types.iter().map(|(handle, _)| handle).filter(is_named).collect();
    for handle in structures {
        let mut ty = module.types[handle].clone();
        marks.replace(&mut ty.name, "unnamed", Role::Struct(handle));
        if let TypeInner::Struct { members, .. } = &mut ty.inner {
            for (i, member) in members.iter_mut().enumerate() {
                marks.replace(&mut member.name, "unnamed", Role::Member(handle, i));
            }
        }
        // Marks are unique, so no other type is equal.
        module.types.replace(handle, ty);
    }
}

fn mark_function(function: &mut Function, marks: &mut Marks) {
    for argument in &mut function.arguments {
        // Arguments need no name in IR; what has none cannot be asked for by it.
        let role = if argument.name.is_some() { Role::Argument } else { Role::Local };
        marks.replace(&mut argument.name, "argument", role);
    }
    for (_, local) in function.local_variables.iter_mut() {
        marks.replace(&mut local.name, "variable", Role::Local);
    }
    for name in function.named_expressions.values_mut() {
        *name = marks.push(std::mem::take(name), Role::Local);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use naga::proc::{CaseInsensitiveKeywordSet, KeywordSet, Namer};

    #[test]
    fn the_namer_lets_marks_through() {
        let mut namer = Namer::default();
        let mut names = Default::default();
        namer.reset(
            &Module::default(),
            &naga::keywords::wgsl::RESERVED_SET,
            KeywordSet::empty(),
            CaseInsensitiveKeywordSet::empty(),
            &["naga_", "__"],
            &mut names,
        );
        for index in (0..20_000).chain((26 * 26 * 26 * 26 - 500)..(26 * 26 * 26 * 26 + 500)) {
            let mark = spell(index);
            assert_eq!(mark.len(), LENGTH);
            assert_eq!(namer.call(&mark), mark);
            assert_eq!(mark.to_lowercase(), mark);
        }
    }

    #[test]
    fn a_mark_is_found_by_its_letters() {
        let mut marks = Marks::default();
        let words: Vec<String> = (0..1000).map(|i| marks.push(format!("n{i}"), Role::Local)).collect();
        for (i, word) in words.iter().enumerate() {
            assert_eq!(marks.at(&format!("{word}_7")).map(|m| m.exact.as_str()), Some(&*format!("n{i}")));
        }
        assert!(
            marks.at("lobeqzzzzz").is_none() && marks.at("lobeq").is_none() && marks.at("lobeqA").is_none()
        );
    }
}
