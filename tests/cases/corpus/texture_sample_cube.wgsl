// Covers: textureSampleLevel of cubes and arrays of cubes: faces, levels, edges and corners.
// lobe: --within out=0.012
// lobe: --texture sky=rgba8unorm:8x8x1:6:3 --texture skies=rgba8unorm:4x4x1:12 --sampler fine=linear,mip-linear
// lobe: --sampler sharp=nearest
@group(0) @binding(0) var sky: texture_cube<f32>;
@group(0) @binding(1) var skies: texture_cube_array<f32>;
@group(0) @binding(2) var fine: sampler;
@group(0) @binding(3) var sharp: sampler;
@group(0) @binding(4) var<storage, read_write> out: array<vec4<f32>, 768>;

@compute @workgroup_size(256)
fn main(@builtin(local_invocation_index) i: u32) {
    // Directions all around, none of them along an edge, by operations that no driver may get wrong by much.
    let direction =
        vec3<f32>(f32(i % 16u) - 7.3, f32(i / 16u) - 7.7, (f32(i % 7u) - 3.2) * 2.3);
    out[i] = textureSampleLevel(sky, fine, direction, f32(i % 5u) / 2.0);
    out[i + 256u] = textureSampleLevel(skies, fine, direction * 3.0, i & 1u, 0.0);
    out[i + 512u] = textureSampleLevel(skies, sharp, direction, i32(i % 4u) - 1, 0.0);
}
