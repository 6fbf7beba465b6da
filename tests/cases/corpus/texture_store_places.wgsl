// Covers: textureStore to 1D, 3D and array textures, stores out of bounds, which do nothing, and masked lanes.
// lobe: --workgroups 2,2,1
// lobe: --texture line=r32uint:16x1x1 --texture block=r32uint:4x4x4 --texture pages=r32uint:8x8x1:2
@group(0) @binding(0) var line: texture_storage_1d<r32uint, write>;
@group(0) @binding(1) var block: texture_storage_3d<r32uint, write>;
@group(0) @binding(2) var pages: texture_storage_2d_array<r32uint, write>;

@compute @workgroup_size(4, 4)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let number = vec4<u32>(id.y * 8u + id.x, 0u, 0u, 0u);
    if id.y == 3u {
        textureStore(line, id.x * 3u, number);
    }
    // The last ones are before the first texel.
    textureStore(block, vec3<i32>(0, 5, 5) - vec3<i32>(id.zxy), number);
    if (id.x & 1u) == 0u {
        textureStore(pages, id.xy, id.y & 3u, number);
    }
}
