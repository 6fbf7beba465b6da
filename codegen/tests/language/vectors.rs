//! Vectors, matrices, swizzles.

use crate::check::agrees;
use lobe_codegen::kernels;
use lobe_codegen::prelude::*;

#[kernel]
fn arithmetic(v: Vec3, w: Vec3, s: f32) -> Vec3 {
    (v + w) * s - 2.0 * v / (w + 1.0) + (3.0 - v) * w - 1.0 / w + -v
}

#[kernel]
fn compound(v: Vec3, s: f32) -> Vec3 {
    let mut v = v;
    v += Vec3::ONE;
    v *= s;
    v -= Vec3::splat(s);
    v /= 2.0;
    v.x = v.y + 1.0;
    v.z *= 3.0;
    v[1] += 1.0;
    v
}

#[kernel]
fn swizzles(v: Vec4, w: Vec2) -> Vec4 {
    let a = v.xyz().zyx();
    let b = w.xxyy() + v.wzyx();
    a.extend(w.y) + b + w.extend(1.0).extend(v.x) + v.xy().extend(v.truncate().truncate().x).extend(2.0)
}

#[kernel]
fn component(v: Vec4, n: u32) -> f32 {
    v[(n % 4) as usize] + v[2]
}

#[kernel]
fn equality(v: Vec3, w: Vec3) -> bool {
    v == w || v.xy() != w.xy() && v == Vec3::new(1.0, w.y, w.z)
}

#[kernel]
fn by_component(v: Vec3, w: Vec3) -> u32 {
    let less = v.cmplt(w);
    let mut n = 0u32;
    if any(less) {
        n += 1;
    }
    if all(v.cmpge(w)) {
        n += 2;
    }
    if all(!v.cmpeq(w)) {
        n += 4;
    }
    n
}

#[kernel]
fn geometry(v: Vec3, w: Vec3) -> f32 {
    v.dot(w)
        + v.length_squared()
        + v.cross(w).y
        + dot(v, w)
        + cross(v, w).x
        + v.abs().z
        + length(v)
        + v.length()
}

#[kernel]
fn integers(v: IVec3, w: UVec3, n: u32) -> IVec3 {
    let u = w * 3 + n;
    let s = v << (n & 3) as i32;
    s + v * 2 - IVec3::new(u.x as i32, (u.y & 3) as i32, (u.z >> 1) as i32)
}

#[kernel]
fn matrices(m: Mat3, v: Vec3) -> Vec3 {
    let n = m * Mat3::IDENTITY + m * 2.0;
    let k = Mat3::from_cols(v, Vec3::Y, n.z_axis);
    (n * v) + k * Vec3::X
}

#[kernel]
fn chosen(v: Vec3, w: Vec3, p: bool) -> Vec3 {
    select(v, w, p) + if p { v } else { w }
}

#[test]
fn vectors_compute_what_glam_computes() {
    agrees(kernels![arithmetic][0]);
    agrees(kernels![compound][0]);
    agrees(kernels![swizzles][0]);
    agrees(kernels![component][0]);
    agrees(kernels![equality][0]);
    agrees(kernels![by_component][0]);
    agrees(kernels![geometry][0]);
    agrees(kernels![integers][0]);
    agrees(kernels![chosen][0]);
}

/// The evaluator has no matrix product; the writers and the validator have.
#[test]
fn matrices_are_taken_by_every_writer() {
    crate::check::writers_take(&crate::check::lowered(&kernels![matrices]));
}
