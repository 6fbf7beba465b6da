// Covers: textureLoad of depth textures and of their arrays, which are one float.
// lobe: --texture depth=depth16unorm:8x8x1 --texture pages=depth16unorm:4x4x1:2
// lobe: --texture real=depth32float:8x8x1:1:2 --texture sky=depth32float:4x4x1 --sampler sharp=nearest
@group(0) @binding(0) var depth: texture_depth_2d;
@group(0) @binding(1) var pages: texture_depth_2d_array;
@group(0) @binding(2) var<storage, read_write> out: array<f32, 128>;
@group(0) @binding(3) var real: texture_depth_2d;
@group(0) @binding(4) var sky: texture_depth_cube;
@group(0) @binding(5) var sharp: sampler;
@group(0) @binding(6) var<storage, read_write> exact: array<f32, 192>;

@compute @workgroup_size(8, 8)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    out[i] = textureLoad(depth, id.xy, 0);
    exact[i] = textureLoad(real, id.xy, 0);
    exact[i + 64u] = textureLoad(real, id.xy / 2u, 1);
    exact[i + 128u] = textureSampleLevel(sky, sharp, vec3<f32>(vec2<f32>(id.xy) - 3.3, 2.9), 0);
    out[i + 64u] = textureLoad(pages, id.xy / 2u, id.x & 1u, 0);
}
