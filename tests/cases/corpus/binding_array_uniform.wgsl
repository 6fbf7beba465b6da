// Covers: arrays of uniform buffers. No driver that wgpu knows lets invocations differ in the index.
enable wgpu_binding_array;

struct Light {
    color: vec3<f32>,
    power: f32,
    frame: mat3x3<f32>,
}

@group(0) @binding(0) var<uniform> lights: binding_array<Light, 3>;
@group(0) @binding(1) var<storage, read_write> out: array<vec3<f32>>;

@compute @workgroup_size(32)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    var sum = lights[0].frame * lights[2].color;
    for (var which = 0u; which < 3u; which += 1u) {
        sum += lights[which].color * lights[which].power + lights[which].frame[1];
    }
    out[id.x] = sum * f32(id.x);
}
