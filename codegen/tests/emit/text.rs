//! Form: header, docs, blanks, and the same bytes each time.

use crate::common::{artifact, module, rich, text};
use lobe_codegen::emit::{Content, Options, Target, emit, with_entry};
use lobe_codegen::prelude::*;

#[test]
fn doc_comments_stand_above_what_they_document() {
    let wgsl = text(&rich(), Target::Wgsl);
    for block in [
        "/// A lobe.\n///\n/// Unit axis.\nstruct Sg {\n    /// Direction, unit length.\n    axis: vec3<f32>,\n    /// 1/sr\n    sharpness: f32,\n",
        "/// Twice π.\nconst TWO_PI: f32 = ",
        "/// The square, `x²`.\nfn square(",
    ] {
        assert!(wgsl.contains(block), "{block}\n{wgsl}");
    }
    let hlsl = text(&rich(), Target::Hlsl);
    for block in [
        "/// Unit axis.\nstruct Sg {\n    /// Direction, unit length.\n    float3 axis;\n    /// 1/sr\n    float sharpness;\n",
        "/// Twice π.\nstatic const float TWO_PI = ",
        "/// The square, `x²`.\nfloat square(",
    ] {
        assert!(hlsl.contains(block), "{block}\n{hlsl}");
    }
    for target in Target::TEXTS {
        assert_eq!(text(&rich(), target).matches("Twice π").count(), 1, "{target}");
        let bare =
            emit(&rich(), target, &Options { docs: false, header: false, ..Options::default() }).unwrap();
        assert!(!bare.content.text().unwrap().contains("//"), "{target}");
    }
}

#[kernel]
/// The half.
#[doc = concat!("included", "\nin two lines\n")]
fn halved(x: f32) -> f32 {
    0.5 * x
}

#[test]
fn an_included_text_is_part_of_the_doc_comment() {
    let module = lobe_codegen::lower(&lobe_codegen::kernels![halved]).unwrap();
    let wgsl = text(&module, Target::Wgsl);
    assert!(wgsl.contains("/// The half.\n/// included\n/// in two lines\nfn halved("), "{wgsl}");
}

#[test]
fn a_doc_comment_cannot_leave_its_comment() {
    let mut naga = module("fn f(x: f32) -> f32 { return x; }").module().clone();
    let (handle, _) = naga.functions.iter().next().unwrap();
    let evil = vec!["tail \\".to_owned(), "a\u{2028}fn evil() {}\nlobeqaaaaa".to_owned()];
    naga.get_or_insert_default_doc_comments().functions.insert(handle, evil);
    let valid =
        lobe_codegen::validate::validate(naga, Default::default()).map_err(|e| e.to_string()).unwrap();
    for target in Target::TEXTS {
        let out = emit(&valid, target, &Options::default()).unwrap();
        let text = out.content.text().unwrap();
        assert!(text.contains("/// tail\n/// a fn evil() {}\n/// lobeqaaaaa\n"), "{target}\n{text}");
    }
}

#[test]
fn the_header_says_who_wrote_it_and_how_to_write_it_again() {
    let text = text(&rich(), Target::Hlsl);
    let mut lines = text.lines();
    assert_eq!(
        lines.next(),
        Some(concat!(
            "// Written by Lobe ",
            env!("CARGO_PKG_VERSION"),
            " from the kernels product, framed, parts, flags."
        ))
    );
    assert_eq!(
        lines.next(),
        Some("// Do not edit; write it again with: lobe emit --target hlsl product framed parts flags")
    );
    let options = Options {
        kernels: vec!["flags".to_owned()],
        command: Some("make\nshaders \\".to_owned()),
        ..Options::default()
    };
    let own = emit(&rich(), Target::Wgsl, &options).unwrap();
    let expected = "from the kernel flags.\n// Do not edit; write it again with: make shaders\n\n";
    assert!(own.content.text().unwrap().contains(expected));
}

#[test]
fn the_text_is_tidy() {
    for target in Target::TEXTS {
        let text = text(&rich(), target);
        assert!(text.ends_with("}\n") && !text.ends_with("\n\n"), "{target}");
        assert!(
            !text.contains("\n\n\n") && !text.contains('\t') && !text.contains(" \n"),
            "{target}\n{text}"
        );
        assert!(text.contains("}\n\nfn f1") || text.contains("}\n\nfloat f1"), "{target}");
    }
}

#[test]
fn the_same_module_gives_the_same_bytes() {
    let (entry, _) = with_entry(&rich(), rich().function("product").unwrap(), 64).unwrap();
    for target in Target::ALL {
        let first = artifact(&entry, target);
        for _ in 0..100 {
            let (again, _) = with_entry(&rich(), rich().function("product").unwrap(), 64).unwrap();
            assert_eq!(artifact(&again, target).content.bytes(), first.content.bytes(), "{target}");
        }
    }
}

#[test]
fn words_are_little_endian() {
    assert_eq!(Content::Words(vec![0x0723_0203]).bytes(), [3, 2, 0x23, 7]);
}

#[test]
fn a_library_has_no_spirv_and_the_error_says_what_to_do() {
    let error = emit(&rich(), Target::Spirv, &Options::default()).unwrap_err();
    assert!(error.to_string().contains("emit the entry form"), "{error}");
}

/// Loops and `switch` make the HLSL writer add names of its own; a parameter may have them.
#[test]
fn parameters_are_stronger_than_the_writers_own_names() {
    let source = "fn f(loop_init: u32) -> u32 {
        var s = 0u;
        for (var i = 0u; i < loop_init; i = i + 1u) { s = s + i; }
        return s;
    }";
    let text = text(&module(source), Target::Hlsl);
    assert!(text.contains("uint f(uint loop_init)") && text.contains("bool loop_init_1 = true;"), "{text}");
}
