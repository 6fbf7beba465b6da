// Covers: arrays of storage buffers that are written: stores and atomics where the index is known, uniform, and another in
// each invocation; what a store leaves is read again.
// lobe: --elements counts=3 --size 'rows[2]=512'
enable wgpu_binding_array;

struct Row {
    header: vec2<u32>,
    items: array<f32>,
}

struct Count {
    sum: atomic<u32>,
    least: atomic<i32>,
    marks: array<atomic<u32>, 8>,
}

@group(0) @binding(0) var<storage, read_write> rows: binding_array<Row, 4>;
@group(0) @binding(1) var<storage, read_write> counts: binding_array<Count>;
@group(0) @binding(2) var<storage, read_write> out: array<vec2<u32>>;

@compute @workgroup_size(16, 4)
fn main(@builtin(local_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) i: u32) {
    // Each invocation has an item, and each row 16 invocations.
    let which = id.y;
    rows[which].items[id.x * 2u] += f32(i) * 0.5;
    rows[which].items[id.x * 2u + 1u] = rows[which].items[id.x * 2u] * 3.0;
    if id.x == 3u {
        rows[which].header = vec2<u32>(which, arrayLength(&rows[which].items));
    }
    atomicAdd(&counts[1].sum, i);
    atomicAdd(&counts[i % 3u].sum, 2u);
    atomicMin(&counts[i % 3u].least, -i32(i));
    atomicOr(&counts[(i * 7u) % 3u].marks[i & 7u], 1u << (i & 15u));
    storageBarrier();
    out[i] = vec2<u32>(atomicLoad(&counts[id.y % 3u].sum), rows[3].header.y + rows[which].header.x);
}
