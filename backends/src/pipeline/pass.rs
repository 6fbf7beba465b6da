//! A pass: an entry point, and what its parameters are bound to.

use crate::executor::{Artifacts, ExecError};
use lobe_codegen::ValidModule;
use lobe_codegen::def::FunctionRef;
use lobe_codegen::layout::{self, BufferLayout};
use naga::{AddressSpace, GlobalVariable, StorageAccess, TypeInner};

/// What a pass may do with a buffer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Access {
    /// A small one that is the same for all invocations.
    Uniform,
    /// It reads.
    Read,
    /// It reads and writes.
    ReadWrite,
}

/// A buffer of a pass.
#[derive(Debug, Clone)]
pub struct PassBuffer {
    /// The parameter's name.
    pub name: String,
    /// What the pass does with it.
    pub access: Access,
    /// Where it is bound, and how its elements lie in it.
    pub layout: BufferLayout,
}

/// An entry point, lowered once and shared by all executors.
pub struct Pass {
    name: &'static str,
    module: ValidModule,
    workgroup_size: [u32; 3],
    buffers: Vec<PassBuffer>,
    pub(super) artifacts: Artifacts,
}

impl Pass {
    /// Lowers `kernel` with all that it calls.
    ///
    /// # Errors
    /// When it is no entry point of the kernel language, or binds what has no layout.
    pub fn new(kernel: FunctionRef) -> Result<Self, ExecError> {
        let name = kernel().name;
        let module = lobe_codegen::lower(&[kernel])?;
        let Some(entry) = module.module().entry_points.first() else {
            return Err(ExecError::NoEntryPoint { kernel: name });
        };
        let workgroup_size = entry.workgroup_size;
        let bound = module.module().global_variables.iter().filter(|(_, v)| v.binding.is_some());
        let buffers = bound.map(|(_, variable)| buffer(name, &module, variable)).collect::<Result<_, _>>()?;
        Ok(Self { name, module, workgroup_size, buffers, artifacts: Artifacts::default() })
    }

    pub(super) fn replace_module(&mut self, module: ValidModule) {
        (self.module, self.artifacts) = (module, Artifacts::default());
    }

    /// The entry point's name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// The module of the entry point.
    #[must_use]
    pub fn module(&self) -> &ValidModule {
        &self.module
    }

    /// Invocations of a workgroup.
    #[must_use]
    pub fn workgroup_size(&self) -> [u32; 3] {
        self.workgroup_size
    }

    /// Its buffers.
    #[must_use]
    pub fn buffers(&self) -> &[PassBuffer] {
        &self.buffers
    }

    /// The buffer of this name.
    #[must_use]
    pub fn buffer(&self, name: &str) -> Option<&PassBuffer> {
        self.buffers.iter().find(|buffer| buffer.name == name)
    }

    /// Workgroups for so many invocations along x.
    #[must_use]
    pub fn groups(&self, invocations: u32) -> [u32; 3] {
        [invocations.div_ceil(self.workgroup_size[0].max(1)).max(1), 1, 1]
    }

    pub(super) fn refused(&self, buffer: &str, reason: impl Into<String>) -> ExecError {
        ExecError::Buffer { pass: self.name, buffer: buffer.to_owned(), reason: reason.into() }
    }
}

fn buffer(
    pass: &'static str,
    module: &ValidModule,
    variable: &GlobalVariable,
) -> Result<PassBuffer, ExecError> {
    let name = variable.name.clone().unwrap_or_default();
    let refused = |reason: String| ExecError::Buffer { pass, buffer: name.clone(), reason };
    let access = match variable.space {
        AddressSpace::Uniform => Access::Uniform,
        AddressSpace::Storage { access } if access.contains(StorageAccess::STORE) => Access::ReadWrite,
        AddressSpace::Storage { .. } => Access::Read,
        other => return Err(refused(format!("passes have uniform and storage buffers, not {other:?}"))),
    };
    let element = match module.module().types[variable.ty].inner {
        TypeInner::Array { base, size: naga::ArraySize::Dynamic, .. } => base,
        _ => variable.ty,
    };
    let at = variable.binding.as_ref().map_or((0, 0), |at| (at.group, at.binding));
    let layout =
        layout::buffer(module.module(), element, "", at).map_err(|error| refused(error.to_string()))?;
    Ok(PassBuffer { access, layout, name })
}

impl std::fmt::Debug for Pass {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Pass").field("name", &self.name).finish_non_exhaustive()
    }
}
