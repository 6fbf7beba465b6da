// Covers: subgroupBarrier: what a subgroup wrote to workgroup memory.
// lobe: --workgroups 1,1,1
@group(0) @binding(0) var<storage, read> data: array<u32, 64>;
@group(0) @binding(1) var<storage, read_write> out: array<u32, 64>;
var<workgroup> place: array<u32, 64>;

@compute @workgroup_size(64)
fn main(@builtin(local_invocation_index) i: u32) {
    place[i] = data[i] * 3u;
    subgroupBarrier();
    out[i] = place[i ^ 1u];
}
