//! Buffers as JSON: arrays and objects that follow the type, and the exact layout with its padding.

use super::number;
use super::shape::Shape;
use serde_json::{Map, Value};

/// The bytes that `value` states for a buffer of this shape, at least `least` of them; padding is zero.
///
/// # Errors
/// With the path of the first value that does not fit.
pub fn bytes(name: &str, shape: &Shape, least: usize, value: &Value) -> Result<Vec<u8>, String> {
    let mut out = vec![0; least];
    put(name, shape, 0, value, &mut out)?;
    Ok(out)
}

fn put(path: &str, shape: &Shape, at: usize, value: &Value, out: &mut Vec<u8>) -> Result<(), String> {
    match (shape, value) {
        (Shape::Scalar { scalar, .. }, value) => {
            let bytes = number::from_json(*scalar, value)
                .ok_or_else(|| format!("`{path}` is {}, not {}", number::wanted(*scalar), kind(value)))?;
            let end = at + bytes.len();
            out.resize(out.len().max(end), 0);
            out[at..end].copy_from_slice(&bytes);
            Ok(())
        }
        (Shape::List { part, count, stride, .. }, Value::Array(items)) => {
            let wanted = count.map_or(items.len(), |n| n as usize);
            if items.len() != wanted {
                return Err(format!("`{path}` has {wanted} elements, {} are given", items.len()));
            }
            out.resize(out.len().max(at + wanted * *stride as usize), 0);
            items.iter().enumerate().try_for_each(|(index, item)| {
                put(&format!("{path}[{index}]"), part, at + index * *stride as usize, item, out)
            })
        }
        (Shape::Struct(members), Value::Object(map)) => {
            if let Some(key) = map.keys().find(|key| members.iter().all(|m| m.name != **key)) {
                return Err(format!("`{path}` has no member `{key}`; {}", names(shape)));
            }
            members.iter().try_for_each(|m| match map.get(&m.name) {
                Some(value) => {
                    put(&format!("{path}.{}", m.name), &m.shape, at + m.offset as usize, value, out)
                }
                None => Err(format!("`{path}` lacks `{}`; {}", m.name, names(shape))),
            })
        }
        (Shape::List { .. }, value) => Err(format!("`{path}` is an array, not {}", kind(value))),
        (Shape::Struct(_), value) => {
            Err(format!("`{path}` is an object, not {}; {}", kind(value), names(shape)))
        }
    }
}

fn names(shape: &Shape) -> String {
    let Shape::Struct(members) = shape else { return String::new() };
    let names: Vec<&str> = members.iter().map(|m| m.name.as_str()).collect();
    format!("its members are {}", names.join(", "))
}

fn kind(value: &Value) -> String {
    match value {
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => value.to_string(),
        Value::Array(_) => "an array".to_owned(),
        Value::Object(_) => "an object".to_owned(),
    }
}

/// The buffer as [`bytes`] reads it.
#[must_use]
pub fn value(shape: &Shape, bytes: &[u8]) -> Value {
    value_at(shape, 0, bytes)
}

fn value_at(shape: &Shape, at: usize, bytes: &[u8]) -> Value {
    match shape {
        Shape::Scalar { scalar, .. } => match bytes.get(at..at + usize::from(scalar.width)) {
            Some(place) => number::to_json(*scalar, place),
            None => Value::Null,
        },
        Shape::List { part, count, stride, .. } => {
            let length = Shape::length(*count, *stride, at, bytes.len());
            (0..length).map(|index| value_at(part, at + index * *stride as usize, bytes)).collect()
        }
        Shape::Struct(members) => {
            let member = |m: &super::shape::Member| {
                (m.name.clone(), value_at(&m.shape, at + m.offset as usize, bytes))
            };
            Value::Object(members.iter().map(member).collect::<Map<_, _>>())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "
        struct Item { flag: i32, color: vec3<f32> }
        struct All { count: u32, items: array<Item> }
        @group(0) @binding(0) var<storage, read_write> all: All;
        @compute @workgroup_size(1) fn main() { all.count = 1u; }
    ";
    const JSON: &str =
        r#"{"count":7,"items":[{"flag":-1,"color":[0.5,"inf","nan"]},{"flag":2,"color":[1.0,2.0,3.0]}]}"#;

    fn shape() -> Shape {
        let module = lobe_codegen::validate::foreign_wgsl(TEXT).expect("valid");
        let module = module.module();
        Shape::of(module, module.global_variables.iter().next().expect("a variable").1.ty).expect("a shape")
    }

    #[test]
    fn a_buffer_comes_back_as_it_went_with_its_padding() {
        let value: Value = serde_json::from_str(JSON).expect("JSON");
        let bytes = bytes("all", &shape(), 48, &value).expect("fits");
        assert_eq!(bytes.len(), 16 + 2 * 32);
        assert_eq!(bytes[16..20], (-1_i32).to_le_bytes());
        assert_eq!(bytes[32..36], 0.5_f32.to_le_bytes());
        assert_eq!(super::value(&shape(), &bytes), value);
    }

    #[test]
    fn what_does_not_fit_is_named_by_its_path() {
        for (json, part) in [
            ("[]", "`all` is an object, not an array; its members are count, items"),
            (r#"{"count": 1}"#, "`all` lacks `items`"),
            (r#"{"count": 1, "items": [], "more": 1}"#, "no member `more`"),
            (r#"{"count": -1, "items": []}"#, "`all.count` is a non-negative integer of 32 bits, not -1"),
            (
                r#"{"count": 1, "items": [{"flag": 1, "color": [1, 2]}]}"#,
                "`all.items[0].color` has 3 elements, 2",
            ),
        ] {
            let value: Value = serde_json::from_str(json).expect("JSON");
            let message = bytes("all", &shape(), 48, &value).expect_err(json);
            assert!(message.contains(part), "{message}");
        }
    }
}
