//! Bounds of what entry points leave in buffers: drivers drawn by chance stay within them.

use crate::chance;
use crate::dispatch::{buffer, words};
use crate::support::{Chance, foreign};
use lobe_backends::interp::{Buffer, Interpreter, ShadowWord};

const DRIVERS: u64 = 12;

/// The words that a program may leave; those of `run` and of chance drivers are among them.
fn shadow(text: &str, groups: u32, buffers: &[Buffer]) -> Vec<Vec<ShadowWord>> {
    let module = foreign(text);
    let interpreter = Interpreter::new(&module).unwrap();
    let shadow = interpreter.shadow_run(0, [groups, 1, 1], &mut buffers.to_vec()).unwrap().buffers;
    for driver in 0..=DRIVERS {
        let mut left = buffers.to_vec();
        match driver {
            0 => interpreter.run(0, [groups, 1, 1], &mut left).unwrap(),
            seed => interpreter.perturbed_run(0, [groups, 1, 1], &mut left, seed).unwrap(),
        }
        for buffer in &shadow {
            let left = left.iter().find(|b| b.binding == buffer.binding).unwrap();
            for (at, (word, shadow)) in words(left).into_iter().zip(&buffer.words).enumerate() {
                within(driver, word, shadow, || format!("driver {driver}, word {at}\n{text}"));
            }
        }
    }
    shadow.into_iter().map(|b| b.words).collect()
}

fn within(driver: u64, word: u32, shadow: &ShadowWord, place: impl Fn() -> String) {
    match *shadow {
        ShadowWord::Float { value, exact, bound } => {
            let left = f32::from_bits(word);
            assert!(
                driver > 0 || value == left || value.is_nan() && left.is_nan(),
                "{value} {left}: {}",
                place()
            );
            let near = (f64::from(left) - exact).abs() <= bound || bound.is_infinite();
            assert!(near, "{left}, not {exact} +- {bound:e}: {}", place());
        }
        ShadowWord::Word { value, known } => {
            assert!(driver > 0 || value == word, "{value} {word}: {}", place());
            assert!(!known || value == word, "{word}, not {value}: {}", place());
        }
    }
}

fn entry(body: &str) -> String {
    format!(
        "@group(0) @binding(0) var<storage, read> a: array<f32>;
        @group(0) @binding(1) var<storage, read_write> b: array<f32>;
        @group(0) @binding(2) var<storage, read_write> n: array<atomic<u32>>;
        var<workgroup> w: array<f32, 4>;
        @compute @workgroup_size(4)
        fn main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) l: u32) {{
            let i = id.x;
            {body}
            if i == 0u {{ atomicStore(&n[7], 5u); }}
        }}"
    )
}

fn run(body: &str) -> (Vec<ShadowWord>, Vec<ShadowWord>) {
    let inputs = [0.25_f32, 0.5, 1.1, 1.3, 2.0, 2.2, 3.0, 4.5].map(f32::to_bits);
    let buffers = [buffer(0, &inputs), buffer(1, &[0; 8]), buffer(2, &[0; 8])];
    let mut left = shadow(&entry(body), 2, &buffers).into_iter();
    (left.next().unwrap(), left.next().unwrap())
}

fn bound(word: &ShadowWord) -> f64 {
    match word {
        ShadowWord::Float { bound, .. } => *bound,
        ShadowWord::Word { .. } => panic!("an integer"),
    }
}

#[test]
fn floats_have_bounds_and_integers_are_known() {
    let (b, n) = run("b[i] = exp(a[i]) * 1.1;");
    assert!(b.iter().all(|w| bound(w) > 0.0 && bound(w) < 1e-3), "{b:?}");
    assert_eq!(n[7], ShadowWord::Word { value: 5, known: true });
    assert_eq!(n[3], ShadowWord::Word { value: 0, known: true });
}

#[test]
fn words_that_nothing_is_written_to_stay_bits() {
    let (b, _) = run("if i < 3u { b[i] = a[i]; }");
    assert_eq!(b[5], ShadowWord::Word { value: 0, known: true });
    assert_eq!(b[1], ShadowWord::Float { value: 0.5, exact: 0.5, bound: 0.0 });
}

#[test]
fn bounds_travel_through_workgroup_memory() {
    let (b, _) = run("w[l] = exp(a[i]);
        workgroupBarrier();
        if l < 2u { w[l] += w[l + 2u]; }
        workgroupBarrier();
        if l == 0u { w[0] += w[1]; }
        workgroupBarrier();
        b[i] = w[0] * a[i];");
    assert!(b.iter().all(|w| bound(w) > 0.0 && bound(w) < 1e-2), "{b:?}");
}

#[test]
fn bounds_travel_from_workgroup_to_workgroup() {
    let (b, _) = run("if i == 0u { b[0] = exp(a[0]); } if i == 4u { b[1] = b[0] - 1.0; }");
    assert!(bound(&b[1]) >= bound(&b[0]), "{b:?}");
}

#[test]
fn a_store_that_may_not_happen_joins_what_was_there() {
    // Of the fourth number no driver is sure.
    let (b, _) = run("b[i] = 2.0; if a[i] * 1.1 / 1.0 < 1.43 { b[i] = 5.0; }");
    assert_eq!((bound(&b[0]), bound(&b[3]), bound(&b[7])), (0.0, 3.0, 0.0));
}

#[test]
fn a_loop_that_may_end_sooner_is_joined() {
    let (b, _) = run("var x = 0.0; loop { if x >= 0.3 { break; } x += 0.1; } b[i] = x;");
    assert!(b.iter().all(|w| bound(w) > 0.05 && bound(w) < 0.11), "{b:?}");
}

#[test]
fn a_place_that_is_not_known_spoils_the_buffer() {
    let (b, n) = run("b[u32(a[i] * 1.1 / 1.43)] = 1.0;");
    assert!(b.iter().all(|w| match w {
        ShadowWord::Float { bound, .. } => bound.is_infinite(),
        ShadowWord::Word { known, .. } => !known,
    }));
    assert_eq!(n[7], ShadowWord::Word { value: 5, known: true });
}

#[test]
fn what_depends_on_the_order_of_invocations_is_not_known() {
    let (b, n) = run(
        "let old = atomicAdd(&n[0], 3u); b[i] = f32(old); atomicMax(&n[1], i); atomicExchange(&n[2], i);",
    );
    assert_eq!(n[0], ShadowWord::Word { value: 24, known: true });
    assert_eq!(n[1], ShadowWord::Word { value: 7, known: true });
    assert!(matches!(n[2], ShadowWord::Word { known: false, .. }));
    assert!(b.iter().all(|w| bound(w).is_infinite()));
}

#[test]
fn an_endless_loop_makes_what_may_be_written_unknown() {
    let module = foreign(&entry("if i == 0u { loop { if a[0] > 1.0 { break; } } b[0] = 1.0; }"));
    let mut buffers = [buffer(0, &[0; 8]), buffer(1, &[0; 8]), buffer(2, &[0; 8])];
    let interpreter = Interpreter::new(&module).unwrap().with_fuel(1000);
    let left = interpreter.shadow_run(0, [1, 1, 1], &mut buffers).unwrap().buffers;
    assert!(matches!(left[0].words[5], ShadowWord::Word { known: false, .. }));
}

#[test]
fn chance_programs_run_as_entry_points() {
    let mut writer = chance::writer();
    let mut bounded = 0;
    for _ in 0..60 {
        let text = chance::program(&mut writer, "var a = y * 1.1; var b = 2.0 * 1.1; var c = 3.3 / 3.0;")
            + "@group(0) @binding(0) var<storage, read> xs: array<f32>;
            @group(0) @binding(1) var<storage, read_write> out: array<vec4<f32>>;
            @compute @workgroup_size(8)
            fn main(@builtin(global_invocation_id) id: vec3<u32>) { out[id.x] = f(id.x % 9u, xs[id.x]); }";
        let floats = few(&mut writer.chance);
        let left = shadow(&text, 2, &[buffer(0, &floats), buffer(1, &[0; 64])]);
        bounded += left[0].iter().filter(|w| bound(w).is_finite()).count();
    }
    println!("{bounded} words bounded");
    assert!(bounded > 60 * 64 / 2);
}

fn few(chance: &mut Chance) -> Vec<u32> {
    const FEW: [f32; 6] = [0.5, 1.0, 1.1, 2.0, 2.2, 3.0];
    (0..16).map(|_| FEW[chance.below(6)].to_bits()).collect()
}

#[test]
fn what_is_gathered_has_the_bound_of_where_it_comes_from() {
    let (b, _) = run("let x = exp(a[i]); b[i] = subgroupShuffleXor(x, 1u);");
    let (plain, _) = run("b[i] = exp(a[i]);");
    for at in 0..8 {
        assert_eq!(bound(&b[at]), bound(&plain[at ^ 1]), "{at}");
    }
}

#[test]
fn sums_of_subgroups_are_bounded_in_every_order() {
    for body in [
        "b[i] = subgroupAdd(exp(a[i]));",
        "b[i] = subgroupMul(a[i]);",
        "b[i] = subgroupInclusiveAdd(a[i]);",
        "b[i] = subgroupMax(exp(a[i]));",
        "if (l & 1u) == 0u { b[i] = subgroupAdd(a[i]); } else { b[i] = subgroupMul(a[i]); }",
    ] {
        let (b, _) = run(body);
        assert!(b.iter().all(|w| bound(w) > 0.0 && bound(w) < 1e-2), "{body}: {b:?}");
    }
}

#[test]
fn integers_of_subgroups_are_known() {
    let (_, n) = run("b[i] = 0.0; let sum = subgroupAdd(i + 1u); if l == 0u { atomicAdd(&n[0], sum); }");
    assert_eq!(n[0], ShadowWord::Word { value: 36, known: true });
}

#[test]
fn a_subgroup_whose_lanes_are_not_certain_promises_nothing() {
    // Of the fourth number no driver is sure; the second workgroup knows nothing of that.
    for (exchange, of_gather) in [
        ("subgroupAdd(1.5)", false),
        ("subgroupBroadcastFirst(a[i])", false),
        ("subgroupShuffle(a[i], u32(a[3] * 1.1 / 1.43))", true),
    ] {
        let body = match of_gather {
            true => format!("b[i] = {exchange};"),
            false => format!("if a[i] * 1.1 / 1.0 < 1.43 {{ b[i] = {exchange}; }}"),
        };
        let (b, _) = run(&body);
        assert!(bound(&b[0]).is_infinite(), "{body}: {b:?}");
    }
}
