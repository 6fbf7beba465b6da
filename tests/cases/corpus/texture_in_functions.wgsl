// Covers: textures and samplers as arguments of functions, in loops and branches.
// lobe: --within out=0.03
// lobe: --texture near=rgba8unorm:8x8x1 --texture far=rgba8unorm:4x4x1 --sampler fine=linear
@group(0) @binding(0) var near: texture_2d<f32>;
@group(0) @binding(1) var far: texture_2d<f32>;
@group(0) @binding(2) var fine: sampler;
@group(0) @binding(3) var<storage, read_write> out: array<vec4<f32>, 64>;

fn sum(image: texture_2d<f32>, how: sampler, at: vec2<f32>, count: u32) -> vec4<f32> {
    var total = vec4<f32>();
    for (var n = 0u; n < count; n += 1u) {
        total += textureSampleLevel(image, how, at * f32(n + 1u), 0.0);
    }
    return total;
}

@compute @workgroup_size(8, 8)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    let at = (vec2<f32>(id.xy) + 0.4) / 24.0;
    if (i & 3u) == 1u {
        out[i] = sum(near, fine, at, i % 4u);
    } else {
        out[i] = sum(far, fine, at, i % 3u) + textureLoad(near, id.xy, 0);
    }
}
