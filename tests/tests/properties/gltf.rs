//! glTF: what is kept is read as it was built, what is wrong is named, and no bytes make the reader panic.

use crate::meshes::{binary, plates, room};
use crate::scene::{assert_sound, change, changed};
use crate::support::check;
use crate::textured::textured;
use lobe_codegen::glam::Vec3;
use lobe_tests::scene::{Choices, Light, Scene, SceneError};
use proptest::prelude::*;
use serde_json::{Value, json};
use std::path::PathBuf;

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("cases/scenes")
}

fn nowhere(name: &str) -> Result<Vec<u8>, String> {
    Err(format!("{name} was not sent"))
}

fn read(value: &Value) -> Result<Scene, SceneError> {
    Scene::from_gltf(value.to_string().as_bytes(), &nowhere, &Choices::default())
}

/// `LOBE_BLESS=1` writes them.
#[test]
fn kept_files_are_what_is_built() {
    for (name, built) in [("room", room()), ("plates", plates()), ("textured", textured())] {
        let (path, text) = (folder().join(format!("{name}.gltf")), format!("{built:#}\n"));
        if std::env::var_os("LOBE_BLESS").is_some() {
            std::fs::write(&path, &text).expect("writable");
        }
        let kept = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        assert!(kept == text, "{} is not what is built; LOBE_BLESS=1 writes it", path.display());
    }
}

#[test]
fn a_room_is_read() {
    let scene = Scene::open(&folder().join("room.gltf"), &Choices::default()).expect("a scene");
    assert_sound(&scene);
    assert_eq!((scene.name.as_str(), scene.triangles.len(), scene.camera.size), ("room", 50, [256, 256]));
    let names: Vec<&str> = scene.materials.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["white", "red", "gold"]);
    let (white, gold) = (scene.materials[0].1, scene.materials[2].1);
    assert_eq!((white.f0, white.f90, white.alpha), (Vec3::splat(0.04), 1.0, 0.25));
    assert_eq!((gold.diffuse_albedo, gold.f0, gold.alpha), (Vec3::ZERO, Vec3::new(1.0, 0.75, 0.25), 0.02));
    assert_eq!(scene.triangles.iter().filter(|t| t.two_sided).count(), 8);
    assert_eq!(scene.triangles[0].normal, Vec3::Y);
    let Light::Directional { to_light, irradiance } = scene.lights[0] else { panic!("{:?}", scene.lights) };
    assert!(
        (to_light - Vec3::Z).length() < 1e-6 && irradiance == Vec3::new(3.0, 3.0, 1.5),
        "{to_light} {irradiance}"
    );
    assert_eq!(scene.notes, ["a roughness below 0.141 is made that, alpha 0.02: gold"]);
    let ray = scene.camera.ray(128, 128);
    assert!(ray.origin == Vec3::new(0.0, 1.0, 4.0) && ray.direction.dot(Vec3::NEG_Z) > 0.999, "{ray:?}");
}

/// A strip and a fan make the same square; a node that mirrors keeps the front where it was seen.
#[test]
fn strips_fans_and_mirrors() {
    let scene = Scene::open(&folder().join("plates.gltf"), &Choices::default()).expect("a scene");
    assert_sound(&scene);
    let normals: Vec<Vec3> = scene.triangles.iter().map(|triangle| triangle.normal).collect();
    assert_eq!(normals, [Vec3::Z; 6]);
    let area = |t: &lobe_tests::scene::Triangle| {
        let [a, b, c] = t.vertices;
        0.5 * (b - a).cross(c - a).dot(t.normal)
    };
    for triangle in &scene.triangles {
        assert!((area(triangle) - 2.0).abs() < 1e-6, "{triangle:?}");
    }
    assert_eq!(scene.materials[0].0, "default");
    assert!(
        matches!(scene.lights[0], Light::Spot { position, axis, .. } if position == Vec3::new(0.0, 0.0, 3.0) && axis == Vec3::NEG_Z)
    );
    assert_eq!(scene.notes, ["there is no perspective camera, so one was placed that sees everything"]);
}

#[test]
fn binary_files_hold_the_same() {
    let (text, glb) = (read(&room()).expect("a scene"), binary(&room()));
    let scene = Scene::from_gltf(&glb, &nowhere, &Choices::default()).expect("a scene");
    assert_eq!((scene.triangles, scene.lights, scene.camera), (text.triangles, text.lights, text.camera));
}

#[test]
fn files_beside_are_asked_for_by_their_names() {
    let mut room = room();
    let bytes = crate::meshes::bytes(&room);
    room["buffers"][0]["uri"] = json!("parts/room%201.bin");
    let beside = |name: &str| (name == "parts/room 1.bin").then(|| bytes.clone()).ok_or(name.to_owned());
    let scene = Scene::from_gltf(room.to_string().as_bytes(), &beside, &Choices::default()).expect("a scene");
    assert_eq!(scene.triangles.len(), 50);
    let said = read(&room).expect_err("there is no file").to_string();
    assert_eq!(said, "parts/room 1.bin: parts/room 1.bin was not sent");
}

/// What is said of the room with `value` at the place `pointer`, which may be new.
fn with(pointer: &str, value: Value) -> String {
    let mut room = room();
    let (parent, member) = pointer.rsplit_once('/').expect("a pointer");
    let parent = room.pointer_mut(parent).expect("a parent");
    match parent {
        Value::Array(entries) => entries[member.parse::<usize>().expect("an index")] = value,
        _ => parent[member] = value,
    }
    match read(&room) {
        Ok(scene) => {
            // That of the gold is said of the room as it is.
            let new: Vec<String> =
                scene.notes.into_iter().filter(|note| !note.starts_with("a roughness")).collect();
            format!("read: {}", new.join("; "))
        }
        Err(error) => error.to_string(),
    }
}

#[test]
fn what_is_wrong_is_named() {
    let point = json!([{ "type": "point" }]);
    let spot = json!([{ "type": "spot", "spot": { "innerConeAngle": 1.0, "outerConeAngle": 1.5707964 } }]);
    let lights = "/extensions/KHR_lights_punctual/lights";
    for (pointer, value, message) in [
        ("/asset/version", json!(2), "glTF: "),
        ("/scenes", json!([]), "glTF: scene: Index out of bounds"),
        ("/scenes/0/nodes", json!([]), "there is no triangle: a node of the scene needs a mesh"),
        ("/scenes/0/nodes", json!([0, 1]), "there is no light: give a node a directional light"),
        (
            lights,
            point,
            "nodes[2] (sun), extensions.KHR_lights_punctual.lights[0]: a point light is not known",
        ),
        (lights, spot, "read: a cone is changed to half angles that are known here, 1.15 to 89.95"),
        (lights, json!([{ "type": "directional", "intensity": -1 }]), "lights[0].intensity: -1 is not in"),
        ("/nodes/0/children", json!([0]), "nodes[0] (room): it hangs in two places, or below itself"),
        ("/nodes/0/rotation", json!([0, 0, 0, 0]), "nodes[0] (room).rotation: it is no rotation"),
        ("/nodes/0/scale", json!([1e20, 1, 1]), "meshes[0] (plates).primitives[0]: vertex 0, ["),
        ("/nodes/0/scale", json!([0, 0, 0]), "there is no triangle"),
        ("/nodes/2/scale", json!([0, 0, 0]), "nodes[2] (sun): its scale leaves it no direction"),
        ("/cameras/0/perspective/yfov", json!(3.2), "nodes[1] (eye), yfov in degrees: 183"),
        (
            "/meshes/0/primitives/0/mode",
            json!(1),
            "read: points and lines are passed over: meshes[0] (plates)",
        ),
        ("/meshes/0/primitives/0/indices", json!(0), "accessors[0]: indices are SCALAR"),
        ("/meshes/0/primitives/0/attributes", json!({}), "glTF: "),
        (
            "/meshes/0/primitives/0/attributes/POSITION",
            json!(90),
            "meshes[0].primitives[0]: an attribute is accessor 90",
        ),
        ("/meshes/0/primitives/0/material", json!(9), "glTF: meshes[0].primitives[0].material: Index out of"),
        ("/accessors/0/count", json!(4_000_000_000u32), "accessors[0]: 4000000000 elements do not fit into"),
        (
            "/accessors/0/count",
            json!(3),
            "meshes[0] (plates).primitives[0]: index 2 is vertex 5, and there are 3",
        ),
        ("/accessors/0/componentType", json!(5123), "accessors[0]: positions are VEC3 of 32-bit floats"),
        ("/bufferViews/0/byteOffset", json!(u64::MAX), "bufferViews[0]: it is not inside its buffer"),
        (
            "/bufferViews/0/byteStride",
            json!(8),
            "accessors[0]: its elements have 12 bytes, and byteStride is 8",
        ),
        ("/buffers/0/byteLength", json!(1e6 as u64), "buffers[0]: it has "),
        ("/buffers/0/uri", json!("../room.bin"), "buffers[0]: the URI \"../room.bin\" is not known here"),
        ("/buffers/0/uri", json!("data:;base64,?"), "buffers[0]: its data URI is no base64"),
        ("/buffers/0/uri", json!("data:text/plain,no"), "buffers[0]: its data URI is not in base64"),
        (
            "/materials/0/pbrMetallicRoughness",
            json!({ "roughnessFactor": 2 }),
            "materials.white.roughnessFactor: 2",
        ),
        (
            "/materials/0/extensions",
            json!({ "KHR_materials_ior": { "ior": 0.5 } }),
            "materials.white.ior: 0.5",
        ),
        ("/materials/0/emissiveFactor", json!([1, 1, 1]), "read: emitted light is passed over: white"),
        ("/materials/1/name", json!("white"), "read: "),
        ("/extensionsRequired", json!(["KHR_draco_mesh_compression"]), "glTF: extensionsRequired[0]"),
        (
            "/extensionsUsed",
            json!(["KHR_materials_sheen"]),
            "read: an extension is passed over: KHR_materials_sheen",
        ),
    ] {
        let said = with(pointer, value);
        assert!(said.contains(message), "{pointer}: {said} // {message}");
    }
}

#[test]
fn cameras_are_chosen_by_name() {
    let choose = |camera: &str| {
        let choices = Choices { camera: Some(camera.to_owned()), size: [8, 4], ..Choices::default() };
        Scene::from_gltf(room().to_string().as_bytes(), &nowhere, &choices)
    };
    assert_eq!(choose("eye").expect("a camera").camera.size, [8, 4]);
    let said = choose("ear").expect_err("there is none").to_string();
    assert_eq!(said, "cameras: there is no perspective camera `ear`; there are: eye");
}

/// A few bytes name as many triangles as they like; they are not believed.
#[test]
fn small_files_make_no_large_scenes() {
    let mut room = room();
    room["accessors"][0] = json!({
        "componentType": 5126, "count": 4_000_000_000u32, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0],
        "sparse": {
            "count": 1, "indices": { "bufferView": 1, "componentType": 5123 }, "values": { "bufferView": 0 }
        },
    });
    let said = read(&room).expect_err("too large").to_string();
    assert!(said.contains("accessors[0]: its count 4000000000 is above 16777216"), "{said}");
}

/// Bytes of a file with some of them changed, left out or put in.
fn bytes() -> impl Strategy<Value = Vec<u8>> {
    let edit = (any::<prop::sample::Index>(), 0..4u8, any::<u8>());
    let files = prop::sample::select(vec![room(), plates(), textured()]);
    (files, prop::collection::vec(edit, 1..5)).prop_map(|(file, edits)| {
        let mut bytes = binary(&file);
        for (place, kind, byte) in edits.into_iter().filter(|(place, ..)| place.index(2) < 2) {
            let at = place.index(bytes.len().max(1)).min(bytes.len().saturating_sub(1));
            match kind {
                0 => bytes.insert(at, byte),
                1 => drop(bytes.drain(at..(at + usize::from(byte)).min(bytes.len()))),
                _ => bytes[at] ^= byte,
            }
            bytes.resize(bytes.len().max(1), 0);
        }
        bytes
    })
}

fn texts() -> impl Strategy<Value = Vec<u8>> {
    let texts = vec![format!("{:#}", room()), plates().to_string(), textured().to_string()];
    (prop::sample::select(texts), prop::collection::vec(change(), 1..4)).prop_map(|(text, changes)| {
        changes.iter().fold(text, |text, change| changed(&text, change)).into_bytes()
    })
}

#[test]
fn spoilt_files_are_refused_or_sound() {
    check(prop_oneof![bytes(), texts()], |bytes| {
        match Scene::from_gltf(&bytes, &nowhere, &Choices::default()) {
            Ok(scene) => assert_sound(&scene),
            // A panic would be an error too, but there is none that is known.
            Err(error) => prop_assert!(!matches!(error, SceneError::Panicked { .. }), "{error}"),
        }
        Ok(())
    });
}
