// A texture out of a video.
@group(0) @binding(0) var video: texture_external;
@group(0) @binding(1) var<storage, read_write> out: array<vec4f>;

@compute @workgroup_size(4)
fn main(@builtin(local_invocation_index) lane: u32) {
    out[lane] = textureLoad(video, vec2u(lane, 0u));
}
