// Covers: subgroup reductions and scans of i32, vectors too, with lanes left out.
// lobe: --workgroups 1,1,1
@group(0) @binding(0) var<storage, read> data: array<i32, 64>;
@group(0) @binding(1) var<storage, read_write> out: array<vec4<i32>, 256>;

@compute @workgroup_size(64)
fn main(@builtin(local_invocation_index) i: u32) {
    let x = data[i];
    out[i] = vec4<i32>(subgroupAdd(x), subgroupMul(x | 1), subgroupMin(x), subgroupMax(x));
    out[i + 64u] = vec4<i32>(subgroupAnd(x | 3), subgroupOr(x), subgroupXor(x), subgroupExclusiveAdd(x));
    out[i + 128u] = vec4<i32>(subgroupInclusiveAdd(x), subgroupExclusiveMul(x | 1), subgroupInclusiveMul(x | 1), 0);
    if i % 3u != 1u {
        out[i + 192u] = vec4<i32>(subgroupAdd(vec2<i32>(x, x * 2)), subgroupExclusiveAdd(x), subgroupMax(x));
    }
}
