// Numbers packed into words and back.
@group(0) @binding(0) var<storage, read> floats: array<vec4f>;
@group(0) @binding(1) var<storage, read> words: array<u32>;
@group(0) @binding(2) var<storage, read_write> packed: array<array<u32, 9>>;
@group(0) @binding(3) var<storage, read_write> of_floats: array<array<vec4f, 2>>;
@group(0) @binding(4) var<storage, read_write> of_halves: array<array<vec2f, 3>>;
@group(0) @binding(5) var<storage, read_write> of_bytes: array<array<vec4u, 2>>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&words) || i >= arrayLength(&floats) {
        return;
    }
    let x = floats[i] * 1.5;
    let w = words[i];
    let bytes = unpack4xI8(w);
    // Halves are of moderate size: infinities and NaN have no one text.
    let halves = (w & 0x83ff83ffu) | 0x38003800u;
    packed[i] = array(
        pack4x8snorm(x), pack4x8unorm(x), pack2x16snorm(x.xy), pack2x16unorm(x.zw), pack2x16float(x.xy),
        pack4xI8(bytes * 3), pack4xU8(unpack4xU8(w) * 5u), pack4xI8Clamp(bytes * 3), pack4xU8Clamp(unpack4xU8(w) * 5u),
    );
    of_floats[i] = array(unpack4x8snorm(w), unpack4x8unorm(w));
    of_halves[i] = array(unpack2x16snorm(w), unpack2x16unorm(w), unpack2x16float(halves));
    of_bytes[i] = array(bitcast<vec4u>(bytes), unpack4xU8(w));
}
