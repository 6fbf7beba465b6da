// Sums of floats by atomics; all numbers are whole, so that order does not show.
@group(0) @binding(0) var<storage, read> a: array<i32>;
@group(0) @binding(1) var<storage, read_write> sums: array<atomic<f32>, 4>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let i = id.x;
    if i < arrayLength(&a) {
        atomicAdd(&sums[i % 4u], f32(a[i] % 100));
    }
}
