// Invocations of a workgroup hand values on through storage memory.
@group(0) @binding(0) var<storage, read_write> work: array<u32>;
@group(0) @binding(1) var<storage, read_write> out: array<u32>;

@compute @workgroup_size(64)
fn main(@builtin(local_invocation_index) lane: u32, @builtin(workgroup_id) group: vec3u) {
    let first = group.x * 64u;
    if first + 63u >= arrayLength(&work) || first + 63u >= arrayLength(&out) {
        return;
    }
    work[first + lane] = lane * lane + group.x;
    storageBarrier();
    let neighbour = work[first + (lane + 1u) % 64u];
    storageBarrier();
    work[first + lane] = neighbour + 1u;
    storageBarrier();
    out[first + lane] = work[first + (lane ^ 5u)];
}
