//! The buffers that an entry point is given.

use super::shape::Shape;
use lobe_backends::gpu::BindingKind;
use lobe_codegen::ValidModule;
use naga::{AddressSpace, GlobalVariable, Module, StorageAccess};

/// A buffer, and where the shader expects it.
#[derive(Debug, Clone)]
pub struct Resource {
    /// The variable's name, else its type's, else its place.
    pub name: String,
    /// Bind group.
    pub group: u32,
    /// Binding within the group.
    pub binding: u32,
    /// What the shader may do with it.
    pub kind: BindingKind,
    /// What lies in it.
    pub shape: Shape,
    /// Bytes that it has at least.
    pub least: usize,
}

impl Resource {
    /// Its place, as `group:binding`.
    #[must_use]
    pub fn place(&self) -> String {
        format!("{}:{}", self.group, self.binding)
    }

    /// Whether a user means it by `name`.
    #[must_use]
    pub fn is_called(&self, name: &str) -> bool {
        self.name == name || self.place() == name
    }

    /// Whether the shader may write to it.
    #[must_use]
    pub fn is_writable(&self) -> bool {
        self.kind == BindingKind::StorageReadWrite
    }
}

/// The resources that entry point `entry` uses, in the order of the module.
///
/// # Errors
/// With the words for one that is no buffer.
pub fn of(module: &ValidModule, entry: usize) -> Result<Vec<Resource>, String> {
    let info = module.info().get_entry_point(entry);
    let module = module.module();
    let bound = module.global_variables.iter().filter(|(handle, _)| !info[*handle].is_empty());
    bound.filter_map(|(_, variable)| resource(module, variable).transpose()).collect()
}

/// `None` for variables of invocations and workgroups.
fn resource(module: &Module, variable: &GlobalVariable) -> Result<Option<Resource>, String> {
    let kind = match variable.space {
        AddressSpace::Uniform => BindingKind::Uniform,
        AddressSpace::Storage { access } if access.contains(StorageAccess::STORE) => {
            BindingKind::StorageReadWrite
        }
        AddressSpace::Storage { .. } => BindingKind::StorageRead,
        AddressSpace::Function | AddressSpace::Private | AddressSpace::WorkGroup => return Ok(None),
        AddressSpace::Handle => return Err(format!("{}, a texture or sampler", describe(module, variable))),
        AddressSpace::Immediate => return Err(format!("{}, an immediate", describe(module, variable))),
        _ => {
            return Err(format!("{}, in the address space {:?}", describe(module, variable), variable.space));
        }
    };
    let Some(place) = variable.binding else {
        return Err(format!("{}, a buffer without group and binding", describe(module, variable)));
    };
    let shape = Shape::of(module, variable.ty)
        .ok_or_else(|| format!("{}, whose type has no layout", describe(module, variable)))?;
    let least = module.types[variable.ty].inner.try_size(module.to_ctx()).unwrap_or(0) as usize;
    let name = described(module, variable).unwrap_or_else(|| format!("{}:{}", place.group, place.binding));
    let (group, binding) = (place.group, place.binding);
    Ok(Some(Resource { name, group, binding, kind, shape, least: least.next_multiple_of(4).max(4) }))
}

fn described(module: &Module, variable: &GlobalVariable) -> Option<String> {
    let own = variable.name.clone().filter(|n| !n.is_empty());
    own.or_else(|| module.types[variable.ty].name.clone().filter(|n| !n.is_empty()))
}

fn describe(module: &Module, variable: &GlobalVariable) -> String {
    let place = variable.binding.map(|b| format!(" ({}:{})", b.group, b.binding)).unwrap_or_default();
    format!(
        "`{}`{place}",
        described(module, variable).unwrap_or_else(|| "a variable without name".to_owned())
    )
}
