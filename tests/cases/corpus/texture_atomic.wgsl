// Covers: atomic operations on texels.
// lobe: --workgroups 4,1,1 --input unsigned=zeros --input signed=zeros --input maxima=zeros
// lobe: --texture unsigned=r32uint:4x4x1 --texture signed=r32sint:4x4x1 --texture maxima=r32sint:4x4x1
@group(0) @binding(0) var unsigned: texture_storage_2d<r32uint, atomic>;
@group(0) @binding(1) var signed: texture_storage_2d<r32sint, atomic>;
@group(0) @binding(2) var maxima: texture_storage_2d<r32sint, atomic>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {
    let at = vec2<i32>(i32(id.x) % 4, i32(id.x) / 4 % 4);
    textureAtomicAdd(unsigned, at, id.x);
    textureAtomicMin(signed, at, 17 - i32(id.x));
    textureAtomicMax(maxima, at, i32(id.x) - 100);
    textureAtomicOr(unsigned, vec2<i32>(3, 3), 1u << 31u);
}
