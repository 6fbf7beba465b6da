// Covers: textureSampleLevel of arrays, layers past the end, and of 3D textures; offsets.
// lobe: --within out=0.012
// lobe: --texture pages=rgba8unorm:8x8x1:3 --texture block=rgba8unorm:4x8x6:1:2 --sampler fine_repeat=linear,mip-linear,repeat
@group(0) @binding(0) var pages: texture_2d_array<f32>;
@group(0) @binding(1) var block: texture_3d<f32>;
@group(0) @binding(2) var fine_repeat: sampler;
@group(0) @binding(3) var<storage, read_write> out: array<vec4<f32>, 768>;

@compute @workgroup_size(16, 16)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    let at = vec2<f32>(id.xy) / 11.0 - 0.3;
    out[i] = textureSampleLevel(pages, fine_repeat, at, i32(i % 5u) - 1, 0.0);
    out[i + 256u] = textureSampleLevel(block, fine_repeat, vec3<f32>(at, f32(i) / 100.0), f32(i % 4u) / 3.0);
    out[i + 512u] = textureSampleLevel(block, fine_repeat, vec3<f32>(at, 0.4), 0.0, vec3<i32>(1, -2, 3));
}
