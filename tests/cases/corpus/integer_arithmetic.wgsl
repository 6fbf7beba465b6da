// Integers of 32 bits: wrapping arithmetic, division by zero, the one overflow of a division, shifts by any distance.
@group(0) @binding(0) var<storage, read> a: array<vec2i>;
@group(0) @binding(1) var<storage, read> b: array<vec2u>;
@group(0) @binding(2) var<storage, read_write> of_signed: array<array<i32, 8>>;
@group(0) @binding(3) var<storage, read_write> of_unsigned: array<array<u32, 8>>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&of_signed) {
        return;
    }
    let x = a[i].x;
    // Every third divisor is 0, every other third -1, which overflows for the least number.
    let y = select(select(a[i].y, 0, i % 3u == 0u), -1, i % 3u == 1u);
    let least = select(x, -2147483647 - 1, i % 4u == 0u);
    of_signed[i] = array(x + y, x - y, x * y, least / y, least % y, -least, least >> (b[i].x & 31u), x << (b[i].y & 31u));
    let u = b[i].x;
    let v = select(b[i].y, 0u, i % 3u == 0u);
    of_unsigned[i] = array(u + v, u - v, u * v, u / v, u % v, u >> (v & 31u), u << (v & 31u), ~u);
}
