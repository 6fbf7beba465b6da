//! A writer's text with the declared names in it.

use super::clash::ClashError;
use super::mark::{LENGTH, Mark, Marks, PREFIX, Role};
use super::scan::{Piece, PieceKind};
use super::scope::{self, Taken};
use super::{Target, docs};
use naga::{FastHashMap as HashMap, FastHashSet as HashSet};
use naga::{Function, Module};
use std::borrow::Cow;

/// Renames the items of one text.
pub(super) struct Renamer<'a> {
    module: &'a Module,
    marks: &'a Marks,
    target: Target,
    taken: Taken,
}

/// An item as it is printed.
pub(super) struct Item {
    /// Its text.
    pub(super) text: String,
    /// What it defines, when that is the user's.
    pub(super) defines: Option<Role>,
}

impl<'a> Renamer<'a> {
    /// Looks through the whole text for names that locals must not take.
    pub(super) fn new(
        module: &'a Module,
        marks: &'a Marks,
        target: Target,
        pieces: &[Piece<'_>],
    ) -> Result<Self, ClashError> {
        let declared: HashSet<&str> =
            marks.iter().filter(|m| m.role.is_module_wide()).map(|m| m.exact.as_str()).collect();
        let mut taken: Taken = declared.iter().map(|&name| name.to_owned()).collect();
        let words: HashSet<&str> =
            pieces.iter().filter(|p| p.kind == PieceKind::Word).map(|p| p.text).collect();
        for word in words.into_iter().filter(|word| marks.at(word).is_none() && scope::helper(word).is_none())
        {
            let name = spelled(word, marks);
            if word.contains(PREFIX) && declared.contains(name.as_ref()) {
                return Err(ClashError::Helper { name: name.into_owned(), target });
            }
            taken.insert(name.into_owned());
        }
        Ok(Self { module, marks, target, taken })
    }

    /// Renames an item; with `with_docs`, its members get their doc comments.
    pub(super) fn item(&self, pieces: &[Piece<'_>], with_docs: bool) -> Result<Item, ClashError> {
        let defines = self.defines(pieces);
        let locals = scope::locals(pieces, self.marks, self.body(defines), &self.taken);
        self.check_hidden(pieces, &locals)?;
        let mut text = String::new();
        let mut documented = HashSet::default();
        for piece in pieces {
            if with_docs
                && let Some(Role::Struct(_)) = defines
                && let Some(Mark { role: Role::Member(ty, i), .. }) = self.marks.at(piece.text)
                && documented.insert(*i)
            {
                let line = text.rfind('\n').map_or(0, |i| i + 1);
                text.insert_str(line, &docs::member(self.module, *ty, *i));
            }
            match piece.kind {
                PieceKind::Word => match locals.get(piece.text) {
                    Some(name) => text.push_str(name),
                    None => text.push_str(&spelled(piece.text, self.marks)),
                },
                PieceKind::Selector => text.push_str(&spelled(piece.text, self.marks)),
                PieceKind::Opaque | PieceKind::Space | PieceKind::Mark => text.push_str(piece.text),
            }
        }
        Ok(Item { text, defines })
    }

    /// What an item defines: the first of the user's module-wide names that is not inside braces and,
    /// for a function, not just the type that it returns.
    fn defines(&self, pieces: &[Piece<'_>]) -> Option<Role> {
        let outer = pieces.iter().take_while(|p| !(p.kind == PieceKind::Mark && matches!(p.text, "{" | "=")));
        let marked = outer.filter(|p| p.kind == PieceKind::Word && p.text.len() == LENGTH);
        let roles: Vec<Role> = marked.filter_map(|p| self.marks.at(p.text)).map(|m| m.role).collect();
        let of_kind = |wanted: fn(&Role) -> bool| roles.iter().copied().find(wanted);
        let is_struct = pieces.iter().find(|p| p.kind == PieceKind::Word).is_some_and(|p| p.text == "struct");
        of_kind(|r| matches!(r, Role::Function(_) | Role::Entry(_)))
            .or_else(|| of_kind(|r| matches!(r, Role::Constant(_) | Role::Global(_))))
            .or_else(|| of_kind(|r| matches!(r, Role::Struct(_))).filter(|_| is_struct))
    }

    /// The function that an item defines, with its module.
    pub(super) fn function(&self, pieces: &[Piece<'_>]) -> Option<(&'a Module, &'a Function)> {
        self.body(self.defines(pieces))
    }

    fn body(&self, role: Option<Role>) -> Option<(&'a Module, &'a Function)> {
        match role? {
            Role::Function(handle) => Some((self.module, &self.module.functions[handle])),
            Role::Entry(index) => Some((self.module, &self.module.entry_points[index].function)),
            Role::Struct(_)
            | Role::Member(..)
            | Role::Constant(_)
            | Role::Global(_)
            | Role::Argument
            | Role::Local => None,
        }
    }

    /// Refuses an item in which one name means two things.
    fn check_hidden(&self, pieces: &[Piece<'_>], locals: &HashMap<&str, String>) -> Result<(), ClashError> {
        let mut meanings: HashMap<Cow<'_, str>, &str> = HashMap::default();
        let mut seen = HashSet::default();
        let is_fixed = |p: &Piece<'_>| p.kind == PieceKind::Word && !locals.contains_key(p.text);
        for piece in pieces.iter().filter(|p| is_fixed(p)) {
            if !seen.insert(piece.text) {
                continue;
            }
            let mark = self.marks.at(piece.text).filter(|_| piece.text.len() == LENGTH);
            if mark.is_some_and(|m| matches!(m.role, Role::Member(..))) {
                continue;
            }
            let name = spelled(piece.text, self.marks);
            if meanings.get(&name).is_some_and(|&other| other != piece.text) {
                let is_function = |m: &&Mark| matches!(m.role, Role::Function(_) | Role::Entry(_));
                let owner = pieces.iter().filter_map(|p| self.marks.at(p.text)).find(is_function);
                let item = owner.map_or_else(|| name.clone().into_owned(), |m| m.exact.clone());
                return Err(ClashError::Hidden { item, name: name.into_owned(), target: self.target });
            }
            meanings.insert(name, piece.text);
        }
        Ok(())
    }
}

/// A word with the declared names in place of the marks inside it.
fn spelled<'w>(word: &'w str, marks: &'w Marks) -> Cow<'w, str> {
    let Some(first) = mark_in(word) else { return Cow::Borrowed(word) };
    match marks.at(word) {
        Some(mark) if word.len() == LENGTH => return Cow::Borrowed(&mark.exact),
        _ => {}
    }
    let (mut out, mut rest, mut next) = (String::new(), word, Some(first));
    while let Some(at) = next {
        out.push_str(&rest[..at]);
        let known = marks.at(&rest[at..]);
        out.push_str(known.map_or(PREFIX, |mark| &mark.exact));
        rest = &rest[at + if known.is_some() { LENGTH } else { PREFIX.len() }..];
        next = mark_in(rest);
    }
    out.push_str(rest);
    Cow::Owned(out)
}

/// Where what may be a mark begins.
fn mark_in(word: &str) -> Option<usize> {
    word.as_bytes().windows(PREFIX.len()).position(|bytes| bytes == PREFIX.as_bytes())
}
