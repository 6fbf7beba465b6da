// Products of matrices of all shapes with vectors, scalars and one another.
@group(0) @binding(0) var<storage, read> a: array<array<vec4f, 4>>;
@group(0) @binding(1) var<storage, read_write> out: array<array<vec4f, 7>>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) {
        return;
    }
    let m = mat4x4f(a[i][0], a[i][1], a[i][2], a[i][3]);
    let m3 = mat3x3f(a[i][0].xyz, a[i][1].xyz, a[i][2].xyz);
    let m23 = mat2x3f(a[i][0].xyz, a[i][3].yzw);
    let m32 = mat3x2f(a[i][1].xy, a[i][2].zw, a[i][0].xy);
    let m24 = mat2x4f(a[i][0], a[i][1]);
    let m42 = mat4x2f(a[i][0].xy, a[i][1].xy, a[i][2].xy, a[i][3].xy);
    let m34 = mat3x4f(a[i][0], a[i][1], a[i][2]);
    let m43 = mat4x3f(a[i][0].xyz, a[i][1].xyz, a[i][2].xyz, a[i][3].xyz);
    let m2 = m32 * m23;
    out[i] = array(
        m * a[i][1], a[i][2] * m, vec4f(m3 * a[i][0].xyz, 1.0), vec4f(m2 * a[i][3].xy, (a[i][3].xyz * m3).xy),
        m24 * a[i][0].xy + m34 * a[i][1].xyz, vec4f(m43 * a[i][2], 0.0) + vec4f(m42 * a[i][3], 0.0, 0.0),
        (m * 0.5 + m * m - m)[i % 4u],
    );
}
