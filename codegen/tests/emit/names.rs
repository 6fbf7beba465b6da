//! The declared name is the emitted name, or there is an error.

use crate::common::{module, rich, text, words};
use lobe_codegen::emit::{ClashError, EmitError, Options, Target, emit};
use lobe_codegen::names::{check, check_member};

const TEXTS: [Target; 5] = Target::TEXTS;

#[test]
fn declared_names_survive_in_every_text() {
    for target in TEXTS {
        let text = text(&rich(), target);
        let words = words(&text);
        for name in
            ["square", "f1", "product", "total", "framed", "parts", "flags", "Sg", "Frame", "TWO_PI", "AXES"]
        {
            assert!(words.iter().any(|w| w == name), "{target}: {name}\n{text}");
            assert!(!words.contains(&format!("{name}_")), "{target}: {name}_\n{text}");
        }
        for word in &words {
            let is_baked = word.strip_prefix("_e").is_some_and(|n| n.parse::<u32>().is_ok());
            assert!(!word.contains("lobeq") && !is_baked, "{target}: {word}\n{text}");
        }
    }
}

#[test]
fn signatures_are_as_declared() {
    let wgsl = text(&rich(), Target::Wgsl);
    for line in [
        "fn square(x: f32) -> f32 {",
        "fn f1(x: f32, x2: f32) -> f32 {",
        "fn product(x: Sg, b: Sg) -> Sg {",
        "fn total(count: u32, values: array<f32, 4>) -> f32 {",
    ] {
        assert!(wgsl.contains(line), "{line}\n{wgsl}");
    }
    let hlsl = text(&rich(), Target::Hlsl);
    for line in [
        "float square(float x)",
        "float f1(float x, float x2)",
        "Sg product(Sg x, Sg b)",
        "float total(uint count, float values[4])",
        "Frame ConstructFrame(",
        "void SetMatthinOnFrame(inout Frame obj",
    ] {
        assert!(hlsl.contains(line), "{line}\n{hlsl}");
    }
}

#[test]
fn locals_keep_their_names_where_they_are_free() {
    let wgsl = text(&rich(), Target::Wgsl);
    let body = wgsl.split("fn f1").nth(1).unwrap().split("fn product").next().unwrap();
    assert!(body.contains("let y1 = square("), "{body}");
    assert!(body.contains("let y1_1 = "), "the shadowing one\n{body}");
    assert!(body.contains("let x_1 = "), "{body}");
    assert!(body.contains("var half_1: f32;"), "a type in HLSL\n{body}");
    assert!(body.contains("let lerp_1 = "), "a function in HLSL\n{body}");
}

#[test]
fn a_local_never_hides_what_its_function_uses() {
    let source = "
        const scale: f32 = 2.0;
        fn twice(x: f32) -> f32 { return x * scale; }
        fn f(v: f32) -> f32 {
            let twice_1 = v + 1.0;
            let y = twice(twice_1) + twice(v) * scale;
            { let scale = y * y; let twice = scale + y; return scale * twice * twice + twice_1; }
        }";
    for target in TEXTS {
        let text = text(&module(source), target);
        let body = text.split("twice_1 = ").next().map(|_| text.as_str()).unwrap();
        let plain = body.replace('(', "");
        assert!(body.contains("scale_1") && plain.contains("twice_1 = v + 1"), "{target}\n{body}");
        assert!(!body.contains("let twice =") && !body.contains("float twice ="), "{target}\n{body}");
    }
}

#[test]
fn clashes_are_errors_that_name_both_sides() {
    let clash = |text: &str, target: Target| match emit(&module(text), target, &Options::default()) {
        Err(EmitError::Name(error)) => error,
        other => panic!("{text}: {other:?}"),
    };
    let hidden = "fn g(x: f32) -> f32 { return x; } fn f(a: f32) -> f32 { return g(a); }";
    assert!(emit(&module(hidden), Target::Wgsl, &Options::default()).is_ok());
    // In IR a parameter may be called as a function that its own function calls.
    let mut naga = module(hidden).module().clone();
    let (_, f) = naga.functions.iter_mut().nth(1).unwrap();
    f.arguments[0].name = Some("g".to_owned());
    let valid = lobe_codegen::validate::validate(naga.clone(), Default::default())
        .map_err(|e| e.to_string())
        .unwrap();
    for target in TEXTS {
        let error = emit(&valid, target, &Options::default()).unwrap_err();
        assert!(matches!(&error, EmitError::Name(ClashError::Hidden { name, .. }) if name == "g"), "{error}");
    }
    let (_, f) = naga.functions.iter_mut().nth(1).unwrap();
    f.name = Some("g".to_owned());
    let valid =
        lobe_codegen::validate::validate(naga, Default::default()).map_err(|e| e.to_string()).unwrap();
    let error = emit(&valid, Target::Spirv, &Options::default()).unwrap_err();
    assert!(error.to_string().contains("names a function and a function"), "{error}");

    let refused = clash("struct S { half: f32 } fn f(s: S) -> f32 { return s.half; }", Target::Wgsl);
    assert!(
        refused.to_string().starts_with("a member of `S`: `half` is a type in HLSL and MSL"),
        "{refused}"
    );
    let refused = clash("fn lerp(x: f32) -> f32 { return x; }", Target::Wgsl);
    assert!(refused.to_string().contains("a built-in function in HLSL"), "{refused}");
    let own = clash("struct S { S: f32 } fn f(s: S) -> f32 { return s.S; }", Target::Wgsl);
    assert!(matches!(own, ClashError::Twice { .. }), "{own}");
    let helper = "struct S { a: f32 } fn ConstructS(x: f32) -> S { return S(x); }";
    assert!(matches!(clash(helper, Target::Hlsl), ClashError::Helper { .. }));
}

#[test]
fn parameters_may_be_called_as_items_that_their_function_does_not_use() {
    let source =
        "fn sharpness(x: f32) -> f32 { return x; } fn f(sharpness: f32) -> f32 { return sharpness * 2.0; }";
    for target in TEXTS {
        assert!(text(&module(source), target).replace('(', "").contains("return sharpness * 2"), "{target}");
    }
}

#[test]
fn a_local_never_takes_a_name_that_the_writer_uses() {
    let source = "fn f(n: u32) -> u32 {
        var s = n;
        loop {
            let should_continue = s * 2u;
            let other = should_continue + should_continue * s;
            switch other { case 1u: { continue; } case 2u: { s = s + other; } default: {} }
            s = s + should_continue;
            if s > 100u { break; }
        }
        return s;
    }
    fn other(n: u32) -> u32 { return n; }";
    let hlsl = text(&module(source), Target::Hlsl);
    assert_eq!(hlsl.matches("bool should_continue = false;").count(), 1, "{hlsl}");
    assert!(hlsl.contains("uint should_continue_1 = ") && hlsl.contains("uint other_1 = "), "{hlsl}");
}

#[test]
fn hostile_words_are_refused() {
    let words: Vec<&str> = include_str!("hostile.txt").split_whitespace().collect();
    let free: Vec<&str> = words.iter().copied().filter(|word| check(word).is_ok()).collect();
    assert!(words.len() > 300 && free.is_empty(), "{} words, let through: {free:?}", words.len());
    for word in [
        "",
        "_x",
        "x_",
        "a__b",
        "λ",
        "2x",
        "a-b",
        "a b",
        "gl_Position",
        "naga_div",
        "nagaSamplerHeap",
        "lobeqx",
    ] {
        assert!(check(word).is_err() && check_member(word).is_err(), "{word}");
    }
    for word in ["PASS", "Technique", "dEcl", "TEXTURE2D"] {
        assert!(check(word).unwrap_err().to_string().contains("HLSL"), "{word}");
    }
}

#[test]
fn every_refusal_of_a_checked_name_would_have_been_a_rename_by_naga() {
    // What `check` lets through, naga's own namer leaves alone (but for a digit at the end).
    let free = ["sg_product", "axis", "Sg", "TWO_PI", "expm1_over_x", "frame", "weight", "mean", "rect", "x"];
    for name in free {
        let source = format!("fn {name}(a: f32) -> f32 {{ return a; }}");
        let options = naga::valid::ValidationFlags::all();
        let parsed = naga::front::wgsl::parse_str(&source).unwrap();
        let info = naga::valid::Validator::new(options, naga::valid::Capabilities::empty())
            .validate(&parsed)
            .unwrap();
        let raw =
            naga::back::wgsl::write_string(&parsed, &info, naga::back::wgsl::WriterFlags::empty()).unwrap();
        assert!(raw.contains(&format!("fn {name}(")), "{raw}");
    }
}
