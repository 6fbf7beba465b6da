// Interpolation between values.
@group(0) @binding(0) var<storage, read> a: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> out: array<array<vec4f, 3>>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i < arrayLength(&a) {
        let x = a[i];
        out[i] = array(mix(x, x.wzyx, abs(x.yxwz)), mix(x, x.yzwx, 0.25), smoothstep(vec4f(-0.75), vec4f(0.5), x));
    }
}
