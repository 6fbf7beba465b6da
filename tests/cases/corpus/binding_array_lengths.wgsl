// Covers: the length of an array at the end of a buffer that each invocation chooses for itself, told and kept to.
// lobe: --elements rows=3 --size 'rows[0]=16' --size 'rows[1]=64' --size 'rows[2]=40'
enable wgpu_binding_array;

struct Row {
    tag: u32,
    items: array<u32>,
}

@group(0) @binding(0) var<storage> rows: binding_array<Row>;
@group(0) @binding(1) var<storage, read_write> out: array<vec2<u32>>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let which = id.x % 3u;
    out[id.x] = vec2<u32>(arrayLength(&rows[which].items), rows[which].items[id.x % 3u]);
}
