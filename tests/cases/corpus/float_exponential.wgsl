// Exponentials, logarithms and roots.
@group(0) @binding(0) var<storage, read> a: array<vec2f>;
@group(0) @binding(1) var<storage, read_write> out: array<array<vec2f, 7>>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) {
        return;
    }
    let x = a[i] * 4.0;
    let positive = abs(x) + 0.01;
    out[i] = array(exp(x), exp2(x), log(positive), log2(positive), pow(positive, x.yx), sqrt(positive), inverseSqrt(positive));
}
