// Covers: subgroupBroadcast, subgroupBroadcastFirst, subgroupShuffle and its relatives, where the other lane is there.
// lobe: --workgroups 1,1,1
@group(0) @binding(0) var<storage, read> data: array<u32, 64>;
@group(0) @binding(1) var<storage, read_write> out: array<vec4<u32>, 128>;

@compute @workgroup_size(64)
fn main(@builtin(local_invocation_index) i: u32, @builtin(subgroup_size) size: u32,
        @builtin(subgroup_invocation_id) lane: u32) {
    let x = data[i];
    let down = subgroupShuffleDown(x, 1u);
    let up = subgroupShuffleUp(x, 2u);
    out[i] = vec4<u32>(subgroupBroadcast(x, 3u), subgroupBroadcastFirst(x), subgroupShuffle(x, size - 1u - lane),
                       subgroupShuffleXor(x, 1u));
    out[i + 64u] = vec4<u32>(select(0u, down, lane + 1u < size), select(0u, up, lane >= 2u), 0u, 0u);
    if lane >= 2u {
        out[i + 64u].z = subgroupBroadcastFirst(x);
    }
}
