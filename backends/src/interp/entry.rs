//! Entry points: workgroups, built-in inputs, buffers.

use super::error::{Fault, Internal, InterpError, Result};
use super::exec::Executor;
use super::memory::Cell;
use super::model::Strict;
use super::value::{Column, Kind, Slot, fixed, kind};
use super::{Buffer, Interpreter};
use lobe_codegen::module::Scope;
use naga::{AddressSpace, BuiltIn, TypeInner};
use std::rc::Rc;

impl Interpreter<'_> {
    /// Runs the entry point of this index; storage buffers are updated in place.
    ///
    /// All invocations of a workgroup run in step, and workgroups one after the other.
    ///
    /// # Errors
    /// When a buffer is missing, or the program does what this interpreter refuses.
    pub fn run(
        &self,
        entry: usize,
        groups: [u32; 3],
        buffers: &mut [Buffer],
    ) -> std::result::Result<(), InterpError> {
        let Some(point) = self.module.module().entry_points.get(entry) else {
            let what = format!("entry point {entry}, of {}", self.module.module().entry_points.len());
            return Err(InterpError::Unsupported { function: "the module".to_owned(), what });
        };
        self.run_groups(entry, groups, buffers).map_err(|fault| fault.within(&point.name))
    }

    fn run_groups(&self, entry: usize, groups: [u32; 3], buffers: &mut [Buffer]) -> Result<()> {
        let module = self.module.module();
        let point = &module.entry_points[entry];
        let lanes = point.workgroup_size.iter().product::<u32>() as usize;
        let mut executor = Executor::<Strict>::new(self.module, lanes);
        for (handle, variable) in module.global_variables.iter() {
            if let Some(binding) = variable.binding {
                let buffer = find(buffers, binding)?;
                let mut cells = Vec::new();
                self.read(&module.types[variable.ty].inner, &buffer.data, &mut cells)?;
                executor.shared.set(handle, cells);
            }
        }
        let live = vec![true; lanes];
        for id in ids(groups) {
            self.reset(&mut executor)?;
            let arguments = inputs(point, id, groups)?;
            let info = self.module.info().get_entry_point(entry);
            executor.body(&point.function, info, Scope::Entry(entry), arguments, &live)?;
        }
        for (handle, variable) in module.global_variables.iter() {
            let writable = matches!(variable.space, AddressSpace::Storage { access } if access.contains(naga::StorageAccess::STORE));
            if let (true, Some(binding)) = (writable, variable.binding) {
                let cells = executor.shared.get(handle)?;
                let buffer = find(buffers, binding)?;
                self.write(&module.types[variable.ty].inner, &mut cells.iter(), &mut buffer.data)?;
            }
        }
        Ok(())
    }

    /// Workgroup and private memory is as new for each workgroup.
    fn reset(&self, executor: &mut Executor<'_, Strict>) -> Result<()> {
        let module = self.module.module();
        for (handle, variable) in module.global_variables.iter() {
            match variable.space {
                AddressSpace::WorkGroup => {
                    let mut all = Vec::new();
                    super::value::kinds(module, &module.types[variable.ty].inner, &mut all)?;
                    executor.shared.set(handle, all.into_iter().map(|k| Cell::from_bits(k, 0)).collect());
                }
                AddressSpace::Private => {
                    return Err(Fault::Unsupported("private global variables".to_owned()));
                }
                AddressSpace::Function
                | AddressSpace::Uniform
                | AddressSpace::Storage { .. }
                | AddressSpace::Handle
                | AddressSpace::Immediate
                | AddressSpace::TaskPayload
                | AddressSpace::RayPayload
                | AddressSpace::IncomingRayPayload => {}
            }
        }
        Ok(())
    }

    /// Takes the scalars of a type out of bytes in WGSL's memory layout.
    fn read(&self, inner: &TypeInner, bytes: &[u8], out: &mut Vec<Cell<Strict>>) -> Result<()> {
        let mut slots = Vec::new();
        self.slots(inner, 0, bytes.len(), &mut slots)?;
        for (offset, kind) in slots {
            let word = bytes.get(offset..offset + 4).ok_or_else(|| too_small(bytes.len(), offset + 4))?;
            let bits = word.try_into().map(u32::from_le_bytes).unwrap_or(0);
            out.push(Cell::from_bits(kind, bits));
        }
        Ok(())
    }

    /// Puts the scalars of a type back.
    fn write<'c>(
        &self,
        inner: &TypeInner,
        cells: &mut impl Iterator<Item = &'c Cell<Strict>>,
        bytes: &mut [u8],
    ) -> Result<()> {
        let mut slots = Vec::new();
        self.slots(inner, 0, bytes.len(), &mut slots)?;
        for ((offset, _), cell) in slots.into_iter().zip(cells) {
            if let Some(word) = bytes.get_mut(offset..offset + 4) {
                word.copy_from_slice(&cell.bits().to_le_bytes());
            }
        }
        Ok(())
    }

    /// Offset and kind of each scalar; a runtime array fills `end`.
    fn slots(&self, inner: &TypeInner, at: usize, end: usize, out: &mut Vec<(usize, Kind)>) -> Result<()> {
        let types = &self.module.module().types;
        match *inner {
            TypeInner::Scalar(s) | TypeInner::Atomic(s) => out.push((at, kind(s)?)),
            TypeInner::Vector { size, scalar } => {
                let kind = kind(scalar)?;
                out.extend((0..size as usize).map(|i| (at + 4 * i, kind)));
            }
            TypeInner::Matrix { columns, rows, scalar } => {
                let kind = kind(scalar)?;
                let stride = if rows == naga::VectorSize::Bi { 8 } else { 16 };
                for column in 0..columns as usize {
                    out.extend((0..rows as usize).map(|i| (at + stride * column + 4 * i, kind)));
                }
            }
            TypeInner::Array { base, size, stride } => {
                let stride = stride as usize;
                let count = fixed(size)?.unwrap_or(end.saturating_sub(at) / stride.max(1));
                (0..count).try_for_each(|i| self.slots(&types[base].inner, at + stride * i, end, out))?;
            }
            TypeInner::Struct { ref members, .. } => members
                .iter()
                .try_for_each(|m| self.slots(&types[m.ty].inner, at + m.offset as usize, end, out))?,
            _ => return Err(Internal::Type.into()),
        }
        Ok(())
    }
}

fn too_small(found: usize, needed: usize) -> Fault {
    Fault::Unsupported(format!("a buffer of {found} bytes where {needed} are needed"))
}

fn find(buffers: &mut [Buffer], binding: naga::ResourceBinding) -> Result<&mut Buffer> {
    let naga::ResourceBinding { group, binding } = binding;
    buffers
        .iter_mut()
        .find(|b| b.group == group && b.binding == binding)
        .ok_or_else(|| Fault::Known(InterpError::Buffer { group, binding, what: "is missing".to_owned() }))
}

/// All workgroups, x fastest.
fn ids([x, y, z]: [u32; 3]) -> impl Iterator<Item = [u32; 3]> {
    (0..z).flat_map(move |k| (0..y).flat_map(move |j| (0..x).map(move |i| [i, j, k])))
}

/// The built-in inputs of a workgroup's invocations.
fn inputs(point: &naga::EntryPoint, group: [u32; 3], groups: [u32; 3]) -> Result<Vec<Slot<Strict>>> {
    let size = point.workgroup_size;
    let local: Vec<[u32; 3]> = ids(size).collect();
    let vector = |f: &dyn Fn(usize, [u32; 3]) -> u32| -> Vec<Column<Strict>> {
        (0..3).map(|axis| Column::W(local.iter().map(|l| f(axis, *l)).collect())).collect()
    };
    point
        .function
        .arguments
        .iter()
        .map(|argument| {
            let Some(naga::Binding::BuiltIn(builtin)) = argument.binding else {
                return Err(Fault::Unsupported("an argument without a built-in binding".to_owned()));
            };
            let columns = match builtin {
                BuiltIn::GlobalInvocationId => vector(&|axis, l| group[axis] * size[axis] + l[axis]),
                BuiltIn::LocalInvocationId => vector(&|axis, l| l[axis]),
                BuiltIn::WorkGroupId => vector(&|axis, _| group[axis]),
                BuiltIn::NumWorkGroups => vector(&|axis, _| groups[axis]),
                BuiltIn::LocalInvocationIndex => vec![Column::W((0..local.len() as u32).collect())],
                other => return Err(Fault::Unsupported(format!("the built-in input {other:?}"))),
            };
            Ok(Slot::Value(Rc::new(columns)))
        })
        .collect()
}
