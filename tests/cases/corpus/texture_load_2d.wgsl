// Covers: textureLoad of sampled 2D textures of floats and integers, levels, texels out of bounds.
// lobe: --workgroups 1,1,1
// lobe: --texture color=rgba8unorm:8x8x1:1:3 --texture counts=rgba16uint:8x8x1 --texture signs=rg8sint:8x8x1
@group(0) @binding(0) var color: texture_2d<f32>;
@group(0) @binding(1) var counts: texture_2d<u32>;
@group(0) @binding(2) var signs: texture_2d<i32>;
@group(0) @binding(3) var<storage, read_write> out: array<vec4<u32>, 512>;
@group(0) @binding(4) var<storage, read_write> colors: array<vec4<f32>, 256>;

@compute @workgroup_size(16, 16)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    // From 4 before the first texel to 4 behind the last.
    let at = vec2<i32>(id.xy) - 4;
    colors[i] = textureLoad(color, at, i32(i % 3u));
    out[i * 2u] = textureLoad(counts, id.xy, 0u);
    out[i * 2u + 1u] = bitcast<vec4<u32>>(textureLoad(signs, at, 0));
}
