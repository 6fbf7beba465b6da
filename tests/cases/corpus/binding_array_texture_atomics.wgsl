// Covers: atomics on a texture that each invocation chooses for itself.
enable wgpu_binding_array;

@group(0) @binding(0) var totals: binding_array<texture_storage_2d<r32uint, atomic>, 2>;

@compute @workgroup_size(8, 8)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    textureAtomicAdd(totals[i & 1u], vec2<u32>(id.x, 0u), i);
}
