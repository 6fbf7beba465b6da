// Cooperative matrices.
enable wgpu_cooperative_matrix;

@group(0) @binding(0) var<storage, read_write> out: array<f32>;

@compute @workgroup_size(8, 8, 1)
fn main() {
    let a = coopLoad<coop_mat8x8<f32, A>>(&out[0]);
    let b = coopLoad<coop_mat8x8<f32, B>>(&out[64]);
    var c = coopLoad<coop_mat8x8<f32, C>>(&out[128]);
    coopStore(coopMultiplyAdd(a, b, c), &out[128]);
}
