// Covers: storage formats of one and two channels of 8 bits, and floats of 16.
// lobe: --texture a=r8unorm:8x8x1
// lobe: --texture b=r8uint:8x8x1
// lobe: --texture c=r8sint:8x8x1
// lobe: --texture d=rg8unorm:8x8x1
// lobe: --texture e=rg8snorm:8x8x1
// lobe: --texture f=r16float:8x8x1
// lobe: --texture g=rg16float:8x8x1
@group(0) @binding(0) var a: texture_storage_2d<r8unorm, write>;
@group(0) @binding(1) var b: texture_storage_2d<r8uint, write>;
@group(0) @binding(2) var c: texture_storage_2d<r8sint, write>;
@group(0) @binding(3) var d: texture_storage_2d<rg8unorm, write>;
@group(0) @binding(4) var e: texture_storage_2d<rg8snorm, write>;
@group(0) @binding(5) var f: texture_storage_2d<r16float, write>;
@group(0) @binding(6) var g: texture_storage_2d<rg16float, write>;

@compute @workgroup_size(8, 8)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    let x = f32(i) / 64.0;
    let color = vec4<f32>(x, 1.0 - 2.0 * x, x * x, x);
    let whole = vec4<u32>(i, 2u * i, 0u, 0u);
    textureStore(a, id.xy, color);
    textureStore(b, id.xy, whole);
    textureStore(c, id.xy, vec4<i32>(32) - vec4<i32>(whole));
    textureStore(d, id.xy, color);
    textureStore(e, id.xy, color);
    textureStore(f, id.xy, color);
    textureStore(g, id.xy, color);
}
