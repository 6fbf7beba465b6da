// Functions that round, and those that take a float's parts.
@group(0) @binding(0) var<storage, read> a: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> out: array<array<vec4f, 8>>;
@group(0) @binding(2) var<storage, read_write> exponents: array<vec4i>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) {
        return;
    }
    // Halves and quarters: ties come up.
    let x = floor(a[i] * 64.0) * 0.25;
    let whole = modf(x);
    let parts = frexp(x + 0.25);
    exponents[i] = parts.exp;
    out[i] = array(ceil(x), floor(x), round(x), trunc(x), fract(x), whole.fract + whole.whole, parts.fract, ldexp(x, vec4i(-3, 0, 4, 9)));
}
