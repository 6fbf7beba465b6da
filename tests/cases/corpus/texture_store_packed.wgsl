// Covers: textureStore to the packed formats rgb10a2 and rg11b10.
// lobe: --texture ten=rgb10a2unorm:8x8x1 --texture whole=rgb10a2uint:8x8x1 --texture eleven=rg11b10ufloat:8x8x1
@group(0) @binding(0) var ten: texture_storage_2d<rgb10a2unorm, write>;
@group(0) @binding(1) var whole: texture_storage_2d<rgb10a2uint, write>;
@group(0) @binding(2) var eleven: texture_storage_2d<rg11b10ufloat, write>;

@compute @workgroup_size(8, 8)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    let x = f32(i) / 64.0;
    // No alpha lies between two of its four codes.
    textureStore(ten, id.xy, vec4<f32>(x, 1.0 - x, x * x, 1.0 - x * 0.75));
    textureStore(whole, id.xy, vec4<u32>(i * 16u, 1023u - i, i, i & 3u));
    textureStore(eleven, id.xy, vec4<f32>(x, x * x, x - 0.5, 0.0));
}
