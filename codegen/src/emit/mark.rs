//! Unique names of our own for everything that a writer names.
//!
//! A mark is `lobeq` and five letters: lower case (the HLSL writer lowers the case of names that it
//! builds others from), of one length (so that it is found inside `GetMat..On..`), no word of any
//! language, and ending in no digit.
//! naga's namer lets it through as it is.

use naga::{Function, Handle, Module, UniqueArena};

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
    fn push(&mut self, exact: &str, role: Role) -> String {
        self.0.push(Mark { exact: exact.to_owned(), role });
        spell(self.0.len() - 1)
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
    let letter = |i: usize| char::from(b'a' + (index / 26usize.pow(i as u32) % 26) as u8);
    PREFIX.chars().chain((0..LETTERS).rev().map(letter)).collect()
}

/// A module whose names are marks, and their meaning.
pub(super) struct Marked {
    /// The copy; its handles are the original's, so that the original's validation holds for it.
    pub(super) module: Module,
    /// What the names stand for.
    pub(super) marks: Marks,
}

/// Copies `original` and gives everything in the copy a mark.
pub(super) fn mark(original: &Module) -> Marked {
    let mut module = original.clone();
    let mut marks = Marks::default();
    mark_types(&mut module, &mut marks);
    for (handle, constant) in module.constants.iter_mut() {
        // Constants without a name are written where they are used.
        if let Some(name) = &mut constant.name {
            *name = marks.push(name, Role::Constant(handle));
        }
    }
    for (handle, global) in module.global_variables.iter_mut() {
        let exact = global.name.as_deref().unwrap_or("unnamed");
        global.name = Some(marks.push(exact, Role::Global(handle)));
    }
    for (handle, function) in module.functions.iter_mut() {
        let exact = function.name.as_deref().unwrap_or("unnamed");
        function.name = Some(marks.push(exact, Role::Function(handle)));
        mark_function(function, &mut marks);
    }
    for (index, entry) in module.entry_points.iter_mut().enumerate() {
        entry.name = marks.push(&entry.name, Role::Entry(index));
        mark_function(&mut entry.function, &mut marks);
    }
    Marked { module, marks }
}

/// Whether naga made this structure for the result of a built-in function.
pub(super) fn is_predeclared(module: &Module, ty: Handle<naga::Type>) -> bool {
    module.special_types.predeclared_types.values().any(|&t| t == ty)
}

fn mark_types(module: &mut Module, marks: &mut Marks) {
    let mut types = UniqueArena::new();
    for (handle, ty) in module.types.iter() {
        let mut ty = ty.clone();
        if let naga::TypeInner::Struct { members, .. } = &mut ty.inner
            && !is_predeclared(module, handle)
        {
            ty.name = Some(marks.push(ty.name.as_deref().unwrap_or("unnamed"), Role::Struct(handle)));
            for (i, member) in members.iter_mut().enumerate() {
                let exact = member.name.as_deref().unwrap_or("unnamed");
                member.name = Some(marks.push(exact, Role::Member(handle, i)));
            }
        }
        // No two types were equal and marks are unique: each gets the handle it had.
        types.insert(ty, module.types.get_span(handle));
    }
    module.types = types;
}

fn mark_function(function: &mut Function, marks: &mut Marks) {
    for argument in &mut function.arguments {
        // Arguments need no name in IR; what has none cannot be asked for by it.
        argument.name = Some(match &argument.name {
            Some(exact) => marks.push(exact, Role::Argument),
            None => marks.push("argument", Role::Local),
        });
    }
    for (_, local) in function.local_variables.iter_mut() {
        local.name = Some(marks.push(local.name.as_deref().unwrap_or("variable"), Role::Local));
    }
    for name in function.named_expressions.values_mut() {
        *name = marks.push(name, Role::Local);
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
        let words: Vec<String> = (0..1000).map(|i| marks.push(&format!("n{i}"), Role::Local)).collect();
        for (i, word) in words.iter().enumerate() {
            assert_eq!(marks.at(&format!("{word}_7")).map(|m| m.exact.as_str()), Some(&*format!("n{i}")));
        }
        assert!(
            marks.at("lobeqzzzzz").is_none() && marks.at("lobeq").is_none() && marks.at("lobeqA").is_none()
        );
    }
}
