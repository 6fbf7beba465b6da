//! Entry points over buffers.
//!
//! The invocations of a workgroup are the lanes of one batch, so a barrier needs nothing but all of them.

use super::error::{InterpError, Res};
use super::exec::{Machine, Value};
use super::layout::{Packing, Pointee, Types};
use super::leaf::Leaf;
use super::mask::Mask;
use super::memory::{Root, Shared};
use super::strict::Strict;
use lobe_codegen::ValidModule;
use lobe_codegen::module::Scope;
use naga::{AddressSpace, Binding, BuiltIn, GlobalVariable, Handle, TypeInner};

/// Bytes bound to a resource, laid out as WGSL lays out its type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Buffer {
    /// Bind group.
    pub group: u32,
    /// Binding within the group.
    pub binding: u32,
    /// The bytes.
    pub data: Vec<u8>,
}

/// One dispatch.
struct Dispatch<'m> {
    module: &'m ValidModule,
    fuel: u64,
    entry: usize,
    size: [u32; 3],
    groups: [u32; 3],
}

pub(super) fn run(
    module: &ValidModule,
    fuel: u64,
    entry: usize,
    groups: [u32; 3],
    buffers: &mut [Buffer],
) -> Res<()> {
    let point = module.module().entry_points.get(entry).ok_or(InterpError::NoEntryPoint(entry))?;
    if point.stage != naga::ShaderStage::Compute || point.workgroup_size_overrides.is_some() {
        let what = "an entry point that is no compute shader of fixed workgroup size".to_owned();
        return Err(InterpError::Unsupported { what, function: point.name.clone() });
    }
    let dispatch = Dispatch { module, fuel, entry, size: point.workgroup_size, groups };
    let bound = dispatch.bind(buffers)?;
    let mut words: Vec<Shared> = bound.iter().map(|(_, index)| to_words(&buffers[*index].data)).collect();
    for z in 0..groups[2] {
        for y in 0..groups[1] {
            for x in 0..groups[0] {
                dispatch.workgroup([x, y, z], &bound, &mut words)?;
            }
        }
    }
    for ((_, index), shared) in bound.iter().zip(words) {
        from_words(&shared, &mut buffers[*index].data);
    }
    Ok(())
}

fn to_words(bytes: &[u8]) -> Shared {
    let word = |chunk: &[u8; 4]| u32::from_le_bytes(*chunk);
    Shared { words: bytes.as_chunks().0.iter().map(word).collect(), packing: Packing::Host }
}

fn from_words(shared: &Shared, bytes: &mut [u8]) {
    for (chunk, word) in bytes.chunks_exact_mut(4).zip(&shared.words) {
        chunk.copy_from_slice(&word.to_le_bytes());
    }
}

impl<'m> Dispatch<'m> {
    /// The buffer of each resource that the entry point uses.
    fn bind(&self, buffers: &[Buffer]) -> Res<Vec<(Handle<GlobalVariable>, usize)>> {
        let module = self.module.module();
        let info = self.module.info().get_entry_point(self.entry);
        let mut bound = Vec::new();
        for (handle, variable) in module.global_variables.iter() {
            let Some(resource) = variable.binding.filter(|_| !info[handle].is_empty()) else {
                continue;
            };
            let name = || variable.name.clone().unwrap_or_default();
            let (group, binding) = (resource.group, resource.binding);
            let index = buffers
                .iter()
                .position(|b| (b.group, b.binding) == (group, binding))
                .ok_or_else(|| InterpError::MissingBuffer { name: name(), group, binding })?;
            let expected = module.types[variable.ty].inner.try_size(module.to_ctx()).unwrap_or(0) as usize;
            let found = buffers[index].data.len();
            if found < expected {
                return Err(InterpError::BufferTooSmall { name: name(), expected, found });
            }
            bound.push((handle, index));
        }
        Ok(bound)
    }

    fn lanes(&self) -> usize {
        self.size.iter().map(|n| *n as usize).product()
    }

    /// Runs one workgroup.
    fn workgroup(
        &self,
        group: [u32; 3],
        bound: &[(Handle<GlobalVariable>, usize)],
        buffers: &mut Vec<Shared>,
    ) -> Res<()> {
        let mut machine = Machine::new(self.module, Strict, self.lanes(), self.fuel)?;
        machine.workgroup = true;
        machine.memory.shared = std::mem::take(buffers);
        for (id, (handle, _)) in bound.iter().enumerate() {
            machine.globals[handle.index()] = Some(Root::Shared(id));
        }
        self.workgroup_memory(&mut machine)?;
        let arguments = self.arguments(group)?;
        machine.invoke(Scope::Entry(self.entry), arguments, Mask::all(self.lanes()))?;
        machine.memory.shared.truncate(bound.len());
        *buffers = machine.memory.shared;
        Ok(())
    }

    /// Adds the workgroup variables, all zero.
    fn workgroup_memory(&self, machine: &mut Machine<'m, Strict>) -> Res<()> {
        let module = self.module.module();
        let info = self.module.info().get_entry_point(self.entry);
        for (handle, variable) in module.global_variables.iter() {
            if variable.space == AddressSpace::WorkGroup && !info[handle].is_empty() {
                let units = Types(&module.types).count(Pointee::Type(variable.ty))?;
                let shared = Shared { words: vec![0; units as usize], packing: Packing::Packed };
                machine.memory.shared.push(shared);
                machine.globals[handle.index()] = Some(Root::Shared(machine.memory.shared.len() - 1));
            }
        }
        Ok(())
    }

    /// Values of the entry point's parameters: built-ins, or structures of them.
    fn arguments(&self, group: [u32; 3]) -> Res<Vec<Value<Strict>>> {
        let module = self.module.module();
        let function = &module.entry_points[self.entry].function;
        function
            .arguments
            .iter()
            .map(|argument| match (&argument.binding, &module.types[argument.ty].inner) {
                (Some(binding), _) => Ok(Value::data(self.builtin(binding, group)?)),
                (None, TypeInner::Struct { members, .. }) => {
                    let bindings = members.iter().filter_map(|m| m.binding.as_ref());
                    let leaves = bindings.map(|b| self.builtin(b, group)).collect::<Res<Vec<_>>>()?;
                    Ok(Value::data(leaves.concat()))
                }
                (None, _) => Err(InterpError::Malformed("a parameter of an entry point has no binding")),
            })
            .collect()
    }

    fn builtin(&self, binding: &Binding, group: [u32; 3]) -> Res<Vec<Leaf<Strict>>> {
        let [w, h, _] = self.size;
        let local = |lane: u32| [lane % w, lane / w % h, lane / (w * h)];
        let each = |f: &dyn Fn(u32) -> u32| Leaf::from_words((0..self.lanes() as u32).map(f).collect());
        let vector = |f: &dyn Fn(u32, usize) -> u32| (0..3).map(|i| each(&|lane| f(lane, i))).collect();
        let wanted = |builtin| *binding == Binding::BuiltIn(builtin);
        if wanted(BuiltIn::GlobalInvocationId) {
            Ok(vector(&|lane, i| group[i].wrapping_mul(self.size[i]).wrapping_add(local(lane)[i])))
        } else if wanted(BuiltIn::LocalInvocationId) {
            Ok(vector(&|lane, i| local(lane)[i]))
        } else if wanted(BuiltIn::LocalInvocationIndex) {
            Ok(vec![each(&|lane| lane)])
        } else if wanted(BuiltIn::WorkGroupId) {
            Ok(vector(&|_, i| group[i]))
        } else if wanted(BuiltIn::NumWorkGroups) {
            Ok(vector(&|_, i| self.groups[i]))
        } else if wanted(BuiltIn::WorkGroupSize) {
            Ok(vector(&|_, i| self.size[i]))
        } else {
            let function = self.module.module().entry_points[self.entry].name.clone();
            Err(InterpError::Unsupported { what: format!("the input {binding:?}"), function })
        }
    }
}
