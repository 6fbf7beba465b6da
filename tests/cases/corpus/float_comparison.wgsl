// Comparisons and the functions that choose among floats.
@group(0) @binding(0) var<storage, read> a: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> out: array<array<vec4f, 6>>;
@group(0) @binding(2) var<storage, read_write> flags: array<vec4u>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) {
        return;
    }
    let x = floor(a[i] * 4.0);
    let y = x.yzwx;
    flags[i] = vec4u(vec4<bool>(any(x < y), all(x >= y), any(x == y), all(x != y.wzyx)))
        + 2u * vec4u(x <= y) + 4u * vec4u(x > y);
    out[i] = array(
        abs(x), min(x, y), max(x, y), clamp(x, vec4f(-2.0), vec4f(1.0)), saturate(x * 0.5),
        sign(x) + step(y, x),
    );
}
