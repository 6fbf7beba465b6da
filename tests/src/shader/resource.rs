//! What an entry point is given: its buffers, textures and samplers.

use super::shape::{MEMBERS, Shape};
use lobe_backends::gpu::BindingKind;
use lobe_backends::interp::IMMEDIATES;
use lobe_codegen::ValidModule;
use naga::{
    AddressSpace, ArraySize, GlobalVariable, Handle, ImageClass, ImageDimension, Module, StorageAccess, Type,
    TypeInner,
};

/// A variable with a binding.
#[derive(Debug, Clone)]
pub struct Resource {
    /// The variable's name, else its type's, else its place.
    pub name: String,
    /// Bind group; of immediates that of [`IMMEDIATES`].
    pub group: u32,
    /// Binding within the group.
    pub binding: u32,
    /// What it is; of a binding array what each element is.
    pub what: What,
    /// How many its variable stands for.
    pub elements: Elements,
    /// Which of them it is, once they are [told apart](Self::each).
    pub element: Option<u32>,
}

/// How many resources a variable stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Elements {
    /// One.
    One,
    /// So many: it is a binding array that says it.
    Known(u32),
    /// As many as are bound: it is a binding array that does not.
    Bound,
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
    /// Its place, as `group:binding`, `group:binding[element]`, or `immediate`.
    #[must_use]
    pub fn place(&self) -> String {
        spelt(place((self.group, self.binding)), self.element)
    }

    /// What a report calls it.
    #[must_use]
    pub fn title(&self) -> String {
        spelt(self.name.clone(), self.element)
    }

    /// Whether a user means it by `name`.
    #[must_use]
    pub fn is_called(&self, name: &str) -> bool {
        is_called(name, &self.name, (self.group, self.binding), self.element)
    }

    /// The element that a user means by `name`, if it names one of this binding array.
    #[must_use]
    pub fn index_in(&self, name: &str) -> Option<u32> {
        let (array, index) = indexed(name)?;
        is_called(array, &self.name, (self.group, self.binding), None).then_some(index)
    }

    /// The elements of a binding array of `count`; of anything else itself.
    #[must_use]
    pub fn each(self, count: u32) -> Vec<Self> {
        match self.elements {
            Elements::One => vec![self],
            Elements::Known(_) | Elements::Bound => {
                (0..count).map(|element| Self { element: Some(element), ..self.clone() }).collect()
            }
        }
    }
}

/// A name, or a place, with the number of an element.
pub(super) fn spelt(name: String, element: Option<u32>) -> String {
    element.map_or(name.clone(), |element| format!("{name}[{element}]"))
}

/// Whether a user means a resource by `wanted`: its name or its place, of an element also those of its array.
pub(super) fn is_called(wanted: &str, name: &str, at: (u32, u32), element: Option<u32>) -> bool {
    let is_meant = |wanted: &str| wanted == name || wanted == place(at);
    let is_element =
        || indexed(wanted).is_some_and(|(array, index)| element == Some(index) && is_meant(array));
    is_meant(wanted) || is_element()
}

/// The name of an array and the number of its element.
fn indexed(name: &str) -> Option<(&str, u32)> {
    let (array, index) = name.strip_suffix(']')?.split_once('[')?;
    Some((array, index.parse().ok()?))
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

/// What a resource may be called.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Called {
    /// Its name.
    pub name: String,
    /// Its place.
    pub place: String,
    /// Whether it has elements.
    pub is_array: bool,
}

impl Called {
    /// Whether a user means it, or one of its elements, by `wanted`.
    #[must_use]
    pub fn is(&self, wanted: &str) -> bool {
        let is_it = |wanted: &str| wanted == self.name || wanted == self.place;
        is_it(wanted) || self.is_array && indexed(wanted).is_some_and(|(array, _)| is_it(array))
    }
}

/// Names and places of all resources of a module, also of those that its entry points do not use.
#[must_use]
pub fn names(module: &Module) -> Vec<Called> {
    let bound = module.global_variables.iter().filter_map(|(_, variable)| {
        let place = place(bound(variable)?);
        let name = named(module, variable).unwrap_or_else(|| place.clone());
        let is_array = elements(module, variable).1 != Elements::One;
        Some(Called { name, place, is_array })
    });
    bound.collect()
}

/// The type of what a variable stands for, and how many of that.
fn elements(module: &Module, variable: &GlobalVariable) -> (Handle<Type>, Elements) {
    match module.types[variable.ty].inner {
        TypeInner::BindingArray { base, size: ArraySize::Constant(count) } => {
            (base, Elements::Known(count.get()))
        }
        // Lengths that overrides state are settled before anything runs.
        TypeInner::BindingArray { base, size: ArraySize::Dynamic | ArraySize::Pending(_) } => {
            (base, Elements::Bound)
        }
        _ => (variable.ty, Elements::One),
    }
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
    let (ty, elements) = elements(module, variable);
    let what = match module.types[ty].inner {
        TypeInner::Image { dim, arrayed, class } => {
            What::Texture { dimension: dim, is_arrayed: arrayed, class }
        }
        TypeInner::Sampler { comparison } => What::Sampler { is_comparison: comparison },
        ref inner => {
            let shape = Shape::of(module, ty).ok_or_else(|| {
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
    Ok(Some(Resource { name, group, binding, what, elements, element: None }))
}

fn named(module: &Module, variable: &GlobalVariable) -> Option<String> {
    let own = variable.name.clone().filter(|n| !n.is_empty());
    own.or_else(|| module.types[variable.ty].name.clone().filter(|n| !n.is_empty()))
}

fn describe(module: &Module, variable: &GlobalVariable) -> String {
    let place = bound(variable).map(|at| format!(" ({})", place(at))).unwrap_or_default();
    format!("`{}`{place}", named(module, variable).unwrap_or_else(|| "a variable without name".to_owned()))
}
