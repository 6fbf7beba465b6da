// Covers: textureDimensions, textureNumLevels and textureNumLayers of every kind of texture.
// lobe: --input out=zeros
// lobe: --texture line=r8unorm:12x1x1 --texture flat=rgba8unorm:20x12x1:1:4 --texture pages=rgba8unorm:6x4x1:5:2
// lobe: --texture block=rgba8unorm:6x4x10:1:3 --texture cube=rgba8unorm:8x8x1:6:2 --texture cubes=rgba8unorm:8x8x1:12
// lobe: --texture depth=depth16unorm:7x5x1:1:2 --texture goal=rgba8unorm:9x3x1 --texture goals=r32uint:4x5x1:3
@group(0) @binding(0) var line: texture_1d<f32>;
@group(0) @binding(1) var flat: texture_2d<f32>;
@group(0) @binding(2) var pages: texture_2d_array<f32>;
@group(0) @binding(3) var block: texture_3d<f32>;
@group(0) @binding(4) var cube: texture_cube<f32>;
@group(0) @binding(5) var cubes: texture_cube_array<f32>;
@group(0) @binding(6) var depth: texture_depth_2d;
@group(0) @binding(7) var goal: texture_storage_2d<rgba8unorm, write>;
@group(0) @binding(8) var goals: texture_storage_2d_array<r32uint, write>;
@group(0) @binding(9) var<storage, read_write> out: array<vec4<u32>, 16>;

@compute @workgroup_size(4)
fn main(@builtin(local_invocation_index) i: u32) {
    // lavapipe asks for the level of its first lane in all of them, so lanes ask for the same.
    for (var level = 0u; level < 4u; level += 1u) {
        out[level] = vec4<u32>(textureDimensions(flat, level), textureNumLevels(flat), textureDimensions(line));
    }
    for (var level = 0u; level < 3u; level += 1u) {
        out[level + 4u] = vec4<u32>(textureDimensions(block, level), textureNumLevels(block));
    }
    out[8] = vec4<u32>(textureDimensions(pages, 1), textureNumLayers(pages), textureNumLevels(pages));
    if i == 0u {
        out[12] = vec4<u32>(textureDimensions(cube, 1), textureDimensions(cubes));
        out[13] = vec4<u32>(textureNumLayers(cubes), textureNumLevels(cube), textureDimensions(depth, 1));
        out[14] = vec4<u32>(textureDimensions(goal), textureDimensions(goals));
        out[15] = vec4<u32>(textureNumLayers(goals), textureNumLevels(depth), 0u, 0u);
    }
}
