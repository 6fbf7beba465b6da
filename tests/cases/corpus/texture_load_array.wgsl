// Covers: textureLoad of 2D arrays, of layers and levels computed, and layers out of bounds.
// lobe: --texture pages=r32sint:8x8x1:4:2
@group(0) @binding(0) var pages: texture_2d_array<i32>;
@group(0) @binding(1) var<storage, read_write> out: array<vec4<i32>, 256>;

@compute @workgroup_size(8, 8, 4)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    let level = id.z & 1u;
    out[i] = textureLoad(pages, id.xy >> vec2<u32>(level), id.z, level);
}
