//! Expressions.

use crate::errors::Errors;
use crate::scope::Scope;
use crate::{method, source, types};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};
use syn::{BinOp, Expr, ExprPath, Lit, UnOp};

/// Translates the inside of one function.
pub(crate) struct Translator<'e> {
    /// Names that are visible.
    pub(crate) scope: Scope,
    /// Where mistakes go.
    pub(crate) errors: &'e mut Errors,
    /// Name of the function, to see recursion.
    pub(crate) function: String,
}

impl Translator<'_> {
    /// A `def::Expr`.
    pub(crate) fn expr(&mut self, e: &Expr) -> TokenStream {
        let kind = self.kind(e);
        let span = source::span(e);
        quote!(::lobe_codegen::def::Expr { kind: #kind, span: #span })
    }

    /// A `&'static [Expr]`.
    fn exprs<'a>(&mut self, list: impl IntoIterator<Item = &'a Expr>) -> TokenStream {
        let list: Vec<_> = list.into_iter().map(|e| self.expr(e)).collect();
        quote!(&[#(#list),*])
    }

    /// A `def::ExprKind`.
    fn kind(&mut self, e: &Expr) -> TokenStream {
        match e {
            Expr::Lit(e) => self.literal(&e.lit),
            Expr::Path(e) => self.path(e),
            Expr::Paren(e) => self.kind(&e.expr),
            Expr::Group(e) => self.kind(&e.expr),
            Expr::Unary(e) => self.unary(e),
            Expr::Binary(e) => self.binary(e),
            Expr::Call(e) => self.call(e),
            Expr::MethodCall(e) => self.method(e),
            Expr::Field(e) => self.field(e),
            Expr::Index(e) => {
                let (base, index) = (self.expr(&e.expr), self.expr(&e.index));
                quote!(::lobe_codegen::def::ExprKind::Index(&#base, &#index))
            }
            Expr::Struct(e) => self.structure(e),
            Expr::Array(e) => {
                let elements = self.exprs(&e.elems);
                quote!(::lobe_codegen::def::ExprKind::Array(#elements))
            }
            Expr::Repeat(e) => {
                let value = self.expr(&e.expr);
                let count = &e.len;
                quote!(::lobe_codegen::def::ExprKind::Repeat(&#value, (#count) as u32))
            }
            Expr::Cast(e) => {
                let value = self.expr(&e.expr);
                let ty = types::cast_target(&e.ty, self.errors);
                quote!(::lobe_codegen::def::ExprKind::Cast(&#value, #ty))
            }
            Expr::If(e) => self.if_else(e),
            Expr::Match(e) => self.match_integers(e),
            Expr::Block(e) if e.label.is_none() => {
                let block = self.block(&e.block);
                quote!(::lobe_codegen::def::ExprKind::Block(#block))
            }
            other => self.refused(other),
        }
    }

    fn literal(&mut self, lit: &Lit) -> TokenStream {
        match lit {
            Lit::Float(f) => match f.suffix() {
                "" | "f32" => self.float(lit, f.base10_digits()),
                suffix => self.refused_literal(lit, suffix, "write an `f32` literal, as `1.0`"),
            },
            Lit::Int(i) => match i.suffix() {
                "" | "u32" | "usize" | "i32" => {
                    let scalar = match i.suffix() {
                        "" => quote!(None),
                        "i32" => quote!(Some(::lobe_codegen::def::Scalar::I32)),
                        _ => quote!(Some(::lobe_codegen::def::Scalar::U32)),
                    };
                    match i.base10_parse::<u64>() {
                        Ok(value) => quote!(::lobe_codegen::def::ExprKind::Int(#value, #scalar)),
                        Err(error) => {
                            self.errors.push(error);
                            nothing()
                        }
                    }
                }
                "f32" => self.float(lit, i.base10_digits()),
                suffix => self.refused_literal(lit, suffix, "write an `i32` or `u32` literal"),
            },
            Lit::Bool(b) => quote!(::lobe_codegen::def::ExprKind::Bool(#b)),
            _ => self.refused_literal(lit, "", "shaders know numbers and `bool` only"),
        }
    }

    fn refused_literal(&mut self, lit: &Lit, suffix: &str, instead: &str) -> TokenStream {
        let what = if suffix.is_empty() {
            "this literal".to_owned()
        } else {
            format!("a literal of type `{suffix}`")
        };
        self.errors.refuse(lit, &what, instead);
        nothing()
    }

    fn float(&mut self, lit: &Lit, digits: &str) -> TokenStream {
        // Rounded from the decimals at once: by way of f64 the last bit may differ.
        let (value, exact) = (digits.parse::<f32>(), digits.parse::<f64>());
        let (value, exact) = (value.unwrap_or(f32::NAN), exact.unwrap_or(f64::NAN));
        if !value.is_finite() {
            self.errors
                .at(lit, "this literal is no finite `f32`: shading languages have no literal for infinity");
            return nothing();
        }
        quote!(::lobe_codegen::def::ExprKind::Float(#value, #exact))
    }

    fn path(&mut self, e: &ExprPath) -> TokenStream {
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

    fn unary(&mut self, e: &syn::ExprUnary) -> TokenStream {
        let op = match e.op {
            UnOp::Neg(_) => quote!(Negate),
            UnOp::Not(_) => quote!(Not),
            UnOp::Deref(_) => return self.dereference(e),
            _ => return self.refused(&Expr::Unary(e.clone())),
        };
        let inner = self.expr(&e.expr);
        quote!(::lobe_codegen::def::ExprKind::Unary(::lobe_codegen::def::UnaryOp::#op, &#inner))
    }

    fn dereference(&mut self, e: &syn::ExprUnary) -> TokenStream {
        if let Expr::Path(p) = &*e.expr
            && let Some(local) = p.path.get_ident().and_then(|name| self.scope.find(name))
            && self.scope.is_binding(local)
        {
            return quote!(::lobe_codegen::def::ExprKind::Local(#local));
        }
        let instead = "only storage, uniform and workgroup parameters are references";
        self.errors.refuse(e, "dereferencing", instead);
        nothing()
    }

    fn binary(&mut self, e: &syn::ExprBinary) -> TokenStream {
        let Some(op) = operator(&e.op) else {
            self.errors.refuse(e, "an assignment inside an expression", "write it as a statement of its own");
            return nothing();
        };
        let (left, right) = (self.expr(&e.left), self.expr(&e.right));
        quote!(::lobe_codegen::def::ExprKind::Binary(#op, &#left, &#right))
    }

    fn call(&mut self, e: &syn::ExprCall) -> TokenStream {
        let Expr::Path(function) = &*e.func else {
            self.errors.refuse(&e.func, "calling a value", "call a function by its name");
            return nothing();
        };
        if let Some(name) = function.path.get_ident() {
            if self.scope.find(name).is_some() {
                self.errors.refuse(&e.func, "calling a variable", "call a function by its name");
                return nothing();
            }
            if *name == self.function {
                self.errors.refuse(&e.func, "recursion", "write a loop; no shading language calls itself");
                return nothing();
            }
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

    fn method(&mut self, e: &syn::ExprMethodCall) -> TokenStream {
        let name = e.method.to_string();
        if !method::allowed(&name) {
            self.errors.refuse(&e.method, &format!("the method `{name}`"), &method::instead(&name));
            return nothing();
        }
        let receiver = self.expr(&e.receiver);
        let arguments = self.exprs(&e.args);
        quote!(::lobe_codegen::def::ExprKind::Method(&#receiver, #name, #arguments))
    }

    fn field(&mut self, e: &syn::ExprField) -> TokenStream {
        let syn::Member::Named(name) = &e.member else {
            self.errors.refuse(&e.member, "a tuple field", "declare a structure with named fields");
            return nothing();
        };
        let base = self.expr(&e.base);
        let name = crate::scope::plain(name);
        quote!(::lobe_codegen::def::ExprKind::Field(&#base, #name))
    }

    fn structure(&mut self, e: &syn::ExprStruct) -> TokenStream {
        let ty = syn::Type::Path(syn::TypePath { attrs: Vec::new(), qself: None, path: e.path.clone() });
        let ty = types::type_def(&ty, self.errors);
        let mut fields = Vec::new();
        for field in &e.fields {
            let syn::Member::Named(name) = &field.member else {
                self.errors.refuse(&field.member, "a tuple structure", "declare named fields");
                continue;
            };
            let (name, value) = (crate::scope::plain(name), self.expr(&field.expr));
            fields.push(quote!((#name, #value)));
        }
        let rest = match &e.rest {
            Some(rest) => {
                let rest = self.expr(rest);
                quote!(Some(&#rest))
            }
            None => quote!(None),
        };
        quote!(::lobe_codegen::def::ExprKind::Struct { ty: #ty, fields: &[#(#fields),*], rest: #rest })
    }

    fn if_else(&mut self, e: &syn::ExprIf) -> TokenStream {
        if let Expr::Let(_) = &*e.cond {
            self.errors.refuse(&e.cond, "`if let`", "compare with `==`, or `match` on an integer");
            return nothing();
        }
        let condition = self.expr(&e.cond);
        let accept = self.block(&e.then_branch);
        let reject = match &e.else_branch {
            None => quote!(None),
            Some((_, branch)) => {
                let block = self.branch(branch);
                quote!(Some(#block))
            }
        };
        quote!(::lobe_codegen::def::ExprKind::If { condition: &#condition, accept: #accept, reject: #reject })
    }

    /// A block, or another expression as the value of one.
    fn branch(&mut self, e: &Expr) -> TokenStream {
        if let Expr::Block(b) = e {
            return self.block(&b.block);
        }
        // Statements such as `x = 1`, `break`, `return` may stand for an arm.
        if crate::stmt::is_statement(e) {
            let stmt = self.expr_stmt(e);
            return quote!(::lobe_codegen::def::Block { stmts: &[#stmt], value: None });
        }
        let value = self.expr(e);
        quote!(::lobe_codegen::def::Block { stmts: &[], value: Some(&#value) })
    }

    fn match_integers(&mut self, e: &syn::ExprMatch) -> TokenStream {
        let selector = self.expr(&e.expr);
        let mut arms = Vec::new();
        for arm in &e.arms {
            let mut patterns = Patterns::default();
            self.pattern(&arm.pat, &mut patterns);
            let values = if patterns.any { Vec::new() } else { patterns.values };
            let body = self.branch(&arm.body);
            let span = source::span(&arm.pat);
            arms.push(
                quote!(::lobe_codegen::def::Arm { patterns: &[#(#values),*], body: #body, span: #span }),
            );
        }
        quote!(::lobe_codegen::def::ExprKind::Match { selector: &#selector, arms: &[#(#arms),*] })
    }

    fn pattern(&mut self, pattern: &syn::Pat, found: &mut Patterns) {
        match pattern {
            syn::Pat::Wild(_) => found.any = true,
            syn::Pat::Or(or) => or.cases.iter().for_each(|case| self.pattern(case, found)),
            syn::Pat::Paren(inner) => self.pattern(&inner.pat, found),
            other => match integer(other) {
                Some(value) => found.values.push(quote!(#value)),
                None => self.refused_pattern(other),
            },
        }
    }

    fn refused_pattern(&mut self, pattern: &syn::Pat) {
        let (what, instead) = match pattern {
            syn::Pat::Guard(_) => ("a guard", "put the test into an `if` inside the arm"),
            syn::Pat::Range(_) => ("a range pattern", "list the values with `|`, or use `if`"),
            syn::Pat::Ident(_) | syn::Pat::Path(_) => {
                ("a name as a pattern", "match literals, `|` and `_`; compare with names by `if`")
            }
            syn::Pat::Lit(_) => ("a pattern that is no integer", "compare with `if`"),
            _ => ("this pattern", "match an integer with literals, `|` and `_`"),
        };
        self.errors.refuse(pattern, what, instead);
    }

    fn refused(&mut self, e: &Expr) -> TokenStream {
        let (what, instead) = match e {
            Expr::Closure(_) => ("a closure", "declare a function under `#[kernel]`"),
            Expr::Reference(_) => ("a reference", "pass the value"),
            Expr::Macro(_) => ("a macro call", "write the code out; assertions belong into tests"),
            Expr::Tuple(_) => ("a tuple", "declare a `#[kernel] struct` with named fields"),
            Expr::Range(_) => ("a range outside `for`", "write `for i in a..b`"),
            Expr::Try(_) => ("`?`", "kernels have no `Option` or `Result`"),
            Expr::Unsafe(_) => ("`unsafe`", "leave it out; kernels have no unsafe operation"),
            Expr::Async(_) | Expr::Await(_) => ("asynchronous code", "a kernel runs from begin to end"),
            Expr::Let(_) => ("`let` in a condition", "compare with `==`"),
            Expr::Block(_) => ("a labelled block", "move it to a function and return from that"),
            Expr::ForLoop(_) | Expr::While(_) | Expr::Loop(_) => {
                ("a loop as a value", "assign to a `let mut` inside the loop")
            }
            Expr::Assign(_) | Expr::Return(_) | Expr::Break(_) | Expr::Continue(_) => {
                ("a statement inside an expression", "write it as a statement of its own")
            }
            _ => ("this expression", "see the list of statements and expressions in lobe_codegen::def"),
        };
        self.errors.refuse(e, what, instead);
        nothing()
    }
}

/// Stands where a mistake was noted; it is never compiled.
fn nothing() -> TokenStream {
    quote!(::lobe_codegen::def::ExprKind::Bool(false))
}

/// What one arm of a `match` stands for.
#[derive(Default)]
struct Patterns {
    values: Vec<TokenStream>,
    /// `_` is among them.
    any: bool,
}

/// An integer literal, possibly negated.
fn integer(pattern: &syn::Pat) -> Option<i64> {
    match syn::parse2(pattern.to_token_stream()).ok()? {
        Expr::Lit(syn::ExprLit { lit: Lit::Int(value), .. }) => value.base10_parse().ok(),
        Expr::Unary(syn::ExprUnary { op: UnOp::Neg(_), expr, .. }) => match *expr {
            Expr::Lit(syn::ExprLit { lit: Lit::Int(value), .. }) => {
                value.base10_parse::<i64>().ok().map(|v| -v)
            }
            _ => None,
        },
        _ => None,
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

/// The operator, unless it assigns.
fn operator(op: &BinOp) -> Option<TokenStream> {
    let name = match op {
        BinOp::Add(_) => quote!(Add),
        BinOp::Sub(_) => quote!(Subtract),
        BinOp::Mul(_) => quote!(Multiply),
        BinOp::Div(_) => quote!(Divide),
        BinOp::Rem(_) => quote!(Remainder),
        BinOp::And(_) => quote!(LogicalAnd),
        BinOp::Or(_) => quote!(LogicalOr),
        BinOp::BitXor(_) => quote!(Xor),
        BinOp::BitAnd(_) => quote!(And),
        BinOp::BitOr(_) => quote!(Or),
        BinOp::Shl(_) => quote!(ShiftLeft),
        BinOp::Shr(_) => quote!(ShiftRight),
        BinOp::Eq(_) => quote!(Equal),
        BinOp::Lt(_) => quote!(Less),
        BinOp::Le(_) => quote!(LessEqual),
        BinOp::Ne(_) => quote!(NotEqual),
        BinOp::Ge(_) => quote!(GreaterEqual),
        BinOp::Gt(_) => quote!(Greater),
        _ => return None,
    };
    Some(quote!(::lobe_codegen::def::BinaryOp::#name))
}

/// The operator of a compound assignment.
pub(crate) fn compound(op: &BinOp) -> Option<TokenStream> {
    let name = match op {
        BinOp::AddAssign(_) => quote!(Add),
        BinOp::SubAssign(_) => quote!(Subtract),
        BinOp::MulAssign(_) => quote!(Multiply),
        BinOp::DivAssign(_) => quote!(Divide),
        BinOp::RemAssign(_) => quote!(Remainder),
        BinOp::BitXorAssign(_) => quote!(Xor),
        BinOp::BitAndAssign(_) => quote!(And),
        BinOp::BitOrAssign(_) => quote!(Or),
        BinOp::ShlAssign(_) => quote!(ShiftLeft),
        BinOp::ShrAssign(_) => quote!(ShiftRight),
        _ => return None,
    };
    Some(quote!(::lobe_codegen::def::BinaryOp::#name))
}
