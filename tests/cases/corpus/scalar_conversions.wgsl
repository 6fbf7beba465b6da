// Conversions between the scalar types, component by component.
@group(0) @binding(0) var<storage, read> a: array<vec4i>;
@group(0) @binding(1) var<storage, read> b: array<vec4f>;
@group(0) @binding(2) var<storage, read_write> out: array<array<vec4i, 5>>;
@group(0) @binding(3) var<storage, read_write> floats: array<array<vec4f, 2>>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) || i >= arrayLength(&b) {
        return;
    }
    let huge = b[i] * vec4f(1e3, 1e10, -1e12, 1e38);
    out[i] = array(vec4i(vec4u(a[i])), vec4i(huge), bitcast<vec4i>(vec4u(huge)), vec4i(vec4<bool>(a[i] % vec4i(2))), vec4i(vec4f(a[i] % 1000)));
    floats[i] = array(vec4f(a[i]), vec4f(bitcast<vec4u>(a[i])));
}
