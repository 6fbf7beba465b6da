// Circular and hyperbolic functions, angles in degrees.
@group(0) @binding(0) var<storage, read> a: array<vec2f>;
@group(0) @binding(1) var<storage, read_write> out: array<array<f32, 15>>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) {
        return;
    }
    let x = a[i].x * 3.0;
    let y = a[i].y * 0.9;
    out[i] = array(
        sin(x), cos(x), tan(x * 0.4), asin(y), acos(y), atan(x), atan2(y, x + sign(x) + 0.5),
        sinh(x), cosh(x), tanh(x), asinh(x), acosh(1.5 + abs(x)), atanh(y), degrees(x), radians(x * 90.0),
    );
}
