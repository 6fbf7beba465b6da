//! WGSL.

use super::tidy::{self, Text};
use super::{EmitError, Options, Target, guarded, mark};
use crate::ValidModule;
use naga::back::wgsl::{Writer, WriterFlags};

/// Writes the module as WGSL.
pub(super) fn write(module: &ValidModule, options: &Options) -> Result<String, EmitError> {
    let marked = mark::mark(mark::copy(module.module()));
    let raw = guarded(Target::Wgsl, || {
        let mut writer = Writer::new(String::with_capacity(super::SIZE), WriterFlags::empty());
        writer.write(&marked.module, module.info())?;
        Ok::<_, naga::back::wgsl::Error>(writer.finish())
    })?;
    let original = (module.module(), &module.meta().definitions);
    tidy::finish(original, &marked.marks, Text::new(&raw), Target::Wgsl, options)
}
