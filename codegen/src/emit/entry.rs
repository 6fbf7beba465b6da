//! A compute entry point around a function: one invocation a row.
//!
//! Made in IR, so that every target, the interpreter and the drivers run the same entry point.
//! Its row count is a uniform rather than `arrayLength`, since translators between HLSL and SPIR-V
//! count bytes differently there.
//! A `bool` has no layout in buffers: it travels as a `u32` ([`super::entry`]'s transport types).

mod transport;

use super::EmitError;
use crate::layout::{self, BufferLayout};
use crate::{ValidModule, validate};
use naga::{
    AddressSpace, BinaryOperator, BuiltIn, EntryPoint, Expression, Function, Handle, Module, Range, Span,
    Statement, StorageAccess, Type, TypeInner,
};
use transport::Transport;

/// What an entry point of [`with_entry`] reads and writes, all in group 0.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
pub struct EntryLayout {
    /// Name of the entry point: `<function>_entry`.
    pub entry_name: String,
    /// Invocations in a workgroup (along x).
    pub workgroup_size: u32,
    /// A read-only storage buffer `<parameter>_values` for each parameter: bindings 0, 1, ..
    pub arguments: Vec<BufferLayout>,
    /// The storage buffer `results`, at the next binding.
    pub result: BufferLayout,
    /// Binding of the uniform `row_count: u32`.
    pub count_binding: u32,
}

/// Adds a compute entry point that applies `function` to each row of its argument buffers.
///
/// ```
/// use lobe_codegen::emit::{reflect, with_entry};
/// use lobe_codegen::prelude::*;
///
/// /// Halves.
/// #[kernel]
/// pub fn halved(x: f32) -> f32 {
///     0.5 * x
/// }
///
/// let library = lobe_codegen::lower(&lobe_codegen::kernels![halved])?;
/// let function = library.function("halved").ok_or("it is there")?;
/// let (module, layout) = with_entry(&library, function, 64)?;
/// assert_eq!((layout.count_binding, reflect(&module).entries[0].workgroup_size), (2, [64, 1, 1]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// When the function takes or returns something that no buffer holds, returns nothing, or when the
/// result is not valid (a workgroup size out of bounds, say).
pub fn with_entry(
    module: &ValidModule,
    function: Handle<Function>,
    workgroup_size: u32,
) -> Result<(ValidModule, EntryLayout), EmitError> {
    let (module, mut layouts) = with_entries(module, &[function], workgroup_size)?;
    match layouts.pop() {
        Some(layout) => Ok((module, layout)),
        None => {
            let reason = "no entry point was made".to_owned();
            Err(EmitError::Entry { function: format!("{function:?}"), reason })
        }
    }
}

/// Adds an entry point for each function, in one module.
///
/// All bind in group 0 from binding 0 on; of several, each has buffers of its own whose names begin with
/// the function's (`<function>_<parameter>_values`, `<function>_results`, `<function>_row_count`).
///
/// # Errors
/// As of [`with_entry`].
pub fn with_entries(
    module: &ValidModule,
    functions: &[Handle<Function>],
    workgroup_size: u32,
) -> Result<(ValidModule, Vec<EntryLayout>), EmitError> {
    let mut built = module.module().clone();
    let (mut layouts, mut names) = (Vec::new(), Vec::new());
    for &function in functions {
        let Ok(callee) = built.functions.try_get(function) else {
            let reason = "it is not a function of this module".to_owned();
            return Err(EmitError::Entry { function: format!("{function:?}"), reason });
        };
        let name = callee.name.clone().unwrap_or_default();
        let prefix = if functions.len() > 1 { format!("{name}_") } else { String::new() };
        let mut builder = Builder::new(built, prefix);
        let layout = builder
            .build(function, &name, workgroup_size)
            .map_err(|reason| EmitError::Entry { function: name.clone(), reason })?;
        built = builder.finish(&layout, &name);
        layouts.push(layout);
        names.push(name);
    }
    let valid = validate::validate(built, module.meta().clone())
        .map_err(|error| EmitError::Entry { function: names.join(", "), reason: error.to_string() })?;
    Ok((valid, layouts))
}

/// An entry point in the making.
struct Builder {
    module: Module,
    body: Function,
    u32: Handle<Type>,
    /// Before the names of its buffers.
    prefix: String,
}

impl Builder {
    fn new(mut module: Module, prefix: String) -> Self {
        let u32 = add_type(&mut module, TypeInner::Scalar(naga::Scalar::U32));
        Self { module, body: Function::default(), u32, prefix }
    }

    fn build(&mut self, function: Handle<Function>, name: &str, size: u32) -> Result<EntryLayout, String> {
        let callee = &self.module.functions[function];
        let parameters: Vec<(String, Handle<Type>)> = callee
            .arguments
            .iter()
            .enumerate()
            .map(|(i, a)| (a.name.clone().unwrap_or_else(|| format!("argument{i}")), a.ty))
            .collect();
        let returned = callee
            .result
            .as_ref()
            .map(|r| r.ty)
            .ok_or("it returns nothing, so there are no rows of results")?;
        let count_binding = parameters.len() as u32 + 1;
        let row = self.row(count_binding);
        let mut arguments = Vec::new();
        let mut values = Vec::new();
        for (binding, (parameter, ty)) in parameters.iter().enumerate() {
            let (layout, value) = self.argument(parameter, *ty, binding as u32, row)?;
            arguments.push(layout);
            values.push(value);
        }
        let result = self.result(returned, count_binding - 1, row, function, values)?;
        let entry_name = format!("{name}_entry");
        Ok(EntryLayout { entry_name, workgroup_size: size, arguments, result, count_binding })
    }

    /// `let row = global_invocation_id.x; if row >= row_count { return; }`
    fn row(&mut self, count_binding: u32) -> Handle<Expression> {
        let vector = TypeInner::Vector { size: naga::VectorSize::Tri, scalar: naga::Scalar::U32 };
        self.body.arguments.push(naga::FunctionArgument {
            name: Some("global_invocation_id".to_owned()),
            ty: add_type(&mut self.module, vector),
            binding: Some(naga::Binding::BuiltIn(BuiltIn::GlobalInvocationId)),
        });
        let id = self.declare(Expression::FunctionArgument(0));
        let row = self.compute(Expression::AccessIndex { base: id, index: 0 });
        self.name(row, "row");
        let count = self.global("row_count", AddressSpace::Uniform, count_binding, self.u32);
        let count = self.compute(Expression::Load { pointer: count });
        self.name(count, "rows");
        let past = Expression::Binary { op: BinaryOperator::GreaterEqual, left: row, right: count };
        let condition = self.compute(past);
        let accept = naga::Block::from_vec(vec![Statement::Return { value: None }]);
        self.push(Statement::If { condition, accept, reject: naga::Block::new() });
        row
    }

    /// Binds the buffer of a parameter and reads its row.
    fn argument(
        &mut self,
        name: &str,
        ty: Handle<Type>,
        binding: u32,
        row: Handle<Expression>,
    ) -> Result<(BufferLayout, Handle<Expression>), String> {
        let access = StorageAccess::LOAD;
        let (layout, pointer) = self.buffer(name, &format!("{name}_values"), ty, binding, access, row)?;
        let loaded = self.compute(Expression::Load { pointer });
        let value = self.decode(loaded, ty);
        self.name(value, name);
        Ok((layout, value))
    }

    /// Binds the buffer of the results, calls the function and stores what it returns.
    fn result(
        &mut self,
        ty: Handle<Type>,
        binding: u32,
        row: Handle<Expression>,
        function: Handle<Function>,
        arguments: Vec<Handle<Expression>>,
    ) -> Result<BufferLayout, String> {
        let value = self.declare(Expression::CallResult(function));
        self.push(Statement::Call { function, arguments, result: Some(value) });
        self.name(value, "result");
        let access = StorageAccess::LOAD | StorageAccess::STORE;
        let (layout, pointer) = self.buffer("result", "results", ty, binding, access, row)?;
        let value = self.encode(value, ty);
        self.push(Statement::Store { pointer, value });
        self.push(Statement::Return { value: None });
        Ok(layout)
    }

    /// Binds a buffer of rows of `ty`, and points at one of them.
    fn buffer(
        &mut self,
        path: &str,
        name: &str,
        ty: Handle<Type>,
        binding: u32,
        access: StorageAccess,
        row: Handle<Expression>,
    ) -> Result<(BufferLayout, Handle<Expression>), String> {
        // Paths and kinds of scalars are those of the value, places those of its transport.
        let declared = layout::leaves(&self.module, ty, path).map_err(|e| e.to_string())?;
        let element = Transport::new(&mut self.module)?.of(ty)?;
        let mut layout =
            layout::buffer(&self.module, element, path, (0, binding)).map_err(|e| e.to_string())?;
        for (slot, leaf) in layout.leaves.iter_mut().zip(declared) {
            slot.scalar = leaf.scalar;
        }
        let array = TypeInner::Array { base: element, size: naga::ArraySize::Dynamic, stride: layout.stride };
        let array = add_type(&mut self.module, array);
        let base = self.global(name, AddressSpace::Storage { access }, binding, array);
        Ok((layout, self.compute(Expression::Access { base, index: row })))
    }

    fn global(
        &mut self,
        name: &str,
        space: AddressSpace,
        binding: u32,
        ty: Handle<Type>,
    ) -> Handle<Expression> {
        let global = naga::GlobalVariable {
            name: Some(format!("{}{name}", self.prefix)),
            space,
            binding: Some(naga::ResourceBinding { group: 0, binding }),
            ty,
            init: None,
            memory_decorations: Default::default(),
        };
        let handle = self.module.global_variables.append(global, Span::UNDEFINED);
        self.declare(Expression::GlobalVariable(handle))
    }

    /// Adds an expression that needs no evaluation.
    fn declare(&mut self, expression: Expression) -> Handle<Expression> {
        self.body.expressions.append(expression, Span::UNDEFINED)
    }

    /// Adds an expression and evaluates it here.
    fn compute(&mut self, expression: Expression) -> Handle<Expression> {
        let handle = self.declare(expression);
        self.push(Statement::Emit(Range::new_from_bounds(handle, handle)));
        handle
    }

    fn name(&mut self, value: Handle<Expression>, name: &str) {
        self.body.named_expressions.insert(value, name.to_owned());
    }

    fn push(&mut self, statement: Statement) {
        self.body.body.push(statement, Span::UNDEFINED);
    }

    fn finish(mut self, layout: &EntryLayout, function: &str) -> Module {
        let index = self.module.entry_points.len();
        let docs = self.module.get_or_insert_default_doc_comments();
        docs.entry_points.insert(index, vec![format!("Applies `{function}` to each row of its buffers.")]);
        self.module.entry_points.push(EntryPoint {
            name: layout.entry_name.clone(),
            stage: naga::ShaderStage::Compute,
            early_depth_test: None,
            workgroup_size: [layout.workgroup_size, 1, 1],
            workgroup_size_overrides: None,
            function: self.body,
            mesh_info: None,
            task_payload: None,
            incoming_ray_payload: None,
        });
        self.module
    }
}

fn add_type(module: &mut Module, inner: TypeInner) -> Handle<Type> {
    module.types.insert(Type { name: None, inner }, Span::UNDEFINED)
}
