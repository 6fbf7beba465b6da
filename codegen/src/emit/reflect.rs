//! What a host must know to use an artifact, as data that prints as JSON.
//!
//! Types are spelled as in WGSL; sizes, offsets and strides are bytes.
//! `tests/schema/reflection-1.json` describes the JSON.
//! Order is the module's everywhere, so that the same module gives the same bytes.

mod spell;

use super::docs;
use super::mark::{Role, is_predeclared};
use crate::ValidModule;
use naga::{AddressSpace, Handle, Module, StorageAccess, TypeInner};
use serde::Serialize;
pub use spell::{ConstantWords, type_name};

/// Version of the form of [`Reflection`]; it grows when a reader of the former one would be misled.
pub const SCHEMA: u32 = 1;

/// A module as its host sees it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Reflection {
    /// [`SCHEMA`]
    pub schema: u32,
    /// The maker and its version.
    pub generator: String,
    /// Structures.
    pub structs: Vec<StructInfo>,
    /// Named constants.
    pub constants: Vec<ConstantInfo>,
    /// Functions.
    pub functions: Vec<FunctionInfo>,
    /// Entry points.
    pub entries: Vec<EntryPointInfo>,
}

/// A structure.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StructInfo {
    /// Its name.
    pub name: String,
    /// Doc comment, a line an item.
    pub docs: Vec<String>,
    /// Bytes, padding at the end included.
    pub size: u32,
    /// Alignment in buffers.
    pub align: u32,
    /// Its members.
    pub members: Vec<MemberInfo>,
}

/// A member of a structure.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MemberInfo {
    /// Its name.
    pub name: String,
    /// Doc comment.
    pub docs: Vec<String>,
    /// Its type.
    #[serde(rename = "type")]
    pub ty: String,
    /// Bytes from the structure's start.
    pub offset: u32,
    /// Bytes.
    pub size: u32,
}

/// A named constant.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ConstantInfo {
    /// Its name.
    pub name: String,
    /// Doc comment.
    pub docs: Vec<String>,
    /// Its type.
    #[serde(rename = "type")]
    pub ty: String,
    /// Its value; `null` when it is computed.
    pub value: Option<ConstantWords>,
}

/// A function.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FunctionInfo {
    /// Its name.
    pub name: String,
    /// Doc comment.
    pub docs: Vec<String>,
    /// Its parameters.
    pub parameters: Vec<ParameterInfo>,
    /// The type that it returns; `null` when it returns nothing.
    pub returns: Option<String>,
}

/// A parameter.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ParameterInfo {
    /// Its name.
    pub name: String,
    /// Its type.
    #[serde(rename = "type")]
    pub ty: String,
}

/// An entry point.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EntryPointInfo {
    /// Its name.
    pub name: String,
    /// Doc comment.
    pub docs: Vec<String>,
    /// Invocations in a workgroup.
    pub workgroup_size: [u32; 3],
    /// The resources that it uses, by group and binding.
    pub bindings: Vec<BindingInfo>,
}

/// A resource.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BindingInfo {
    /// Its name.
    pub name: String,
    /// Bind group; also HLSL's space.
    pub group: u32,
    /// Binding; also HLSL's register.
    pub binding: u32,
    /// `uniform`, `read` or `read_write`.
    pub access: &'static str,
    /// Its type.
    #[serde(rename = "type")]
    pub ty: String,
    /// Bytes from one element to the next, for arrays.
    pub stride: Option<u32>,
}

impl Reflection {
    /// As JSON, indented, with a line break at the end.
    ///
    /// # Errors
    /// When a number in it has no JSON form; those of valid modules all have.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string_pretty(self).map(|text| text + "\n")
    }
}

/// What a host must know about `module`.
///
/// ```
/// use lobe_codegen::emit::reflect;
/// use lobe_codegen::prelude::*;
///
/// /// A light.
/// #[kernel]
/// pub struct Light {
///     /// Where it is.
///     pub position: Vec3,
///     /// How strong it is.
///     pub power: f32,
/// }
///
/// /// Irradiance at the origin.
/// #[kernel]
/// pub fn irradiance(light: Light) -> f32 {
///     light.power / dot(light.position, light.position)
/// }
///
/// let reflection = reflect(&lobe_codegen::lower(&lobe_codegen::kernels![irradiance])?);
/// let light = &reflection.structs[0];
/// assert_eq!((light.members[1].name.as_str(), light.members[1].offset, light.size), ("power", 12, 16));
/// assert_eq!(reflection.functions[0].returns.as_deref(), Some("f32"));
/// assert!(reflection.to_json()?.contains("\"docs\": [\n        \"A light.\"\n      ]"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn reflect(module: &ValidModule) -> Reflection {
    let naga = module.module();
    Reflection {
        schema: SCHEMA,
        generator: format!("lobe {}", env!("CARGO_PKG_VERSION")),
        structs: structs(naga),
        constants: constants(naga),
        functions: naga.functions.iter().map(|(handle, f)| function(naga, handle, f)).collect(),
        entries: (0..naga.entry_points.len()).map(|index| entry(module, index)).collect(),
    }
}

fn structs(module: &Module) -> Vec<StructInfo> {
    let mut layouter = naga::proc::Layouter::default();
    // A type that cannot be laid out (none of a valid module) leaves those behind it out.
    let is_laid_out = layouter.update(module.to_ctx()).is_ok();
    let mut out = Vec::new();
    for (handle, ty) in module.types.iter().filter(|(h, _)| is_laid_out && !is_predeclared(module, *h)) {
        let TypeInner::Struct { members, span } = &ty.inner else { continue };
        let member = |(i, m): (usize, &naga::StructMember)| MemberInfo {
            name: m.name.clone().unwrap_or_default(),
            docs: docs::plain(module, Role::Member(handle, i)),
            ty: type_name(module, m.ty),
            offset: m.offset,
            size: layouter[m.ty].size,
        };
        out.push(StructInfo {
            name: ty.name.clone().unwrap_or_default(),
            docs: docs::plain(module, Role::Struct(handle)),
            size: *span,
            align: layouter[handle].alignment.round_up(1),
            members: members.iter().enumerate().map(member).collect(),
        });
    }
    out
}

fn constants(module: &Module) -> Vec<ConstantInfo> {
    let named = module.constants.iter().filter_map(|(h, c)| Some((h, c, c.name.clone()?)));
    named
        .map(|(handle, constant, name)| ConstantInfo {
            name,
            docs: docs::plain(module, Role::Constant(handle)),
            ty: type_name(module, constant.ty),
            value: spell::constant(module, constant.init),
        })
        .collect()
}

fn function(module: &Module, handle: Handle<naga::Function>, function: &naga::Function) -> FunctionInfo {
    let parameter = |a: &naga::FunctionArgument| ParameterInfo {
        name: a.name.clone().unwrap_or_default(),
        ty: type_name(module, a.ty),
    };
    FunctionInfo {
        name: function.name.clone().unwrap_or_default(),
        docs: docs::plain(module, Role::Function(handle)),
        parameters: function.arguments.iter().map(parameter).collect(),
        returns: function.result.as_ref().map(|r| type_name(module, r.ty)),
    }
}

fn entry(module: &ValidModule, index: usize) -> EntryPointInfo {
    let naga = module.module();
    let point = &naga.entry_points[index];
    let uses = module.info().get_entry_point(index);
    let used = naga.global_variables.iter().filter(|(handle, _)| !uses[*handle].is_empty());
    let mut bindings: Vec<BindingInfo> = used.filter_map(|(_, global)| binding(naga, global)).collect();
    bindings.sort_by_key(|b| (b.group, b.binding));
    EntryPointInfo {
        name: point.name.clone(),
        docs: docs::plain(naga, Role::Entry(index)),
        workgroup_size: point.workgroup_size,
        bindings,
    }
}

fn binding(module: &Module, global: &naga::GlobalVariable) -> Option<BindingInfo> {
    let place = global.binding?;
    let access = match global.space {
        AddressSpace::Storage { access } if access.contains(StorageAccess::STORE) => "read_write",
        AddressSpace::Storage { .. } => "read",
        AddressSpace::Uniform => "uniform",
        _ => "handle",
    };
    let stride = match module.types[global.ty].inner {
        TypeInner::Array { stride, .. } => Some(stride),
        _ => None,
    };
    Some(BindingInfo {
        name: global.name.clone().unwrap_or_default(),
        group: place.group,
        binding: place.binding,
        access,
        ty: type_name(module, global.ty),
        stride,
    })
}
