// A sum by halves in workgroup memory, with barriers between.
var<workgroup> sums: array<vec2u, 64>;
var<workgroup> flags: array<u32, 64>;

@group(0) @binding(0) var<storage, read> a: array<u32>;
@group(0) @binding(1) var<storage, read_write> out: array<vec4u>;

@compute @workgroup_size(8, 4, 2)
fn main(
    @builtin(local_invocation_id) local: vec3u,
    @builtin(local_invocation_index) lane: u32,
    @builtin(workgroup_id) group: vec3u,
) {
    let first = group.x * 64u;
    let x = select(0u, a[first + lane], first + lane < arrayLength(&a));
    sums[lane] = vec2u(x, local.x + 8u * local.y + 32u * local.z);
    flags[63u - lane] = x & 1u;
    workgroupBarrier();
    for (var half = 32u; half > 0u; half >>= 1u) {
        if lane < half {
            sums[lane] += sums[lane + half];
        }
        workgroupBarrier();
    }
    let odd = flags[lane];
    if lane == 0u && group.x < arrayLength(&out) {
        out[group.x] = vec4u(sums[0], odd, flags[63]);
    }
}
