//! Entry points, private and otherwise unused.
#![deny(warnings)]
use lobe_codegen::prelude::*;

#[kernel(workgroup_size(8, 8))]
fn scale(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] factor: &Vec4,
    #[storage(0, 1)] given: &[f32],
    #[storage(0, 2)] found: &mut [f32],
    #[storage(0, 3)] count: &AtomicU32,
    #[workgroup] tile: &mut [f32; 64],
) {
    let i = id.x as usize;
    tile[(id.x % 64) as usize] = given[i];
    workgroup_barrier();
    found[i] = tile[(id.x % 64) as usize] * factor.x;
    atomic_add(count, 1);
}

fn main() {}
