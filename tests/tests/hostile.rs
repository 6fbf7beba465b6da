//! Names that come near to words of some language: each is refused with a reason, or every compiler takes it as it is.

mod common;

use common::tool;
use lobe_backends::translate::{Dawn, Dxc, DxcOutput, Glslang, Tint};
use lobe_codegen::ValidModule;
use lobe_codegen::emit::{Options, Target, emit};
use lobe_codegen::names;
use lobe_codegen::validate::{from_wgsl, validate};
use naga::{Module, TypeInner};
use std::collections::BTreeSet;

/// Words of all languages.
const WORDS: &str = include_str!("../../codegen/tests/emit/hostile.txt");

/// Each word, and what comes near it: a digit at its end, other cases, a part of a longer name.
fn candidates() -> BTreeSet<String> {
    let near = |word: &str| {
        let mut title = word.to_owned();
        title[..1].make_ascii_uppercase();
        let (upper, lower) = (word.to_uppercase(), word.to_lowercase());
        let (digit, whole) = (format!("{word}7"), format!("my_{word}"));
        [word.to_owned(), title, upper, lower, digit, whole, format!("{word}_of_2x2")]
    };
    let fixed =
        ["x2", "f1", "a1b2", "E", "PI", "TAU", "e", "i", "O", "Sg", "sg", "SG", "row_count", "results"];
    WORDS.split_whitespace().flat_map(near).chain(fixed.map(str::to_owned)).collect()
}

/// A module with a function of each name, and a structure whose members have the others.
fn module(functions: &[String], members: &[String]) -> ValidModule {
    let spell = |i: usize| format!("value_{i}_x");
    let fields: String = (0..members.len()).map(|i| format!("{}: f32,\n", spell(i))).collect();
    let sum: String = (0..members.len()).map(|i| format!("sum += s.{};\n", spell(i))).collect();
    let mut text = format!(
        "struct Named {{ {fields} }}\nfn summed_up(s: Named) -> f32 {{ var sum = 0.0;\n{sum} return sum; }}\n"
    );
    for i in 0..functions.len() {
        text += &format!(
            "fn value_{i}_f(x: f32) -> f32 {{ let twice_of = x * 0.5; return twice_of + {i}.0; }}\n"
        );
    }
    let calls: String = (0..functions.len()).map(|i| format!("sum += value_{i}_f(x);\n")).collect();
    text += &format!("fn called_up(x: f32) -> f32 {{ var sum = 0.0;\n{calls} return sum; }}\n");
    let mut named = from_wgsl(&text).unwrap_or_else(|e| panic!("{e}")).module().clone();
    // A front end would refuse many of them; the intermediate representation takes any name.
    let is_mine = |f: &naga::Function| f.name.as_deref().is_some_and(|name| name.ends_with("_f"));
    let mine = named.functions.iter_mut().filter(|(_, f)| is_mine(f));
    mine.zip(functions).for_each(|((_, function), name)| function.name = Some(name.clone()));
    rename_members(&mut named, members);
    validate(named, Default::default()).unwrap_or_else(|e| panic!("{e}"))
}

fn rename_members(module: &mut Module, names: &[String]) {
    let mut types = naga::UniqueArena::new();
    for (handle, ty) in module.types.iter() {
        let mut ty = ty.clone();
        if let TypeInner::Struct { members, .. } = &mut ty.inner {
            members.iter_mut().zip(names).for_each(|(member, name)| member.name = Some(name.clone()));
        }
        types.insert(ty, module.types.get_span(handle));
    }
    module.types = types;
}

fn written(module: &ValidModule, target: Target) -> String {
    let artifact = emit(module, target, &Options::default()).unwrap_or_else(|e| panic!("{target}: {e}"));
    artifact.content.text().expect("text").to_owned()
}

fn free_names() -> (Vec<String>, Vec<String>) {
    let candidates = candidates();
    let functions = candidates.iter().filter(|name| names::check(name).is_ok()).cloned().collect();
    let members = candidates.iter().filter(|name| names::check_member(name).is_ok()).cloned().collect();
    (functions, members)
}

#[test]
fn a_name_is_refused_with_a_reason_or_free() {
    let candidates = candidates();
    let (functions, members) = free_names();
    assert!(candidates.len() > 2000 && functions.len() > 1000 && members.len() > functions.len());
    for name in candidates.iter().filter(|name| !functions.contains(name)) {
        let reason = names::check(name).expect_err("refused").to_string();
        assert!(reason.contains(name.as_str()) && reason.len() > name.len() + 20, "{reason}");
    }
    for word in WORDS.split_whitespace() {
        assert!(!functions.iter().any(|name| name == word), "{word}");
    }
}

#[test]
fn free_names_are_declared_as_they_are_in_every_language() {
    let (functions, members) = free_names();
    let module = module(&functions, &members);
    for target in Target::TEXTS {
        let text = written(&module, target);
        let words: BTreeSet<&str> = text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).collect();
        for name in functions.iter().chain(&members) {
            assert!(words.contains(name.as_str()), "{target}: {name}");
            assert!(!words.contains(format!("{name}_").as_str()), "{target}: {name}_");
        }
    }
}

#[test]
fn naga_and_tint_take_them() {
    let (functions, members) = free_names();
    let text = written(&module(&functions, &members), Target::Wgsl);
    from_wgsl(&text).unwrap_or_else(|e| panic!("{e}"));
    let Some(mut tint) = tool(Dawn::find().and_then(|dawn| Tint::start(&dawn))) else { return };
    tint.validate(&text).unwrap_or_else(|e| panic!("{e}"));
}

#[test]
fn dxc_takes_them() {
    let Some(dxc) = tool(Dxc::find()) else { return };
    let (functions, members) = free_names();
    let text = written(&module(&functions, &members), Target::Hlsl);
    let object = dxc.compile(&text, "lib_6_3", None, DxcOutput::Dxil).unwrap_or_else(|e| panic!("{e}"));
    for name in functions {
        let mangled = format!("?{name}@@Y");
        assert!(object.windows(mangled.len()).any(|bytes| bytes == mangled.as_bytes()), "{name}");
    }
}

#[test]
fn glslang_takes_them_in_both_versions() {
    let Some(glslang) = tool(Glslang::find()) else { return };
    let (functions, members) = free_names();
    let module = module(&functions, &members);
    for (target, head) in [
        (Target::Glsl, "#version 450\n"),
        (Target::Essl, "#version 310 es\nprecision highp float;\nprecision highp int;\n"),
    ] {
        let whole = format!("{head}{}\nvoid main() {{}}\n", written(&module, target));
        glslang.validate(&whole).unwrap_or_else(|e| panic!("{target}: {e}"));
    }
}
