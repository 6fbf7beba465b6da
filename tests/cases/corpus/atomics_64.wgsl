// Atomics on integers of 64 bits.
@group(0) @binding(0) var<storage, read> a: array<u64>;
@group(0) @binding(1) var<storage, read_write> sum: atomic<u64>;
@group(0) @binding(2) var<storage, read_write> most: atomic<u64>;
@group(0) @binding(3) var<storage, read_write> least: atomic<i64>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i < arrayLength(&a) {
        atomicAdd(&sum, a[i]);
        atomicMax(&most, a[i]);
        atomicMin(&least, i64(a[i]));
    }
}
