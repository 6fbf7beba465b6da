//! Descriptions of modules follow `tests/schema/reflection-1.json`.

use super::{library, programs};
use lobe_codegen::emit::reflect::SCHEMA;
use lobe_codegen::emit::{Reflection, prefixed, reflect};
use lobe_codegen::validate::from_wgsl;
use serde_json::Value;

fn schema() -> jsonschema::Validator {
    let schema: Value = serde_json::from_str(include_str!("../../schema/reflection-1.json")).expect("JSON");
    assert_eq!(schema["properties"]["schema"]["const"], SCHEMA);
    jsonschema::validator_for(&schema).expect("a schema")
}

#[track_caller]
fn assert_follows(schema: &jsonschema::Validator, reflection: &Reflection) -> Value {
    let text = reflection.to_json().unwrap_or_else(|e| panic!("{e}"));
    let value = serde_json::from_str(&text).expect("JSON");
    let errors: Vec<String> =
        schema.iter_errors(&value).map(|e| format!("{}: {e}", e.instance_path())).collect();
    assert!(errors.is_empty(), "{}", errors.join("\n"));
    value
}

#[test]
fn those_of_the_library_and_of_every_entry_point() {
    let schema = schema();
    let library = library();
    assert_follows(&schema, &reflect(&library));
    let prefixed = prefixed(&library, "lobe_").unwrap_or_else(|e| panic!("{e}"));
    assert_follows(&schema, &reflect(&prefixed));
    for program in programs() {
        let (module, _) = program.entry().unwrap_or_else(|e| panic!("{e}"));
        assert_follows(&schema, &reflect(module));
    }
}

/// What the library has not: constants of every shape, functions without a result, every kind of resource.
const RICH: &str = "
    struct Pair { first: vec2<f32>, second: array<vec4<i32>, 2> }
    const COUNT: u32 = 3u;
    const IS_ON: bool = true;
    const SHIFT: vec2<i32> = vec2<i32>(-1, 2);
    const TURN: mat2x2<f32> = mat2x2<f32>(vec2<f32>(0.0, 1.0), vec2<f32>(-1.0, 0.0));
    const PAIR: Pair = Pair(vec2<f32>(0.1, 1e-30), array<vec4<i32>, 2>(vec4<i32>(1), vec4<i32>(2)));
    @group(0) @binding(1) var<uniform> pair: Pair;
    @group(0) @binding(0) var<storage> given: array<Pair>;
    @group(1) @binding(7) var<storage, read_write> total: atomic<u32>;
    @group(1) @binding(8) var picture: texture_2d<f32>;
    fn add(n: u32) { atomicAdd(&total, n); }
    @compute @workgroup_size(8, 4) fn sum() {
        add(arrayLength(&given) + u32(pair.second[1].x) + textureDimensions(picture).x);
    }";

#[test]
fn that_of_a_module_with_everything() {
    let module = from_wgsl(RICH).unwrap_or_else(|e| panic!("{e}"));
    let value = assert_follows(&schema(), &reflect(&module));
    let bindings = &value["entries"][0]["bindings"];
    let accesses: Vec<&Value> = bindings.as_array().expect("a list").iter().map(|b| &b["access"]).collect();
    assert_eq!(accesses, ["read", "uniform", "read_write", "handle"]);
    assert_eq!((&bindings[0]["stride"], &bindings[1]["stride"]), (&48.into(), &Value::Null));
}

#[test]
fn a_member_that_the_schema_does_not_know_is_an_error() {
    let module = from_wgsl(RICH).unwrap_or_else(|e| panic!("{e}"));
    let schema = schema();
    let mut value = assert_follows(&schema, &reflect(&module));
    for place in [
        "",
        "/structs/0",
        "/structs/0/members/0",
        "/constants/0",
        "/functions/0",
        "/functions/0/parameters/0",
        "/entries/0",
        "/entries/0/bindings/0",
    ] {
        let object = value.pointer_mut(place).and_then(Value::as_object_mut).expect("an object");
        object.insert("unknown".to_owned(), Value::Null);
        assert!(!schema.is_valid(&value), "{place:?} may have members that the schema does not know");
        value.pointer_mut(place).and_then(Value::as_object_mut).expect("an object").remove("unknown");
    }
    assert!(schema.is_valid(&value));
}
