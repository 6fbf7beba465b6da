// Covers: textureStore to integer formats, numbers that they hold.
// lobe: --texture t_rgba8uint=rgba8uint:8x8x1
// lobe: --texture t_rgba8sint=rgba8sint:8x8x1
// lobe: --texture t_rgba16uint=rgba16uint:8x8x1
// lobe: --texture t_rgba16sint=rgba16sint:8x8x1
// lobe: --texture t_rgba32uint=rgba32uint:8x8x1
// lobe: --texture t_rgba32sint=rgba32sint:8x8x1
// lobe: --texture t_r32uint=r32uint:8x8x1
// lobe: --texture t_r32sint=r32sint:8x8x1
// lobe: --texture t_rg32uint=rg32uint:8x8x1
// lobe: --texture t_rg32sint=rg32sint:8x8x1
@group(0) @binding(0) var t_rgba8uint: texture_storage_2d<rgba8uint, write>;
@group(0) @binding(1) var t_rgba8sint: texture_storage_2d<rgba8sint, write>;
@group(0) @binding(2) var t_rgba16uint: texture_storage_2d<rgba16uint, write>;
@group(0) @binding(3) var t_rgba16sint: texture_storage_2d<rgba16sint, write>;
@group(0) @binding(4) var t_rgba32uint: texture_storage_2d<rgba32uint, write>;
@group(0) @binding(5) var t_rgba32sint: texture_storage_2d<rgba32sint, write>;
@group(0) @binding(6) var t_r32uint: texture_storage_2d<r32uint, write>;
@group(0) @binding(7) var t_r32sint: texture_storage_2d<r32sint, write>;
@group(0) @binding(8) var t_rg32uint: texture_storage_2d<rg32uint, write>;
@group(0) @binding(9) var t_rg32sint: texture_storage_2d<rg32sint, write>;

@compute @workgroup_size(8,8)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    let at = id.xy;
    textureStore(t_rgba8uint, at, vec4<u32>(vec4<u32>(i, i * 3u, 127u - i, i & 7u)));
    textureStore(t_rgba8sint, at, vec4<i32>(vec4<u32>(i, i * 2u, 127u - i, i & 7u)));
    textureStore(t_rgba16uint, at, vec4<u32>(vec4<u32>(i, i * 3u, 127u - i, i & 7u)));
    textureStore(t_rgba16sint, at, vec4<i32>(vec4<u32>(i, i * 2u, 127u - i, i & 7u)));
    textureStore(t_rgba32uint, at, vec4<u32>(vec4<u32>(i, i * 3u, 127u - i, i & 7u)));
    textureStore(t_rgba32sint, at, vec4<i32>(vec4<u32>(i, i * 2u, 127u - i, i & 7u)));
    textureStore(t_r32uint, at, vec4<u32>(vec4<u32>(i, i * 3u, 127u - i, i & 7u)));
    textureStore(t_r32sint, at, vec4<i32>(vec4<u32>(i, i * 2u, 127u - i, i & 7u)));
    textureStore(t_rg32uint, at, vec4<u32>(vec4<u32>(i, i * 3u, 127u - i, i & 7u)));
    textureStore(t_rg32sint, at, vec4<i32>(vec4<u32>(i, i * 2u, 127u - i, i & 7u)));
}
