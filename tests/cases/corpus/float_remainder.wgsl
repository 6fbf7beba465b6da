// The remainder of floats, where both are whole: then every driver has the same.
@group(0) @binding(0) var<storage, read> a: array<vec2i>;
@group(0) @binding(1) var<storage, read_write> out: array<f32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i < arrayLength(&a) {
        out[i] = f32(a[i].x % 2000) % f32(1 + (abs(a[i].y % 100)));
    }
}
