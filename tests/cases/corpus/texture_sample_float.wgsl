// Covers: linear filtering of float formats, where drivers keep the weights exact.
// lobe: --within out=0.001
// lobe: --texture color=rgba32float:16x8x1:1:2 --texture half=rgba16float:8x8x1 --sampler fine_clamp=linear,mip-linear
@group(0) @binding(0) var color: texture_2d<f32>;
@group(0) @binding(1) var half: texture_2d<f32>;
@group(0) @binding(2) var fine_clamp: sampler;
@group(0) @binding(3) var<storage, read_write> out: array<vec4<f32>, 512>;

@compute @workgroup_size(16, 16)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    let at = vec2<f32>(id.xy) / 14.0 - 0.05;
    out[i] = textureSampleLevel(color, fine_clamp, at, f32(i % 5u) / 4.0);
    out[i + 256u] = textureSampleLevel(half, fine_clamp, at, 0.0);
}
