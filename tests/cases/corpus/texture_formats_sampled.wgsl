// Covers: loads of formats that only sampled textures have, or of other channel orders. lavapipe's sRGB is an estimate.
// lobe: --within out=0.0000005 --within lights=0.0015
// lobe: --texture curved=rgba8unorm-srgb:8x8x1 --texture swapped=bgra8unorm:8x8x1 --texture both=bgra8unorm-srgb:8x8x1
// lobe: --texture ten=rgb10a2unorm:8x8x1 --texture eleven=rg11b10ufloat:8x8x1 --texture half=rgba16float:8x8x1
// lobe: --texture signed=rgba8snorm:8x8x1 --texture wide=rgba16snorm:8x8x1
@group(0) @binding(0) var curved: texture_2d<f32>;
@group(0) @binding(1) var swapped: texture_2d<f32>;
@group(0) @binding(2) var both: texture_2d<f32>;
@group(0) @binding(3) var ten: texture_2d<f32>;
@group(0) @binding(4) var eleven: texture_2d<f32>;
@group(0) @binding(5) var half: texture_2d<f32>;
@group(0) @binding(6) var signed: texture_2d<f32>;
@group(0) @binding(7) var wide: texture_2d<f32>;
@group(0) @binding(8) var<storage, read_write> out: array<vec4<f32>, 384>;
@group(0) @binding(9) var<storage, read_write> lights: array<vec4<f32>, 128>;

@compute @workgroup_size(8, 8)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    lights[i] = textureLoad(curved, id.xy, 0);
    out[i] = textureLoad(swapped, id.xy, 0);
    lights[i + 64u] = textureLoad(both, id.xy, 0);
    out[i + 64u] = textureLoad(ten, id.xy, 0);
    out[i + 128u] = textureLoad(eleven, id.xy, 0);
    out[i + 192u] = textureLoad(half, id.xy, 0);
    out[i + 256u] = textureLoad(signed, id.xy, 0);
    out[i + 320u] = textureLoad(wide, id.xy, 0);
}
