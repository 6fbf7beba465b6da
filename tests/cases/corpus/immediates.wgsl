// Immediate data: scalars, vectors, a matrix and an array, by known and by computed indices.

struct Part {
    scale: f32,
    shift: vec3f,
}

struct Push {
    factor: u32,
    sign: i32,
    turn: mat2x2f,
    part: Part,
    list: array<u32, 4>,
}

var<immediate> push: Push;
@group(0) @binding(1) var<storage, read_write> out: array<u32>;
@group(0) @binding(2) var<storage, read_write> floats: array<f32>;

fn listed(lane: u32) -> u32 {
    return push.list[lane % 4u] + push.list[3];
}

@compute @workgroup_size(4)
fn main(@builtin(local_invocation_index) lane: u32) {
    let whole = push;
    out[lane] = lane * push.factor + u32(push.sign + 64) + listed(lane);
    floats[lane] = push.part.scale;
    floats[lane + 4u] = push.part.shift[lane % 3u];
    floats[lane + 8u] = push.turn[lane % 2u].y;
    floats[lane + 12u] = whole.part.shift.y;
}
