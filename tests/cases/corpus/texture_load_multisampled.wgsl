// Covers: textureLoad and textureNumSamples of multisampled textures, depth ones too; they begin as zeros.
// lobe: --texture color=rgba8unorm:4x4x1 --texture depth=depth32float:4x4x1
@group(0) @binding(0) var color: texture_multisampled_2d<f32>;
@group(0) @binding(1) var depth: texture_depth_multisampled_2d;
@group(0) @binding(2) var<storage, read_write> out: array<vec4<f32>, 16>;

@compute @workgroup_size(4, 4)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    let samples = f32(textureNumSamples(color) + 16u * textureNumSamples(depth));
    let size = vec2<f32>(textureDimensions(color));
    out[i] = textureLoad(color, id.xy, id.x) + vec4<f32>(textureLoad(depth, id.xy, 1), samples, size);
}
