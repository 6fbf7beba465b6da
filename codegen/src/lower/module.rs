//! Functions, types and constants of the module, each lowered once.

use super::body::BodyBuilder;
use super::error::{Fail, LowerError, Lowered, byte_range, render};
use super::layout;
use super::value::Lit;
use crate::def::{
    Binding, Builtin, ConstantDef, ConstantValue, FunctionDef, Param, Scalar, Source, Span, StructDef,
    TypeDef,
};
use crate::module::{Meta, Scope, ValidModule};
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
    /// Names taken, with the place of the definition.
    names: HashMap<&'static str, String>,
    /// Functions whose bodies are being lowered, outermost first.
    open: Vec<&'static FunctionDef>,
    docs: naga::DocComments,
    sources: SourceMap,
}

/// Gives each function a stretch of one virtual text, so that a naga span finds its way back.
#[derive(Default)]
struct SourceMap {
    /// First offset and definition; offsets start at 1, since naga takes 0..0 for "unknown".
    stretches: Vec<(u32, &'static FunctionDef)>,
    end: u32,
}

impl SourceMap {
    fn add(&mut self, def: &'static FunctionDef) -> u32 {
        let base = self.end.max(1);
        self.end = base + def.source.text.len() as u32 + 1;
        self.stretches.push((base, def));
        base
    }

    /// The definition and the range in its text.
    fn find(&self, span: naga::Span) -> Option<(&'static FunctionDef, std::ops::Range<usize>)> {
        let range = span.to_range()?;
        let (base, def) = self.stretches.iter().rev().find(|(base, _)| *base as usize <= range.start)?;
        Some((def, range.start - *base as usize..range.end - *base as usize))
    }
}

/// Turns spans of one function into naga's.
pub(super) struct Spans {
    base: u32,
    source: &'static Source,
}

impl Spans {
    pub(super) fn naga(&self, span: Span) -> naga::Span {
        let range = byte_range(self.source, &span);
        naga::Span::new(self.base + range.start as u32, self.base + range.end as u32)
    }
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
        let handle = self.module.functions.append(function, naga::Span::UNDEFINED);
        self.functions.insert(def, handle);
        self.meta.definitions.insert(handle, def);
        self.meta.exact.extend(exact.into_iter().map(|(e, v)| ((Scope::Function(handle), e), v)));
        if let Some(truth) = def.contract.truth {
            self.meta.truths.insert(handle, truth);
        }
        if !def.docs.is_empty() {
            self.docs.functions.insert(handle, owned(def.docs));
        }
        Ok(handle)
    }

    fn entry_point(&mut self, def: &'static FunctionDef, workgroup_size: [u32; 3]) -> Result<(), LowerError> {
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
        self.claim(def.name, &def.source).map_err(|message| Fail::new(def.span, message).in_function(def))?;
        self.open.push(def);
        let spans = Spans { base: self.sources.add(def), source: &def.source };
        let lowered = BodyBuilder::lower(self, def, spans);
        self.open.pop();
        lowered
    }

    /// Takes a name for a definition; two may not share one.
    fn claim(&mut self, name: &'static str, source: &Source) -> Result<(), String> {
        let place = format!("{}:{}", source.file, source.line);
        match self.names.insert(name, place.clone()) {
            Some(other) if other != place => {
                Err(format!("two kernel items of one module are called `{name}`: {place} and {other}"))
            }
            _ => Ok(()),
        }
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
        let handle = self.module.types.insert(ty, naga::Span::UNDEFINED);
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
    pub(super) fn constant(&mut self, def: &'static ConstantDef) -> Lowered<Handle<naga::Constant>> {
        if let Some(handle) = self.constants.get(&std::ptr::from_ref(def)) {
            return Ok(*handle);
        }
        self.claim(def.name, &def.source).map_err(|message| Fail::new(def.span, message))?;
        let ty = self.ty(&def.ty);
        let init = self.constant_value(def, &def.ty, &def.value)?;
        if let Some(exact) = def.exact {
            self.meta.exact.insert((Scope::Global, init), exact);
        }
        let constant = naga::Constant { name: Some(def.name.to_owned()), ty, init };
        let handle = self.module.constants.append(constant, naga::Span::UNDEFINED);
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
    pub(super) fn global(&mut self, param: &'static Param) -> Option<Handle<naga::GlobalVariable>> {
        let (space, binding) = match param.binding {
            Binding::Value | Binding::Builtin(_) => return None,
            Binding::Storage { group, binding, writable } => {
                let load = naga::StorageAccess::LOAD;
                let access = if writable { load | naga::StorageAccess::STORE } else { load };
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
            .find(|(_, g)| binding.is_some() && g.binding == binding && g.ty == ty && g.space == space)
            .map(|(handle, _)| handle);
        Some(existing.unwrap_or_else(|| {
            let name = Some(param.name.to_owned());
            let global = naga::GlobalVariable {
                name,
                space,
                binding,
                ty,
                init: None,
                memory_decorations: Default::default(),
            };
            self.module.global_variables.append(global, naga::Span::UNDEFINED)
        }))
    }

    /// Validates.
    pub(super) fn finish(mut self) -> Result<ValidModule, LowerError> {
        self.module.doc_comments = Some(Box::new(std::mem::take(&mut self.docs)));
        let Self { module, meta, sources, .. } = self;
        crate::validate::validate(module, meta).map_err(|error| sources.explain(&error))
    }
}

impl SourceMap {
    /// A validation error at the Rust lines that it points at.
    fn explain(&self, error: &crate::validate::ValidateError) -> LowerError {
        let message = error.to_string();
        let mut found: Vec<(&'static FunctionDef, Span, String)> = Vec::new();
        for (span, label) in error.spans() {
            if let Some((def, range)) = self.find(span) {
                found.push((def, span_of(&def.source, range), label));
            }
        }
        // The innermost label says most; it is the last one with a source.
        let rendered = match found.last() {
            Some((def, _, _)) => {
                let labels: Vec<_> = found
                    .iter()
                    .rev()
                    .filter(|(d, ..)| std::ptr::eq(*d, *def))
                    .map(|(_, span, label)| (*span, label.clone()))
                    .collect();
                render(&message, &def.source, &labels)
            }
            None => format!("error: {message}"),
        };
        LowerError::Invalid { message, rendered }
    }
}

/// Lines and columns of a byte range of a source's text.
fn span_of(source: &Source, range: std::ops::Range<usize>) -> Span {
    let position = |offset: usize| {
        let before = &source.text[..offset.min(source.text.len())];
        let line = before.matches('\n').count() as u32;
        let column = before.rsplit('\n').next().map_or(0, |l| l.chars().count() as u32);
        (source.line + line, column)
    };
    Span { start: position(range.start), end: position(range.end) }
}

/// A literal's expression and the value that its decimals state.
pub(super) type ExactLiteral = (Handle<naga::Expression>, f64);

fn owned(docs: &[&str]) -> Vec<String> {
    docs.iter().map(|&line| line.to_owned()).collect()
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
