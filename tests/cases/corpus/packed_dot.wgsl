// Dot products of four bytes in a word.
requires packed_4x8_integer_dot_product;

@group(0) @binding(0) var<storage, read> a: array<vec2u>;
@group(0) @binding(1) var<storage, read_write> out: array<vec2u>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i < arrayLength(&a) {
        out[i] = vec2u(bitcast<u32>(dot4I8Packed(a[i].x, a[i].y)), dot4U8Packed(a[i].x, a[i].y));
    }
}
