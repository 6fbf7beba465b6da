// Matrices of two and three rows in memory: strides and padding of columns, columns written alone.
struct Shapes {
    a: mat2x2f,
    b: f32,
    c: mat3x3f,
    d: vec3f,
    e: mat4x2f,
    f: mat2x3f,
    g: u32,
}

@group(0) @binding(0) var<storage, read> shapes: array<Shapes>;
@group(0) @binding(1) var<storage, read_write> out: array<Shapes>;
@group(0) @binding(2) var<uniform> scale: Shapes;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&shapes) || i >= arrayLength(&out) {
        return;
    }
    var s = shapes[i];
    s.a = s.a * 2.0;
    s.c[i % 3u] = s.d;
    s.e[3][i % 2u] = s.b;
    s.f[1] = scale.f[0];
    s.g = s.g + scale.g;
    out[i] = s;
    out[i].c[1].z = scale.c[2].y;
    out[i].a[i % 2u] = scale.e[i % 4u];
}
