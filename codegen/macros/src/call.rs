//! Paths, calls and methods.

use crate::expr::{Translator, nothing};
use crate::{method, types};
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::{Expr, ExprPath};

impl Translator<'_> {
    pub(crate) fn path(&mut self, e: &ExprPath) -> TokenStream {
        if e.qself.is_some() {
            self.errors.refuse(e, "a path through a trait", "name the item directly");
            return nothing();
        }
        if let Some(local) = e.path.get_ident().and_then(|name| self.scope.find(name)) {
            return quote!(::lobe_codegen::def::ExprKind::Local(#local));
        }
        if let Some(name) = standard_constant(&e.path) {
            let path = &e.path;
            return quote!(::lobe_codegen::def::ExprKind::Float(#path, ::core::f64::consts::#name));
        }
        if let Some((ty, name)) = associated(&e.path) {
            let name = name.to_string();
            if let Some(instead) = method::associated_constant(&types::last_name(&ty), &name) {
                let what = format!("`{}`", types::text(e));
                self.errors.refuse(e, &what, &instead);
                return nothing();
            }
            let ty = types::type_def(&ty, self.errors);
            return quote!(::lobe_codegen::def::ExprKind::TypeConstant(#ty, #name));
        }
        let path = &e.path;
        quote!(::lobe_codegen::def::ExprKind::Constant(<#path as ::lobe_codegen::def::Constant>::DEF))
    }

    pub(crate) fn call(&mut self, e: &syn::ExprCall) -> TokenStream {
        let Expr::Path(function) = &*e.func else {
            self.errors.refuse(&e.func, "calling a value", "call a function by its name");
            return nothing();
        };
        if function.path.get_ident().is_some_and(|name| self.scope.find(name).is_some()) {
            self.errors.refuse(&e.func, "calling a variable", "call a function by its name");
            return nothing();
        }
        if is_self(&function.path, &self.function) {
            self.errors.refuse(&e.func, "recursion", "write a loop; no shading language has it");
            return nothing();
        }
        if let Some(last) = function.path.segments.last() {
            if !last.arguments.is_none() {
                self.errors.refuse(&e.func, "a generic call", "leave the type arguments out");
                return nothing();
            }
            if function.path.segments.len() == 1 && last.ident.to_string().starts_with(char::is_uppercase) {
                let instead = "build structures as `Name { field: value }`; kernels have no enumerations";
                self.errors.refuse(&e.func, "a tuple structure or variant", instead);
                return nothing();
            }
        }
        let arguments: Vec<_> = e.args.iter().map(|a| self.argument(a)).collect();
        let arguments = quote!(&[#(#arguments),*]);
        if let Some((ty, name)) = associated(&function.path) {
            let name = name.to_string();
            if let Some(instead) = method::associated_function(&types::last_name(&ty), &name) {
                let what = format!("`{}(..)`", types::text(function));
                self.errors.refuse(function, &what, &instead);
                return nothing();
            }
            let ty = types::type_def(&ty, self.errors);
            return quote!(::lobe_codegen::def::ExprKind::TypeCall(#ty, #name, #arguments));
        }
        let path = &function.path;
        quote!(::lobe_codegen::def::ExprKind::Call(<#path as ::lobe_codegen::def::Callable>::CALLEE, #arguments))
    }

    /// An argument; `&place` is allowed here, for atomics.
    fn argument(&mut self, e: &Expr) -> TokenStream {
        match e {
            Expr::Reference(r) if r.mutability.is_none() => self.expr(&r.expr),
            other => self.expr(other),
        }
    }

    pub(crate) fn method(&mut self, e: &syn::ExprMethodCall) -> TokenStream {
        let name = e.method.to_string();
        if !method::allowed(&name) {
            self.errors.refuse(&e.method, &format!("the method `{name}`"), &method::instead(&name));
            return nothing();
        }
        let receiver = self.expr(&e.receiver);
        let arguments = self.exprs(&e.args);
        quote!(::lobe_codegen::def::ExprKind::Method(&#receiver, #name, #arguments))
    }
}

/// Whether the path is `name` or `self::name`.
fn is_self(path: &syn::Path, name: &str) -> bool {
    let names: Vec<String> = path.segments.iter().map(|s| s.ident.to_string()).collect();
    match &names[..] {
        [only] => only == name,
        [first, last] => first == "self" && last == name,
        _ => false,
    }
}

/// `PI` of `std::f32::consts::PI`.
fn standard_constant(path: &syn::Path) -> Option<Ident> {
    let names: Vec<&Ident> = path.segments.iter().map(|s| &s.ident).collect();
    match names[..] {
        [.., float, consts, name] if *float == "f32" && *consts == "consts" => Some(name.clone()),
        _ => None,
    }
}

/// `Type::name`: the type and the name, for a path whose last but one segment is a type by its case.
fn associated(path: &syn::Path) -> Option<(syn::Type, Ident)> {
    let mut segments: Vec<_> = path.segments.iter().cloned().collect();
    let last = segments.pop()?;
    let owner = segments.last()?.ident.to_string();
    let primitive = matches!(owner.as_str(), "f32" | "i32" | "u32" | "bool");
    if !primitive && !owner.starts_with(char::is_uppercase) {
        return None;
    }
    let path = syn::Path { leading_colon: path.leading_colon, segments: segments.into_iter().collect() };
    Some((syn::Type::Path(syn::TypePath { attrs: Vec::new(), qself: None, path }), last.ident))
}
