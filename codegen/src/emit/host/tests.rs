use super::*;
use crate::validate::foreign_wgsl;

const TEXT: &str = "
    struct Inner { axis: vec3f, weight: f32 }
    struct Outer {
        first: f32,
        frame: mat3x3f,
        inner: array<Inner, 2>,
        directions: array<vec3f, 4>,
        flags: vec2u,
        last: i32,
    }
    struct Hit { is_hit: bool }
    struct List { count: u32, values: array<f32> }
    @group(0) @binding(0) var<storage, read_write> outer: Outer;
    @group(0) @binding(1) var<storage, read_write> list: List;
    @compute @workgroup_size(1) fn main() { let h = Hit(true); if h.is_hit { outer.first = list.values[0]; } }";

#[test]
fn rust_has_each_byte_and_asserts_each_offset() {
    let text = host(&foreign_wgsl(TEXT).unwrap(), Host::Rust);
    for line in [
        "pub struct Inner {\n    pub axis: [f32; 3],\n    pub weight: f32,\n}",
        "    pub _pad0: [u32; 3],\n    pub frame: [[f32; 4]; 3],",
        "    pub inner: [Inner; 2],\n    pub directions: [[f32; 4]; 4],\n    pub flags: [u32; 2],\n    pub last: i32,",
        "assert!(core::mem::size_of::<Outer>() == 176);",
        "assert!(core::mem::offset_of!(Outer, directions) == 96);",
        "// No buffer can hold: Hit, List.",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
}

#[test]
fn c_has_the_same() {
    let text = host(&foreign_wgsl(TEXT).unwrap(), Host::C);
    for line in [
        "typedef struct Inner {\n    float axis[3];\n    float weight;\n} Inner;",
        "    uint32_t _pad0[3];\n    float frame[3][4];",
        "    Inner inner[2];\n    float directions[4][4];\n    uint32_t flags[2];\n    int32_t last;",
        "static_assert(sizeof(Outer) == 176, \"Outer differs",
        "static_assert(offsetof(Outer, directions) == 96, \"Outer.directions differs",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
}
