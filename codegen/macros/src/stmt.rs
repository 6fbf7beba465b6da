//! Statements and blocks.

use crate::expr::{Translator, compound};
use crate::{source, types};
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::{Expr, Pat, Stmt};

/// Whether the expression has no value to speak of, so that it can only stand as a statement.
pub(crate) fn is_statement(e: &Expr) -> bool {
    match e {
        Expr::Assign(_)
        | Expr::While(_)
        | Expr::ForLoop(_)
        | Expr::Loop(_)
        | Expr::Break(_)
        | Expr::Continue(_)
        | Expr::Return(_) => true,
        Expr::Binary(b) => compound(&b.op).is_some(),
        _ => false,
    }
}

impl Translator<'_> {
    /// A `def::Block`; names declared inside end with it.
    pub(crate) fn block(&mut self, block: &syn::Block) -> TokenStream {
        let mark = self.scope.enter();
        let mut stmts = Vec::new();
        let mut value = quote!(None);
        for (i, stmt) in block.stmts.iter().enumerate() {
            match stmt {
                Stmt::Expr(e, None) if i + 1 == block.stmts.len() && !is_statement(e) => {
                    self.refuse_alias(e);
                    let e = self.expr(e);
                    value = quote!(Some(&#e));
                }
                other => stmts.extend(self.stmt(other)),
            }
        }
        self.scope.leave(mark);
        quote!(::lobe_codegen::def::Block { stmts: &[#(#stmts),*], value: #value })
    }

    fn stmt(&mut self, stmt: &Stmt) -> Option<TokenStream> {
        match stmt {
            Stmt::Local(local) => Some(self.local(local)),
            Stmt::Expr(e, _) => Some(self.expr_stmt(e)),
            Stmt::Item(item) => {
                let instead = match item {
                    syn::Item::Use(_) => "move it to the top of the module",
                    _ => "move it out of the function and mark it `#[kernel]`",
                };
                self.errors.refuse(item, "an item inside a function", instead);
                None
            }
            Stmt::Macro(call) => {
                let instead = "write the code out; assertions belong into tests";
                self.errors.refuse(&call.mac, "a macro call", instead);
                None
            }
        }
    }

    fn local(&mut self, local: &syn::Local) -> TokenStream {
        let (pattern, ty) = match &local.pat {
            Pat::Type(typed) => (&*typed.pat, Some(&*typed.ty)),
            other => (other, None),
        };
        // The value is translated first: in `let x = x + 1.0` it means the former `x`.
        let init = match &local.init {
            Some(init) => {
                if let Some((_, diverge)) = &init.diverge {
                    self.errors.refuse(diverge, "`let .. else`", "test with `if` and return");
                }
                self.refuse_alias(&init.expr);
                let e = self.expr(&init.expr);
                quote!(Some(#e))
            }
            None => quote!(None),
        };
        let ty = match ty {
            Some(ty) => {
                let ty = types::cast_target(ty, self.errors);
                quote!(Some(#ty))
            }
            None => quote!(None),
        };
        let local_number = self.declared(pattern);
        self.finish(quote!(Let { local: #local_number, ty: #ty, init: #init }), local)
    }

    /// The local that a pattern declares; patterns that bind more than one name are refused.
    fn declared(&mut self, pattern: &Pat) -> u32 {
        match pattern {
            Pat::Ident(p) if p.by_ref.is_none() && p.subpat.is_none() => {
                self.scope.declare(&p.ident, p.mutability.is_some())
            }
            Pat::Ident(p) if p.by_ref.is_some() => {
                self.errors.refuse(pattern, "a `ref` binding", "kernel values are copied; leave `ref` out");
                0
            }
            Pat::Wild(p) => self.scope.declare_unnamed(&Ident::new("unused", p.underscore_token.span)),
            other => {
                let instead = "bind one name and take its fields with `.`";
                self.errors.refuse(other, "a destructuring pattern", instead);
                0
            }
        }
    }

    /// Notes a second name for memory: what Rust would write through it, a shader would write to a copy.
    pub(crate) fn refuse_alias(&mut self, e: &Expr) {
        if let Expr::Path(p) = e
            && let Some(local) = p.path.get_ident().and_then(|name| self.scope.find(name))
            && self.scope.is_binding(local)
        {
            let instead = "use the parameter itself, or write `*name` for a copy of its value";
            self.errors.refuse(e, "a second name for memory", instead);
        }
    }

    /// An expression that stands as a statement.
    pub(crate) fn expr_stmt(&mut self, e: &Expr) -> TokenStream {
        let kind = match e {
            Expr::Assign(a) => {
                self.refuse_alias(&a.right);
                let (place, value) = (self.expr(&a.left), self.expr(&a.right));
                quote!(Assign { place: #place, op: None, value: #value })
            }
            Expr::Binary(b) if compound(&b.op).is_some() => {
                let op = compound(&b.op);
                let (place, value) = (self.expr(&b.left), self.expr(&b.right));
                quote!(Assign { place: #place, op: Some(#op), value: #value })
            }
            Expr::While(w) => {
                self.unlabelled(w.label.as_ref());
                let (condition, body) = (self.expr(&w.cond), self.block(&w.body));
                quote!(While { condition: #condition, body: #body })
            }
            Expr::Loop(l) => {
                self.unlabelled(l.label.as_ref());
                let body = self.block(&l.body);
                quote!(Loop(#body))
            }
            Expr::ForLoop(f) => self.for_loop(f),
            Expr::Break(b) => {
                self.unlabelled(b.label.as_ref());
                if let Some(value) = &b.expr {
                    self.errors.refuse(value, "`break` with a value", "assign to a `let mut` before `break`");
                }
                quote!(Break)
            }
            Expr::Continue(c) => {
                self.unlabelled(c.label.as_ref());
                quote!(Continue)
            }
            Expr::Return(r) => match &r.expr {
                Some(value) => {
                    let value = self.expr(value);
                    quote!(Return(Some(#value)))
                }
                None => quote!(Return(None)),
            },
            other => {
                let e = self.expr(other);
                quote!(Expr(#e))
            }
        };
        self.finish(kind, e)
    }

    fn for_loop(&mut self, f: &syn::ExprForLoop) -> TokenStream {
        self.unlabelled(f.label.as_ref());
        let Expr::Range(syn::ExprRange { start: Some(start), end: Some(end), limits, .. }) = &*f.expr else {
            self.errors.refuse(
                &f.expr,
                "`for` over anything but a range `a..b`",
                "write `for i in start..end` and index",
            );
            return quote!(Break);
        };
        let (start, end) = (self.expr(start), self.expr(end));
        let inclusive = matches!(limits, syn::RangeLimits::Closed(_));
        let mark = self.scope.enter();
        let local = self.declared(&f.pat);
        let body = self.block(&f.body);
        self.scope.leave(mark);
        quote!(For { local: #local, start: #start, end: #end, inclusive: #inclusive, body: #body })
    }

    fn unlabelled(&mut self, label: Option<&impl quote::ToTokens>) {
        if let Some(label) = label {
            self.errors.refuse(
                label,
                "a loop label",
                "leave the inner loop by a flag, or move it to a function",
            );
        }
    }

    fn finish(&self, kind: TokenStream, at: &dyn quote::ToTokens) -> TokenStream {
        let span = source::span(at);
        quote!(::lobe_codegen::def::Stmt { kind: ::lobe_codegen::def::StmtKind::#kind, span: #span })
    }
}
