//! Whether a contract speaks of things that there are.

use super::error::{Fail, Lowered};
use super::expr::member;
use crate::def::{Domain, DomainDef, FunctionDef, Scalar, Span, TypeDef};

/// Checks the paths of domains and budgets, and that domains are not empty.
pub(super) fn check(def: &FunctionDef) -> Lowered<()> {
    def.contract.domain.iter().try_for_each(|row| domain(def, row))?;
    for budget in def.contract.budget.iter().filter(|b| !b.path.is_empty()) {
        if let Some(ret) = &def.ret {
            follow(*ret, budget.path.split('.'), def.span)?;
        }
    }
    Ok(())
}

fn domain(def: &FunctionDef, row: &DomainDef) -> Lowered<()> {
    let mut names = row.path.split('.');
    let first = names.next().unwrap_or_default();
    let Some(param) = def.params.iter().find(|p| p.name == first) else {
        return Err(Fail::new(row.span, format!("`{first}` is no parameter of `{}`", def.name)));
    };
    let ty = follow(param.ty, names, row.span)?;
    match row.domain {
        Domain::Range(low, high) if low > high || low.is_nan() || high.is_nan() => {
            Err(Fail::new(row.span, format!("the domain {low:?}..={high:?} is empty")))
        }
        Domain::Values([]) => Err(Fail::new(row.span, "the domain lists no value")),
        Domain::Unit if !matches!(ty, TypeDef::Vector(_, Scalar::F32)) => {
            Err(Fail::new(row.span, format!("`unit` speaks of vectors, `{}` is {ty}", row.path)))
        }
        Domain::NormalTo(_) | Domain::Cross(..) if ty != TypeDef::Vector(3, Scalar::F32) => Err(Fail::new(
            row.span,
            format!("`normal_to` and `cross` speak of vectors of three, `{}` is {ty}", row.path),
        )),
        Domain::Range(..) | Domain::Values(_) | Domain::Unit | Domain::NormalTo(_) | Domain::Cross(..) => {
            Ok(())
        }
    }
}

fn follow<'a>(ty: TypeDef, names: impl Iterator<Item = &'a str>, span: Span) -> Lowered<TypeDef> {
    names.into_iter().try_fold(ty, |ty, name| member(&ty, name, span).map(|(_, ty)| ty))
}
