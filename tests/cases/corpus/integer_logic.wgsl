// Bit operations, comparisons, logic and selection on integers and booleans, scalars and vectors.
@group(0) @binding(0) var<storage, read> a: array<vec4i>;
@group(0) @binding(1) var<storage, read> b: array<vec4u>;
@group(0) @binding(2) var<storage, read_write> out: array<vec4u>;

fn both(p: bool, q: bool) -> bool {
    return (p && q) || (!p && !q);
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) {
        return;
    }
    let x = a[i];
    let u = b[i];
    let bits = (u & bitcast<vec4u>(x)) ^ (u | bitcast<vec4u>(~x));
    let less = x < x.yzwx;
    let most = u >= u.wxyz;
    let flags = vec4<bool>(both(less.x, most.x), any(less & most), all(less | most), x.x != x.y);
    let equal = (u.xy == u.zw) != (x.xy <= x.zw);
    out[i] = select(bits, bits * 3u, flags) + vec4u(vec2u(equal), vec2u(u.zw > u.xy));
}
