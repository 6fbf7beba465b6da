//! Parameters of entry points.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel(workgroup_size(64))]
fn unbound(x: f32) {}

#[kernel(workgroup_size(64))]
fn returns(#[builtin(global_invocation_id)] id: UVec3) -> f32 {
    id.x as f32
}

#[kernel(workgroup_size(64))]
fn builtins(#[builtin(vertex_index)] a: u32, #[builtin(workgroup_id)] b: &UVec3) {}

#[kernel(workgroup_size(64))]
fn memory(
    #[storage(0, 0)] a: f32,
    #[uniform(0, 1)] b: &mut Vec4,
    #[workgroup] c: &[f32; 4],
    #[storage(0)] d: &[f32],
    #[storage(first, second)] e: &[f32],
    #[storage(0, 4)] #[uniform(0, 5)] f: &Vec4,
) {
}

#[kernel]
fn plain(#[storage(0, 0)] a: &[f32]) -> f32 {
    a[0]
}

fn main() {}
