//! glTF files that tests read: those of `tests/cases/scenes` without textures, built here.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};

/// Buffers and what points into them.
#[derive(Default)]
pub(crate) struct Builder {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Builder {
    /// Bytes without an accessor; the index of their view.
    pub(crate) fn bytes(&mut self, bytes: &[u8]) -> usize {
        self.views.push(json!({ "buffer": 0, "byteOffset": self.bytes.len(), "byteLength": bytes.len() }));
        self.bytes.extend(bytes);
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        self.views.len() - 1
    }

    fn view(&mut self, bytes: &[u8], accessor: Value) -> usize {
        self.bytes(bytes);
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    /// Vectors of two, three or four numbers.
    pub(crate) fn vectors<const N: usize>(&mut self, vectors: &[[f32; N]]) -> usize {
        let accessor = json!({
            "bufferView": self.views.len(), "componentType": 5126, "count": vectors.len(), "type": format!("VEC{N}"),
        });
        self.view(&vectors.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>(), accessor)
    }

    pub(crate) fn points(&mut self, points: &[[f32; 3]]) -> usize {
        let bound = |pick: fn(f32, f32) -> f32| -> Vec<f32> {
            (0..3).filter_map(|i| points.iter().map(|p| p[i]).reduce(pick)).collect()
        };
        let accessor = json!({
            "bufferView": self.views.len(), "componentType": 5126, "count": points.len(), "type": "VEC3",
            "min": bound(f32::min), "max": bound(f32::max),
        });
        self.view(&points.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>(), accessor)
    }

    pub(crate) fn indices(&mut self, indices: &[u16]) -> usize {
        let accessor = json!({
            "bufferView": self.views.len(), "componentType": 5123, "count": indices.len(), "type": "SCALAR",
        });
        self.view(&indices.iter().flat_map(|i| i.to_le_bytes()).collect::<Vec<u8>>(), accessor)
    }

    /// A plate `corner + s u + t v`, s and t in 0 ..= 1, of `n` by `n` squares.
    pub(crate) fn plate(&mut self, [corner, u, v]: [[f32; 3]; 3], n: u16, material: usize) -> Value {
        let at = |i: u16, j: u16| {
            let [s, t] = [i, j].map(|k| f32::from(k) / f32::from(n));
            [0, 1, 2].map(|axis| corner[axis] + s * u[axis] + t * v[axis])
        };
        let points: Vec<_> = (0..=n).flat_map(|j| (0..=n).map(move |i| at(i, j))).collect();
        let square = |i: u16, j: u16| {
            let a = j * (n + 1) + i;
            [a, a + 1, a + n + 2, a, a + n + 2, a + n + 1]
        };
        let indices: Vec<u16> = (0..n).flat_map(|j| (0..n).flat_map(move |i| square(i, j))).collect();
        json!({
            "attributes": { "POSITION": self.points(&points) }, "indices": self.indices(&indices),
            "material": material,
        })
    }

    /// The file, with `rest` beside the buffers.
    pub(crate) fn finish(self, mut rest: Value) -> Value {
        rest["asset"] = json!({ "version": "2.0" });
        rest["scene"] = json!(0);
        rest["extensionsUsed"] = match rest["extensionsUsed"].take() {
            Value::Null => json!(["KHR_lights_punctual"]),
            used => used,
        };
        rest["accessors"] = json!(self.accessors);
        rest["bufferViews"] = json!(self.views);
        let uri = format!("data:application/octet-stream;base64,{}", STANDARD.encode(&self.bytes));
        rest["buffers"] = json!([{ "byteLength": self.bytes.len(), "uri": uri }]);
        rest
    }
}

/// Three walls and a floor of 42 triangles, with a golden plate of 8 in the middle, from the front.
pub(crate) fn room() -> Value {
    let mut builder = Builder::default();
    let primitives = [
        builder.plate([[-1.0, 0.0, 1.0], [2.0, 0.0, 0.0], [0.0, 0.0, -2.0]], 3, 0),
        builder.plate([[-1.0, 0.0, -1.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]], 2, 0),
        builder.plate([[-1.0, 0.0, 1.0], [0.0, 0.0, -2.0], [0.0, 2.0, 0.0]], 2, 1),
        builder.plate([[1.0, 0.0, -1.0], [0.0, 0.0, 2.0], [0.0, 2.0, 0.0]], 2, 0),
        builder.plate([[-0.5, 0.25, 0.0], [0.75, 0.0, 0.5], [0.0, 1.0, 0.0]], 2, 2),
    ];
    let material = |name: &str, colour: [f32; 3], metallic: f32, roughness: f32| {
        let [r, g, b] = colour;
        json!({ "name": name, "doubleSided": metallic > 0.0, "pbrMetallicRoughness": {
            "baseColorFactor": [r, g, b, 1.0], "metallicFactor": metallic, "roughnessFactor": roughness,
        } })
    };
    let sun = json!({ "type": "directional", "color": [1.0, 1.0, 0.5], "intensity": 3.0 });
    let camera =
        json!({ "name": "eye", "type": "perspective", "perspective": { "yfov": 0.75, "znear": 0.1 } });
    builder.finish(json!({
        "scenes": [{ "name": "room", "nodes": [0, 1, 2] }],
        "nodes": [
            { "name": "room", "mesh": 0 },
            { "name": "eye", "camera": 0, "translation": [0.0, 1.0, 4.0] },
            { "name": "sun", "extensions": { "KHR_lights_punctual": { "light": 0 } } },
        ],
        "meshes": [{ "name": "plates", "primitives": primitives }],
        "materials": [
            material("white", [0.75, 0.75, 0.75], 0.0, 0.5), material("red", [0.75, 0.25, 0.25], 0.0, 0.5),
            material("gold", [1.0, 0.75, 0.25], 1.0, 0.125),
        ],
        "cameras": [camera],
        "extensions": { "KHR_lights_punctual": { "lights": [sun] } },
    }))
}

/// A square as a strip and as a fan, and the strip a second time by a node that mirrors, under a spotlight; no camera.
pub(crate) fn plates() -> Value {
    let mut builder = Builder::default();
    let strip = builder.points(&[[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [-1.0, 1.0, 0.0], [1.0, 1.0, 0.0]]);
    let fan = builder.points(&[[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]]);
    let mesh = |points: usize, mode: u32| json!({ "primitives": [{ "attributes": { "POSITION": points }, "mode": mode }] });
    let spot = json!({ "type": "spot", "intensity": 10.0, "spot": { "innerConeAngle": 0.25, "outerConeAngle": 0.5 } });
    builder.finish(json!({
        "scenes": [{ "nodes": [0] }],
        "nodes": [
            { "children": [1, 2, 3, 4] },
            { "mesh": 0 },
            { "mesh": 1, "translation": [2.5, 0.0, 0.0] },
            { "mesh": 0, "scale": [-1.0, 1.0, 1.0], "translation": [-2.5, 0.0, 0.0] },
            { "translation": [0.0, 0.0, 3.0], "extensions": { "KHR_lights_punctual": { "light": 0 } } },
        ],
        "meshes": [mesh(strip, 5), mesh(fan, 6)],
        "extensions": { "KHR_lights_punctual": { "lights": [spot] } },
    }))
}

/// The bytes of a file's buffer.
pub(crate) fn bytes(file: &Value) -> Vec<u8> {
    let uri = file["buffers"][0]["uri"].as_str().expect("a URI");
    STANDARD.decode(uri.split_once(',').expect("data").1).expect("base64")
}

/// A file as `.glb`.
pub(crate) fn binary(file: &Value) -> Vec<u8> {
    let mut json = file.clone();
    json["buffers"] = json!([{ "byteLength": bytes(file).len() }]);
    let mut text = json.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut chunks = Vec::new();
    for (kind, chunk) in [(b"JSON", text), (b"BIN\0", bytes(file))] {
        chunks.extend((chunk.len() as u32).to_le_bytes());
        chunks.extend(kind);
        chunks.extend(chunk);
    }
    let length = (12 + chunks.len() as u32).to_le_bytes();
    [&b"glTF"[..], &2u32.to_le_bytes(), &length, &chunks].concat()
}
