//! What an entry point is given: its buffers, textures and samplers.

use super::shape::{MEMBERS, Shape};
use lobe_backends::gpu::BindingKind;
use lobe_backends::interp::IMMEDIATES;
use lobe_codegen::ValidModule;
use naga::{AddressSpace, GlobalVariable, ImageClass, ImageDimension, Module, StorageAccess, TypeInner};

/// A variable with a binding.
#[derive(Debug, Clone)]
pub struct Resource {
    /// The variable's name, else its type's, else its place.
    pub name: String,
    /// Bind group; of immediates that of [`IMMEDIATES`].
    pub group: u32,
    /// Binding within the group.
    pub binding: u32,
    /// What it is.
    pub what: What,
}

/// Kinds of resources.
#[derive(Debug, Clone)]
pub enum What {
    /// Bytes.
    Buffer {
        /// What the shader may do with it.
        kind: BindingKind,
        /// What lies in it.
        shape: Shape,
        /// Bytes that it has at least.
        least: usize,
    },
    /// Texels.
    Texture {
        /// Its axes.
        dimension: ImageDimension,
        /// Whether it is a list of such.
        is_arrayed: bool,
        /// What the shader may do with it.
        class: ImageClass,
    },
    /// A sampler.
    Sampler {
        /// Whether it compares.
        is_comparison: bool,
    },
}

impl Resource {
    /// Its place, as `group:binding`, or `immediate`.
    #[must_use]
    pub fn place(&self) -> String {
        place((self.group, self.binding))
    }

    /// Whether a user means it by `name`.
    #[must_use]
    pub fn is_called(&self, name: &str) -> bool {
        self.name == name || self.place() == name
    }
}

/// A place as a user writes it.
pub(super) fn place((group, binding): (u32, u32)) -> String {
    match (group, binding) {
        IMMEDIATES => "immediate".to_owned(),
        _ => format!("{group}:{binding}"),
    }
}

/// Group and binding of a variable, if it is a resource.
fn bound(variable: &GlobalVariable) -> Option<(u32, u32)> {
    match variable.space {
        AddressSpace::Immediate => Some(IMMEDIATES),
        _ => variable.binding.map(|b| (b.group, b.binding)),
    }
}

/// The resources that entry point `entry` uses, in the order of the module.
///
/// # Errors
/// With the words for one that nothing can be given for.
pub fn of(module: &ValidModule, entry: usize) -> Result<Vec<Resource>, String> {
    let info = module.info().get_entry_point(entry);
    let module = module.module();
    let bound = module.global_variables.iter().filter(|(handle, _)| !info[*handle].is_empty());
    bound.filter_map(|(_, variable)| resource(module, variable).transpose()).collect()
}

/// Names and places of all resources of a module, also of those that its entry points do not use.
#[must_use]
pub fn names(module: &Module) -> Vec<(String, String)> {
    let bound = module.global_variables.iter().filter_map(|(_, variable)| {
        let place = place(bound(variable)?);
        Some((named(module, variable).unwrap_or_else(|| place.clone()), place))
    });
    bound.collect()
}

/// `None` for variables of invocations and workgroups.
fn resource(module: &Module, variable: &GlobalVariable) -> Result<Option<Resource>, String> {
    let kind = match variable.space {
        AddressSpace::Uniform | AddressSpace::Handle | AddressSpace::Immediate => BindingKind::Uniform,
        AddressSpace::Storage { access } if access.contains(StorageAccess::STORE) => {
            BindingKind::StorageReadWrite
        }
        AddressSpace::Storage { .. } => BindingKind::StorageRead,
        AddressSpace::Function | AddressSpace::Private | AddressSpace::WorkGroup => return Ok(None),
        _ => {
            return Err(format!("{}, in the address space {:?}", describe(module, variable), variable.space));
        }
    };
    let Some((group, binding)) = bound(variable) else {
        return Err(format!("{}, a resource without group and binding", describe(module, variable)));
    };
    let what = match module.types[variable.ty].inner {
        TypeInner::Image { dim, arrayed, class } => {
            What::Texture { dimension: dim, is_arrayed: arrayed, class }
        }
        TypeInner::Sampler { comparison } => What::Sampler { is_comparison: comparison },
        ref inner => {
            let shape = Shape::of(module, variable.ty).ok_or_else(|| {
                format!(
                    "{}, whose type has no layout, or more than {MEMBERS} members",
                    describe(module, variable)
                )
            })?;
            let least = inner.try_size(module.to_ctx()).unwrap_or(0) as usize;
            What::Buffer { kind, shape, least: least.next_multiple_of(4).max(4) }
        }
    };
    let name = named(module, variable).unwrap_or_else(|| place((group, binding)));
    Ok(Some(Resource { name, group, binding, what }))
}

fn named(module: &Module, variable: &GlobalVariable) -> Option<String> {
    let own = variable.name.clone().filter(|n| !n.is_empty());
    own.or_else(|| module.types[variable.ty].name.clone().filter(|n| !n.is_empty()))
}

fn describe(module: &Module, variable: &GlobalVariable) -> String {
    let place = bound(variable).map(|at| format!(" ({})", place(at))).unwrap_or_default();
    format!("`{}`{place}", named(module, variable).unwrap_or_else(|| "a variable without name".to_owned()))
}
