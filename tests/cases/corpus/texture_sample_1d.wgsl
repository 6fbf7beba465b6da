// Covers: textureSampleLevel of 1D textures.
// lobe: --within out=0.008
// lobe: --texture line=rgba8unorm:16x1x1 --sampler fine_repeat=linear,repeat
@group(0) @binding(0) var line: texture_1d<f32>;
@group(0) @binding(1) var fine_repeat: sampler;
@group(0) @binding(2) var<storage, read_write> out: array<vec4<f32>, 64>;

@compute @workgroup_size(64)
fn main(@builtin(local_invocation_index) i: u32) {
    out[i] = textureSampleLevel(line, fine_repeat, f32(i) / 50.0 - 0.1, 0.0);
}
