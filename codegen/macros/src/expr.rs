//! Expressions.

use crate::errors::Errors;
use crate::scope::Scope;
use crate::{source, types};
use proc_macro2::TokenStream;
use quote::quote;
use syn::{BinOp, Expr, Lit, UnOp};

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
    pub(crate) fn exprs<'a>(&mut self, list: impl IntoIterator<Item = &'a Expr>) -> TokenStream {
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
                    match i.base10_parse::<u32>() {
                        Ok(value) => {
                            let value = u64::from(value);
                            quote!(::lobe_codegen::def::ExprKind::Int(#value, #scalar))
                        }
                        Err(_) => {
                            self.errors.at(lit, "an integer of the kernel language has 32 bits");
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
pub(crate) fn nothing() -> TokenStream {
    quote!(::lobe_codegen::def::ExprKind::Bool(false))
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
