// Covers: storage textures that are read and written, textureBarrier, a read-only storage texture.
// lobe: --workgroups 3,2,1 --texture image=r32uint:24x16x1 --texture source=rgba8uint:24x16x1
@group(0) @binding(0) var image: texture_storage_2d<r32uint, read_write>;
@group(0) @binding(1) var source: texture_storage_2d<rgba8uint, read>;

@compute @workgroup_size(8, 8)
fn main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_id) local: vec3<u32>) {
    let old = textureLoad(image, id.xy).x;
    let other = textureLoad(source, id.xy);
    textureStore(image, id.xy, vec4<u32>(old / 2u + other.x + other.w, 0u, 0u, 0u));
    textureBarrier();
    // What the neighbour across the workgroup wrote.
    let mirrored = id.xy - local.xy + (vec2<u32>(7u) - local.xy);
    let theirs = textureLoad(image, mirrored).x;
    textureBarrier();
    textureStore(image, id.xy, vec4<u32>(theirs ^ old, 0u, 0u, 0u));
}
