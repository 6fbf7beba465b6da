//! slang: what it makes of good shaders, and what it says of bad ones.

mod common;

use std::fs;

use common::{DEMANDING_WGSL, hlsl, tool};
use lobe_backends::translate::{Slang, TranslateError, spirv_val, spirv_words};

#[track_caller]
fn slang() -> Option<Slang> {
    tool(Slang::find())
}

#[test]
fn the_version_is_told() {
    let Some(slang) = slang() else { return };
    let year = slang.version().split('.').next().and_then(|year| year.parse::<u32>().ok());
    assert!(year >= Some(2024), "{slang:?}");
}

#[test]
fn a_shader_becomes_valid_spirv_without_a_warning() {
    let Some(slang) = slang() else { return };
    let compiled = slang.compile_with_warnings(&hlsl(DEMANDING_WGSL), "main").expect("compiles");
    assert_eq!(compiled.warnings, "");
    let words = spirv_words(&compiled.object).expect("words");
    assert_eq!(words[..2], [0x0723_0203, 0x0001_0300], "SPIR-V 1.3");
    if tool(spirv_val::find()).is_some() {
        spirv_val::validate(&words).expect("valid");
    }
}

/// Whether the SPIR-V decorates a variable with this descriptor set and this binding.
fn is_bound(words: &[u32], group: u32, binding: u32) -> bool {
    const DECORATE: u32 = 4 << 16 | 71;
    let decorated = |what: u32, number: u32| {
        let places = words.windows(4).filter(move |w| w[0] == DECORATE && w[2] == what && w[3] == number);
        places.map(|w| w[1]).collect::<Vec<_>>()
    };
    let (sets, bindings) = (decorated(34, group), decorated(33, binding));
    sets.iter().any(|id| bindings.contains(id))
}

#[test]
fn registers_and_spaces_are_bindings_and_groups() {
    let Some(slang) = slang() else { return };
    let hlsl = "
        cbuffer size : register(b4, space1) { uint size; }
        ByteAddressBuffer input : register(t5);
        RWByteAddressBuffer output : register(u6, space2);
        Texture2D<float> picture : register(t7, space3);
        SamplerState smooth : register(s8, space3);
        [numthreads(1, 1, 1)] void first(uint3 id : SV_DispatchThreadID) {
            float texel = picture.SampleLevel(smooth, float2(0.5, 0.5), 0);
            output.Store(0, input.Load(0) + size + asuint(texel));
        }";
    let words = slang.compile(hlsl, "first").and_then(|bytes| spirv_words(&bytes)).expect("compiles");
    for (group, binding) in [(1, 4), (0, 5), (2, 6), (3, 7), (3, 8)] {
        assert!(is_bound(&words, group, binding), "group {group}, binding {binding}");
    }
    assert!(!is_bound(&words, 0, 4));
}

#[test]
fn warnings_are_handed_on() {
    let Some(slang) = slang() else { return };
    let hlsl = "[numthreads(1, 1, 1)] void main() { float a = 1.5; uint b = a; }";
    let compiled = slang.compile_with_warnings(hlsl, "main").expect("compiles");
    assert!(compiled.warnings.contains("implicit conversion"), "{}", compiled.warnings);
}

#[track_caller]
fn refused(hlsl: &str, entry: &str, part: &str) {
    let Some(slang) = slang() else { return };
    let error = slang.compile(hlsl, entry).expect_err("should be refused");
    assert!(matches!(error, TranslateError::Rejected { .. }), "{error:?}");
    assert!(error.to_string().contains(part), "{error}");
}

#[test]
fn the_compilers_own_words_come_through() {
    refused("[numthreads(1, 1, 1)]\nvoid main() { undeclared = 1; }", "main", "shader.hlsl:2:15");
    refused("[numthreads(1, 1, 1)]\nvoid main() { undeclared = 1; }", "main", "undefined identifier");
    refused("void f() {}", "main", "main");
    refused("#include \"other.hlsl\"", "main", "other.hlsl");
    refused("", "main", "main");
}

#[test]
fn a_refusal_leaves_the_compiler_usable() {
    let Some(slang) = slang() else { return };
    let hlsl = hlsl(DEMANDING_WGSL);
    let first = slang.compile(&hlsl, "main").expect("compiles");
    slang.compile("void main( {", "main").expect_err("should be refused");
    assert_eq!(slang.compile(&hlsl, "main"), Ok(first));
}

#[test]
fn many_threads_share_one_compiler() {
    let Some(slang) = slang() else { return };
    let hlsl = hlsl(DEMANDING_WGSL);
    let compile = || slang.compile(&hlsl, "main").expect("compiles");
    let first = compile();
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..4).map(|_| scope.spawn(compile)).collect();
        for thread in threads {
            assert_eq!(thread.join().expect("no panic"), first, "the same text gives the same bytes");
        }
    });
}

#[track_caller]
fn unusable(bytes: Option<&[u8]>, part: &str) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("libslang-compiler.so");
    if let Some(bytes) = bytes {
        fs::write(&path, bytes).expect("writable");
    }
    let error = Slang::load(&path).expect_err("should be refused");
    assert!(matches!(error, TranslateError::Unusable { .. }), "{error:?}");
    assert!(error.to_string().contains(part), "{error}");
    assert!(error.to_string().contains("libslang-compiler.so"), "{error}");
}

#[test]
fn damaged_libraries_are_named() {
    unusable(None, "No such file");
    unusable(Some(b"gone"), "4 bytes, too few");
    unusable(Some(&[b'x'; 4096]), "invalid ELF header");
    if let Some(slang) = slang() {
        let whole = fs::read(slang.path()).expect("readable");
        unusable(Some(&whole[..whole.len() - 4096]), "cut short");
    }
}

#[test]
#[cfg(target_os = "linux")]
fn a_library_of_another_kind_is_named() {
    let error = Slang::load("libc.so.6".as_ref()).expect_err("should be refused");
    assert!(error.to_string().contains("it is not slang"), "{error}");
}
