// Covers: textureSampleCompareLevel and textureSampleLevel of depth textures, flat, arrays and cubes.
// lobe: --within out=0.008
// lobe: --texture depth=depth16unorm:8x8x1 --texture pages=depth16unorm:8x8x1:3 --texture cube=depth16unorm:4x4x1
// lobe: --sampler shadow=less --sampler soft=linear,greater-equal --sampler sharp=nearest
@group(0) @binding(0) var depth: texture_depth_2d;
@group(0) @binding(1) var pages: texture_depth_2d_array;
@group(0) @binding(2) var cube: texture_depth_cube;
@group(0) @binding(3) var shadow: sampler_comparison;
@group(0) @binding(4) var soft: sampler_comparison;
@group(0) @binding(5) var sharp: sampler;
@group(0) @binding(6) var<storage, read_write> out: array<f32, 1280>;

@compute @workgroup_size(16, 16)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    let at = (vec2<f32>(id.xy) + 0.29) / 15.0;
    let reference = f32(i * 37u % 64u) / 63.3;
    out[i] = textureSampleCompareLevel(depth, shadow, at, reference);
    out[i + 256u] = textureSampleCompareLevel(depth, soft, at, reference);
    out[i + 512u] = textureSampleCompareLevel(pages, shadow, at, i & 3u, reference);
    out[i + 768u] = textureSampleCompareLevel(cube, shadow, vec3<f32>(at - 0.5, 0.7), reference);
    out[i + 1024u] = textureSampleLevel(depth, sharp, at, 0);
}
