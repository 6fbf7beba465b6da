// Bits of floats as integers and back; conversions that saturate.
@group(0) @binding(0) var<storage, read> a: array<vec2u>;
@group(0) @binding(1) var<storage, read_write> out: array<array<u32, 6>>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) {
        return;
    }
    // A finite float of any size, never a subnormal one.
    let bits = (a[i].x & 0x80ffffffu) | ((1u + (a[i].y % 253u)) << 23u);
    let x = bitcast<f32>(bits);
    out[i] = array(
        bitcast<u32>(i32(x)), u32(x), bitcast<u32>(f32(bitcast<i32>(a[i].x))), bitcast<u32>(f32(a[i].y)),
        u32(bool(x)), bitcast<u32>(f32(a[i].x % 2u == 0u)),
    );
}
