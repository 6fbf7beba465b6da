// Covers: textureSampleBaseClampToEdge.
// lobe: --within out=0.008
// lobe: --texture color=rgba8unorm:16x8x1:1:2 --sampler fine_repeat=linear,mip-linear,repeat
@group(0) @binding(0) var color: texture_2d<f32>;
@group(0) @binding(1) var fine_repeat: sampler;
@group(0) @binding(2) var<storage, read_write> out: array<vec4<f32>, 256>;

@compute @workgroup_size(16, 16)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    out[i] = textureSampleBaseClampToEdge(color, fine_repeat, vec2<f32>(id.xy) / 13.0 - 0.1);
}
