// Covers: arrays of samplers, alone and with an array of textures: samples, comparing and not, and gathers, where the index is
// known, uniform, and another in each invocation.
// lobe: --sampler 'plain[1]=repeat' --sampler 'plain[2]=mirror' --elements plain=3 --sampler 'less[1]=greater'
enable wgpu_binding_array;

@group(0) @binding(0) var images: binding_array<texture_2d<f32>, 2>;
@group(0) @binding(1) var plain: binding_array<sampler>;
@group(0) @binding(2) var depth: texture_depth_2d;
@group(0) @binding(3) var less: binding_array<sampler_comparison, 2>;
@group(0) @binding(4) var<storage, read_write> out: array<vec4<f32>>;

@compute @workgroup_size(8, 8)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    // In the midst of texels, some of them beyond the edges.
    let at = (vec2<f32>(id.xy) * 4.0 + 0.5) / 16.0 - 0.25;
    var sum = textureSampleLevel(images[i & 1u], plain[i % 3u], at, 0.0);
    sum += textureSampleLevel(images[1], plain[2], at, 0.0);
    sum += textureSampleLevel(images[0], plain[id.y % 3u], at, 1.0);
    let beside = at + 0.5 / 16.0;
    sum += textureGather(2, images[(i >> 1u) & 1u], plain[i % 3u], beside);
    sum.x += textureSampleCompareLevel(depth, less[i & 1u], at, 0.5);
    sum.y += textureSampleCompareLevel(depth, less[0], at, 0.25);
    out[i] = sum;
}
