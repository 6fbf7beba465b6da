// Indices past the end: reads and writes stay inside, as the default policy has it.
@group(0) @binding(0) var<storage, read> table: array<u32, 16>;
@group(0) @binding(1) var<storage, read> indices: array<u32>;
@group(0) @binding(2) var<storage, read_write> out: array<vec2u>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i >= arrayLength(&indices) {
        return;
    }
    let index = indices[i] % 40u;
    var local = array(1u, 2u, 3u, 4u);
    local[min(index, 3u)] = 9u;
    let inside = index < 16u;
    out[i] = vec2u(select(0u, table[index], inside), local[index % 4u]);
}
