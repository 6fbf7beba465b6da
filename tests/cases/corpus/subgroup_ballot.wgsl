// Covers: subgroupBallot, subgroupAll, subgroupAny, in uniform and parted control flow.
// lobe: --workgroups 1,1,1
@group(0) @binding(0) var<storage, read> data: array<u32, 64>;
@group(0) @binding(1) var<storage, read_write> out: array<vec4<u32>, 128>;

@compute @workgroup_size(64)
fn main(@builtin(local_invocation_index) i: u32) {
    let x = data[i];
    out[i] = subgroupBallot(x > 31u);
    var flags = vec4<u32>(u32(subgroupAll(x < 63u)), u32(subgroupAny(x > 55u)), 0u, 0u);
    if (i & 1u) == 0u {
        flags.z = subgroupBallot(true).x;
        flags.w = u32(subgroupAll(x < 40u)) * 2u + u32(subgroupAny(x < 8u));
    }
    out[i + 64u] = flags;
}
