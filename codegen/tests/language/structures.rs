//! Structures and arrays.

use crate::check::agrees;
use lobe_codegen::kernels;
use lobe_codegen::prelude::*;

/// A lobe.
#[kernel]
struct Lobe {
    /// Axis.
    axis: Vec3,
    /// Sharpness.
    sharpness: f32,
}

/// Two of them, and weights.
#[kernel]
struct Bundle {
    /// Lobes.
    lobes: [Lobe; 2],
    /// Weights.
    weights: [f32; 3],
    /// Frame.
    frame: Mat3,
    /// How many count.
    count: u32,
}

#[kernel]
fn build(axis: Vec3, sharpness: f32) -> Lobe {
    Lobe { sharpness, axis: axis * 2.0 }
}

#[kernel]
fn reads(b: Bundle, i: u32) -> f32 {
    let i = (i % 2) as usize;
    let lobe = b.lobes[i];
    lobe.axis.y + b.lobes[1 - i].sharpness + b.weights[i] + b.weights[2] + b.frame.y_axis.z + b.count as f32
}

#[kernel]
fn writes(b: Bundle, i: u32, x: f32) -> Bundle {
    let mut b = b;
    b.lobes[(i % 2) as usize].axis.x = x;
    b.lobes[0].sharpness *= 2.0;
    b.weights[(i % 3) as usize] += x;
    b.frame.x_axis.y -= 1.0;
    b.frame.z_axis = Vec3::splat(x);
    b.count += 1;
    let first = b.lobes[0];
    b.lobes = [first; 2];
    Bundle { count: b.count + i, ..b }
}

#[kernel]
fn mutable_parameter(mut lobe: Lobe, mut w: [f32; 2]) -> f32 {
    lobe.axis += Vec3::Y;
    w[1] = lobe.axis.y;
    w[0] + w[1]
}

#[kernel]
fn nested_arrays(n: u32) -> f32 {
    let mut grid = [[0.0; 3]; 2];
    for i in 0..2 {
        for j in 0..3 {
            grid[i][j] = (i * 3 + j) as f32;
        }
    }
    let row = grid[(n % 2) as usize];
    grid[1][(n % 3) as usize] = -1.0;
    row[(n % 3) as usize] + grid[1][2] + row.len() as f32 + grid.len() as f32
}

#[kernel]
fn table(n: u32) -> i32 {
    let small = [1, -2, 3];
    let unsigned = [7u32, 8];
    small[(n % 3) as usize] + unsigned[(n & 1) as usize] as i32 + [5, 6][(n & 1) as usize]
}

#[kernel]
fn array_from_call(x: f32, n: u32) -> f32 {
    triple(x)[(n % 3) as usize] + triple(x)[1]
}

#[kernel]
fn triple(x: f32) -> [f32; 3] {
    [x, x * 2.0, x * 3.0]
}

#[kernel]
fn chosen_array(n: u32) -> f32 {
    let a = if n > 3 { [1.0, 2.0] } else { [3.0, 4.0] };
    a[(n & 1) as usize]
}

#[test]
fn structures_and_arrays_hold_what_rust_holds() {
    agrees(kernels![build][0]);
    agrees(kernels![reads][0]);
    agrees(kernels![writes][0]);
    agrees(kernels![mutable_parameter][0]);
    agrees(kernels![nested_arrays][0]);
    agrees(kernels![table][0]);
    agrees(kernels![array_from_call][0]);
    agrees(kernels![chosen_array][0]);
}
