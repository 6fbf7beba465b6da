//! DXC and spirv-val: what they make of good shaders, and what they say of bad ones.

mod common;

use std::fs;

use common::{DEMANDING_WGSL, hlsl, spirv, tool};
use lobe_backends::translate::{Dxc, DxcOutput, TranslateError, spirv_val, spirv_words};

#[track_caller]
fn dxc() -> Option<Dxc> {
    tool(Dxc::find())
}

#[test]
fn the_version_is_told() {
    let Some(dxc) = dxc() else { return };
    assert!(dxc.version() >= (1, 7), "{dxc:?}");
}

#[test]
fn a_shader_becomes_valid_spirv_without_a_warning() {
    let Some(dxc) = dxc() else { return };
    let compiled = dxc
        .compile_with_warnings(&hlsl(DEMANDING_WGSL), "cs_6_0", Some("main"), DxcOutput::Spirv)
        .expect("compiles");
    assert_eq!(compiled.warnings, "");
    let words = spirv_words(&compiled.object).expect("words");
    assert_eq!(words[0], 0x0723_0203);
    if tool(spirv_val::find()).is_some() {
        spirv_val::validate(&words).expect("valid");
    }
}

/// Two functions and no entry point, as a library of kernels is emitted.
const LIBRARY: &str = "
float half_of(float x) { return x * 0.5; }
float lobe_quarter_of(float x) { return half_of(half_of(x)); }
";

#[test]
fn a_library_keeps_its_functions() {
    let Some(dxc) = dxc() else { return };
    let dxil = dxc.compile(LIBRARY, "lib_6_3", None, DxcOutput::Dxil).expect("compiles");
    assert!(dxil.starts_with(b"DXBC"), "a DXIL container");
    let name = b"lobe_quarter_of";
    assert!(dxil.windows(name.len()).any(|window| window == name), "the function is in it");
}

#[test]
fn a_shader_becomes_dxil() {
    let Some(dxc) = dxc() else { return };
    let dxil = dxc.compile(&hlsl(DEMANDING_WGSL), "cs_6_0", Some("main"), DxcOutput::Dxil).expect("compiles");
    assert!(dxil.starts_with(b"DXBC"));
}

#[test]
fn warnings_are_handed_on() {
    let Some(dxc) = dxc() else { return };
    let hlsl = "[numthreads(1, 1, 1)] void main() { float2 a = float2(1, 2); float b = a; }";
    let compiled =
        dxc.compile_with_warnings(hlsl, "cs_6_0", Some("main"), DxcOutput::Spirv).expect("compiles");
    assert!(compiled.warnings.contains("implicit truncation"), "{}", compiled.warnings);
}

#[track_caller]
fn refused(hlsl: &str, profile: &str, entry: Option<&str>, part: &str) {
    let Some(dxc) = dxc() else { return };
    let error = dxc.compile(hlsl, profile, entry, DxcOutput::Spirv).expect_err("should be refused");
    assert!(matches!(error, TranslateError::Rejected { .. }), "{error:?}");
    assert!(error.to_string().contains(part), "{error}");
}

#[test]
fn the_compilers_own_words_come_through() {
    let hlsl = "[numthreads(1, 1, 1)]\nvoid main() { undeclared = 1; }";
    refused(hlsl, "cs_6_0", Some("main"), "2:15: error: use of undeclared identifier 'undeclared'");
    refused("void f() {}", "cs_6_0", Some("main"), "missing entry point definition");
    refused("void main() {}", "cs_9_9", Some("main"), "unknown shader module");
    refused("#include \"other.hlsl\"", "cs_6_0", Some("main"), "other.hlsl");
    refused("", "cs_6_0", Some("main"), "missing entry point definition");
}

#[test]
fn many_threads_share_one_compiler() {
    let Some(dxc) = dxc() else { return };
    let hlsl = hlsl(DEMANDING_WGSL);
    let compile = || dxc.compile(&hlsl, "cs_6_0", Some("main"), DxcOutput::Spirv).expect("compiles");
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
    let path = folder.path().join("libdxcompiler.so");
    if let Some(bytes) = bytes {
        fs::write(&path, bytes).expect("writable");
    }
    let error = Dxc::load(&path).expect_err("should be refused");
    assert!(matches!(error, TranslateError::Unusable { .. }), "{error:?}");
    assert!(error.to_string().contains(part), "{error}");
    assert!(error.to_string().contains("libdxcompiler.so"), "{error}");
}

#[test]
fn damaged_libraries_are_named() {
    unusable(None, "No such file");
    unusable(Some(b"gone"), "4 bytes, too few");
    unusable(Some(&[b'x'; 4096]), "invalid ELF header");
    if let Some(dxc) = dxc() {
        let whole = fs::read(dxc.path()).expect("readable");
        unusable(Some(&whole[..whole.len() - 4096]), "cut short");
    }
}

#[test]
#[cfg(target_os = "linux")]
fn a_library_of_another_kind_is_named() {
    let error = Dxc::load("libc.so.6".as_ref()).expect_err("should be refused");
    assert!(error.to_string().contains("it is not DXC"), "{error}");
}

#[test]
fn the_validators_own_words_come_through() {
    if tool(spirv_val::find()).is_none() {
        return;
    }
    let mut words = spirv(DEMANDING_WGSL);
    spirv_val::validate(&words).expect("naga's SPIR-V is valid");
    // An id that is used but never defined.
    words[3] = 100_000;
    let last = words.len() - 1;
    words.truncate(last);
    let error = spirv_val::validate(&words).expect_err("should be refused");
    assert!(matches!(error, TranslateError::Rejected { .. }), "{error:?}");
    assert!(error.to_string().starts_with("spirv-val rejected the shader:\n"), "{error}");
    let error = spirv_val::validate(&[]).expect_err("should be refused");
    assert!(matches!(error, TranslateError::Rejected { .. }), "{error:?}");
}
