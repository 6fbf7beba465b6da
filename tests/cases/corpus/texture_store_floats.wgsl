// Covers: textureStore to float and normalised formats, clamped and rounded to the nearest code or its neighbour.
// lobe: --texture t_rgba8unorm=rgba8unorm:8x8x1
// lobe: --texture t_rgba8snorm=rgba8snorm:8x8x1
// lobe: --texture t_rgba16float=rgba16float:8x8x1
// lobe: --texture t_r32float=r32float:8x8x1
// lobe: --texture t_rg32float=rg32float:8x8x1
// lobe: --texture t_rgba32float=rgba32float:8x8x1
@group(0) @binding(0) var t_rgba8unorm: texture_storage_2d<rgba8unorm, write>;
@group(0) @binding(1) var t_rgba8snorm: texture_storage_2d<rgba8snorm, write>;
@group(0) @binding(2) var t_rgba16float: texture_storage_2d<rgba16float, write>;
@group(0) @binding(3) var t_r32float: texture_storage_2d<r32float, write>;
@group(0) @binding(4) var t_rg32float: texture_storage_2d<rg32float, write>;
@group(0) @binding(5) var t_rgba32float: texture_storage_2d<rgba32float, write>;

@compute @workgroup_size(8,8)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    let x = f32(i) / 64.0;
    let color = vec4<f32>(x, 1.5 * x - 0.75, x * x * 4.0 - 1.0, 0.5 - x);
    textureStore(t_rgba8unorm, id.xy, color);
    textureStore(t_rgba8snorm, id.xy, color);
    textureStore(t_rgba16float, id.xy, color);
    textureStore(t_r32float, id.xy, color);
    textureStore(t_rg32float, id.xy, color);
    textureStore(t_rgba32float, id.xy, color);
}
