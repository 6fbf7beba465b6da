//! Textures: what is read of them, and what is said of those that are broken.

use crate::scene::assert_sound;
use crate::textured::{JPEG, data, png, textured};
use lobe_codegen::glam::Vec3;
use lobe_kernels::scene::texture::{
    VALUES_LINEAR, VALUES_SIGNED, VALUES_SRGB, WRAP_CLAMP, WRAP_MIRROR, WRAP_REPEAT,
};
use lobe_tests::scene::{Choices, Scene, SceneError, Triangle};
use serde_json::{Value, json};
use std::path::PathBuf;

fn read(file: &Value, beside: &[(&str, Vec<u8>)]) -> Result<Scene, SceneError> {
    let get = |name: &str| {
        let found = beside.iter().find(|(known, _)| *known == name);
        found.map(|(_, bytes)| bytes.clone()).ok_or(format!("{name} was not sent"))
    };
    Scene::from_gltf(file.to_string().as_bytes(), &get, &Choices::default())
}

fn kept() -> Scene {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("cases/scenes/textured.gltf");
    Scene::open(&path, &Choices::default()).expect("a scene")
}

/// The triangles of a material.
fn of<'a>(scene: &'a Scene, name: &str) -> Vec<&'a Triangle> {
    let index = scene.materials.iter().position(|(known, _)| known == name).expect("a material");
    scene.triangles.iter().filter(|triangle| triangle.material == index).collect()
}

#[test]
fn a_textured_room_is_read() {
    let scene = kept();
    assert_sound(&scene);
    assert_eq!((scene.triangles.len(), scene.details.skins.len()), (44, 4));
    assert_eq!(scene.details.texels.len(), 4 * 4 + 8 * 8 + 2 * 2 + 8 * 8);
    assert!(scene.notes.is_empty(), "{:?}", scene.notes);
    let images = |name: &str| {
        let detail = of(&scene, name)[0].detail.expect("a detail");
        scene.details.skins[detail.skin as usize]
            .images
            .map(|i| [i.width, i.is_smooth, i.wrap_x, i.wrap_y, i.values])
    };
    let none = [0; 5];
    assert_eq!(images("tiles"), [[4, 0, WRAP_REPEAT, WRAP_REPEAT, VALUES_SRGB], none, none]);
    let picture = [8, 1, WRAP_MIRROR, WRAP_CLAMP, VALUES_SRGB];
    assert_eq!(images("wall"), [picture, none, [8, 1, WRAP_REPEAT, WRAP_REPEAT, VALUES_SIGNED]]);
    assert_eq!(images("brass"), [none, [2, 1, WRAP_CLAMP, WRAP_CLAMP, VALUES_LINEAR], none]);
    assert_eq!(images("glaze"), [none; 3]);
}

/// A tube that a node mirrors and scales has the normals of a round one, outwards as its triangles are.
#[test]
fn normals_are_placed_with_their_corners() {
    let scene = kept();
    for triangle in of(&scene, "glaze") {
        let corners = triangle.detail.expect("a detail").corners;
        for (vertex, corner) in triangle.vertices.iter().zip(corners) {
            let corner = scene.details.corners[corner as usize];
            let outwards = ((*vertex - Vec3::new(0.45, 0.0, 0.1)) * Vec3::new(1.0, 0.0, 1.0)).normalize();
            assert!(corner.normal.distance(outwards) < 1e-6, "{} {outwards}", corner.normal);
            assert!(corner.normal.dot(triangle.normal) > 0.9, "{} {}", corner.normal, triangle.normal);
        }
    }
}

/// Along the wall's bumps the first coordinate grows to the right, and rows of the image are counted from above.
#[test]
fn tangents_follow_coordinates() {
    let mut file = textured();
    for mirrored in [false, true] {
        if mirrored {
            file["nodes"][0]["scale"] = json!([-1, 1, 1]);
        }
        let scene = read(&file, &[]).expect("a scene");
        let right = if mirrored { Vec3::NEG_X } else { Vec3::X };
        for corner in
            of(&scene, "wall").iter().flat_map(|triangle| triangle.detail.expect("a detail").corners)
        {
            let corner = scene.details.corners[corner as usize];
            let up = corner.handedness * corner.normal.cross(corner.tangent);
            assert!(corner.tangent.distance(right) < 1e-5, "{corner:?}");
            assert!(up.distance(Vec3::Y) < 1e-5 && corner.normal.distance(Vec3::Z) < 1e-5, "{corner:?}");
        }
    }
}

/// Tangents of the file count with its normals, and without these they do not.
#[test]
fn tangents_of_the_file_are_taken() {
    let mut file = textured();
    // 9 vertices of the wall; three floats of the floor's places and their next are as good as any.
    let attributes = &mut file["meshes"][0]["primitives"][1]["attributes"];
    let position = attributes["POSITION"].as_u64().expect("an index") as usize;
    let count = file["accessors"].as_array().expect("accessors").len();
    let view = file["bufferViews"].as_array().expect("views").len();
    let offset = crate::meshes::bytes(&file).len();
    let mut bytes = crate::meshes::bytes(&file);
    for _ in 0..9 {
        bytes.extend([0.0_f32, 0.0, 1.0].iter().flat_map(|x| x.to_le_bytes()));
    }
    for _ in 0..9 {
        bytes.extend([0.0_f32, 2.0, 0.0, -1.0].iter().flat_map(|x| x.to_le_bytes()));
    }
    file["buffers"] = json!([{ "byteLength": bytes.len(), "uri": data("application/octet-stream", &bytes) }]);
    let list = |value: &mut Value, entry: Value| value.as_array_mut().expect("a list").push(entry);
    list(&mut file["bufferViews"], json!({ "buffer": 0, "byteOffset": offset, "byteLength": 108 }));
    list(&mut file["bufferViews"], json!({ "buffer": 0, "byteOffset": offset + 108, "byteLength": 144 }));
    for (i, kind) in ["VEC3", "VEC4"].into_iter().enumerate() {
        list(
            &mut file["accessors"],
            json!({ "bufferView": view + i, "componentType": 5126, "count": 9, "type": kind }),
        );
    }
    let attributes = &mut file["meshes"][0]["primitives"][1]["attributes"];
    attributes["TANGENT"] = json!(count + 1);
    let derived = read(&file, &[]).expect("a scene");
    file["meshes"][0]["primitives"][1]["attributes"]["NORMAL"] = json!(count);
    let taken = read(&file, &[]).expect("a scene");
    for (scene, tangent) in [(derived, Vec3::X), (taken, Vec3::Y)] {
        for corner in
            of(&scene, "wall").iter().flat_map(|triangle| triangle.detail.expect("a detail").corners)
        {
            let corner = scene.details.corners[corner as usize];
            assert!(corner.tangent.distance(tangent) < 1e-5, "{corner:?}");
        }
    }
    assert!(position < count);
}

/// The mean of light and dark tiles, each half of the floor; 2.5 turns cut no tile in two.
#[test]
fn materials_are_means_of_their_textures() {
    let scene = kept();
    let linear = |byte: u8| f64::from(((f64::from(byte) / 255.0 + 0.055) / 1.055).powf(2.4) as f32);
    let mean = |i: usize| 0.5 * (linear([230, 220, 200][i]) + linear([60, 70, 90][i]));
    let tiles = scene.materials[0].1;
    for i in 0..3 {
        let (found, wanted) = (f64::from(tiles.diffuse_albedo[i]), mean(i));
        assert!((found - wanted).abs() < 0.01 * wanted, "{found} {wanted}");
    }
    assert_eq!((tiles.f0, tiles.alpha), (Vec3::splat(0.04), 0.25));
    let brass = scene.materials[2].1;
    assert!(brass.diffuse_albedo.max_element() > 0.0 && brass.f0.x > 0.04, "{brass:?}");
}

#[test]
fn images_are_found_beside_the_file() {
    let mut file = textured();
    file["images"][0]["uri"] = json!("parts/white%20tiles.png");
    let white = png(4, |_, _| [255; 3]);
    let scene = read(&file, &[("parts/white tiles.png", white)]).expect("a scene");
    assert!(scene.materials[0].1.diffuse_albedo.distance(Vec3::ONE) < 1e-5, "{:?}", scene.materials[0]);
    let said = read(&file, &[]).expect_err("there is no file").to_string();
    assert_eq!(said, "parts/white tiles.png: parts/white tiles.png was not sent");
}

/// Images of grey and of 16 bits become 8 bits of red, green and blue.
#[test]
fn images_of_other_depths_are_read() {
    for (color, depth, bytes, texel) in [
        (png::ColorType::Grayscale, png::BitDepth::One, vec![0b1000_0000], 0xffff_ffff_u32),
        (png::ColorType::Grayscale, png::BitDepth::Sixteen, vec![0x12, 0x34], 0xff12_1212),
        (png::ColorType::GrayscaleAlpha, png::BitDepth::Eight, vec![5, 6], 0x0605_0505),
        (png::ColorType::Rgba, png::BitDepth::Eight, vec![1, 2, 3, 4], 0x0403_0201),
    ] {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, 1, 1);
        encoder.set_color(color);
        encoder.set_depth(depth);
        encoder.write_header().expect("a header").write_image_data(&bytes).expect("a pixel");
        let mut room = textured();
        room["images"][0]["uri"] = json!(data("image/png", &file));
        let scene = read(&room, &[]).expect("a scene");
        assert_eq!(scene.details.texels[0], texel, "{color:?} {depth:?}");
    }
}

/// What is said of the room with `value` at the place `pointer`, which may be new.
fn with(pointer: &str, value: Value) -> String {
    let mut room = textured();
    let (parent, member) = pointer.rsplit_once('/').expect("a pointer");
    match room.pointer_mut(parent).expect("a parent") {
        Value::Array(entries) => entries[member.parse::<usize>().expect("an index")] = value,
        parent => parent[member] = value,
    }
    match read(&room, &[]) {
        Ok(scene) => {
            assert_sound(&scene);
            format!("read: {}", scene.notes.join("; "))
        }
        Err(error) => error.to_string(),
    }
}

/// A PNG file whose header states other columns and rows.
fn bomb(width: u32, height: u32) -> String {
    let mut file = png(4, |_, _| [0; 3]);
    file[16..20].copy_from_slice(&width.to_be_bytes());
    file[20..24].copy_from_slice(&height.to_be_bytes());
    let mut sum = !0_u32;
    for byte in &file[12..29] {
        sum ^= u32::from(*byte);
        for _ in 0..8 {
            sum = if sum & 1 == 1 { sum >> 1 ^ 0xedb8_8320 } else { sum >> 1 };
        }
    }
    file[29..33].copy_from_slice(&(!sum).to_be_bytes());
    data("image/png", &file)
}

#[test]
fn what_is_wrong_is_named() {
    let cut = |bytes: &[u8]| json!(data("image/png", &bytes[..bytes.len() / 2]));
    let tiles = png(4, |_, _| [0; 3]);
    let wall = "/meshes/0/primitives/1/attributes";
    for (pointer, value, message) in [
        (
            "/images/0/uri",
            json!("data:image/png;base64,AAAA"),
            "images[0] (tiles): it is neither PNG nor JPEG",
        ),
        ("/images/0/uri", cut(&tiles), "images[0] (tiles): it is no PNG image: "),
        (
            "/images/1/uri",
            json!(format!("data:;base64,{}", &JPEG[..300])),
            "images[1] (picture): it is no JPEG image: ",
        ),
        (
            "/images/0/uri",
            json!(bomb(20_000, 1)),
            "images[0] (tiles): its size 20000 by 1 is not in 1 ..= 16384",
        ),
        ("/images/0/uri", json!(bomb(0, 1)), "images[0] (tiles): it is no PNG image: "),
        (
            "/images/0/uri",
            json!(bomb(16_384, 16_384)),
            "images[0] (tiles): with its 16384 by 16384 texels there are more than 134217728; make images smaller",
        ),
        ("/images/0/uri", json!(bomb(8192, 8192)), "images[0] (tiles): it is no PNG image: "),
        (
            "/images/0/uri",
            json!("../tiles.png"),
            "images[0] (tiles): the URI \"../tiles.png\" is not known here",
        ),
        ("/images/0", json!({}), "images[0]: it has neither a bufferView nor a uri"),
        ("/images/2/bufferView", json!(0), "images[2] (wear): it is neither PNG nor JPEG"),
        ("/images/2/bufferView", json!(99), "glTF: images[2].bufferView: Index out of bounds"),
        ("/textures/0/source", json!(9), "glTF: textures[0].source: Index out of bounds"),
        ("/textures/0", json!({}), "glTF: textures[0].source: Missing data"),
        ("/textures/0/sampler", json!(9), "glTF: textures[0].sampler: Index out of bounds"),
        ("/samplers/0/wrapS", json!(1), "glTF: samplers[0].wrapS: Invalid value"),
        (
            "/materials/0/pbrMetallicRoughness/baseColorTexture/index",
            json!(9),
            "glTF: materials[0].pbrMetallicRoughness.baseColorTexture.index: Index out of bounds",
        ),
        (
            "/materials/0/pbrMetallicRoughness/baseColorTexture/texCoord",
            json!(7),
            "read: a texture for which a mesh has no coordinates is of one colour there: meshes[0] (plates).primitives[0]",
        ),
        (
            "/materials/2/pbrMetallicRoughness/metallicRoughnessTexture/extensions/KHR_texture_transform",
            json!({ "scale": [1e20, 1] }),
            "materials.brass.metallicRoughnessTexture.KHR_texture_transform: its numbers are not below",
        ),
        (
            "/materials/1/normalTexture/extensions",
            json!({ "KHR_texture_transform": { "scale": "large" } }),
            "materials.wall.normalTexture.KHR_texture_transform: invalid type",
        ),
        (
            "/materials/1/normalTexture/scale",
            json!(1e3),
            "materials.wall.normalTexture.scale: 1000 is not in -100",
        ),
        (
            "/materials/1/occlusionTexture",
            json!({ "index": 0 }),
            "read: textures of occlusion are passed over: wall",
        ),
        (&format!("{wall}/TEXCOORD_0"), json!(1), "texture coordinates are VEC2 of 32-bit floats"),
        (&format!("{wall}/NORMAL"), json!(1), "normals are VEC3 of 32-bit floats"),
        (
            "/meshes/1/primitives/0/attributes/NORMAL",
            json!(0),
            "meshes[1] (tube).primitives[0]: NORMAL has 9 elements, and there are 22 vertices",
        ),
    ] {
        let said = with(pointer, value);
        assert!(said.contains(message), "{pointer}: {said} // {message}");
    }
}

/// An image that nothing refers to is not asked for.
#[test]
fn images_that_are_not_used_are_not_read() {
    let mut file = textured();
    file["images"].as_array_mut().expect("images").push(json!({ "uri": "nowhere.png" }));
    file["textures"].as_array_mut().expect("textures").push(json!({ "source": 4 }));
    assert!(read(&file, &[]).is_ok());
}
