//! WGSL.

use super::tidy::{self, Text};
use super::{EmitError, Options, Target, guarded, mark};
use crate::ValidModule;
use naga::back::wgsl::{WriterFlags, write_string};

/// Writes the module as WGSL.
pub(super) fn write(module: &ValidModule, options: &Options) -> Result<String, EmitError> {
    let marked = mark::mark(mark::copy(module.module()));
    let raw = guarded(Target::Wgsl, || write_string(&marked.module, module.info(), WriterFlags::empty()))?;
    let original = (module.module(), &module.meta().definitions);
    tidy::finish(original, &marked.marks, Text::new(&raw), Target::Wgsl, options)
}
