//! One entry point of a module.

use super::read::validated;
use super::{ForeignError, Source, guarded, workgroup};
use crate::ValidModule;
use naga::back::pipeline_constants::process_overrides;
use naga::{EntryPoint, ShaderStage};

/// A value for a pipeline-overridable constant.
#[derive(Debug, Clone, PartialEq)]
pub struct Override {
    /// Its name, or its number where it has one (`@id`).
    pub name: String,
    /// Its value.
    pub value: f64,
}

/// The compute entry point called `wanted`; the only one if no name is given.
///
/// # Errors
/// When there is none, or more than one to choose from.
pub fn choose(source: &Source, module: &ValidModule, wanted: Option<&str>) -> Result<String, ForeignError> {
    let points = &module.module().entry_points;
    let names = |is_compute: bool| -> Vec<String> {
        let is_meant = |p: &&EntryPoint| (p.stage == ShaderStage::Compute) == is_compute;
        points.iter().filter(is_meant).map(|p| p.name.clone()).collect()
    };
    let (name, entries) = (source.name.clone(), names(true));
    match (wanted, entries.as_slice()) {
        (_, []) => Err(ForeignError::NoEntry { name, others: names(false) }),
        (Some(wanted), _) if entries.iter().any(|e| e == wanted) => Ok(wanted.to_owned()),
        (Some(wanted), _) => Err(ForeignError::UnknownEntry { name, wanted: wanted.to_owned(), entries }),
        (None, [only]) => Ok(only.clone()),
        (None, _) => Err(ForeignError::SeveralEntries { name, entries }),
    }
}

/// The module of compute entry point `entry` alone, with what it uses, and values in place of its overrides.
///
/// # Errors
/// When an override has no value, or one that does not fit, or there is none of a name given.
pub fn isolate(
    source: &Source,
    module: &ValidModule,
    entry: &str,
    overrides: &[Override],
) -> Result<ValidModule, ForeignError> {
    let point = Some((ShaderStage::Compute, entry));
    let constants = overrides.iter().map(|o| (o.name.clone(), o.value)).collect();
    let resolved = guarded(source, "override evaluation", || {
        let resolved = process_overrides(module.module(), module.info(), point, &constants);
        resolved.map(|(module, _)| module.into_owned()).map_err(|error| error.to_string())
    })?;
    let mut resolved = resolved.map_err(|reason| ForeignError::Override {
        name: source.name.clone(),
        reason,
        overrides: names(module.module()),
    })?;
    workgroup::settle(&mut resolved);
    check_stage(source, &resolved)?;
    validated(source, resolved)
}

/// GLSL does not say of what stage it is: what has inputs or outputs of others is no compute shader.
fn check_stage(source: &Source, module: &naga::Module) -> Result<(), ForeignError> {
    let is_located =
        |binding: &Option<naga::Binding>| matches!(binding, Some(naga::Binding::Location { .. }));
    let computing = module.entry_points.iter().filter(|p| p.stage == ShaderStage::Compute);
    for point in computing {
        let input = point.function.arguments.iter().any(|a| is_located(&a.binding));
        if input || point.function.result.is_some() {
            let what = if input { "an input at a location" } else { "an output" };
            return Err(ForeignError::Unsupported {
                name: source.name.clone(),
                what: format!("`{}` has {what}, as shaders of other stages have", point.name),
            });
        }
    }
    Ok(())
}

/// How a user may name the overrides.
fn names(module: &naga::Module) -> Vec<String> {
    let name = |o: &naga::Override| o.id.map(|id| id.to_string()).or_else(|| o.name.clone());
    module.overrides.iter().filter_map(|(_, o)| name(o)).collect()
}
