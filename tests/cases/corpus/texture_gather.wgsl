// Covers: textureGather of each channel, of integers and depths, and textureGatherCompare.
// lobe: --texture color=rgba8unorm:8x8x1 --texture counts=rgba8uint:8x8x1 --texture depth=depth16unorm:8x8x1
// lobe: --texture pages=rgba8unorm:4x4x1:2 --sampler fine=linear,repeat --sampler shadow=linear,less --sampler sharp=nearest
@group(0) @binding(0) var color: texture_2d<f32>;
@group(0) @binding(1) var counts: texture_2d<u32>;
@group(0) @binding(2) var depth: texture_depth_2d;
@group(0) @binding(3) var pages: texture_2d_array<f32>;
@group(0) @binding(4) var fine: sampler;
@group(0) @binding(5) var shadow: sampler_comparison;
@group(0) @binding(6) var sharp: sampler;
@group(0) @binding(7) var<storage, read_write> out: array<vec4<f32>, 1536>;

@compute @workgroup_size(16, 16)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    let at = (vec2<f32>(id.xy) + 0.29) / 13.0 - 0.1;
    out[i] = textureGather(0, color, fine, at) + textureGather(3, color, fine, at);
    out[i + 256u] = textureGather(2, color, fine, at, vec2<i32>(1, -2));
    out[i + 512u] = vec4<f32>(textureGather(1, counts, sharp, at));
    out[i + 768u] = textureGather(depth, fine, at);
    out[i + 1024u] = textureGatherCompare(depth, shadow, at, f32(i) / 255.3);
    out[i + 1280u] = textureGather(1, pages, fine, at, i & 1u);
}
