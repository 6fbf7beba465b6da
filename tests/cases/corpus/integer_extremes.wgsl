// abs, min, max, clamp, sign and dot on integers, at the extremes too.
@group(0) @binding(0) var<storage, read> a: array<vec4i>;
@group(0) @binding(1) var<storage, read_write> out: array<array<vec4i, 6>>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) {
        return;
    }
    let x = select(a[i], vec4i(-2147483647 - 1, 2147483647, 0, -1), vec4<bool>(i % 5u == 0u));
    let y = a[i].wzyx;
    let u = bitcast<vec4u>(x);
    out[i] = array(
        abs(x), min(x, y), max(x, y), clamp(x, min(y, y.yxwz), max(y, y.yxwz)), sign(x),
        vec4i(dot(x, y), bitcast<i32>(dot(u, u.yzwx)), bitcast<i32>(min(u, u.yzwx).x), bitcast<i32>(clamp(u.x, 7u, 70000u))),
    );
}
