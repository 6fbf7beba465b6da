//! The macro's expansion compiles, stays callable, and writes down what was written.
use lobe_codegen::prelude::*;

/// A lobe.
#[kernel]
pub struct Sg {
    /// Axis.
    #[domain(unit)]
    pub axis: Vec3,
    /// Sharpness.
    #[domain(0.0..=1e6)]
    pub sharpness: f32,
}

/// Half.
#[kernel]
pub const HALF_OF_IT: f32 = 0.5;

/// Evaluates.
#[kernel(family = "sg", domain(dir = unit), budget(1e-6 * result), truth = no)]
pub fn evaluate(dir: Vec3, sg: Sg) -> f32 {
    let d = dir - sg.axis;
    let mut sum = 0.0;
    for i in 0..3 {
        if i == 1 {
            continue;
        }
        sum += i as f32;
    }
    exp(-sg.sharpness * HALF_OF_IT * dot(d, d)) + sum * 0.0
}
fn no(x: f64, _: f64) -> f64 {
    x
}

#[kernel]
fn pick(n: u32) -> f32 {
    match n {
        0 | 1 => 1.0,
        2 => {
            let x = evaluate(Vec3::X, Sg { axis: Vec3::Z, sharpness: 1.0 });
            x
        }
        _ => -1.0,
    }
}

#[kernel(workgroup_size(64))]
fn scale(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] input: &[f32],
    #[storage(0, 1)] output: &mut [f32],
) {
    if id.x < input.len() as u32 {
        output[id.x as usize] = 2.0 * input[id.x as usize];
    }
}

#[test]
fn expands() {
    assert!(pick(2) > 0.0);
    let mut out = [0.0; 2];
    scale(UVec3::new(1, 0, 0), &[1.0, 2.0], &mut out);
    assert_eq!(out, [0.0, 4.0]);
    let m = lobe_codegen::lower(&lobe_codegen::kernels![pick, scale, mixed, hard])
        .unwrap_or_else(|e| panic!("{e}"));
    let text =
        naga::back::wgsl::write_string(m.module(), m.info(), naga::back::wgsl::WriterFlags::empty()).unwrap();
    println!("{text}");
    let e = lobe_codegen::lower(&lobe_codegen::kernels![wrong]).unwrap_err();
    println!("{e}");
}

#[kernel]
fn wrong(v: Vec3, n: u32) -> f32 {
    let two = 2;
    let k = n + two;
    if v.x > 1.0 && k > 2 {
        return select(v.x, v.y, v.x < dot(v, Vec3::X));
    }
    1.0
}

#[kernel]
fn mixed(v: Vec3, n: u32) -> Vec3 {
    let w = v / 2.0 + 3.0 * v - 1.0;
    let mut a = [1.0, 2.0, 3.0];
    a[1] *= 2.0;
    a[(n % 3) as usize] += w.x;
    let b = Sg { sharpness: 2.0 * 3.0, axis: w };
    let t = if n > 3 && a[n as usize] > 0.0 {
        b.sharpness
    } else {
        let q = v.y;
        q * q
    };
    if v == Vec3::ZERO || !(t < 1.0) {
        return Vec3::splat(t);
    }
    let x = x_of(v);
    let x = x + 1.0;
    Vec3::new(x, a[1], t) * f32::from_bits(x.to_bits() & 0x7fffffff)
}

#[kernel]
fn x_of(v: Vec3) -> f32 {
    v.x
}

#[kernel]
fn hard(n: i32) -> i32 {
    let mut total = 0;
    for i in 0..=n {
        match i {
            3 => continue,
            5 | 6 => break,
            _ => {
                total += i;
            }
        }
        let mut j = 0;
        while j < i {
            j += 1;
            if j == 7 {
                return total;
            }
        }
    }
    total
}
