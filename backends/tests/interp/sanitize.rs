//! Each kind of mistake is found at its line, and its clean twin has none.

use crate::dispatch::buffer;
use crate::support::{floats, module};
use lobe_backends::interp::{Checks, Fault, Finding, Interpreter, Invocation};

const EVERYTHING: Checks = Checks { unwritten: true, limit: 100 };

/// Findings of an entry point of four invocations whose body begins in line 8, over two workgroups.
fn findings(body: &str) -> Vec<(Fault, u32)> {
    let text = format!(
        "@group(0) @binding(0) var<storage, read_write> b: array<u32, 8>;
@group(0) @binding(1) var<storage, read_write> count: atomic<u32>;
var<workgroup> w: array<u32, 4>;
var<private> p: u32;
@compute @workgroup_size(4)
fn main(@builtin(local_invocation_index) i: u32, @builtin(global_invocation_id) id: vec3<u32>) {{
let g = id.x;
{body}
}}"
    );
    let module = module(&text);
    let interpreter = Interpreter::new(&module).unwrap().with_fuel(1000);
    let mut buffers = [buffer(0, &[0; 8]), buffer(1, &[0])];
    let found = interpreter.sanitize(0, [2, 1, 1], &mut buffers, EVERYTHING).unwrap();
    println!("{found:#?}");
    let line = |f: &Finding| f.line(&text).map_or(0, |(line, _)| line);
    found.iter().map(|f| (f.kind, line(f))).collect()
}

/// `faulty` has a mistake of this kind in this line, and nothing else; `clean` has none.
fn check(kind: Fault, line: u32, faulty: &str, clean: &str) {
    assert_eq!(findings(faulty), [(kind, line)], "{faulty}");
    assert_eq!(findings(clean), [], "{clean}");
}

#[test]
fn an_index_beyond_the_end_is_found() {
    let kind = Fault::OutOfBounds;
    check(kind, 9, "let at = i + 2u;\nlet x = w[at];\nb[g] = 1u;", "let at = i;\nb[g] = 1u;");
    let text = |at: &str| format!("var t = array<u32, 4>(1u, 2u, 3u, 4u);\nb[g] = t[{at}];");
    check(kind, 9, &text("i32(i) - 1"), &text("i32(i)"));
    // Of a value, which is chosen by comparing, and where the index is known after all.
    let text = |at: &str| format!("let v = vec4u(i) + 1u;\nb[g] = v[{at}];");
    check(kind, 9, &text("i + 1u"), &text("i"));
    let text = |at: &str| format!("var n = {at};\nn += 1u;\nb[n] = g;");
    check(kind, 10, &format!("if g == 0u {{ {} }}", text("7u")), &format!("if g == 0u {{ {} }}", text("6u")));
}

/// A known index is as far out as one that is computed, where the buffer says how long the array is.
#[test]
fn a_known_index_beyond_a_runtime_array_is_found() {
    let found = |index: u32| {
        let module = module(&format!(
            "struct Items {{ count: u32, items: array<array<u32, 2>> }}
            @group(0) @binding(0) var<storage, read_write> all: Items;
            @compute @workgroup_size(1) fn main() {{ all.items[{index}][1] = all.count; }}"
        ));
        let mut buffers = [buffer(0, &[0; 7])];
        let interpreter = Interpreter::new(&module).unwrap();
        let found = interpreter.sanitize(0, [1; 3], &mut buffers, EVERYTHING).unwrap();
        found.iter().map(|f| f.kind).collect::<Vec<_>>()
    };
    assert_eq!(found(2), []);
    assert_eq!(found(3), [Fault::OutOfBounds]);
    assert_eq!(found(100_000), [Fault::OutOfBounds]);
}

#[test]
fn races_within_a_workgroup_are_found() {
    let kind = Fault::Race;
    check(kind, 8, "w[0] = i;", "if i == 0u { w[0] = i; }");
    let read = |between: &str| format!("w[i] = i;\n{between}\nb[g] = w[3u - i];");
    check(kind, 10, &read(""), &read("workgroupBarrier();"));
    let write =
        |between: &str| format!("w[i] = i;\nworkgroupBarrier();\nlet x = w[3u - i];\n{between}\nw[i] = x;");
    check(kind, 12, &write(""), &write("workgroupBarrier();"));
}

#[test]
fn races_between_workgroups_are_found() {
    check(Fault::Race, 8, "b[i] = g;", "b[g] = i;");
    // No barrier orders workgroups.
    let text = |value: &str| {
        format!("if i == 0u {{ b[g] = 1u; }}\nstorageBarrier();\nif i == 1u {{ b[7] = {value}; }}")
    };
    assert_eq!(findings(&text("2u")), [(Fault::Race, 10)]);
}

#[test]
fn atomics_do_not_race_with_each_other() {
    let plain = "atomicAdd(&count, 1u);\natomicStore(&count, 2u);\nb[g] = atomicLoad(&count);";
    assert_eq!(findings(plain), []);
}

#[test]
fn a_barrier_that_some_invocations_miss_is_found() {
    let text = |condition: &str| format!("if {condition} {{\nworkgroupBarrier();\n}}\nw[i] = 1u;");
    check(Fault::NonUniformBarrier, 9, &text("i + b[7] < 2u"), &text("i + b[7] < 9u"));
}

#[test]
fn division_by_zero_is_found() {
    let text = |divisor: &str| format!("let d = i - {divisor};\nb[g] = 12u / d;");
    check(Fault::DivisionByZero, 9, &text("2u"), &text("9u"));
    let text = |divisor: &str| {
        format!(
            "let d = i32(i) - {divisor};\nb[g] = u32(-2147483647i - 1i - i32(b[g])) + u32((-2147483647i - 1i - i32(b[g])) % d);"
        )
    };
    check(Fault::DivisionByZero, 9, &text("4i"), &text("9i"));
}

#[test]
fn the_birth_of_a_nan_is_found_not_its_life() {
    let text = |offset: &str| {
        format!("let x = f32(i) - {offset};\nlet y = sqrt(x);\nb[g] = bitcast<u32>(y * 2.0 + x);")
    };
    check(Fault::NanBirth, 9, &text("1.0"), &text("0.0"));
}

#[test]
fn a_loop_that_does_not_end_is_found() {
    let text =
        |step: &str| format!("var n = i;\nloop {{\nif n > 100u {{ break; }}\nn += {step};\n}}\nb[g] = n;");
    check(Fault::EndlessLoop, 9, &text("b[g]"), &text("1u"));
}

#[test]
fn the_use_of_what_nothing_was_written_to_is_found() {
    let kind = Fault::Unwritten;
    let text =
        |first: &str| format!("var x: u32 {first};\nif i > 2u {{ x = 7u; }}\nlet y = x;\nb[g] = y + 1u;");
    check(kind, 11, &text(""), &text("= 0u"));
    let text = |first: &str| format!("var x: array<u32, 4>;\n{first}\nx[i] = 1u;\nlet y = x[1];\nb[g] = y;");
    check(kind, 12, &text(""), &text("x[1] = 2u;"));
    check(kind, 9, "let y = p;\nb[g] = y * 2u;", "p = 1u;\nb[g] = p * 2u;");
    check(kind, 8, "b[g] = w[i] + 1u;", "w[i] = 3u;\nb[g] = w[i] + 1u;");
}

#[test]
fn what_wgsl_defines_to_be_zero_is_looked_for_on_request_only() {
    let module = module("fn f(a: f32) -> f32 { var x: f32; if a > 1.0 { x = a; } return x + 1.0; }");
    let (interpreter, f) = (Interpreter::new(&module).unwrap(), module.function("f").unwrap());
    let args = floats(&[vec![2.0, 0.5]]);
    assert_eq!(interpreter.sanitize_call(f, &args, Checks::default()).unwrap(), []);
    let found = interpreter.sanitize_call(f, &args, EVERYTHING).unwrap();
    assert_eq!(
        found.iter().map(|f| (f.kind, f.invocation)).collect::<Vec<_>>(),
        [(Fault::Unwritten, Invocation::Row(1))]
    );
}

#[test]
fn rows_of_all_batches_are_looked_at_and_a_place_is_reported_once() {
    let module = module("fn f(a: f32) -> f32 { return sqrt(a) + log(a + 1.0); }");
    let (interpreter, f) = (Interpreter::new(&module).unwrap(), module.function("f").unwrap());
    let mut rows = vec![1.0_f32; 1000];
    (rows[700], rows[701], rows[999]) = (-0.5, -0.5, -2.0);
    let found = interpreter.sanitize_call(f, &floats(&[rows]), Checks::default()).unwrap();
    let found: Vec<_> = found.iter().map(|f| (f.kind, f.invocation, f.message.clone())).collect();
    let nan = |row, message: &str| (Fault::NanBirth, Invocation::Row(row), message.to_owned());
    assert_eq!(found, [nan(700, "Sqrt of [-0.5] is NaN"), nan(999, "Log of [-1.0] is NaN")]);
}

#[test]
fn what_is_sanitized_runs_as_ever() {
    let module = module(
        "@group(0) @binding(0) var<storage, read_write> b: array<u32>;
        @compute @workgroup_size(4) fn main(@builtin(global_invocation_id) id: vec3<u32>) { b[id.x + 1u] = 7u / id.x; }",
    );
    let (mut run, mut sanitized) = ([buffer(0, &[0; 6])], [buffer(0, &[0; 6])]);
    let interpreter = Interpreter::new(&module).unwrap();
    interpreter.run(0, [2, 1, 1], &mut run).unwrap();
    let found = interpreter.sanitize(0, [2, 1, 1], &mut sanitized, Checks::default()).unwrap();
    assert_eq!(run, sanitized);
    let kinds: Vec<_> = found.iter().map(|f| f.kind).collect();
    assert_eq!(kinds, [Fault::DivisionByZero, Fault::OutOfBounds, Fault::Race]);
    let Invocation::Global { group, local } = found[1].invocation else { panic!("no row") };
    assert_eq!((group, local), ([1, 0, 0], [1, 0, 0]));
}
