//! Code that was linked already.

use super::super::error::Res;
use super::super::program::Program;
use super::{Code, Isa, LANES};
use lobe_codegen::module::Scope;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// The code of a module's functions and entry points, linked when first asked for; clones share it.
#[derive(Clone, Default)]
pub(in super::super) struct Cache(Arc<Mutex<Known>>);

type Known = HashMap<(Scope, Isa), Arc<Code<LANES>>>;

impl Cache {
    /// The code of a function or entry point, which `lower` lowers. A batch may hold several workgroups, unless these are
    /// cooperative.
    ///
    /// # Errors
    /// Those of `lower`, and operations without a form.
    pub(in super::super) fn get(
        &self,
        scope: Scope,
        isa: Isa,
        lower: impl FnOnce() -> Res<Program>,
    ) -> Res<Arc<Code<LANES>>> {
        let known = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(code) = known().get(&(scope, isa)) {
            return Ok(Arc::clone(code));
        }
        let program = lower()?;
        let packed = matches!(scope, Scope::Entry(_)) && !program.cooperative;
        let code = Arc::new(link(program, packed, isa)?);
        known().insert((scope, isa), Arc::clone(&code));
        Ok(code)
    }
}

/// All forms of all operations hang on this function: where it is not generic they are compiled once, not again in each
/// crate that runs programs.
#[inline(never)]
fn link(program: Program, packed: bool, isa: Isa) -> Res<Code<LANES>> {
    Code::new(program, packed, isa)
}

impl std::fmt::Debug for Cache {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Cache")
    }
}
