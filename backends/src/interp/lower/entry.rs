//! Where programs begin: parameters and shared memory.

use super::super::buffer::IMMEDIATES;
use super::super::error::{InterpError, Res};
use super::super::program::op::Input;
use super::super::program::{Buffer, Content, Op, Scalar, Value};
use super::frame::{Item, Pointer, Root};
use super::layout::{Packing, Shape};
use super::{Lowerer, malformed};
use lobe_codegen::module::Scope;
use naga::{AddressSpace, Binding, BuiltIn, Function, GlobalVariable, Handle, StorageAccess, TypeInner};

fn subgroup_input(binding: &Binding) -> Option<Input> {
    match binding {
        Binding::BuiltIn(BuiltIn::SubgroupInvocationId) => Some(Input::SubgroupInvocationId),
        Binding::BuiltIn(BuiltIn::SubgroupId) => Some(Input::SubgroupId),
        Binding::BuiltIn(BuiltIn::SubgroupSize) => Some(Input::SubgroupSize),
        Binding::BuiltIn(BuiltIn::NumSubgroups) => Some(Input::NumSubgroups),
        Binding::BuiltIn(_) | Binding::Location { .. } => None,
    }
}

impl<'m> Lowerer<'m> {
    /// What is being lowered.
    pub(crate) fn entry(&self) -> Option<Scope> {
        self.root
    }

    fn input(&mut self, input: Input, scalar: Scalar) -> Value {
        self.b.eval(Op::Input(input, scalar), &[])
    }

    /// The parameters of a function, each scalar a column.
    pub(crate) fn columns(&mut self, function: &Function) -> Res<Vec<Item>> {
        let mut column = 0;
        let mut items = Vec::new();
        for argument in &function.arguments {
            let mut values = Vec::new();
            for scalar in self.types().kinds(Shape::Type(argument.ty))? {
                values.push(self.input(Input::Column(column), scalar));
                column += 1;
            }
            items.push(Item::values(values));
        }
        self.b.program.columns = column as usize;
        Ok(items)
    }

    /// The parameters of an entry point: built-ins, or structures of them.
    pub(crate) fn builtins(&mut self, entry: usize) -> Res<Vec<Item>> {
        let module = self.module.module();
        let point = module.entry_points.get(entry).ok_or(InterpError::NoEntryPoint(entry))?;
        let mut items = Vec::new();
        for argument in &point.function.arguments {
            let values = match (&argument.binding, &module.types[argument.ty].inner) {
                (Some(binding), _) => self.builtin(binding, &point.name)?,
                (None, TypeInner::Struct { members, .. }) => {
                    let bindings = members.iter().filter_map(|m| m.binding.as_ref());
                    bindings.map(|b| self.builtin(b, &point.name)).collect::<Res<Vec<_>>>()?.concat()
                }
                (None, _) => return Err(malformed("a parameter of an entry point has no binding")),
            };
            items.push(Item::values(values));
        }
        Ok(items)
    }

    fn builtin(&mut self, binding: &Binding, entry: &str) -> Res<Vec<Value>> {
        let wanted = |builtin| *binding == Binding::BuiltIn(builtin);
        let vector: fn(u8) -> Input = if wanted(BuiltIn::GlobalInvocationId) {
            Input::GlobalInvocationId
        } else if wanted(BuiltIn::LocalInvocationId) {
            Input::LocalInvocationId
        } else if wanted(BuiltIn::LocalInvocationIndex) {
            return Ok(vec![self.input(Input::LocalInvocationIndex, Scalar::U32)]);
        } else if let Some(input) = subgroup_input(binding) {
            self.b.program.cooperative = true;
            return Ok(vec![self.input(input, Scalar::U32)]);
        } else if wanted(BuiltIn::WorkGroupId) {
            Input::WorkGroupId
        } else if wanted(BuiltIn::NumWorkGroups) {
            Input::NumWorkGroups
        } else if wanted(BuiltIn::WorkGroupSize) {
            Input::WorkGroupSize
        } else {
            let what = format!("the input {binding:?}");
            return Err(InterpError::Unsupported { what, function: entry.to_owned(), at: None });
        };
        Ok((0..3).map(|axis| self.input(vector(axis), Scalar::U32)).collect())
    }

    /// The place of a buffer or workgroup variable; none for what is no memory.
    pub(crate) fn shared(&mut self, handle: Handle<GlobalVariable>) -> Res<Option<Pointer>> {
        let variable = &self.module.module().global_variables[handle];
        let ty = self.bound_type(variable);
        let shape = Shape::Type(ty);
        let (binding, bytes, writable) = match variable.space {
            AddressSpace::WorkGroup => {
                let unit = self.workgroup_unit(shape)?;
                (None, self.types().count(shape)? * unit, true)
            }
            AddressSpace::Uniform | AddressSpace::Storage { .. } | AddressSpace::Immediate => {
                let context = self.module.module().to_ctx();
                let inner = self.types().inner(ty);
                let bytes = inner.try_size(context).unwrap_or(0);
                let writable = match variable.space {
                    AddressSpace::Storage { access } => access.contains(StorageAccess::STORE),
                    _ => false,
                };
                let is_immediate = variable.space == AddressSpace::Immediate;
                let place = variable.binding.map(|b| (b.group, b.binding));
                (place.or(is_immediate.then_some(IMMEDIATES)), bytes, writable)
            }
            AddressSpace::Function
            | AddressSpace::Private
            | AddressSpace::Handle
            | AddressSpace::TaskPayload
            | AddressSpace::RayPayload
            | AddressSpace::IncomingRayPayload => return Ok(None),
        };
        self.b.program.cooperative |= binding.is_none();
        let name = variable.name.clone().unwrap_or_default();
        let array = self.binding_array(handle, Content::Places)?;
        let content = array.map_or(Content::Variable, Content::Elements);
        let buffer = Buffer { variable: handle, name, binding, bytes, written: false, writable, content };
        self.b.program.buffers.push(buffer);
        let root = Root::Buffer(self.b.program.buffers.len() as u32 - 1);
        let pointer = Pointer { root, offset: 0, index: None, end: None, shape: Shape::Type(variable.ty) };
        self.globals[handle.index()] = Some(pointer);
        Ok(Some(pointer))
    }

    /// Bytes of a scalar in workgroup memory: there is room for the widest.
    fn workgroup_unit(&self, shape: Shape) -> Res<u32> {
        Ok(if self.types().kinds(shape)?.iter().any(|s| s.wide()) { 8 } else { 4 })
    }

    /// How the memory behind `root` is laid out.
    pub(crate) fn packing(&self, root: Root) -> Packing {
        match root {
            Root::Registers(_) | Root::Lane(_) => Packing::Packed(1),
            Root::Buffer(id) => {
                let buffer = &self.b.program.buffers[id as usize];
                if buffer.binding.is_some() {
                    return Packing::Host;
                }
                let ty = self.module.module().global_variables[buffer.variable].ty;
                Packing::Packed(self.workgroup_unit(Shape::Type(ty)).unwrap_or(4))
            }
        }
    }
}
