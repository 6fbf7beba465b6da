// Covers: arrays of sampled textures of all kinds of texels and several shapes: loads and queries, where the index is known,
// uniform, and another in each invocation.
// lobe: --texture 'images[0]=rgba8unorm:8x8x1' --texture 'images[1]=rgba8unorm:4x16x1:1:3' --texture 'images[2]=rgba8unorm:5x3x1'
// lobe: --texture 'layers[1]=rgba8uint:4x4x1:3' --elements images=3 --elements layers=2
enable wgpu_binding_array;

@group(0) @binding(0) var images: binding_array<texture_2d<f32>>;
@group(0) @binding(1) var blocks: binding_array<texture_3d<i32>, 2>;
@group(0) @binding(2) var layers: binding_array<texture_2d_array<u32>>;
@group(0) @binding(3) var depths: binding_array<texture_depth_2d, 2>;
@group(0) @binding(4) var fine: binding_array<texture_multisampled_2d<f32>, 2>;
@group(0) @binding(5) var<storage, read_write> floats: array<vec4<f32>>;
@group(0) @binding(6) var<storage, read_write> words: array<vec4<u32>>;

@compute @workgroup_size(8, 8)
fn main(
    @builtin(local_invocation_id) id: vec3<u32>,
    @builtin(local_invocation_index) i: u32,
    @builtin(workgroup_id) group: vec3<u32>,
) {
    let own = i % 3u;
    let at = id.xy % textureDimensions(images[own]);
    var sum = textureLoad(images[own], at, 0) + textureLoad(images[2], vec2<u32>(id.x % 5u, 1u), 0);
    sum += textureLoad(images[1], textureDimensions(images[1], id.y % 3u) - 1u, id.y % 3u) + textureLoad(images[group.x + 1u], vec2<u32>(3u, 2u), 0);
    floats[i] = sum + textureLoad(depths[i & 1u], id.xy, 0) + textureLoad(fine[i & 1u], id.xy, i32(id.x & 3u));
    let block = textureLoad(blocks[i & 1u], id.yxx, 0);
    let layer = textureLoad(layers[(i >> 1u) & 1u], id.xy & vec2<u32>(3u), id.y % 3u, 0);
    let asked = vec4<u32>(
        textureDimensions(images[own]),
        textureNumLevels(images[own]) * 10u + textureNumSamples(fine[i & 1u]),
        textureNumLayers(layers[i & 1u]),
    );
    words[i] = bitcast<vec4<u32>>(block) + layer + asked;
}
