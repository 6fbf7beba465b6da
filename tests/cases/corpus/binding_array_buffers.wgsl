// Covers: arrays of storage buffers that are read, of known length and without: indices known, uniform, and another in each
// invocation; members, vectors, arrays with a length in them and without, and those lengths.
// lobe: --elements loose=5 --size loose=144 --size 'uneven[0]=48' --size 'uneven[1]=208' --size 'uneven[2]=32'
enable wgpu_binding_array;

struct Fixed {
    scale: f32,
    shift: vec3<f32>,
    table: array<u32, 5>,
}

struct Loose {
    first: vec2<f32>,
    count: u32,
    items: array<vec2<u32>>,
}

@group(0) @binding(0) var<storage> exact: binding_array<Fixed, 3>;
@group(0) @binding(1) var<storage> loose: binding_array<Loose>;
@group(0) @binding(2) var<storage> uneven: binding_array<Loose, 3>;
@group(0) @binding(3) var<storage, read_write> floats: array<vec4<f32>>;
@group(0) @binding(4) var<storage, read_write> words: array<vec4<u32>>;

fn item(which: u32, at: u32) -> vec2<u32> {
    return uneven[which].items[at % arrayLength(&uneven[which].items)];
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(workgroup_id) group: vec3<u32>) {
    let i = id.x;
    let known = exact[1].shift;
    let shared_by_all = loose[group.x + 2u].first;
    let own = exact[i % 3u];
    floats[i] = vec4<f32>(known * own.scale + own.shift, shared_by_all.x + loose[i % 5u].first.y);
    var sum = vec2<u32>();
    for (var which = 0u; which < 3u; which += 1u) {
        sum += item(which, i) * (which + 1u);
    }
    if (i & 1u) == 0u {
        sum += loose[i % 5u].items[(i >> 1u) % 16u] + loose[4].items[2];
    }
    let lengths = arrayLength(&loose[4].items) * 100u + arrayLength(&uneven[group.x + 1u].items);
    words[i] = vec4<u32>(sum, own.table[i % 5u] + exact[i % 3u].table[4], lengths);
}
