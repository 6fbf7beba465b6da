// Floats rounded to what 16 bits hold, where they lie between its numbers and on them.
@group(0) @binding(0) var<storage, read> a: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> out: array<vec4f>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i < arrayLength(&a) {
        out[i] = quantizeToF16(a[i] * 100.0 + vec4f(0.0, 1.0, 1024.5, 0.001));
    }
}
