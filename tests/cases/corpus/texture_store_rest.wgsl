// Covers: the storage formats that the other modules leave; every number stored is one that the format has.
// lobe: --texture a=r8snorm:8x8x1 --texture b=r16uint:8x8x1 --texture c=rg8uint:8x8x1 --texture d=rg8sint:8x8x1
// lobe: --texture e=rg16sint:8x8x1 --texture f=bgra8unorm:8x8x1 --texture g=r16snorm:8x8x1 --texture h=rg16unorm:8x8x1
// lobe: --texture j=rgba16snorm:8x8x1
@group(0) @binding(0) var a: texture_storage_2d<r8snorm, write>;
@group(0) @binding(1) var b: texture_storage_2d<r16uint, write>;
@group(0) @binding(2) var c: texture_storage_2d<rg8uint, write>;
@group(0) @binding(3) var d: texture_storage_2d<rg8sint, write>;
@group(0) @binding(4) var e: texture_storage_2d<rg16sint, write>;
@group(0) @binding(5) var f: texture_storage_2d<bgra8unorm, write>;
@group(0) @binding(6) var g: texture_storage_2d<r16snorm, write>;
@group(0) @binding(7) var h: texture_storage_2d<rg16unorm, write>;
@group(0) @binding(8) var j: texture_storage_2d<rgba16snorm, write>;

@compute @workgroup_size(8, 8)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    let whole = vec4<u32>(i, 2u * i, 0u, 0u);
    let signed = vec4<i32>(32) - vec4<i32>(whole);
    let steps = vec4<f32>(signed + vec4<i32>(0, 0, 3, 5));
    textureStore(a, id.xy, steps / 127.0);
    textureStore(b, id.xy, whole);
    textureStore(c, id.xy, whole);
    textureStore(d, id.xy, signed);
    textureStore(e, id.xy, signed);
    textureStore(f, id.xy, vec4<f32>(whole + vec4<u32>(0u, 0u, 3u, 255u)) / 255.0);
    textureStore(g, id.xy, steps / 32767.0);
    textureStore(h, id.xy, vec4<f32>(whole) / 65535.0);
    textureStore(j, id.xy, steps / 32767.0);
}
