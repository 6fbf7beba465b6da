// Atomics in storage memory, whose order does not show.
struct Counters {
    sum: atomic<u32>,
    least: atomic<i32>,
    most: atomic<u32>,
    bits: array<atomic<u32>, 3>,
    signed: atomic<i32>,
}

@group(0) @binding(0) var<storage, read> a: array<i32>;
@group(0) @binding(1) var<storage, read_write> counters: Counters;
@group(0) @binding(2) var<storage, read_write> histogram: array<atomic<u32>, 16>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&a) {
        return;
    }
    let x = a[i];
    atomicAdd(&counters.sum, bitcast<u32>(x));
    atomicMin(&counters.least, x);
    atomicMax(&counters.most, bitcast<u32>(x));
    atomicAnd(&counters.bits[0], bitcast<u32>(x));
    atomicOr(&counters.bits[1], bitcast<u32>(x));
    atomicXor(&counters.bits[2], bitcast<u32>(x));
    atomicSub(&counters.signed, x / 3);
    atomicAdd(&histogram[u32(x) % 16u], 1u);
}
