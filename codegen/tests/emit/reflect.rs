//! Reflection.

use crate::common::rich;
use lobe_codegen::emit::{reflect, with_entry};

#[test]
fn reflection_tells_types_places_and_docs() {
    let module = rich();
    let (entry, layout) = with_entry(&module, module.function("product").unwrap(), 64).unwrap();
    let text = reflect(&entry).to_json().unwrap();
    assert_eq!(reflect(&entry).to_json().unwrap(), text);
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["schema"], 1);
    let sg = &json["structs"][0];
    assert_eq!((&sg["name"], &sg["size"], &sg["align"]), (&"Sg".into(), &32.into(), &16.into()));
    assert_eq!(sg["docs"], serde_json::json!(["A lobe.", "", "Unit axis."]));
    assert_eq!(
        sg["members"][1],
        serde_json::json!({ "name": "sharpness", "docs": ["1/sr"], "type": "f32", "offset": 12, "size": 4 })
    );
    assert_eq!(json["constants"][0]["value"].to_string(), "6.2831855");
    assert_eq!(json["constants"][1]["type"], "array<vec3<f32>, 2>");
    let function = &json["functions"].as_array().unwrap().iter().find(|f| f["name"] == "total").unwrap();
    assert_eq!(function["parameters"][1], serde_json::json!({ "name": "values", "type": "array<f32, 4>" }));
    let point = &json["entries"][0];
    assert_eq!(point["workgroup_size"], serde_json::json!([64, 1, 1]));
    let bindings = point["bindings"].as_array().unwrap();
    assert_eq!(bindings.len(), layout.arguments.len() + 2);
    assert_eq!(
        bindings[2],
        serde_json::json!({
            "name": "results", "group": 0, "binding": 2, "access": "read_write", "type": "array<Sg>", "stride": 32
        })
    );
    assert_eq!(bindings[3]["access"], "uniform");
}
