// Values put together and taken apart: swizzles, splats, dynamic indices of vectors, matrices and arrays.
struct Inner {
    values: array<vec3f, 2>,
    flag: u32,
}
struct Outer {
    first: Inner,
    rest: array<Inner, 3>,
}

@group(0) @binding(0) var<storage, read> a: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> out: array<Outer>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) || i >= arrayLength(&out) {
        return;
    }
    let v = a[i];
    var inner = Inner(array(v.xyz, v.zzw), i);
    inner.values[i % 2u][i % 3u] = v[(i + 1u) % 4u];
    var m = mat3x3f(v.xyz, v.yzw, vec3f(v.x));
    m[i % 3u] = vec3f(v[i % 4u]);
    m[(i + 1u) % 3u].y = 0.5;
    let list = array(m[0], m[1], m[2]);
    var result = Outer(inner, array(inner, Inner(), Inner(array(list[i % 3u], list[0]), 3u)));
    result.rest[1].values[1] = list[(i * 7u) % 3u];
    out[i] = result;
}
