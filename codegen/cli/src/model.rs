//! `--model`: which specification drivers keep to.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use lobe_codegen::accuracy::Model;

/// Takes the name of a model.
pub(crate) fn parser() -> impl TypedValueParser<Value = &'static Model> {
    let values = Model::all().iter().map(|model| PossibleValue::new(model.name).help(model.title));
    PossibleValuesParser::new(values).try_map(|name| Model::named(&name).ok_or("no such model"))
}
