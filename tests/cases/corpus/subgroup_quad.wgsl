// Covers: quadBroadcast, quadSwapX, quadSwapY, quadSwapDiagonal.
// lobe: --workgroups 1,1,1
@group(0) @binding(0) var<storage, read> data: array<vec4<f32>, 64>;
@group(0) @binding(1) var<storage, read_write> out: array<vec4<f32>, 64>;

@compute @workgroup_size(64)
fn main(@builtin(local_invocation_index) i: u32) {
    let x = data[i];
    out[i] = vec4<f32>(quadBroadcast(x.x, 2u), quadSwapX(x.y), quadSwapY(x.z), quadSwapDiagonal(x.w));
}
