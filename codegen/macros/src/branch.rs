//! `if` and `match`.

use crate::expr::{Translator, nothing};
use crate::source;
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::{Expr, Lit, UnOp};

impl Translator<'_> {
    pub(crate) fn if_else(&mut self, e: &syn::ExprIf) -> TokenStream {
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
        self.refuse_alias(e);
        let value = self.expr(e);
        quote!(::lobe_codegen::def::Block { stmts: &[], value: Some(&#value) })
    }

    pub(crate) fn match_integers(&mut self, e: &syn::ExprMatch) -> TokenStream {
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
            syn::Pat::Lit(_) => ("`match` on anything but an integer", "compare with `if`"),
            _ => ("this pattern", "match an integer with literals, `|` and `_`"),
        };
        self.errors.refuse(pattern, what, instead);
    }
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
