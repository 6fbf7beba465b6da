// Covers: textureSampleLevel with nearest filtering, to the last bit of a code over 255: texels, levels, address modes, offsets.
// lobe: --texture color=rgba8unorm:16x8x1:1:4 --sampler sharp=nearest --sampler sharp_repeat=repeat
// lobe: --sampler sharp_mirror=mirror --sampler middle=lod:1:2
@group(0) @binding(0) var color: texture_2d<f32>;
@group(0) @binding(1) var sharp: sampler;
@group(0) @binding(2) var sharp_repeat: sampler;
@group(0) @binding(3) var sharp_mirror: sampler;
@group(0) @binding(4) var middle: sampler;
@group(0) @binding(5) var<storage, read_write> out: array<vec4<f32>, 1280>;

@compute @workgroup_size(16, 16)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    // Away from the borders between texels, where rounding decides.
    let at = (vec2<f32>(id.xy) * 1.25 + 0.3) / vec2<f32>(16.0, 8.0) - 0.25;
    out[i] = textureSampleLevel(color, sharp, at, 0.0);
    out[i + 256u] = textureSampleLevel(color, sharp_repeat, at, 0.0);
    out[i + 512u] = textureSampleLevel(color, sharp_mirror, at, f32(i % 7u) / 2.0 + 0.1);
    out[i + 768u] = textureSampleLevel(color, middle, at, f32(i % 9u) / 2.0 - 0.3);
    out[i + 1024u] = textureSampleLevel(color, sharp_repeat, at, 0.0, vec2<i32>(-3, 5));
}
