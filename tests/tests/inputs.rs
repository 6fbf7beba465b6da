//! Inputs lie in their domain, cover its edges, and are the same for the same seed.

use lobe_codegen::data::Columns;
use lobe_codegen::def::{FunctionDef, FunctionRef};
use lobe_codegen::prelude::*;
use lobe_tests::domain::{Family, Inputs, slots};

/// Takes two directions and some numbers.
#[kernel(domain(a = unit, b = unit, k = 0.0..=1e6, s = -2.0..=3.0, n = 0.0..=5.0, c = [1.0, 2.0, 4.0]))]
fn many(a: Vec3, b: Vec3, k: f32, s: f32, n: i32, c: f32, on: bool) -> f32 {
    dot(a, b) * k + s + n as f32 + select(c, 0.0, on)
}

/// A lobe's frame, and a direction.
#[kernel(domain(z = unit, x = normal_to(z), y = cross(z, x), dir = unit))]
fn framed(z: Vec3, x: Vec3, y: Vec3, dir: Vec3) -> f32 {
    dot(z, dir) + dot(x, dir) + dot(y, dir)
}

/// In relation to what comes later.
#[kernel(domain(x = normal_to(z), z = unit))]
fn too_early(x: Vec3, z: Vec3) -> f32 {
    dot(x, z)
}

/// One number.
#[kernel(domain(x = 0.1..=0.3))]
fn narrow(x: f32) -> f32 {
    x
}

/// A domain for what is no argument.
#[kernel(domain(x = 0.0..=1.0, x.y = 0.0..=1.0))]
fn stray(x: f32) -> f32 {
    x
}

/// An empty domain.
#[kernel(domain(x = 1.0..=0.0))]
fn empty(x: f32) -> f32 {
    x
}

/// Out of the integers.
#[kernel(domain(n = -1.0..=5.0))]
fn negative(n: u32) -> f32 {
    n as f32
}

const KERNELS: [FunctionRef; 7] =
    lobe_codegen::kernels![many, framed, too_early, narrow, stray, empty, negative];

fn def(name: &str) -> &'static FunctionDef {
    KERNELS.into_iter().map(|k| k()).find(|d| d.name == name).expect("one of the above")
}

fn draw(name: &str, n: usize, seed: u64) -> Inputs {
    let width = if name == "many" { 11 } else { 1 };
    Inputs::draw(def(name), n, seed, &Columns::zeros(width, 0)).expect("a sound domain")
}

fn floats(inputs: &Inputs, column: usize) -> impl Iterator<Item = f32> + '_ {
    inputs.args.columns[column].iter().map(|w| f32::from_bits(*w))
}

#[test]
fn the_same_seed_draws_the_same_rows() {
    assert_eq!(draw("many", 2000, 7), draw("many", 2000, 7));
    assert_ne!(draw("many", 2000, 7).args, draw("many", 2000, 8).args);
}

#[test]
fn every_value_lies_in_its_domain() {
    let inputs = draw("many", 4000, 7);
    assert!(floats(&inputs, 6).all(|k| (0.0..=1e6).contains(&k)));
    assert!(floats(&inputs, 7).all(|s| (-2.0..=3.0).contains(&s)));
    assert!(inputs.args.columns[8].iter().all(|n| *n <= 5));
    assert!(floats(&inputs, 9).all(|c| [1.0, 2.0, 4.0].contains(&c)));
    assert!(inputs.args.columns[10].iter().all(|on| *on <= 1));
    let narrow = draw("narrow", 4000, 7);
    assert!(floats(&narrow, 0).all(|x| (0.1f32..=0.3f32).contains(&x)));
}

#[test]
fn unit_vectors_have_length_one_and_meet() {
    let inputs = draw("many", 4000, 7);
    let (mut same, mut opposite, mut near, mut apart) = (0, 0, 0, 0);
    for row in 0..4000 {
        let v = |at: usize| {
            Vec3::from_array(std::array::from_fn(|i| f32::from_bits(inputs.args.columns[at + i][row])))
        };
        let (a, b) = (v(0), v(3));
        assert!((a.length_squared() - 1.0).abs() < 5e-7 && (b.length_squared() - 1.0).abs() < 5e-7);
        same += usize::from(a == b);
        opposite += usize::from(a == -b);
        near += usize::from(a != b && (a - b).length() < 1e-3);
        apart += usize::from(dot(a, b).abs() < 0.5);
    }
    assert!(same > 5 && opposite > 5 && near > 100 && apart > 500, "{same} {opposite} {near} {apart}");
}

#[test]
fn frames_are_orthonormal_and_right_handed() {
    let inputs = Inputs::draw(def("framed"), 4000, 7, &Columns::zeros(12, 0)).expect("a sound domain");
    let mut along = 0;
    for row in 0..4000 {
        let v = |at: usize| {
            Vec3::from_array(std::array::from_fn(|i| f32::from_bits(inputs.args.columns[at + i][row])))
        };
        let (z, x, y, dir) = (v(0), v(3), v(6), v(9));
        assert!(dot(z, x).abs() < 2e-7 && (x.length_squared() - 1.0).abs() < 5e-7, "row {row}: {z} {x}");
        assert!((cross(z, x) - y).length() < 5e-7, "row {row}: {z} {x} {y}");
        along += usize::from((dir - z).length() < 1e-3);
    }
    assert!(along > 50, "{along}");
}

#[test]
fn ends_zeros_and_subnormals_are_among_the_edges() {
    let inputs = draw("many", 4000, 7);
    let has = |wanted: f32| floats(&inputs, 6).any(|k| k.to_bits() == wanted.to_bits());
    for wanted in [0.0, 1e6, 1.0, f32::MIN_POSITIVE, f32::from_bits(1)] {
        assert!(has(wanted), "{wanted:e}");
    }
    assert!(floats(&inputs, 6).any(|k| k > 0.0 && k < 1e-20), "small magnitudes are drawn too");
}

#[test]
fn families_stand_in_order_and_listed_rows_come_first() {
    let listed = Columns::from_rows(1, &[vec![0.2f32.to_bits()]]);
    let inputs = Inputs::draw(def("narrow"), 100, 7, &listed).expect("a sound domain");
    assert_eq!(inputs.args.rows, 101);
    assert_eq!(inputs.family(0), Family::Listed);
    assert_eq!(inputs.family(1), Family::Edge);
    assert_eq!(inputs.family(100), Family::Random);
    assert_eq!(inputs.families.iter().map(|(_, n)| n).sum::<usize>(), 101);
}

#[test]
fn what_cannot_be_drawn_is_named() {
    for (name, part) in [
        ("too_early", "the domain of `x` speaks of `z`, which is no unit vector that is declared before"),
        ("stray", "stated for `x.y`, which is none of its arguments"),
        ("empty", "`x` is 1.0..=0.0, which is no range of f32"),
        ("negative", "`n` is -1.0..=5.0, which is no range of u32"),
    ] {
        let message = slots(def(name)).expect_err(name).to_string();
        assert!(message.contains(part), "{message}");
    }
}
