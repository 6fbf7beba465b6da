// Structures in memory: a vector of three, sizes and alignments asked for, arrays with strides, a runtime array at the end.
struct Small {
    @size(16) a: u32,
    @align(16) b: vec3u,
    c: u32,
}
struct Buffer {
    head: vec3f,
    count: u32,
    small: array<Small, 2>,
    items: array<Item>,
}
struct Item {
    v: vec3f,
    w: f32,
    n: vec2i,
}

@group(0) @binding(0) var<storage, read> source: Buffer;
@group(1) @binding(3) var<storage, read_write> destination: Buffer;
@group(1) @binding(0) var<storage, read_write> lengths: array<u32, 4>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i == 0u {
        lengths[0] = arrayLength(&source.items);
        lengths[1] = arrayLength(&destination.items);
        destination.head = source.head.zyx;
        destination.count = source.count + 1u;
        destination.small[1] = source.small[0];
        destination.small[0].b = vec3u(source.small[1].c);
    }
    if i < min(arrayLength(&source.items), arrayLength(&destination.items)) {
        var item = source.items[i];
        item.v.x = item.w;
        destination.items[i] = item;
        destination.items[i].n.y = item.n.x - 5;
    }
}
