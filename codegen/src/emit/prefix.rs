//! Every name that a file declares, with a prefix: for engines whose shaders have names of their own.

use super::EmitError;
use super::mark::is_predeclared;
use crate::{ValidModule, validate};
use naga::{Module, TypeInner, UniqueArena};
use std::collections::HashMap;

/// The module with `prefix` before the name of each function, structure, constant, variable and entry point, and
/// where its documentation speaks of them in code.
///
/// Members and parameters keep their names: nothing outside of their structure or function can clash with them.
///
/// # Errors
/// When the result is not valid. Whether its names are portable, [`super::emit`] says.
pub fn prefixed(module: &ValidModule, prefix: &str) -> Result<ValidModule, EmitError> {
    renamed(module, false, &|name| format!("{prefix}{name}"))
}

/// The module whose names that end in a digit have it spelt: `f0` is `f_zero`, members too.
///
/// For naga_oil, which refuses them where they can be imported.
///
/// # Errors
/// As of [`prefixed`].
pub(crate) fn without_last_digits(module: &ValidModule) -> Result<ValidModule, EmitError> {
    renamed(module, true, &spelt)
}

/// The name with its last digit in letters, if it ends in one.
pub(crate) fn spelt(name: &str) -> String {
    const DIGITS: [&str; 10] =
        ["zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine"];
    match name.chars().last().and_then(|last| last.to_digit(10)) {
        Some(digit) => {
            let letters = DIGITS[digit as usize];
            let is_upper = name.chars().any(|c| c.is_ascii_uppercase()) && name == name.to_uppercase();
            let letters = if is_upper { letters.to_uppercase() } else { letters.to_owned() };
            format!("{}_{letters}", name[..name.len() - 1].trim_end_matches('_'))
        }
        None => name.to_owned(),
    }
}

/// The module with other names, of members too if `with_members`.
fn renamed(
    module: &ValidModule,
    with_members: bool,
    of: &dyn Fn(&str) -> String,
) -> Result<ValidModule, EmitError> {
    let mut renamed = module.module().clone();
    let mut names = HashMap::new();
    let mut rename = |name: &mut String| {
        let new = of(name);
        names.insert(std::mem::replace(name, new.clone()), new);
    };
    rename_types(&mut renamed, with_members, &mut rename);
    renamed.constants.iter_mut().filter_map(|(_, c)| c.name.as_mut()).for_each(&mut rename);
    renamed.global_variables.iter_mut().filter_map(|(_, g)| g.name.as_mut()).for_each(&mut rename);
    renamed.functions.iter_mut().filter_map(|(_, f)| f.name.as_mut()).for_each(&mut rename);
    renamed.entry_points.iter_mut().map(|e| &mut e.name).for_each(&mut rename);
    rename_in_docs(&mut renamed, &names);
    validate::validate(renamed, module.meta().clone())
        .map_err(|e| EmitError::Entry { function: "the renamed module".to_owned(), reason: e.to_string() })
}

fn rename_types(module: &mut Module, with_members: bool, rename: &mut impl FnMut(&mut String)) {
    let mut types = UniqueArena::new();
    for (handle, ty) in module.types.iter() {
        let mut ty = ty.clone();
        if let TypeInner::Struct { members, .. } = &mut ty.inner
            && !is_predeclared(module, handle)
        {
            ty.name.as_mut().into_iter().for_each(&mut *rename);
            let names = members.iter_mut().filter_map(|member| member.name.as_mut());
            names.filter(|_| with_members).for_each(&mut *rename);
        }
        // No two types were equal, and none became so: each gets the handle it had.
        types.insert(ty, module.types.get_span(handle));
    }
    module.types = types;
}

fn rename_in_docs(module: &mut Module, names: &HashMap<String, String>) {
    let Some(docs) = module.doc_comments.as_deref_mut() else { return };
    let all = docs
        .types
        .values_mut()
        .chain(docs.struct_members.values_mut())
        .chain(docs.entry_points.values_mut())
        .chain(docs.functions.values_mut())
        .chain(docs.constants.values_mut())
        .chain(docs.global_variables.values_mut());
    all.flatten().for_each(|line| *line = with_names(line, names));
}

/// The line with new names where it is code: between backticks.
fn with_names(line: &str, names: &HashMap<String, String>) -> String {
    let parts = line.split('`').enumerate();
    let renamed = parts.map(|(i, part)| if i % 2 == 1 { words(part, names) } else { part.to_owned() });
    renamed.collect::<Vec<_>>().join("`")
}

fn words(code: &str, names: &HashMap<String, String>) -> String {
    let pieces = super::scan::pieces(code);
    pieces.iter().map(|p| names.get(p.text).map_or(p.text, String::as_str)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emit::{Options, Target, emit};
    use crate::validate::from_wgsl;

    const TEXT: &str = "
        /// Twice a `Lobe`'s `sharpness`, by `twice`; twice is plain here.
        struct Lobe { sharpness: f32 }
        const TWO: f32 = 2.0;
        fn twice(lobe: Lobe) -> f32 { let twice_of = lobe.sharpness * TWO; return twice_of; }
        fn four(lobe: Lobe) -> f32 { return twice(Lobe(twice(lobe))); }";

    #[test]
    fn what_is_declared_has_the_prefix_and_nothing_else() {
        let module = prefixed(&from_wgsl(TEXT).unwrap(), "eng_").unwrap();
        for target in Target::TEXTS {
            let options = Options { header: false, ..Options::default() };
            let text = emit(&module, target, &options).unwrap().content;
            let text = text.text().unwrap();
            for name in ["eng_Lobe", "eng_TWO", "eng_twice", "eng_four"] {
                assert!(text.contains(name), "{target}: {name}\n{text}");
            }
            for word in ["eng_sharpness", "eng_lobe", " twice(", " Lobe ", "eng_eng_"] {
                assert!(!text.contains(word), "{target}: {word}\n{text}");
            }
        }
    }

    #[test]
    fn documentation_follows_in_code_alone() {
        let names = HashMap::from([("twice".to_owned(), "eng_twice".to_owned())]);
        assert_eq!(
            with_names("twice: `2 twice(x)`, `twice_x`", &names),
            "twice: `2 eng_twice(x)`, `twice_x`"
        );
    }

    #[test]
    fn last_digits_are_spelt() {
        for (name, expected) in [
            ("f0", "f_zero"),
            ("F0", "F_ZERO"),
            ("x12", "x1_two"),
            ("LN_2", "LN_TWO"),
            ("expm1_of", "expm1_of"),
        ] {
            assert_eq!(spelt(name), expected);
        }
    }

    #[test]
    fn a_prefix_that_makes_names_unportable_is_refused() {
        let module = prefixed(&from_wgsl(TEXT).unwrap(), "gl_").unwrap();
        let error = emit(&module, Target::Hlsl, &Options::default()).unwrap_err().to_string();
        assert!(error.contains("begins with `gl_`"), "{error}");
    }
}
