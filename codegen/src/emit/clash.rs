//! What cannot keep its name is refused: a word of some language, or a second item in one scope.

use super::Target;
use super::mark::is_predeclared;
use crate::names::{self, NameError};
use naga::{FastHashMap, Function, Module, TypeInner};
use std::fmt;

/// Why an item cannot have its declared name in every target.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ClashError {
    /// The name is not portable.
    #[error("{item}: {reason}")]
    Refused {
        /// What has the name: "a member of `Sg`".
        item: String,
        /// Why the name is refused.
        reason: NameError,
    },
    /// There is no name.
    #[error("{item} has no name, and emitted items are called by theirs; give it one")]
    Unnamed {
        /// What has none.
        item: String,
    },
    /// Two items of one scope have one name.
    #[error("`{name}` names {first} and {second}; emitted code has one scope for both, so rename one")]
    Twice {
        /// The name.
        name: String,
        /// What has it.
        first: String,
        /// What has it too.
        second: String,
    },
    /// Within a function, the name of a parameter hides something that the function uses.
    #[error(
        "in `{item}`, `{name}` names two things that its {target} code uses: rename the parameter, or the item \
         that it hides"
    )]
    Hidden {
        /// The function.
        item: String,
        /// The name.
        name: String,
        /// Where that happens.
        target: Target,
    },
    /// naga's writer adds a helper of this name.
    #[error("`{name}` is also the name of a helper that naga's {target} writer adds; choose another name")]
    Helper {
        /// The name.
        name: String,
        /// The writer.
        target: Target,
    },
}

/// Checks every name of the module that must be written as it is declared.
pub(super) fn check(module: &Module) -> Result<(), ClashError> {
    let mut scope = Scope::default();
    for (handle, ty) in module.types.iter() {
        if let TypeInner::Struct { members, .. } = &ty.inner
            && !is_predeclared(module, handle)
        {
            let name = scope.claim(ty.name.as_deref(), Item::Structure)?;
            check_members(name, members)?;
        }
    }
    for (_, constant) in module.constants.iter().filter(|(_, c)| c.name.is_some()) {
        scope.claim(constant.name.as_deref(), Item::Constant)?;
    }
    for (_, global) in module.global_variables.iter() {
        scope.claim(global.name.as_deref(), Item::Global)?;
    }
    for (_, function) in module.functions.iter() {
        let name = scope.claim(function.name.as_deref(), Item::Function)?;
        check_arguments(name, function)?;
    }
    for entry in &module.entry_points {
        let name = scope.claim(Some(&entry.name), Item::Entry)?;
        check_arguments(name, &entry.function)?;
    }
    Ok(())
}

fn check_members(owner: &str, members: &[naga::StructMember]) -> Result<(), ClashError> {
    let mut scope = Scope { check: Some(names::check_member), ..Scope::default() };
    for member in members {
        let name = scope.claim(member.name.as_deref(), Item::Member(owner))?;
        if name == owner {
            let first = Item::Structure.to_string();
            let second = "its own member (the constructor, in languages like C++)".to_owned();
            return Err(ClashError::Twice { name: name.to_owned(), first, second });
        }
    }
    Ok(())
}

fn check_arguments(owner: &str, function: &Function) -> Result<(), ClashError> {
    let mut scope = Scope::default();
    for argument in function.arguments.iter().filter(|a| a.name.is_some()) {
        scope.claim(argument.name.as_deref(), Item::Parameter(owner))?;
    }
    Ok(())
}

/// What has a name.
#[derive(Clone, Copy)]
enum Item<'a> {
    Structure,
    /// Of this structure.
    Member(&'a str),
    Constant,
    Global,
    Function,
    /// Of this function.
    Parameter(&'a str),
    Entry,
}

impl fmt::Display for Item<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Structure => f.write_str("a structure"),
            Self::Member(owner) => write!(f, "a member of `{owner}`"),
            Self::Constant => f.write_str("a constant"),
            Self::Global => f.write_str("a global variable"),
            Self::Function => f.write_str("a function"),
            Self::Parameter(owner) => write!(f, "a parameter of `{owner}`"),
            Self::Entry => f.write_str("an entry point"),
        }
    }
}

type Check = fn(&str) -> Result<(), NameError>;

#[derive(Default)]
struct Scope<'a> {
    taken: FastHashMap<&'a str, Item<'a>>,
    check: Option<Check>,
}

impl<'a> Scope<'a> {
    /// Enters an item under its name.
    fn claim(&mut self, name: Option<&'a str>, item: Item<'a>) -> Result<&'a str, ClashError> {
        let Some(name) = name else { return Err(ClashError::Unnamed { item: item.to_string() }) };
        let check = self.check.unwrap_or(names::check);
        check(name).map_err(|reason| ClashError::Refused { item: item.to_string(), reason })?;
        match self.taken.insert(name, item) {
            Some(first) => {
                let (first, second) = (first.to_string(), item.to_string());
                Err(ClashError::Twice { name: name.to_owned(), first, second })
            }
            None => Ok(name),
        }
    }
}
