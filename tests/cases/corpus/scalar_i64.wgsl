// Integers of 64 bits.
@group(0) @binding(0) var<storage, read> a: array<vec2<i64>>;
@group(0) @binding(1) var<storage, read> b: array<vec2<u64>>;
@group(0) @binding(2) var<storage, read_write> of_signed: array<array<i64, 9>>;
@group(0) @binding(3) var<storage, read_write> of_unsigned: array<array<u64, 9>>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) || i >= arrayLength(&b) {
        return;
    }
    let x = a[i].x;
    let y = select(a[i].y, 3li, a[i].y == 0li);
    let shift = u32(b[i].y & 63lu);
    of_signed[i] = array(
        x + y, x - y, x * y, x / y, x % y, -x, x >> shift, max(x, y), i64(i32(x)) + i64(shift) + abs(y / 2li),
    );
    let u = b[i].x;
    let v = select(b[i].y, 10000000000lu, b[i].y == 0lu);
    of_unsigned[i] = array(u + v, u - v, u * v, u / v, u % v, u << shift, (u & v) ^ (u | ~v), min(u, v), u64(u32(u)) + u64(f32(v % 1000lu)));
}
