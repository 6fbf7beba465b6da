// Covers: textureLoad of 1D and 3D textures.
// lobe: --texture line=r32float:16x1x1 --texture block=rgba32uint:4x4x4
@group(0) @binding(0) var line: texture_1d<f32>;
@group(0) @binding(1) var block: texture_3d<u32>;
@group(0) @binding(2) var<storage, read_write> out: array<vec4<u32>, 64>;
@group(0) @binding(3) var<storage, read_write> floats: array<vec4<f32>, 64>;

@compute @workgroup_size(4, 4, 4)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    out[i] = textureLoad(block, id, 0);
    floats[i] = textureLoad(line, i32(i % 16u), 0);
}
