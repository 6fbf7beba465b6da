// Covers: subgroup reductions and scans of f32; the order of a sum is the driver's.
@group(0) @binding(0) var<storage, read> data: array<f32, 64>;
@group(0) @binding(1) var<storage, read_write> out: array<vec4<f32>, 128>;

@compute @workgroup_size(64)
fn main(@builtin(local_invocation_index) i: u32) {
    let x = data[i];
    out[i] = vec4<f32>(subgroupAdd(x), subgroupMul(x), subgroupMin(x), subgroupMax(x));
    out[i + 64u] = vec4<f32>(subgroupExclusiveAdd(x), subgroupInclusiveAdd(x), subgroupExclusiveMul(x),
                             subgroupInclusiveMul(x));
}
