// Geometry of vectors.
@group(0) @binding(0) var<storage, read> a: array<vec4f>;
@group(0) @binding(1) var<storage, read> b: array<vec4f>;
@group(0) @binding(2) var<storage, read_write> out: array<array<vec4f, 5>>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) || i >= arrayLength(&b) {
        return;
    }
    let x = a[i].xyz + vec3f(2.0);
    let y = b[i].xyz - vec3f(1.5);
    let n = normalize(x);
    let d = normalize(y);
    out[i] = array(
        vec4f(cross(x, y), dot(x, y)), vec4f(n, length(y)), vec4f(reflect(d, n), distance(x, y)),
        vec4f(refract(d, n, 0.5), dot(x.xy, y.yx)), vec4f(faceForward(n, d, vec3f(1.0)), length(a[i].w + 3.0)),
    );
}
