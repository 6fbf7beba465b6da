// Immediate data.
var<immediate> factor: u32;
@group(0) @binding(0) var<storage, read_write> out: array<u32>;

@compute @workgroup_size(4)
fn main(@builtin(local_invocation_index) lane: u32) {
    out[lane] = lane * factor;
}
