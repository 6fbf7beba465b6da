//! The glTF file of `tests/cases/scenes` with textures and with normals at its corners, built here.

use crate::meshes::Builder;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};
use std::f32::consts::TAU;

/// A JPEG file of 8 by 8 pixels, red to the left and blue to the right.
pub(crate) const JPEG: &str = "/9j/4AAQSkZJRgABAgAAAQABAAD/wAARCAAIAAgDABEAAREBAhEB/9sAQwAGBAUGBQQGBgUGBwcGCAoQCgoJCQoUDg8M\
    EBcUGBgXFBYWGh0lHxobIxwWFiAsICMmJykqKRkfLTAtKDAlKCko/9sAQwEHBwcKCAoTCgoTKBoWGigoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgo\
    KCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgo/8QAFAABAAAAAAAAAAAAAAAAAAAABv/EABcQAAMBAAAAAAAAAAAAAAAAAAAEQoH/xAAUAQEAAAAAAAAAAAAA\
    AAAAAAAF/8QAGBEAAgMAAAAAAAAAAAAAAAAAAAZDgsL/2gAIAQAAAD8AJNxp/9oACAEBEQA/AEU2euj/2gAIAQIRAD8AWd4LZP/Z";

/// A PNG file of `side` by `side` pixels without compression.
pub(crate) fn png(side: u32, pixel: impl Fn(u32, u32) -> [u8; 3]) -> Vec<u8> {
    let pixels: Vec<u8> =
        (0..side).flat_map(|y| (0..side).map(move |x| (x, y))).flat_map(|(x, y)| pixel(x, y)).collect();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, side, side);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::NoCompression);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&pixels).expect("all pixels");
    writer.finish().expect("an end");
    bytes
}

pub(crate) fn data(kind: &str, bytes: &[u8]) -> String {
    format!("data:{kind};base64,{}", STANDARD.encode(bytes))
}

/// Light and dark tiles.
fn tiles(x: u32, y: u32) -> [u8; 3] {
    if (x + y).is_multiple_of(2) { [230, 220, 200] } else { [60, 70, 90] }
}

/// Roughness in green, metalness in blue: polished metal to rough paint.
fn wear(x: u32, y: u32) -> [u8; 3] {
    [0, 70 + 50 * (x + y) as u8, if x == 0 { 255 } else { 30 }]
}

/// Normals of bumps, four by four texels each, steepest between them.
fn bumps(x: u32, y: u32) -> [u8; 3] {
    let slope = |at: u32| [-0.4_f32, -0.2, 0.2, 0.4][(at % 4) as usize];
    let (along, across) = (slope(x), -slope(y));
    [along, across, (1.0 - along * along - across * across).sqrt()].map(|c| (127.5 * (c + 1.0)) as u8)
}

impl Builder {
    /// A square plate with coordinates from 0 to `turns` across it, in two sets of which the second is turned around.
    fn covered(&mut self, plate: [[f32; 3]; 3], turns: f32, material: usize) -> Value {
        const SIDE: u16 = 2;
        let mut plate = self.plate(plate, SIDE, material);
        let at = |k: u16| turns * f32::from(k) / f32::from(SIDE);
        let uvs: Vec<_> = (0..=SIDE).flat_map(|j| (0..=SIDE).map(move |i| [at(i), turns - at(j)])).collect();
        let turned: Vec<_> = uvs.iter().map(|[u, v]| [turns - u, *v]).collect();
        plate["attributes"]["TEXCOORD_0"] = json!(self.vectors(&uvs));
        plate["attributes"]["TEXCOORD_1"] = json!(self.vectors(&turned));
        plate
    }

    /// A tube of radius and height 1 about y, with the normals of a round one.
    fn tube(&mut self, sides: u16, material: usize) -> Value {
        let around = |i: u16| (TAU * f32::from(i) / f32::from(sides)).sin_cos();
        let ring = |y: f32| (0..=sides).map(move |i| (around(i), y));
        let all: Vec<_> = ring(0.0).chain(ring(1.0)).collect();
        let points: Vec<_> = all.iter().map(|((sine, cosine), y)| [*sine, *y, *cosine]).collect();
        let normals: Vec<_> = all.iter().map(|((sine, cosine), _)| [*sine, 0.0, *cosine]).collect();
        let upper = sides + 1;
        let indices: Vec<u16> =
            (0..sides).flat_map(|i| [i, i + 1, i + 1 + upper, i, i + 1 + upper, i + upper]).collect();
        json!({
            "attributes": { "POSITION": self.points(&points), "NORMAL": self.vectors(&normals) },
            "indices": self.indices(&indices), "material": material,
        })
    }
}

/// A floor of tiles, a wall with bumps and a picture, a worn plate of brass before it, and a tube.
pub(crate) fn textured() -> Value {
    let mut builder = Builder::default();
    let room = [
        builder.covered([[-1.0, 0.0, 1.0], [2.0, 0.0, 0.0], [0.0, 0.0, -2.0]], 2.5, 0),
        builder.covered([[-1.0, 0.0, -1.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]], 2.0, 1),
        builder.covered([[-0.9, 0.1, -0.25], [0.7, 0.0, -0.4], [0.0, 1.2, 0.0]], 1.0, 2),
    ];
    let tube = builder.tube(10, 3);
    let wear = builder.bytes(&png(2, wear));
    let material = |name: &str, rest: Value| {
        let mut material = rest;
        material["name"] = json!(name);
        material
    };
    let transform = json!({ "offset": [0.25, 0.0], "rotation": 0.5, "scale": [0.75, 0.5] });
    builder.finish(json!({
        "extensionsUsed": ["KHR_lights_punctual", "KHR_texture_transform"],
        "scenes": [{ "name": "textured", "nodes": [0, 1, 2, 3] }],
        "nodes": [
            { "name": "room", "mesh": 0 },
            { "name": "tube", "mesh": 1, "translation": [0.45, 0.0, 0.1], "scale": [-0.3, 0.9, 0.3] },
            { "name": "eye", "camera": 0, "translation": [0.0, 1.0, 4.0] },
            {
                "name": "sun", "rotation": [-0.4, 0.2, 0.1, 0.9],
                "extensions": { "KHR_lights_punctual": { "light": 0 } }
            },
        ],
        "meshes": [{ "name": "plates", "primitives": room }, { "name": "tube", "primitives": [tube] }],
        "images": [
            { "name": "tiles", "uri": data("image/png", &png(4, tiles)) },
            { "name": "picture", "uri": format!("data:image/jpeg;base64,{JPEG}") },
            { "name": "wear", "bufferView": wear, "mimeType": "image/png" },
            { "name": "bumps", "uri": data("image/png", &png(8, bumps)) },
        ],
        "samplers": [
            { "magFilter": 9728 }, { "magFilter": 9729, "wrapS": 33648, "wrapT": 33071 },
            { "wrapS": 33071, "wrapT": 33071 },
        ],
        "textures": [
            { "source": 0, "sampler": 0 }, { "source": 1, "sampler": 1 }, { "source": 2, "sampler": 2 },
            { "source": 3 },
        ],
        "materials": [
            material("tiles", json!({ "pbrMetallicRoughness": {
                "baseColorTexture": { "index": 0 }, "metallicFactor": 0.0, "roughnessFactor": 0.5,
            } })),
            material("wall", json!({
                "pbrMetallicRoughness": {
                    "baseColorTexture": { "index": 1, "texCoord": 1 }, "baseColorFactor": [0.9, 0.8, 0.7, 1.0],
                    "metallicFactor": 0.0, "roughnessFactor": 0.5,
                },
                "normalTexture": { "index": 3, "scale": 0.75 },
            })),
            material("brass", json!({ "doubleSided": true, "pbrMetallicRoughness": {
                "baseColorFactor": [1.0, 0.75, 0.25, 1.0],
                "metallicRoughnessTexture": { "index": 2, "extensions": { "KHR_texture_transform": transform } },
            } })),
            material("glaze", json!({ "pbrMetallicRoughness": {
                "baseColorFactor": [0.2, 0.5, 0.3, 1.0], "metallicFactor": 0.0, "roughnessFactor": 0.4,
            } })),
        ],
        "cameras": [{ "name": "eye", "type": "perspective", "perspective": { "yfov": 0.75, "znear": 0.1 } }],
        "extensions": { "KHR_lights_punctual": { "lights": [{ "type": "directional", "intensity": 3.0 }] } },
    }))
}
