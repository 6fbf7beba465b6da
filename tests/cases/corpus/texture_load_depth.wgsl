// Covers: textureLoad of depth textures and of their arrays, which are one float.
// lobe: --texture depth=depth16unorm:8x8x1 --texture pages=depth16unorm:4x4x1:2
@group(0) @binding(0) var depth: texture_depth_2d;
@group(0) @binding(1) var pages: texture_depth_2d_array;
@group(0) @binding(2) var<storage, read_write> out: array<f32, 128>;

@compute @workgroup_size(8, 8)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    out[i] = textureLoad(depth, id.xy, 0);
    out[i + 64u] = textureLoad(pages, id.xy / 2u, id.x & 1u, 0);
}
