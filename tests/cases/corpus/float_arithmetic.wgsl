// Arithmetic of floats, scalars and vectors, with the remainder of truncated division.
@group(0) @binding(0) var<storage, read> a: array<vec4f>;
@group(0) @binding(1) var<storage, read> b: array<vec4f>;
@group(0) @binding(2) var<storage, read_write> out: array<array<vec4f, 6>>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) || i >= arrayLength(&b) {
        return;
    }
    let x = a[i];
    let y = b[i] + select(vec4f(2.0), vec4f(-2.0), b[i] < vec4f(0.0));
    out[i] = array(x + y, x - y.x, x.y * y, x / y, -x, fma(x, y, x.wzyx));
}
