// A dispatch of three dimensions, and all built-in values of an invocation.
@group(0) @binding(0) var<storage, read_write> out: array<array<vec4u, 3>>;

@compute @workgroup_size(4, 2, 2)
fn main(
    @builtin(global_invocation_id) global: vec3u,
    @builtin(local_invocation_id) local: vec3u,
    @builtin(local_invocation_index) index: u32,
    @builtin(workgroup_id) group: vec3u,
    @builtin(num_workgroups) groups: vec3u,
) {
    let size = groups * vec3u(4u, 2u, 2u);
    let i = global.x + size.x * (global.y + size.y * global.z);
    if i < arrayLength(&out) {
        out[i] = array(vec4u(global, index), vec4u(local, i), vec4u(group, groups.x));
    }
}
