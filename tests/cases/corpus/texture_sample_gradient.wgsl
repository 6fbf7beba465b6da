// Covers: textureSampleGrad, the level by the longer of two steps along an axis.
// lobe: --within out=0.02
// lobe: --texture color=rgba8unorm:16x16x1:1:5 --sampler fine=linear,mip-linear
@group(0) @binding(0) var color: texture_2d<f32>;
@group(0) @binding(1) var fine: sampler;
@group(0) @binding(2) var<storage, read_write> out: array<vec4<f32>, 256>;

@compute @workgroup_size(16, 16)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    let at = (vec2<f32>(id.xy) + 0.37) / 16.0;
    let step = exp2(f32(i % 9u) / 2.0 - 5.0);
    out[i] = textureSampleGrad(color, fine, at, vec2<f32>(step, 0.0), vec2<f32>(0.0, step * 0.5));
}
