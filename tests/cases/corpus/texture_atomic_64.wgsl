// Covers: atomic operations on texels of 64 bits.
@group(0) @binding(0) var most: texture_storage_2d<r64uint, atomic>;

@compute @workgroup_size(64)
fn main(@builtin(local_invocation_index) i: u32) {
    let at = vec2<i32>(i32(i) % 4, i32(i) / 4 % 4);
    textureAtomicMax(most, at, 10000000000lu + u64(i));
}
