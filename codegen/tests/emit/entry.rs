//! The entry point around a function, and the layout that goes with it.

use crate::common::{artifact, module, rich, text};
use lobe_codegen::def::Scalar;
use lobe_codegen::emit::{EmitError, Target, with_entry};

fn entry_of(name: &str) -> (lobe_codegen::ValidModule, lobe_codegen::emit::EntryLayout) {
    let module = rich();
    let function = module.function(name).unwrap();
    with_entry(&module, function, 64).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn every_function_of_values_gets_an_entry_point_in_every_target() {
    for name in ["square", "f1", "product", "total", "framed", "parts", "flags"] {
        let (module, layout) = entry_of(name);
        assert_eq!(layout.entry_name, format!("{name}_entry"));
        assert_eq!(layout.count_binding as usize, layout.arguments.len() + 1);
        for (i, argument) in layout.arguments.iter().enumerate() {
            assert_eq!((argument.group, argument.binding as usize), (0, i));
        }
        assert_eq!(layout.result.binding as usize, layout.arguments.len());
        for target in Target::ALL {
            let artifact = artifact(&module, target);
            assert_eq!(artifact.entries.len(), 1);
            assert_eq!(artifact.entries[0].name, target.entry_name(&layout.entry_name));
            assert_eq!(artifact.entries[0].workgroup_size, [64, 1, 1]);
        }
    }
}

#[test]
fn the_entry_point_reads_as_if_written_by_hand() {
    let (module, _) = entry_of("f1");
    let wgsl = text(&module, Target::Wgsl);
    let expected = "\
var<uniform> row_count: u32;
@group(0) @binding(0)
var<storage> x_values: array<f32>;";
    assert!(wgsl.replace("\n\n", "\n").contains(expected), "{wgsl}");
    let expected = "\
/// Applies `f1` to each row of its buffers.
@compute @workgroup_size(64, 1, 1)
fn f1_entry(@builtin(global_invocation_id) global_invocation_id: vec3<u32>) {
    let row = global_invocation_id.x;
    let rows = row_count;
    if (row >= rows) {
        return;
    }
    let x = x_values[row];
    let x2 = x2_values[row];
    let result = f1(x, x2);
    results[row] = result;
}
";
    assert!(wgsl.ends_with(expected), "{wgsl}");
}

#[test]
fn booleans_travel_as_words() {
    let source = "struct Hit { near: f32, is_hit: bool, sides: array<vec2<bool>, 2> }
        fn turn(h: Hit) -> Hit { return Hit(-h.near, !h.is_hit, array<vec2<bool>, 2>(h.sides[1], h.sides[0])); }";
    let module = module(source);
    let (entry, layout) = with_entry(&module, module.function("turn").unwrap(), 32).unwrap();
    let kinds: Vec<Scalar> = layout.result.leaves.iter().map(|l| l.scalar).collect();
    assert_eq!(kinds, [Scalar::F32, Scalar::Bool, Scalar::Bool, Scalar::Bool, Scalar::Bool, Scalar::Bool]);
    let offsets: Vec<u32> = layout.result.leaves.iter().map(|l| l.offset).collect();
    assert_eq!((offsets, layout.result.stride), (vec![0, 4, 8, 12, 16, 20], 24));
    assert_eq!(layout.arguments[0].leaves[2].path, "h.sides[0].x");
    for target in Target::ALL {
        artifact(&entry, target);
    }
    let wgsl = text(&entry, Target::Wgsl);
    assert!(wgsl.contains("struct Hit_in_buffer {"), "{wgsl}");
    assert!(wgsl.contains(".is_hit != 0u)") && wgsl.contains("u32(result.is_hit)"), "{wgsl}");
    assert!(wgsl.contains(" != vec2(0u))") && wgsl.contains("vec2<u32>(result.sides["), "{wgsl}");
}

#[test]
fn what_no_buffer_holds_is_refused_with_the_reason() {
    for (source, reason) in [
        ("fn f(p: ptr<function, f32>) -> f32 { return *p; }", "`p` is a pointer"),
        ("fn f(x: f32) { }", "it returns nothing"),
    ] {
        let module = module(source);
        let error = with_entry(&module, module.function("f").unwrap(), 64).unwrap_err();
        assert!(matches!(&error, EmitError::Entry { .. }) && error.to_string().contains(reason), "{error}");
    }
    let module = rich();
    let error = with_entry(&module, module.function("f1").unwrap(), 0).unwrap_err();
    assert!(error.to_string().contains("no entry point can be made for `f1`"), "{error}");
}

#[test]
fn the_layout_has_a_scalar_for_each_column() {
    let (_, layout) = entry_of("framed");
    assert_eq!(layout.arguments[0].leaves.len(), 6 + 9 + 3 + 1);
    assert_eq!(layout.arguments[0].stride, 96);
    assert_eq!(layout.arguments[0].leaves[6].path, "f.wide.x_axis.x");
    assert_eq!(layout.arguments[0].leaves[6].offset, 32);
}
