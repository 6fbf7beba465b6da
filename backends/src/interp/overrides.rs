//! Values for pipeline-overridable constants.

use super::Interpreter;
use super::error::{InterpError, Res};
use super::fast::cache::Cache;
use lobe_codegen::ValidModule;
use lobe_codegen::foreign::{Language, Override, Source, isolate};
use std::borrow::Cow;

impl Interpreter<'_> {
    /// The same, but with these values for overrides, by name or number (`@id`); others have their defaults.
    ///
    /// What does not fit is an error of [`Interpreter::run`].
    #[must_use]
    pub fn with_overrides(self, overrides: Vec<Override>) -> Self {
        Self { overrides, cache: Cache::default(), ..self }
    }

    /// The module in which overrides have their values, and the index of the entry point in it.
    pub(super) fn resolved(&self, entry: usize) -> Res<(Cow<'_, ValidModule>, usize)> {
        let module = self.module.module();
        let point = module.entry_points.get(entry).ok_or(InterpError::NoEntryPoint(entry))?;
        if point.stage != naga::ShaderStage::Compute {
            let what = format!("entry points of stage {:?}", point.stage);
            return Err(InterpError::Unsupported { what, function: point.name.clone(), at: None });
        }
        if module.overrides.is_empty() && self.overrides.is_empty() {
            return Ok((Cow::Borrowed(self.module), entry));
        }
        // Its name is what messages begin with.
        let source = Source { name: point.name.clone(), language: Language::Wgsl, bytes: Vec::new() };
        let resolved = isolate(&source, self.module, &point.name, &self.overrides);
        let resolved = resolved.map_err(|error| InterpError::Override(error.to_string()))?;
        Ok((Cow::Owned(resolved), 0))
    }
}
