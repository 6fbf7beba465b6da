// Floats of 16 bits, in memory too.
enable f16;

struct Half {
    a: f16,
    b: vec3h,
    c: mat2x2h,
    d: f16,
}

@group(0) @binding(0) var<storage, read> a: array<vec4h>;
@group(0) @binding(1) var<storage, read_write> out: array<array<vec4h, 4>>;
@group(0) @binding(2) var<storage, read_write> structs: array<Half>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) {
        return;
    }
    let x = a[i];
    let y = a[i].wzyx * 0.5h + 2.0h;
    out[i] = array(x + y, x - y, x * y, vec4h(vec4f(x) * 3.0));
    structs[i].a = x.x;
    structs[i].b = y.xyz;
    structs[i].c = mat2x2h(x.xy, y.zw);
    structs[i].d = f16(i32(x.w * 100.0h)) + f16(i % 7u);
}
