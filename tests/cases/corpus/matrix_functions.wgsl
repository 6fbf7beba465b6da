// Transposes and determinants.
@group(0) @binding(0) var<storage, read> a: array<mat4x4f>;
@group(0) @binding(1) var<storage, read_write> out: array<mat4x4f>;
@group(0) @binding(2) var<storage, read_write> determinants: array<vec3f>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) {
        return;
    }
    let m = a[i];
    out[i] = transpose(m);
    let m3 = mat3x3f(m[0].xyz, m[1].xyz, m[2].xyz);
    let m2 = mat2x2f(m[0].xy, m[1].zw);
    determinants[i] = vec3f(determinant(m2), determinant(m3), determinant(m));
}
