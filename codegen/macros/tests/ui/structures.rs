//! Structures have named fields with a layout.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
struct Flags {
    visible: bool,
    mask: BVec3,
    many: [bool; 4],
}

#[kernel]
struct Empty {}

#[kernel]
struct Unit;

fn main() {}
