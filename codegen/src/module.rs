//! A naga module with what naga does not carry: exact literals, truths, definitions, sources.

use crate::def::{FunctionDef, Truth};
use crate::source::Sources;
use naga::valid::ModuleInfo;
use std::collections::HashMap;

/// A module that naga's validator has accepted.
///
/// Only [`crate::validate`] makes one, and nothing that takes one panics on it.
#[derive(Debug, Clone)]
pub struct ValidModule {
    module: naga::Module,
    info: ModuleInfo,
    meta: Meta,
}

impl ValidModule {
    pub(crate) fn new(module: naga::Module, info: ModuleInfo, meta: Meta) -> Self {
        Self { module, info, meta }
    }

    /// The module.
    pub fn module(&self) -> &naga::Module {
        &self.module
    }

    /// What the validator learnt.
    pub fn info(&self) -> &ModuleInfo {
        &self.info
    }

    /// What naga does not carry.
    pub fn meta(&self) -> &Meta {
        &self.meta
    }

    /// The function of this exact name.
    pub fn function(&self, name: &str) -> Option<naga::Handle<naga::Function>> {
        self.module.functions.iter().find(|(_, f)| f.name.as_deref() == Some(name)).map(|(h, _)| h)
    }
}

/// The definitions of functions.
pub type Definitions = HashMap<naga::Handle<naga::Function>, &'static FunctionDef>;

/// Facts about a module beside its IR.
#[derive(Debug, Clone, Default)]
pub struct Meta {
    /// The value that a float literal's decimal text states, where f32 rounds it:
    /// by function (`None` for entry points' bodies and global expressions) and expression.
    pub exact: HashMap<(Scope, naga::Handle<naga::Expression>), f64>,
    /// The exact functions that functions approximate.
    pub truths: HashMap<naga::Handle<naga::Function>, Truth>,
    /// The definition that each function was lowered from.
    pub definitions: Definitions,
    /// The Rust lines that it was lowered from.
    pub sources: Sources,
}

/// The arena that an expression handle belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Scope {
    /// `Module::global_expressions`
    Global,
    /// A function's expressions.
    Function(naga::Handle<naga::Function>),
    /// An entry point's expressions, by index.
    Entry(usize),
}
