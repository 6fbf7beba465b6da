// Covers: elements of arrays of textures and samplers as arguments of functions. A driver takes those that each invocation chooses
// for itself only where it is told so, which has no place in a parameter.
// lobe: --texture 'images[1]=rgba8unorm:4x16x1:1:3' --sampler 'plain[1]=repeat'
enable wgpu_binding_array;

@group(0) @binding(0) var images: binding_array<texture_2d<f32>, 3>;
@group(0) @binding(1) var plain: binding_array<sampler, 2>;
@group(0) @binding(2) var<storage, read_write> out: array<vec4<f32>>;

fn corner(image: texture_2d<f32>, level: u32) -> vec4<f32> {
    return textureLoad(image, textureDimensions(image, level) - 1u, level);
}

fn sampled(image: texture_2d<f32>, how: sampler, at: vec2<f32>) -> vec4<f32> {
    return textureSampleLevel(image, how, at, 0.0);
}

@compute @workgroup_size(8, 8)
fn main(
    @builtin(local_invocation_id) id: vec3<u32>,
    @builtin(local_invocation_index) i: u32,
    @builtin(workgroup_id) group: vec3<u32>,
) {
    // In the midst of texels, some of them beyond the edges.
    let at = (vec2<f32>(id.xy) * 4.0 + 0.5) / 16.0 - 0.25;
    var sum = corner(images[1], id.y % 3u) + corner(images[group.x + 2u], 0u);
    for (var which = 0u; which < 2u; which += 1u) {
        sum += sampled(images[0], plain[which], at);
    }
    out[i] = sum;
}
