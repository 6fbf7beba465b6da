//! glslang: what it makes of good shaders, and what it says of bad ones.

mod common;

use common::tool;
use lobe_backends::translate::{Glslang, TranslateError, spirv_val};

#[track_caller]
fn glslang() -> Option<Glslang> {
    tool(Glslang::find())
}

/// `output[i] = input[i] * 2 + 1`, in the language that the first line names.
fn shader(version: &str) -> String {
    format!(
        "#version {version}
        precision highp float;
        layout(local_size_x = 64) in;
        layout(std430, binding = 3) readonly buffer Input {{ float data_in[]; }};
        layout(std430, binding = 5) buffer Output {{ float data_out[]; }};
        void main() {{
            uint i = gl_GlobalInvocationID.x;
            data_out[i] = data_in[i] * 2.0 + 1.0;
        }}"
    )
}

#[test]
fn the_version_is_told() {
    let Some(glslang) = glslang() else { return };
    let version = glslang.version().expect("a version");
    assert!(version.contains('.'), "{version}");
}

#[test]
fn a_shader_becomes_valid_spirv() {
    let Some(glslang) = glslang() else { return };
    let words = glslang.compile(&shader("450")).expect("compiles");
    assert_eq!(words[..2], [0x0723_0203, 0x0001_0300], "SPIR-V 1.3");
    const DECORATE: u32 = 4 << 16 | 71;
    let is_bound = |at: u32| words.windows(4).any(|w| w[0] == DECORATE && w[2] == 33 && w[3] == at);
    assert!(is_bound(3) && is_bound(5) && !is_bound(0), "bindings are those of the text");
    if tool(spirv_val::find()).is_some() {
        spirv_val::validate(&words).expect("valid");
    }
}

#[test]
fn the_same_text_gives_the_same_words() {
    let Some(glslang) = glslang() else { return };
    assert_eq!(glslang.compile(&shader("450")), glslang.compile(&shader("450")));
}

#[track_caller]
fn rejected<T: std::fmt::Debug>(result: Result<T, TranslateError>, part: &str) {
    let error = result.expect_err("should be refused");
    assert!(matches!(error, TranslateError::Rejected { .. }), "{error:?}");
    assert!(error.to_string().contains(part), "{error}");
}

#[test]
fn the_compilers_own_words_come_through() {
    let Some(glslang) = glslang() else { return };
    let bad = |body: &str| format!("#version 450\nlayout(local_size_x = 1) in;\n{body}");
    rejected(
        glslang.compile(&bad("void main() { undeclared = 1; }")),
        "'undeclared' : undeclared identifier",
    );
    rejected(glslang.compile(&bad("void f() {}")), "Missing entry point");
    rejected(glslang.compile(&bad("#include \"other.glsl\"\nvoid main() {}")), "#include");
    rejected(glslang.compile(""), "version");
    rejected(
        glslang.validate(&bad("void main() { undeclared = 1; }")),
        "'undeclared' : undeclared identifier",
    );
}

#[test]
fn opengl_es_has_rules_of_its_own() {
    let Some(glslang) = glslang() else { return };
    glslang.validate(&shader("310 es")).expect("GLSL ES");
    glslang.validate(&shader("450")).expect("GLSL");
    // ES has no 64-bit floats, and no compute shaders before 3.10.
    let double = |version| format!("{} void f() {{ double d; }}", shader(version));
    rejected(glslang.validate(&double("310 es")), "double");
    glslang.validate(&double("450")).expect("GLSL");
    rejected(glslang.validate(&shader("300 es")), "310");
}
