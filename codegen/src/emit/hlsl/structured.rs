//! Structured buffers, where naga has words without a type.
//!
//! naga reads every storage buffer as a `ByteAddressBuffer`, word by word at places that it computes.
//! An author writes `StructuredBuffer<Sg> lobes` and `lobes[row]`, which compilers also make less of.
//! naga writes just that of an array in private memory; so it is given one, and its declaration then becomes the
//! buffer's.
//!
//! Only arrays whose elements lie alike by the rules of WGSL, D3D and Vulkan are: 32-bit numbers, vectors of them,
//! structures and arrays of these without gaps that naga does not fill.
//! A vector of three takes the room of four, so the buffer's elements are vectors of four.

mod stores;

use crate::emit::mark::{self, Marks, Role};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{
    AddressSpace, ArraySize, Expression, Function, GlobalVariable, Handle, Module, ResourceBinding,
    StorageAccess, Type, TypeInner, VectorSize,
};
use std::collections::BTreeMap;

/// Elements of the arrays that stand in: naga knows no type larger than a gigabyte.
const LARGEST: u32 = 0x3fff_ffff;

/// What is known of a module with arrays for buffers.
pub(super) struct Structured {
    pub(super) info: ModuleInfo,
    buffers: BTreeMap<Handle<GlobalVariable>, Buffer>,
}

/// What a declaration becomes.
#[derive(Debug)]
pub(super) struct Buffer {
    is_written: bool,
    /// Whether its elements are vectors of three.
    pub(super) is_wider: bool,
    /// What comes behind its name: ` : register(u0);`.
    pub(super) place: String,
}

impl Buffer {
    /// What HLSL calls such buffers.
    pub(super) fn kind(&self) -> &'static str {
        if self.is_written { "RWStructuredBuffer" } else { "StructuredBuffer" }
    }
}

/// A copy of the module, with arrays for the buffers that can be structured ones; `None` when there are none.
pub(super) fn of(original: &Module) -> Option<(Module, Structured)> {
    let candidate = |(handle, variable)| Some((handle, buffer(original, variable)?));
    let mut found: BTreeMap<_, _> = original.global_variables.iter().filter_map(candidate).collect();
    if found.is_empty() {
        return None;
    }
    let misused = misused(original);
    found.retain(|handle, _| !misused.contains(handle));
    let mut module = mark::copy(original);
    for (&handle, (_, element, stride)) in &found {
        let count = std::num::NonZeroU32::new(LARGEST / *stride)?;
        let inner = TypeInner::Array { base: *element, size: ArraySize::Constant(count), stride: *stride };
        let ty = module.types.insert(Type { name: None, inner }, naga::Span::UNDEFINED);
        let standing_in = module.global_variables.get_mut(handle);
        (standing_in.ty, standing_in.space, standing_in.binding) = (ty, AddressSpace::Private, None);
    }
    stores::by_member(&mut module, |global| found.contains_key(&global));
    let info = crate::guard::quietly(|| validated(&module)).ok()??;
    let buffers = found.into_iter().map(|(handle, (buffer, ..))| (handle, buffer)).collect();
    Some((module, Structured { info, buffers }))
}

/// What the writer wants to know of the module.
///
/// Private memory is not uniform, which read-only buffers are; the module itself was found to be sound.
fn validated(module: &Module) -> Option<ModuleInfo> {
    let flags = ValidationFlags::all() - ValidationFlags::CONTROL_FLOW_UNIFORMITY;
    Validator::new(flags, Capabilities::all()).validate(module).ok()
}

/// What `variable` becomes, with the type and the stride of its elements; `None` if it stays as it is.
fn buffer(module: &Module, variable: &GlobalVariable) -> Option<(Buffer, Handle<Type>, u32)> {
    let AddressSpace::Storage { access } = variable.space else { return None };
    let TypeInner::Array { base, size: ArraySize::Dynamic, stride } = module.types[variable.ty].inner else {
        return None;
    };
    let is_wider = is_vector_of_three(module, base);
    // HLSL has no name for a type of arrays.
    let has_name = !matches!(module.types[base].inner, TypeInner::Array { .. });
    let fits = is_wider || (has_name && size(module, base) == Some(stride));
    let is_written = access.contains(StorageAccess::STORE);
    let place = place(variable.binding?, is_written);
    fits.then_some((Buffer { is_written, is_wider, place }, base, stride))
}

fn place(binding: ResourceBinding, is_written: bool) -> String {
    let register = if is_written { 'u' } else { 't' };
    let space = if binding.group == 0 { String::new() } else { format!(", space{}", binding.group) };
    format!(" : register({register}{}{space});", binding.binding)
}

fn is_vector_of_three(module: &Module, ty: Handle<Type>) -> bool {
    matches!(module.types[ty].inner, TypeInner::Vector { size: VectorSize::Tri, scalar } if scalar.width == 4)
}

/// The bytes of a value of `ty` packed word by word, as HLSL packs what naga declares; `None` if WGSL lays it out
/// otherwise.
fn size(module: &Module, ty: Handle<Type>) -> Option<u32> {
    let of_scalar = |scalar: naga::Scalar| {
        (scalar.width == 4 && scalar.kind != naga::ScalarKind::Bool).then_some(u32::from(scalar.width))
    };
    match module.types[ty].inner {
        TypeInner::Scalar(scalar) => of_scalar(scalar),
        TypeInner::Vector { size, scalar } => of_scalar(scalar).map(|width| width * size as u32),
        TypeInner::Array { base, size: ArraySize::Constant(count), stride } => {
            (size(module, base)? == stride).then_some(stride * count.get())
        }
        TypeInner::Struct { ref members, span } => {
            // Between members, and behind the last, naga declares the words that are missing.
            members.iter().all(|member| size(module, member.ty).is_some()).then_some(span)
        }
        _ => None,
    }
}

/// Variables that are used otherwise than by reading and writing at a place within them.
fn misused(module: &Module) -> Vec<Handle<GlobalVariable>> {
    let is_pointer = |ty: Handle<Type>| {
        matches!(
            module.types[ty].inner,
            TypeInner::Pointer { space: AddressSpace::Storage { .. }, .. }
                | TypeInner::ValuePointer { space: AddressSpace::Storage { .. }, .. }
        )
    };
    let mut functions = module.functions.iter().map(|(_, function)| function);
    if functions.any(|function| function.arguments.iter().any(|argument| is_pointer(argument.ty))) {
        return module.global_variables.iter().map(|(handle, _)| handle).collect();
    }
    let functions = module.functions.iter().map(|(_, function)| function);
    let entries = module.entry_points.iter().map(|entry| &entry.function);
    functions.chain(entries).flat_map(misused_in).collect()
}

fn misused_in(function: &Function) -> Vec<Handle<GlobalVariable>> {
    let array = |expression: &Expression| match *expression {
        Expression::ArrayLength(array) => Some(array),
        _ => None,
    };
    let mut arrays = function.expressions.iter().filter_map(|(_, expression)| array(expression)).peekable();
    // Most functions ask for no lengths.
    match arrays.peek() {
        Some(_) => {
            let within = within(function);
            arrays.filter_map(|array| within[array.index()]).collect()
        }
        None => Vec::new(),
    }
}

/// The variable that each expression points into, if it points into one.
fn within(function: &Function) -> Vec<Option<Handle<GlobalVariable>>> {
    let mut within = vec![None; function.expressions.len()];
    for (handle, expression) in function.expressions.iter() {
        within[handle.index()] = match *expression {
            Expression::GlobalVariable(global) => Some(global),
            Expression::Access { base, .. } | Expression::AccessIndex { base, .. } => within[base.index()],
            _ => None,
        };
    }
    within
}

impl Structured {
    /// The buffer that the array with this mark stands for.
    pub(super) fn buffer(&self, word: &str, marks: &Marks) -> Option<&Buffer> {
        match marks.at(word)?.role {
            Role::Global(global) => self.buffers.get(&global),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::emit::{Options, Target, emit};
    use crate::validate::from_wgsl;

    fn hlsl(text: &str) -> String {
        let options = Options { docs: false, header: false, ..Options::default() };
        let artifact = emit(&from_wgsl(text).unwrap(), Target::Hlsl, &options).unwrap();
        artifact.content.text().unwrap().to_owned()
    }

    #[test]
    fn arrays_of_structures_are_structured() {
        let text = hlsl(
            "struct Lobe { axis: vec3f, sharpness: f32, tint: vec2f }
            @group(0) @binding(0) var<storage> lobes: array<Lobe>;
            @group(1) @binding(7) var<storage, read_write> sums: array<f32>;
            @compute @workgroup_size(64) fn total(@builtin(global_invocation_id) id: vec3u) {
                let lobe = lobes[id.x];
                sums[id.x] = lobe.sharpness + lobes[id.x + 1u].axis.y + lobe.tint.x;
            }",
        );
        for part in [
            "StructuredBuffer<Lobe> lobes : register(t0);",
            "RWStructuredBuffer<float> sums : register(u7, space1);",
            "Lobe lobe = lobes[id.x];",
            "lobes[id.x + 1u].axis.y",
            "sums[id.x] = lobe.sharpness + ",
        ] {
            assert!(text.contains(part), "{part}\n{text}");
        }
        assert!(!text.contains("static") && !text.contains("Construct"), "{text}");
    }

    #[test]
    fn vectors_of_three_lie_in_the_room_of_four() {
        let text = hlsl(
            "@group(0) @binding(0) var<storage> starts: array<vec3f>;
            @group(0) @binding(1) var<storage, read_write> places: array<vec3u>;
            @compute @workgroup_size(64) fn copy_all(@builtin(global_invocation_id) id: vec3u) {
                places[places[id.x].y] = vec3u(starts[id.x + 2u]);
                places[id.y].z = 7u;
            }",
        );
        for part in [
            "StructuredBuffer<float4> starts : register(t0);",
            "RWStructuredBuffer<uint4> places : register(u1);",
            "uint places_1 = places[id.x].y;",
            "places[places_1].xyz = ",
            "starts[id.x + 2u].xyz",
            "places[id.y].z = 7u;",
        ] {
            assert!(text.contains(part), "{part}\n{text}");
        }
    }

    #[test]
    fn words_that_only_fill_a_structure_are_not_written() {
        let text = hlsl(
            "struct Lobe { axis: vec3f, sharpness: f32, log_amplitude: f32 }
            struct Full { axis: vec3f, sharpness: f32 }
            @group(0) @binding(0) var<storage, read_write> lobes: array<Lobe>;
            @group(0) @binding(1) var<storage, read_write> full: array<Full>;
            @compute @workgroup_size(64) fn move_down(@builtin(global_invocation_id) id: vec3u) {
                if id.x > 0u {
                    let lobe = lobes[id.x];
                    lobes[id.x - 1u] = lobe;
                    full[id.x] = full[id.y];
                }
            }",
        );
        for part in [
            "lobes[id.x - 1u].axis = lobe.axis;",
            "lobes[id.x - 1u].sharpness = lobe.sharpness;",
            "lobes[id.x - 1u].log_amplitude = lobe.log_amplitude;",
            "full[id.x] = ",
        ] {
            assert!(text.contains(part), "{part}\n{text}");
        }
    }

    #[test]
    fn what_lies_otherwise_or_is_measured_stays_as_words() {
        let text = hlsl(
            "struct Turned { by: mat3x3f }
            struct Gaps { rows: array<vec3f, 2> }
            struct Rows { rows: array<vec4f, 2> }
            @group(0) @binding(0) var<storage> turned: array<Turned>;
            @group(0) @binding(1) var<storage> gaps: array<Gaps>;
            @group(0) @binding(2) var<storage> measured: array<f32>;
            @group(0) @binding(3) var<storage, read_write> counts: array<atomic<u32>>;
            @group(0) @binding(4) var<storage> lists: array<array<f32, 4>>;
            @group(0) @binding(5) var<storage> tables: array<Rows>;
            @compute @workgroup_size(64) fn look(@builtin(global_invocation_id) id: vec3u) {
                if turned[0].by[1].x + gaps[1].rows[1].x > measured[arrayLength(&measured) - 1u] {
                    let list = lists[id.x];
                    atomicAdd(&counts[id.x], u32(list[1] + tables[id.y].rows[1].z));
                }
            }",
        );
        for name in ["turned", "gaps", "measured", "counts", "lists"] {
            assert!(text.contains(&format!("ByteAddressBuffer {name} ")), "{name}\n{text}");
        }
        assert!(text.contains("StructuredBuffer<Rows> tables "), "{text}");
    }
}
