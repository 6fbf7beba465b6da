// Covers: arrays of storage textures: stores, loads and atomics, where the index is known, uniform, and of the first two
// another in each invocation.
// lobe: --texture 'goals[0]=rgba8unorm:8x8x1' --texture 'goals[1]=rgba8unorm:16x8x1' --elements goals=2
enable wgpu_binding_array;

@group(0) @binding(0) var goals: binding_array<texture_storage_2d<rgba8unorm, write>>;
@group(0) @binding(1) var both: binding_array<texture_storage_2d<r32uint, read_write>, 2>;
@group(0) @binding(2) var sources: binding_array<texture_storage_2d<rgba16float, read>, 3>;
@group(0) @binding(3) var totals: binding_array<texture_storage_2d<r32uint, atomic>, 2>;

@compute @workgroup_size(8, 8)
fn main(
    @builtin(local_invocation_id) id: vec3<u32>,
    @builtin(local_invocation_index) i: u32,
    @builtin(workgroup_id) group: vec3<u32>,
) {
    let color = textureLoad(sources[i % 3u], id.yx) + textureLoad(sources[2], id.xy);
    textureStore(goals[i & 1u], id.xy, color);
    textureStore(goals[1], id.xy + vec2<u32>(8u, 0u), color.wzyx);
    let old = textureLoad(both[id.y & 1u], id.xy).x;
    textureStore(both[id.y & 1u], id.xy, vec4<u32>(old + i, 0u, 0u, 0u));
    textureAtomicAdd(totals[group.x], vec2<u32>(id.x, 0u), i);
    textureAtomicMax(totals[1], vec2<u32>(0u, 1u), i);
}
