// Covers: textureSampleLevel with linear filtering within and between levels, coordinates past the edges.
// lobe: --within out=0.012
// lobe: --texture color=rgba8unorm:16x8x1:1:4 --sampler fine_clamp=linear,mip-linear
// lobe: --sampler fine_repeat=linear,mip-linear,repeat --sampler fine_mirror=linear,mip-linear,mirror
@group(0) @binding(0) var color: texture_2d<f32>;
@group(0) @binding(1) var fine_clamp: sampler;
@group(0) @binding(2) var fine_repeat: sampler;
@group(0) @binding(3) var fine_mirror: sampler;
@group(0) @binding(4) var<storage, read_write> out: array<vec4<f32>, 1024>;

@compute @workgroup_size(16, 16)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    let at = vec2<f32>(id.xy) / 6.0 - vec2<f32>(0.8, 0.7);
    let level = f32(i % 13u) / 4.0;
    out[i] = textureSampleLevel(color, fine_clamp, at, 0.0);
    out[i + 256u] = textureSampleLevel(color, fine_repeat, at, 1.0);
    out[i + 512u] = textureSampleLevel(color, fine_mirror, at, 0.0);
    out[i + 768u] = textureSampleLevel(color, fine_clamp, at, level);
}
