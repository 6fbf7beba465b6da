//! A writer's text with the declared names in it.

use super::clash::ClashError;
use super::mark::{Marks, PREFIX, Role};
use super::scan::{Piece, PieceKind};
use super::scope::{self, Taken};
use super::words::{Word, Words};
use super::{Target, docs};
use naga::{FastHashMap as HashMap, FastHashSet as HashSet};
use naga::{Function, Module};
use std::borrow::Cow;

/// Renames the items of one text.
pub(super) struct Renamer<'a> {
    module: &'a Module,
    words: &'a Words<'a>,
    target: Target,
    taken: Taken<'a>,
    /// The name of each word that names a local of the item at hand.
    locals: Vec<Option<Cow<'a, str>>>,
    /// Whether a word was seen in the item at hand.
    seen: Vec<bool>,
}

/// An item as it is printed.
pub(super) struct Item {
    /// Its text.
    pub(super) text: String,
    /// What it defines, when that is the user's.
    pub(super) defines: Option<Role>,
}

impl<'a> Renamer<'a> {
    /// Looks through all words of the text for names that locals must not take.
    pub(super) fn new(
        module: &'a Module,
        marks: &'a Marks,
        target: Target,
        words: &'a Words<'a>,
    ) -> Result<Self, ClashError> {
        let module_wide = marks.iter().filter(|m| m.role.is_module_wide());
        let declared: HashSet<&str> = module_wide.map(|m| m.exact.as_str()).collect();
        let mut taken: Taken<'a> =
            HashSet::with_capacity_and_hasher(declared.len() + words.len(), Default::default());
        taken.extend(declared.iter().map(|&name| Cow::Borrowed(name)));
        let is_others = |w: &&Word<'_>| w.mark.is_none() && scope::helper(w.text).is_none();
        for word in words.iter().filter(|word| word.is_free).filter(is_others) {
            if declared.contains(word.spelled.as_ref()) && word.text.contains(PREFIX) {
                return Err(ClashError::Helper { name: word.spelled.clone().into_owned(), target });
            }
            taken.insert(word.spelled.clone());
        }
        let (locals, seen) = (vec![None; words.len()], vec![false; words.len()]);
        Ok(Self { module, words, target, taken, locals, seen })
    }

    /// Renames an item, which defines this; with `with_docs`, its members get their doc comments.
    pub(super) fn item(
        &mut self,
        pieces: &[Piece<'_>],
        defines: Option<Role>,
        with_docs: bool,
    ) -> Result<Item, ClashError> {
        let distinct = self.distinct(pieces);
        for (word, name) in scope::locals(&distinct, self.words, self.body(defines), &self.taken) {
            self.locals[word as usize] = Some(name);
        }
        self.check_hidden(pieces, &distinct)?;
        let text = match defines {
            Some(Role::Struct(_)) if with_docs => self.with_docs(pieces),
            _ => self.text(pieces),
        };
        distinct.iter().for_each(|&word| self.locals[word as usize] = None);
        Ok(Item { text, defines })
    }

    /// The words that name something in an item, in order of appearance.
    fn distinct(&mut self, pieces: &[Piece<'_>]) -> Vec<u32> {
        let mut distinct = Vec::new();
        for piece in pieces.iter().filter(|piece| piece.kind == PieceKind::Word) {
            if !std::mem::replace(&mut self.seen[piece.word as usize], true) {
                distinct.push(piece.word);
            }
        }
        distinct.iter().for_each(|&word| self.seen[word as usize] = false);
        distinct
    }

    fn text(&self, pieces: &[Piece<'_>]) -> String {
        // Names are about as long as marks, and pieces have three characters or so.
        let mut text = String::with_capacity(4 * pieces.len());
        pieces.iter().for_each(|piece| text.push_str(self.name(piece)));
        text
    }

    /// What is written for a piece.
    fn name<'p>(&'p self, piece: &Piece<'p>) -> &'p str {
        let word = piece.word as usize;
        match piece.kind {
            PieceKind::Word => self.locals[word].as_deref().unwrap_or(&self.words.at(piece.word).spelled),
            PieceKind::Selector => &self.words.at(piece.word).spelled,
            PieceKind::Opaque | PieceKind::Space | PieceKind::Mark => piece.text,
        }
    }

    /// The text of a structure, with the doc comments of its members.
    fn with_docs(&self, pieces: &[Piece<'_>]) -> String {
        let mut text = String::new();
        let mut documented = HashSet::default();
        for piece in pieces {
            if let Some(Role::Member(ty, i)) = self.words.of(piece).and_then(|word| word.role())
                && documented.insert(i)
            {
                let line = text.rfind('\n').map_or(0, |i| i + 1);
                text.insert_str(line, &docs::member(self.module, ty, i));
            }
            text.push_str(self.name(piece));
        }
        text
    }

    /// What an item defines: the first of the user's module-wide names that is not inside braces and,
    /// for a function, not just the type that it returns.
    pub(super) fn defines(&self, pieces: &[Piece<'_>]) -> Option<Role> {
        let outer = pieces.iter().take_while(|p| !(p.kind == PieceKind::Mark && matches!(p.text, "{" | "=")));
        let words = outer.filter(|p| p.kind == PieceKind::Word).map(|p| self.words.at(p.word));
        let roles: Vec<Role> =
            words.filter(|word| word.is_whole_mark()).filter_map(|word| word.role()).collect();
        let of_kind = |wanted: fn(&Role) -> bool| roles.iter().copied().find(wanted);
        let is_struct = pieces.iter().find(|p| p.kind == PieceKind::Word).is_some_and(|p| p.text == "struct");
        of_kind(|r| matches!(r, Role::Function(_) | Role::Entry(_)))
            .or_else(|| of_kind(|r| matches!(r, Role::Constant(_) | Role::Global(_))))
            .or_else(|| of_kind(|r| matches!(r, Role::Struct(_))).filter(|_| is_struct))
    }

    /// The function that is defined, if one is.
    pub(super) fn body(&self, defined: Option<Role>) -> Option<(&'a Module, &'a Function)> {
        match defined? {
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
    fn check_hidden(&self, pieces: &[Piece<'_>], distinct: &[u32]) -> Result<(), ClashError> {
        let mut meanings: HashMap<&str, u32> = HashMap::default();
        for &number in distinct.iter().filter(|&&number| self.is_fixed(number)) {
            let name = self.words.at(number).spelled.as_ref();
            if meanings.insert(name, number).is_some() {
                let is_function = |role: &Role| matches!(role, Role::Function(_) | Role::Entry(_));
                let mut words = pieces.iter().filter_map(|piece| self.words.of(piece));
                let owner = words.find(|word| word.role().as_ref().is_some_and(is_function));
                let item = owner.and_then(|word| word.mark).map_or(name, |mark| &mark.exact).to_owned();
                return Err(ClashError::Hidden { item, name: name.to_owned(), target: self.target });
            }
        }
        Ok(())
    }

    /// Whether a word keeps a name in the item at hand that another word has too.
    fn is_fixed(&self, number: u32) -> bool {
        let word = self.words.at(number);
        let is_member = || word.is_whole_mark() && matches!(word.role(), Some(Role::Member(..)));
        word.is_shared && self.locals[number as usize].is_none() && !is_member()
    }
}
