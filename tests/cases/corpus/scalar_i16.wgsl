// Integers of 16 bits, in memory too.
enable wgpu_int16;

struct Narrow {
    a: i16,
    b: u16,
    c: vec3<i16>,
    d: u16,
}

@group(0) @binding(0) var<storage, read> a: array<vec2<i16>>;
@group(0) @binding(1) var<storage, read_write> out: array<array<i32, 8>>;
@group(0) @binding(2) var<storage, read_write> structs: array<Narrow>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) {
        return;
    }
    let x = a[i].x;
    let y = a[i].y;
    let u = u16(x);
    let v = u16(y);
    out[i] = array(
        i32(x + y), i32(x - y), i32(x * y), i32(max(x, y)), i32(u + v), i32(u * v), i32(min(u, v)) + i32(u16(7)),
        i32(x < y) + i32(x & i16(255)),
    );
    structs[i] = Narrow(x - i16(3), u + u16(9), vec3<i16>(y, x, y), v);
}
