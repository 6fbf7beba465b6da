//! Changes of the text of a JSON scene, drawn by chance: what an author, a script or a broken disk may leave in one.

use lobe_tests::domain::Rng;
use serde_json::{Value, json};

/// Stand in a value for what its type cannot hold; the text has what is between the marks.
const MARKS: [(&str, &str); 5] = [
    ("\"#NaN#\"", "NaN"),
    ("\"#-NaN#\"", "-nan(0x1)"),
    ("\"#1e400#\"", "1e400"),
    ("\"#-1e400#\"", "-1e400"),
    ("#twice\"", "\""),
];

/// The text of `scene` after one to three changes, and what was done.
pub(crate) fn spoilt(mut scene: Value, rng: &mut Rng) -> (String, Vec<String>) {
    let mut done = Vec::new();
    for _ in 0..1 + rng.below(3) {
        done.push(match rng.below(13) {
            0 => lengths(&mut scene, rng),
            1..8 => meaningful(&mut scene, rng),
            8..12 => number(&mut scene, rng),
            _ => structure(&mut scene, rng),
        });
    }
    let mut text = MARKS.iter().fold(scene.to_string(), |text, (mark, word)| text.replace(mark, word));
    if rng.one_in(20) {
        let mut bytes = text.into_bytes();
        for _ in 0..1 + rng.below(3) {
            let at = rng.below(bytes.len());
            bytes[at] ^= 1 << rng.below(8);
        }
        text = String::from_utf8_lossy(&bytes).into_owned();
        done.push("bits flipped".to_owned());
    }
    (text, done)
}

/// The place of every value that `is_wanted`.
fn places(value: &Value, is_wanted: &dyn Fn(&Value) -> bool) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = vec![(String::new(), value)];
    while let Some((at, value)) = rest.pop() {
        match value {
            Value::Array(all) => rest.extend(all.iter().enumerate().map(|(i, v)| (format!("{at}/{i}"), v))),
            Value::Object(all) => rest.extend(all.iter().map(|(name, v)| (format!("{at}/{name}"), v))),
            _ => {}
        }
        if is_wanted(value) {
            found.push(at);
        }
    }
    found
}

/// One of them.
fn place(value: &Value, rng: &mut Rng, is_wanted: &dyn Fn(&Value) -> bool) -> Option<String> {
    let found = places(value, is_wanted);
    (!found.is_empty()).then(|| found[rng.below(found.len())].clone())
}

/// A number in place of another.
fn number(scene: &mut Value, rng: &mut Rng) -> String {
    let Some(at) = place(scene, rng, &Value::is_number) else { return "nothing".to_owned() };
    let target = scene.pointer_mut(&at).expect("it was found");
    let former = target.as_f64().unwrap_or(0.0);
    *target = match rng.below(6) {
        0 | 5 => json!(former * 10f64.powf(rng.range(-14.0, 14.0))),
        1 => json!(-former),
        2 => json!(former * (1.0 + 1e-7) + 1e-9),
        3 => json!(former.round() as i64),
        _ => special(rng),
    };
    format!("{at} = {target}")
}

fn special(rng: &mut Rng) -> Value {
    let all = json!([
        0,
        -0.0,
        5e-324,
        1e-300,
        1e-45,
        1e-38,
        1e-20,
        1e-9,
        1e-6,
        0.02,
        0.019_999,
        1,
        1.000_001,
        2,
        -1,
        1e4,
        1e9,
        -1e9,
        1.1e9,
        1e20,
        1e38,
        1e300,
        -1e300,
        4_294_967_296_u64,
        "#NaN#",
        "#-NaN#",
        "#1e400#",
        "#-1e400#",
        "nan",
        "1",
        "",
        null,
        true,
        [],
        {},
        [1, 2, 3]
    ]);
    let all = all.as_array().expect("it is one");
    all[rng.below(all.len())].clone()
}

/// Parts left out, twice, emptied, put in each other's place.
fn structure(scene: &mut Value, rng: &mut Rng) -> String {
    let is_holder = |value: &Value| value.is_object() || value.is_array();
    let Some(at) = place(scene, rng, &is_holder) else { return "nothing".to_owned() };
    let donor =
        place(scene, rng, &|_| true).and_then(|at| scene.pointer(&at).cloned()).unwrap_or(Value::Null);
    let what = rng.below(4);
    match scene.pointer_mut(&at).expect("it was found") {
        Value::Array(all) if !all.is_empty() => {
            let index = rng.below(all.len());
            match what {
                0 => drop(all.remove(index)),
                1 => all.push(all[index].clone()),
                2 => all.clear(),
                _ => all[index] = donor,
            }
        }
        Value::Object(all) if !all.is_empty() => {
            let name = all.keys().nth(rng.below(all.len())).cloned().unwrap_or_default();
            let value = all[&name].clone();
            match what {
                0 => drop(all.remove(&name)),
                1 => drop(all.insert(format!("{name}#twice"), value)),
                2 => all.clear(),
                _ => drop(all.insert(name, donor)),
            }
        }
        _ => {}
    }
    format!("{at} {}", ["loses a part", "has one twice", "is emptied", "has another's part"][what])
}

/// All lengths of a scene times a factor, or all places moved: what a wrong unit or a place on a globe makes.
fn lengths(scene: &mut Value, rng: &mut Rng) -> String {
    let factor = 10f64.powf(rng.range(-7.0, 9.0));
    let offset = if rng.one_in(3) { 10f64.powf(rng.range(0.0, 8.0)) } else { 0.0 };
    let is_place =
        |at: &str| ["position", "look_at", "center"].iter().any(|name| at.contains(&format!("/{name}/")));
    for at in places(scene, &Value::is_number) {
        let Some(target) = scene.pointer_mut(&at) else { continue };
        let former = target.as_f64().unwrap_or(0.0);
        if is_place(&at) {
            *target = json!(former * factor + offset);
        } else if at.contains("/half_") {
            *target = json!(former * factor);
        } else if at.contains("/intensity/") && rng.one_in(2) {
            *target = json!((former * factor * factor).min(1e9));
        }
    }
    format!("lengths times {factor:e}, places moved by {offset:e}")
}

/// A vector of a scene's size.
fn point(rng: &mut Rng) -> Value {
    json!([rng.range(-2.0, 2.0), rng.range(-2.0, 2.0), rng.range(-2.0, 2.0)])
}

/// A copy of a vector somewhere in the scene.
fn other_point(scene: &Value, rng: &mut Rng) -> Value {
    let is_triple = |value: &Value| value.as_array().is_some_and(|all| all.len() == 3 && all[0].is_number());
    place(scene, rng, &is_triple).and_then(|at| scene.pointer(&at).cloned()).unwrap_or(Value::Null)
}

/// What a scene may be and should not: rectangles without a width or in each other, lights in surfaces, below them or along
/// them, distributions at their limits, eyes in walls.
fn meaningful(scene: &mut Value, rng: &mut Rng) -> String {
    let count = |name: &str| scene[name].as_array().map_or(0, Vec::len);
    let rect = format!("/rects/{}", rng.below(count("rects")));
    let light = format!("/lights/{}", rng.below(count("lights")));
    let names: Vec<String> =
        scene["materials"].as_object().map(|all| all.keys().cloned().collect()).unwrap_or_default();
    let material = format!("/materials/{}", names.get(rng.below(names.len())).cloned().unwrap_or_default());
    let axis = json!(
        [[0.0, -1.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [1.0, 1e-7, 0.0]]
            [rng.below(5)]
    );
    let length = [0.0, 1e-9, 1e-6, 1.1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9][rng.below(9)];
    let alpha = [0.0, -0.1, 0.019_999, 0.02, 0.020_001, 0.999_999, 1.0, 1.000_001, 7.0][rng.below(9)];
    let power = json!([0.0, 1e-30, 1e9, 1.1e9][rng.below(4)]);
    let shares = json!([rng.below(2), rng.below(2), 1e-30]);
    let degrees = json!([0.0, 0.001, 1.15, 1.21, 45.0, 89.95, 90.0, 179.0, 179.1][rng.below(9)]);
    let near = other_point(scene, rng);
    let changes: Vec<(String, Value)> = match rng.below(13) {
        0 => vec![(rect.clone() + "/half_u", json!([length, 0, 0])), (rect + "/half_v", json!([0, 0, 1]))],
        1 => vec![
            (rect.clone() + "/half_u", json!([0, length, 0])),
            (rect.clone() + "/half_v", json!([0, 0, length])),
            (rect + "/normal", Value::Null),
        ],
        2 => {
            vec![(rect.clone() + "/half_u", scene.pointer(&(rect + "/half_v")).cloned().unwrap_or_default())]
        }
        3 => vec![(rect + "/center", near)],
        4 => vec![(
            light,
            json!({ "type": "directional", "direction": axis, "irradiance": [power, power, 1] }),
        )],
        5 | 6 => {
            let position = if rng.one_in(3) { point(rng) } else { near };
            vec![(
                light,
                json!({
                    "type": "spot", "position": position, "direction": axis, "cone_inner_deg": 0.5,
                    "cone_outer_deg": degrees, "intensity": [power, 1, 1]
                }),
            )]
        }
        7 => vec![(light.clone() + "/direction", axis), (light + "/cone_inner_deg", degrees)],
        8 | 9 => vec![(material + "/ggx_alpha", json!(alpha))],
        10 => {
            vec![(material.clone() + "/specular_f0", shares.clone()), (material + "/diffuse_albedo", shares)]
        }
        11 => vec![("/camera/position".to_owned(), near)],
        _ => vec![("/camera/look_at".to_owned(), near), ("/camera/vfov_deg".to_owned(), degrees)],
    };
    let said = changes.iter().map(|(at, value)| format!("{at} = {value}")).collect::<Vec<_>>().join(", ");
    for (at, value) in changes {
        put(scene, &at, value);
    }
    said
}

/// Puts a value where it was, or as a new member; a place whose parent is gone stays gone.
fn put(scene: &mut Value, at: &str, value: Value) {
    let Some((parent, name)) = at.rsplit_once('/') else { return };
    match scene.pointer_mut(parent) {
        Some(Value::Object(all)) if value.is_null() => drop(all.remove(name)),
        Some(Value::Object(all)) => drop(all.insert(name.to_owned(), value)),
        Some(Value::Array(all)) => {
            if let Some(target) = name.parse::<usize>().ok().and_then(|i| all.get_mut(i)) {
                *target = value;
            }
        }
        _ => {}
    }
}
