// Covers: storage formats of 16-bit integers and normalised numbers.
// lobe: --texture a=rg16uint:8x8x1
// lobe: --texture b=r16sint:8x8x1
// lobe: --texture c=r16unorm:8x8x1
// lobe: --texture d=rg16snorm:8x8x1
// lobe: --texture e=rgba16unorm:8x8x1
@group(0) @binding(0) var a: texture_storage_2d<rg16uint, write>;
@group(0) @binding(1) var b: texture_storage_2d<r16sint, write>;
@group(0) @binding(2) var c: texture_storage_2d<r16unorm, write>;
@group(0) @binding(3) var d: texture_storage_2d<rg16snorm, write>;
@group(0) @binding(4) var e: texture_storage_2d<rgba16unorm, write>;

@compute @workgroup_size(8, 8)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    let x = f32(i) / 64.0;
    let color = vec4<f32>(x, 1.0 - 2.0 * x, x * x, x);
    let whole = vec4<u32>(i, 2u * i, 0u, 0u);
    textureStore(a, id.xy, whole);
    textureStore(b, id.xy, vec4<i32>(32) - vec4<i32>(whole));
    textureStore(c, id.xy, color);
    textureStore(d, id.xy, color);
    textureStore(e, id.xy, color);
}
