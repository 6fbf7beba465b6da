// Floats of 64 bits.
@group(0) @binding(0) var<storage, read> a: array<vec2f>;
@group(0) @binding(1) var<storage, read_write> out: array<array<f64, 6>>;
@group(0) @binding(2) var<storage, read_write> narrowed: array<vec2f>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) {
        return;
    }
    let x = f64(a[i].x) * 1.1lf;
    let y = f64(a[i].y) + 2.5lf;
    out[i] = array(x + y, x - y, x * y, x / y, select(x, -y, x < y), min(floor(x * 8.0lf), abs(y)));
    narrowed[i] = vec2f(f32(x * y), f32(i32(x * 100.0lf)));
}
