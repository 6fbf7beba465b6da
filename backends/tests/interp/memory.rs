//! Structures, arrays, vectors and matrices, by value and behind pointers.

use crate::support::{call, columns, floats, word};

#[test]
fn structures_and_arrays_travel_as_their_scalars() {
    let text = "struct S { a: vec2<u32>, b: array<u32, 3>, c: bool }
        fn f(s: S, i: u32) -> S {
            var t = s;
            t.b[i] = s.a.y + t.b[2];
            t.a = t.a.yx;
            t.c = !t.c;
            return t;
        }";
    let args: Vec<Vec<u32>> = [1, 2, 3, 4, 5, 1, 1].into_iter().map(|w| vec![w]).collect();
    assert_eq!(call(text, &columns(&args)).row(0), [2, 1, 3, 7, 5, 0]);
}

#[test]
fn indices_differ_from_lane_to_lane() {
    let text = "fn f(i: u32, j: u32) -> u32 {
        var a = array<array<u32, 3>, 2>(array(1u, 2u, 3u), array(4u, 5u, 6u));
        a[i][j] += 10u;
        let whole = a[i];
        return whole[j] * 100u + a[1u - i][j];
    }";
    let got = call(text, &columns(&[vec![0, 1, 1], vec![0, 2, 1]]));
    assert_eq!(got.columns[0], [1104, 1603, 1502]);
}

#[test]
fn indices_out_of_bounds_are_clamped_for_reads_and_writes() {
    let text = "fn f(i: i32, v: vec3<u32>) -> u32 {
        var a = array<u32, 4>(1u, 2u, 3u, 4u);
        a[i] += 10u;
        let b = array<u32, 2>(5u, 6u);
        return a[3] * 100u + b[i] * 10u + v[i];
    }";
    assert_eq!(word(text, &[7, 1, 2, 3]), 1463);
    assert_eq!(word(text, &[-1_i32 as u32, 1, 2, 3]), 1463);
    assert_eq!(word(text, &[0, 1, 2, 3]), 451);
}

#[test]
fn components_and_columns_are_places() {
    let text = "fn f(i: u32, x: f32) -> vec3<f32> {
        var m = mat3x3<f32>(vec3(1.0, 2.0, 3.0), vec3(4.0, 5.0, 6.0), vec3(7.0, 8.0, 9.0));
        m[i][1] = x;
        m[0].z = 0.5;
        var v = m[i];
        v[i] += 1.0;
        return v;
    }";
    let got = call(text, &columns(&[vec![2, 0], vec![20.0_f32.to_bits(), 30.0_f32.to_bits()]]));
    assert_eq!(got.row(0).iter().map(|w| f32::from_bits(*w)).collect::<Vec<_>>(), [7.0, 20.0, 10.0]);
    assert_eq!(got.row(1).iter().map(|w| f32::from_bits(*w)).collect::<Vec<_>>(), [2.0, 30.0, 0.5]);
}

#[test]
fn a_matrix_can_be_indexed_by_value() {
    let text = "fn f(m: mat2x3<f32>, i: u32) -> f32 { let n = m * 2.0; return n[i].y + n[1][i]; }";
    let mut args = floats(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0].map(|x: f32| vec![x, x]));
    args.columns.push(vec![0, 9]);
    let got = call(text, &args);
    assert_eq!(got.columns[0].iter().map(|w| f32::from_bits(*w)).collect::<Vec<_>>(), [12.0, 22.0]);
}

#[test]
fn constants_are_composed_once_and_reach_every_lane() {
    let text = "const A = array<vec2<f32>, 2>(vec2(1.0, 2.0), vec2<f32>(3.0));
        const B = 2u;
        fn f(i: u32) -> f32 { var a = A; return a[i].x + f32(B) + vec3<f32>().z; }";
    let got = call(text, &columns(&[vec![0, 1]]));
    assert_eq!(got.columns[0], [3.0_f32.to_bits(), 5.0_f32.to_bits()]);
}
