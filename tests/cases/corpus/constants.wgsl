// Constants, overrides with their defaults, arrays sized by an override, and zero values.
const SCALE = 2.5;
const TABLE = array(1.0, SCALE, SCALE * SCALE, -1.0);
const LIMIT = 3u + u32(SCALE);

struct Pair {
    a: vec2f,
    b: i32,
}
const PAIR = Pair(vec2f(1.5, -2.0), 7);

@id(4) override count: u32 = 8u;
override half_count = count / 2u;
override gain: f32 = 0.5;
override flag: bool = true;

var<workgroup> shared_values: array<f32, half_count>;

@group(0) @binding(0) var<storage, read_write> out: array<vec4f>;

@compute @workgroup_size(half_count)
fn main(@builtin(local_invocation_index) lane: u32, @builtin(workgroup_id) group: vec3u) {
    shared_values[lane] = TABLE[lane % 4u] * gain;
    workgroupBarrier();
    let zero = Pair();
    let empty = array<vec2f, 3>();
    let other = shared_values[half_count - 1u - lane];
    let i = group.x * half_count + lane;
    if i < arrayLength(&out) {
        out[i] = vec4f(other, PAIR.a + zero.a + empty[lane % 3u], select(-1.0, f32(LIMIT), flag));
    }
}
