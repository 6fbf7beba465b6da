// Atomics in workgroup memory, with the values that they return where these do not depend on order.
var<workgroup> tickets: atomic<u32>;
var<workgroup> taken: array<atomic<u32>, 64>;
var<workgroup> winner: atomic<i32>;

@group(0) @binding(0) var<storage, read_write> out: array<vec4u>;

@compute @workgroup_size(64)
fn main(@builtin(local_invocation_index) lane: u32, @builtin(workgroup_id) group: vec3u) {
    if lane == 0u {
        atomicStore(&winner, -1);
    }
    workgroupBarrier();
    let ticket = atomicAdd(&tickets, 1u);
    atomicStore(&taken[ticket], lane + 1u);
    let before = atomicExchange(&taken[ticket], lane + 2u);
    let won = atomicCompareExchangeWeak(&winner, -1, i32(group.x));
    workgroupBarrier();
    let expected = select(0u, 1u, before == lane + 1u);
    let i = group.x * 64u + lane;
    if i < arrayLength(&out) {
        let old_is_one_of_two = won.old_value == -1 || won.old_value == i32(group.x);
        out[i] = vec4u(atomicLoad(&tickets), expected, bitcast<u32>(atomicLoad(&winner)), u32(old_is_one_of_two));
    }
}
