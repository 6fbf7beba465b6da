// Covers: subgroup_size, subgroup_invocation_id, num_subgroups, subgroup_id.
// lobe: --workgroups 2,1,1
@group(0) @binding(0) var<storage, read_write> out: array<vec4<u32>, 128>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(subgroup_size) size: u32,
        @builtin(subgroup_invocation_id) lane: u32, @builtin(num_subgroups) count: u32,
        @builtin(subgroup_id) subgroup: u32) {
    out[id.x] = vec4<u32>(size, lane, count, subgroup);
}
