//! Functions, types and constants of the module, each lowered once.

use super::body::BodyBuilder;
use super::error::{Fail, LowerError, Lowered};
use super::layout;
use super::source::SourceMap;
use super::value::Lit;
use crate::def::{
    Binding, Builtin, ConstantDef, ConstantValue, FunctionDef, Param, Scalar, Source, Span, StructDef,
    TypeDef,
};
use crate::module::{Meta, Scope, ValidModule};
use crate::validate::validate;
use naga::{Handle, TypeInner};
use std::collections::HashMap;

/// The module under construction.
#[derive(Default)]
pub(super) struct ModuleBuilder {
    pub(super) module: naga::Module,
    pub(super) meta: Meta,
    functions: HashMap<*const FunctionDef, Handle<naga::Function>>,
    structs: HashMap<*const StructDef, Handle<naga::Type>>,
    constants: HashMap<*const ConstantDef, Handle<naga::Constant>>,
    /// Names taken: the address of the definition, and where it stands.
    names: HashMap<&'static str, (usize, String)>,
    /// Two definitions of one name, found where no error can be returned.
    clash: Option<LowerError>,
    entries: Vec<*const FunctionDef>,
    /// Functions whose bodies are being lowered, outermost first.
    open: Vec<&'static FunctionDef>,
    docs: naga::DocComments,
    sources: SourceMap,
}

impl ModuleBuilder {
    /// Lowers a function, or an entry point, if that has not happened.
    pub(super) fn add(&mut self, def: &'static FunctionDef) -> Result<(), LowerError> {
        match def.entry {
            Some(size) => self.entry_point(def, size),
            None => self.function(def).map(|_| ()),
        }
    }

    /// The naga function of `def`.
    pub(super) fn function(
        &mut self,
        def: &'static FunctionDef,
    ) -> Result<Handle<naga::Function>, LowerError> {
        if let Some(handle) = self.functions.get(&std::ptr::from_ref(def)) {
            return Ok(*handle);
        }
        let (function, exact) = self.body(def)?;
        let span = self.sources.spans(&def.source).naga(def.span);
        let handle = self.module.functions.append(function, span);
        self.functions.insert(def, handle);
        self.meta.definitions.insert(handle, def);
        self.meta.exact.extend(exact.into_iter().map(|(e, v)| ((Scope::Function(handle), e), v)));
        if let Some(truth) = def.contract.truth {
            self.meta.truths.insert(handle, truth);
        }
        let docs = with_measured(def);
        if !docs.is_empty() {
            self.docs.functions.insert(handle, docs);
        }
        Ok(handle)
    }

    fn entry_point(&mut self, def: &'static FunctionDef, workgroup_size: [u32; 3]) -> Result<(), LowerError> {
        if self.entries.contains(&std::ptr::from_ref(def)) {
            return Ok(());
        }
        self.entries.push(def);
        let (function, exact) = self.body(def)?;
        let index = self.module.entry_points.len();
        self.module.entry_points.push(naga::EntryPoint {
            name: def.name.to_owned(),
            stage: naga::ShaderStage::Compute,
            early_depth_test: None,
            workgroup_size,
            workgroup_size_overrides: None,
            function,
            mesh_info: None,
            task_payload: None,
            incoming_ray_payload: None,
        });
        self.meta.exact.extend(exact.into_iter().map(|(e, v)| ((Scope::Entry(index), e), v)));
        if !def.docs.is_empty() {
            self.docs.entry_points.insert(index, owned(def.docs));
        }
        Ok(())
    }

    /// Lowers the body of `def`, its callees first.
    fn body(&mut self, def: &'static FunctionDef) -> Result<(naga::Function, Vec<ExactLiteral>), LowerError> {
        if let Some(first) = self.open.iter().position(|open| std::ptr::eq(*open, def)) {
            let chain: Vec<_> = self.open[first..].iter().map(|d| d.name).chain([def.name]).collect();
            let message =
                format!("recursion: {}; no shading language allows it, write a loop", chain.join(" -> "));
            return Err(Fail::new(def.span, message).in_function(def));
        }
        self.claim(def.name, address(def), &def.source)
            .map_err(|message| Fail::new(def.span, message).in_function(def))?;
        self.open.push(def);
        self.sources.name(def);
        let spans = self.sources.spans(&def.source);
        let lowered = BodyBuilder::lower(self, def, spans);
        self.open.pop();
        lowered
    }

    /// Takes a name for a definition; two may not share one.
    fn claim(&mut self, name: &'static str, address: usize, source: &Source) -> Result<(), String> {
        let place = format!("{}:{}", source.file, source.line);
        match self.names.get(name) {
            Some((other, _)) if *other == address => Ok(()),
            Some((_, other)) => {
                Err(format!("two items of one module are called `{name}`, here and at {other}: rename one"))
            }
            None => {
                self.names.insert(name, (address, place));
                Ok(())
            }
        }
    }

    /// Notes the first clash of names.
    fn note_clash(&mut self, item: &'static str, source: &'static Source, span: Span, message: String) {
        self.clash.get_or_insert_with(|| Fail::new(span, message).in_source(item, source));
    }

    /// The naga type of `ty`.
    pub(super) fn ty(&mut self, ty: &TypeDef) -> Handle<naga::Type> {
        let inner = match *ty {
            TypeDef::Scalar(s) => TypeInner::Scalar(scalar(s)),
            TypeDef::Vector(n, s) => TypeInner::Vector { size: vector_size(n), scalar: scalar(s) },
            TypeDef::Matrix(c, r) => TypeInner::Matrix {
                columns: vector_size(c),
                rows: vector_size(r),
                scalar: scalar(Scalar::F32),
            },
            TypeDef::Atomic(s) => TypeInner::Atomic(scalar(s)),
            TypeDef::Array(element, n) => {
                let size = match std::num::NonZeroU32::new(n) {
                    Some(n) => naga::ArraySize::Constant(n),
                    None => naga::ArraySize::Dynamic,
                };
                TypeInner::Array { base: self.ty(element), size, stride: layout::layout(element).stride() }
            }
            TypeDef::Slice(element) => TypeInner::Array {
                base: self.ty(element),
                size: naga::ArraySize::Dynamic,
                stride: layout::layout(element).stride(),
            },
            TypeDef::Struct(def) => return self.structure(def()),
        };
        self.module.types.insert(naga::Type { name: None, inner }, naga::Span::UNDEFINED)
    }

    fn structure(&mut self, def: &'static StructDef) -> Handle<naga::Type> {
        if let Some(handle) = self.structs.get(&std::ptr::from_ref(def)) {
            return *handle;
        }
        if let Err(message) = self.claim(def.name, address(def), &def.source) {
            self.note_clash(def.name, &def.source, def.span, message);
        }
        let (offsets, whole) = layout::members(def);
        let members = def
            .fields
            .iter()
            .zip(offsets)
            .map(|(field, offset)| naga::StructMember {
                name: Some(field.name.to_owned()),
                ty: self.ty(&field.ty),
                binding: None,
                offset,
            })
            .collect();
        let inner = TypeInner::Struct { members, span: whole.size };
        let ty = naga::Type { name: Some(def.name.to_owned()), inner };
        let span = self.sources.spans(&def.source).naga(def.span);
        let handle = self.module.types.insert(ty, span);
        self.structs.insert(def, handle);
        if !def.docs.is_empty() {
            self.docs.types.insert(handle, owned(def.docs));
        }
        for (i, field) in def.fields.iter().enumerate().filter(|(_, f)| !f.docs.is_empty()) {
            self.docs.struct_members.insert((handle, i), owned(field.docs));
        }
        handle
    }

    /// The naga constant of `def`.
    pub(super) fn constant(
        &mut self,
        def: &'static ConstantDef,
    ) -> Result<Handle<naga::Constant>, LowerError> {
        if let Some(handle) = self.constants.get(&std::ptr::from_ref(def)) {
            return Ok(*handle);
        }
        if let Err(message) = self.claim(def.name, address(def), &def.source) {
            self.note_clash(def.name, &def.source, def.span, message);
        }
        let ty = self.ty(&def.ty);
        let init = self
            .constant_value(def, &def.ty, &def.value)
            .map_err(|fail| fail.in_source(def.name, &def.source))?;
        if let (Some(exact), ConstantValue::F32(value)) = (def.exact, def.value)
            && f64::from(value) != exact
        {
            self.meta.exact.insert((Scope::Global, init), exact);
        }
        let constant = naga::Constant { name: Some(def.name.to_owned()), ty, init };
        let span = self.sources.spans(&def.source).naga(def.span);
        let handle = self.module.constants.append(constant, span);
        self.constants.insert(def, handle);
        if !def.docs.is_empty() {
            self.docs.constants.insert(handle, owned(def.docs));
        }
        Ok(handle)
    }

    fn constant_value(
        &mut self,
        def: &'static ConstantDef,
        ty: &TypeDef,
        value: &ConstantValue,
    ) -> Lowered<Handle<naga::Expression>> {
        let lit = match *value {
            ConstantValue::F32(v) if !v.is_finite() => {
                let message =
                    format!("the constant `{}` is not finite, and shaders have no such literal", def.name);
                return Err(Fail::new(def.span, message));
            }
            ConstantValue::F32(v) => Lit::F32(v, f64::from(v)),
            ConstantValue::I32(v) => Lit::I32(v),
            ConstantValue::U32(v) => Lit::U32(v),
            ConstantValue::Bool(v) => Lit::Bool(v),
            ConstantValue::Composite(parts) => {
                let part = element(ty);
                let components =
                    parts.iter().map(|p| self.constant_value(def, &part, p)).collect::<Lowered<Vec<_>>>()?;
                let compose = naga::Expression::Compose { ty: self.ty(ty), components };
                return Ok(self.module.global_expressions.append(compose, naga::Span::UNDEFINED));
            }
        };
        let literal = naga::Expression::Literal(lit.naga());
        Ok(self.module.global_expressions.append(literal, naga::Span::UNDEFINED))
    }

    /// The global variable behind a parameter of an entry point.
    pub(super) fn global(
        &mut self,
        def: &'static FunctionDef,
        param: &'static Param,
    ) -> Option<Handle<naga::GlobalVariable>> {
        let (space, binding) = match param.binding {
            Binding::Value | Binding::Builtin(_) => return None,
            Binding::Storage { group, binding, writable } => {
                let load = naga::StorageAccess::LOAD;
                // Atomics change through shared references.
                let access =
                    if writable || has_atomic(&param.ty) { load | naga::StorageAccess::STORE } else { load };
                (naga::AddressSpace::Storage { access }, Some(naga::ResourceBinding { group, binding }))
            }
            Binding::Uniform { group, binding } => {
                (naga::AddressSpace::Uniform, Some(naga::ResourceBinding { group, binding }))
            }
            Binding::Workgroup => (naga::AddressSpace::WorkGroup, None),
        };
        let ty = self.ty(&param.ty);
        let existing = self
            .module
            .global_variables
            .iter()
            .find(|(_, g)| {
                let is_same = g.binding == binding && g.ty == ty && g.space == space;
                binding.is_some() && is_same && g.name.as_deref() == Some(param.name)
            })
            .map(|(handle, _)| handle);
        Some(existing.unwrap_or_else(|| {
            if let Err(message) = self.claim(param.name, address(param), &def.source) {
                self.note_clash(def.name, &def.source, param.span, message);
            }
            let name = Some(param.name.to_owned());
            let global = naga::GlobalVariable {
                name,
                space,
                binding,
                ty,
                init: None,
                memory_decorations: Default::default(),
            };
            let span = self.sources.spans(&def.source).naga(param.span);
            self.module.global_variables.append(global, span)
        }))
    }

    /// Validates.
    pub(super) fn finish(mut self) -> Result<ValidModule, LowerError> {
        if let Some(clash) = self.clash {
            return Err(clash);
        }
        self.module.doc_comments = Some(Box::new(std::mem::take(&mut self.docs)));
        let Self { module, mut meta, sources, .. } = self;
        meta.sources = sources.sources().clone();
        validate(module, meta).map_err(|error| sources.explain(&error))
    }
}

/// A literal's expression and the value that its decimals state.
pub(super) type ExactLiteral = (Handle<naga::Expression>, f64);

/// Address of a definition, which tells it from others of the same name.
fn address<T>(def: &'static T) -> usize {
    std::ptr::from_ref(def).addr()
}

fn has_atomic(ty: &TypeDef) -> bool {
    match *ty {
        TypeDef::Atomic(_) => true,
        TypeDef::Array(element, _) | TypeDef::Slice(element) => has_atomic(element),
        TypeDef::Struct(def) => def().fields.iter().any(|f| has_atomic(&f.ty)),
        TypeDef::Scalar(_) | TypeDef::Vector(..) | TypeDef::Matrix(..) => false,
    }
}

/// The doc comment of a function, and after it the first paragraph of what was measured of it.
fn with_measured(def: &FunctionDef) -> Vec<String> {
    let mut docs = owned(def.docs);
    if let Some(text) = def.contract.measured {
        docs.push(String::new());
        docs.extend(text.lines().take_while(|line| !line.is_empty()).map(str::to_owned));
    }
    docs
}

/// A line an item; a text that the comment includes has several.
fn owned(docs: &[&str]) -> Vec<String> {
    docs.iter()
        .flat_map(|text| text.strip_suffix('\n').unwrap_or(text).split('\n'))
        .map(str::to_owned)
        .collect()
}

/// The type of the parts of a composite type.
pub(super) fn element(ty: &TypeDef) -> TypeDef {
    match *ty {
        TypeDef::Vector(_, s) => TypeDef::Scalar(s),
        TypeDef::Matrix(_, rows) => TypeDef::Vector(rows, Scalar::F32),
        TypeDef::Array(element, _) | TypeDef::Slice(element) => *element,
        TypeDef::Scalar(_) | TypeDef::Atomic(_) | TypeDef::Struct(_) => *ty,
    }
}

pub(super) fn scalar(s: Scalar) -> naga::Scalar {
    match s {
        Scalar::F32 => naga::Scalar::F32,
        Scalar::I32 => naga::Scalar::I32,
        Scalar::U32 => naga::Scalar::U32,
        Scalar::Bool => naga::Scalar::BOOL,
    }
}

pub(super) fn vector_size(n: u8) -> naga::VectorSize {
    match n {
        2 => naga::VectorSize::Bi,
        3 => naga::VectorSize::Tri,
        _ => naga::VectorSize::Quad,
    }
}

/// naga's name of a built-in input.
pub(super) fn builtin(builtin: Builtin) -> naga::Binding {
    naga::Binding::BuiltIn(match builtin {
        Builtin::GlobalInvocationId => naga::BuiltIn::GlobalInvocationId,
        Builtin::LocalInvocationId => naga::BuiltIn::LocalInvocationId,
        Builtin::LocalInvocationIndex => naga::BuiltIn::LocalInvocationIndex,
        Builtin::WorkgroupId => naga::BuiltIn::WorkGroupId,
        Builtin::NumWorkgroups => naga::BuiltIn::NumWorkGroups,
    })
}
