//! Entry points: bindings, workgroup memory, barriers, atomics.

use crate::check::{lowered, refusal, wgsl, writers_take};
use lobe_codegen::kernels;
use lobe_codegen::prelude::*;

/// What a pass needs.
#[kernel]
struct Settings {
    /// Factor.
    factor: f32,
    /// Direction.
    axis: Vec3,
}

#[kernel(workgroup_size(64))]
fn scale(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] settings: &Settings,
    #[storage(0, 1)] given: &[f32],
    #[storage(0, 2)] found: &mut [f32],
) {
    let i = id.x;
    if i >= given.len() as u32 {
        return;
    }
    found[i as usize] = settings.factor * given[i as usize] + settings.axis.x;
}

#[kernel(workgroup_size(8, 8))]
fn count(
    #[builtin(local_invocation_index)] index: u32,
    #[builtin(workgroup_id)] group: UVec3,
    #[storage(0, 0)] cells: &[AtomicU32],
    #[storage(0, 1)] total: &mut u32,
    #[workgroup] tile: &mut [u32; 64],
) {
    tile[index as usize] = index + group.x;
    workgroup_barrier();
    let former = atomic_add(&cells[(index % 4) as usize], tile[(63 - index) as usize]);
    atomic_max(&cells[5], former);
    atomic_store(&cells[6], atomic_load(&cells[7]));
    storage_barrier();
    if index == 0 {
        *total = former;
    }
}

#[test]
fn an_entry_point_stays_a_rust_function() {
    let mut out = [0.0; 2];
    let settings = Settings { factor: 3.0, axis: Vec3::X };
    scale(UVec3::new(1, 0, 0), &settings, &[1.0, 2.0], &mut out);
    scale(UVec3::new(2, 0, 0), &settings, &[1.0, 2.0], &mut out);
    assert_eq!(out, [0.0, 7.0]);
}

#[test]
fn entry_points_go_through_every_writer() {
    writers_take(&lowered(&kernels![scale]));
    let module = lowered(&kernels![count, count]);
    writers_take(&module);
    assert_eq!(module.module().entry_points.len(), 1);
    assert_eq!(module.module().entry_points[0].workgroup_size, [8, 8, 1]);
    let text = wgsl(&module);
    assert!(text.contains("var<storage, read_write> cells: array<atomic<u32>>"), "{text}");
    assert!(text.contains("workgroupBarrier()"), "{text}");
}

#[kernel(workgroup_size(1))]
fn wrong_builtin(#[builtin(global_invocation_id)] id: u32, #[storage(0, 0)] found: &mut [u32]) {
    found[0] = id;
}

#[kernel]
fn calls_an_entry_point(x: f32) -> f32 {
    lonely();
    x
}

#[kernel(workgroup_size(1))]
fn lonely() {}

#[kernel(workgroup_size(1))]
fn one_found(#[storage(0, 0)] found: &mut [f32]) {
    found[0] = 1.0;
}

#[kernel(workgroup_size(1))]
fn same_found(#[storage(0, 0)] found: &mut [f32]) {
    found[0] = 1.0;
}

#[kernel(workgroup_size(1))]
fn other_found(#[storage(0, 1)] found: &mut [u32]) {
    found[0] = 1;
}

#[test]
fn entry_points_share_a_binding_or_clash() {
    let module = lowered(&kernels![one_found, same_found]);
    assert_eq!(module.module().global_variables.len(), 1);
    let message = lobe_codegen::lower(&kernels![one_found, other_found]).unwrap_err().to_string();
    assert!(message.contains("two items of one module are called `found`"), "{message}");
}

#[test]
fn mistakes_of_entry_points_are_shown() {
    let message = refusal(kernels![wrong_builtin][0]);
    assert!(message.contains("`global_invocation_id` is a UVec3, this parameter a u32"), "{message}");
    assert!(message.contains("id: u32"), "{message}");
    assert!(refusal(kernels![calls_an_entry_point][0]).contains("`lonely` is an entry point"));
}
