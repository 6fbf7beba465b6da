// An array of buffers.
enable wgpu_binding_array;

struct Block {
    value: u32,
}

@group(0) @binding(0) var<storage> blocks: binding_array<Block, 4>;
@group(0) @binding(1) var<storage, read_write> out: array<u32>;

@compute @workgroup_size(4)
fn main(@builtin(local_invocation_index) lane: u32) {
    out[lane] = blocks[1].value;
}
