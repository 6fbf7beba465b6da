//! The JSON format.

use super::limits::{
    self, ALPHAS, LEAST_BLEND_DEGREES, OUTER_DEGREES, POWERS, SHARES, direction, number, place, refused,
    triple,
};
use super::{Camera, Details, FORMAT, Light, Material, Scene, SceneError, Surface};
use serde::Deserialize;
use serde::de::{Deserializer, MapAccess, Visitor};

type Triple = [f64; 3];

#[derive(Deserialize)]
struct Text {
    format: String,
    #[serde(default)]
    name: String,
    camera: CameraText,
    lights: Vec<LightText>,
    materials: Materials,
    rects: Vec<RectText>,
}

#[derive(Deserialize)]
struct CameraText {
    position: Triple,
    look_at: Triple,
    up: Triple,
    vfov_deg: f64,
    width: u32,
    height: u32,
}

#[derive(Deserialize)]
#[serde(tag = "type", rename_all = "lowercase")]
enum LightText {
    Directional { direction: Triple, irradiance: Triple },
    Spot { position: Triple, direction: Triple, cone_inner_deg: f64, cone_outer_deg: f64, intensity: Triple },
}

#[derive(Deserialize)]
struct MaterialText {
    diffuse_albedo: Triple,
    specular_f0: Triple,
    specular_f90: f64,
    ggx_alpha: f64,
}

#[derive(Deserialize)]
struct RectText {
    #[serde(default)]
    name: String,
    center: Triple,
    half_u: Triple,
    half_v: Triple,
    normal: Option<Triple>,
    material: String,
}

/// Materials by name; a map would keep the last of two of one name, without a word.
struct Materials(Vec<(String, MaterialText)>);

impl<'de> Deserialize<'de> for Materials {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Entries;
        impl<'de> Visitor<'de> for Entries {
            type Value = Materials;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str("materials by their names")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Materials, A::Error> {
                let mut entries = Vec::new();
                while let Some(entry) = map.next_entry()? {
                    entries.push(entry);
                }
                Ok(Materials(entries))
            }
        }
        deserializer.deserialize_map(Entries)
    }
}

impl Scene {
    /// Reads a scene of the format `glossy-oracle-scene/1`.
    ///
    /// # Errors
    /// When the text is no JSON of this form, or a number is out of its range.
    pub fn from_json(text: &str) -> Result<Self, SceneError> {
        let text: Text = serde_json::from_str(text).map_err(|error| SceneError::Json {
            line: error.line(),
            column: error.column(),
            message: without_place(&error.to_string()),
        })?;
        if text.format != FORMAT {
            return Err(SceneError::Format { found: text.format });
        }
        let materials = materials(text.materials)?;
        Ok(Self {
            name: text.name,
            camera: camera(&text.camera)?,
            lights: some("lights", text.lights, |at, light| self::light(&at, &light))?,
            rectangles: some("rects", text.rects, |at, rect| surface(&at, rect, &materials))?,
            triangles: Vec::new(),
            details: Details::default(),
            notes: Vec::new(),
            materials,
        })
    }
}

/// The message without the place, which stands before it.
fn without_place(message: &str) -> String {
    message.rsplit_once(" at line ").map_or(message, |(message, _)| message).to_owned()
}

/// All entries of a list that may not be empty.
fn some<T, U>(
    name: &str,
    entries: Vec<T>,
    read: impl Fn(String, T) -> Result<U, SceneError>,
) -> Result<Vec<U>, SceneError> {
    if entries.is_empty() {
        return refused(name, "there is none, so there is nothing to see");
    }
    entries.into_iter().enumerate().map(|(i, entry)| read(format!("{name}[{i}]"), entry)).collect()
}

fn camera(text: &CameraText) -> Result<Camera, SceneError> {
    let position = place("camera.position", text.position)?;
    let target = place("camera.look_at", text.look_at)?;
    let up = direction("camera.up", text.up)?;
    let vfov = limits::view_angle("camera.vfov_deg", text.vfov_deg)?;
    let size = limits::picture([text.width, text.height])?;
    limits::camera("camera", [position, target, up], vfov, size)
}

fn light(at: &str, text: &LightText) -> Result<Light, SceneError> {
    let name = |member: &str| format!("{at}.{member}");
    match *text {
        LightText::Directional { direction: travel, irradiance } => Ok(Light::Directional {
            to_light: -direction(&name("direction"), travel)?.as_vec3(),
            irradiance: triple(&name("irradiance"), irradiance, &POWERS)?,
        }),
        LightText::Spot { position, direction: axis, cone_inner_deg, cone_outer_deg, intensity } => {
            number(&name("cone_outer_deg"), cone_outer_deg, &OUTER_DEGREES)?;
            let inner = 0.0..=cone_outer_deg - LEAST_BLEND_DEGREES;
            number(&name("cone_inner_deg"), cone_inner_deg, &inner)?;
            Ok(Light::Spot {
                position: place(&name("position"), position)?.as_vec3(),
                axis: direction(&name("direction"), axis)?.as_vec3(),
                inner: cone_inner_deg.to_radians() as f32,
                outer: cone_outer_deg.to_radians() as f32,
                intensity: triple(&name("intensity"), intensity, &POWERS)?,
            })
        }
    }
}

fn materials(text: Materials) -> Result<Vec<(String, Material)>, SceneError> {
    let mut materials: Vec<(String, Material)> = Vec::new();
    for (name, text) in text.0 {
        let at = format!("materials.{name}");
        if materials.iter().any(|(other, _)| *other == name) {
            return refused(&at, "there are two of this name; rename one");
        }
        let part = |member: &str| format!("{at}.{member}");
        let material = Material {
            diffuse_albedo: triple(&part("diffuse_albedo"), text.diffuse_albedo, &SHARES)?,
            f0: triple(&part("specular_f0"), text.specular_f0, &SHARES)?,
            f90: number(&part("specular_f90"), text.specular_f90, &SHARES)?,
            alpha: number(&part("ggx_alpha"), text.ggx_alpha, &ALPHAS)?,
        };
        materials.push((name, material));
    }
    Ok(materials)
}

/// Half the sides of the smallest rectangle, m.
const LEAST_HALF: f64 = 1e-6;
/// The largest cosine of the angle between its sides, and sine of that between a stated normal and theirs.
const SLANT: f64 = 1e-4;

fn surface(at: &str, text: RectText, materials: &[(String, Material)]) -> Result<Surface, SceneError> {
    let name = |member: &str| format!("{at}.{member}");
    let center = place(&name("center"), text.center)?;
    let half_u = place(&name("half_u"), text.half_u)?;
    let half_v = place(&name("half_v"), text.half_v)?;
    for (member, half) in [("half_u", half_u), ("half_v", half_v)] {
        if half.length() < LEAST_HALF {
            return refused(
                &name(member),
                format!("it is shorter than {LEAST_HALF} m; a rectangle has two sides"),
            );
        }
    }
    let (u, v) = (half_u.normalize(), half_v.normalize());
    if u.dot(v).abs() > SLANT {
        return refused(
            &name("half_v"),
            "it is not perpendicular to half_u; parallelograms are not known here",
        );
    }
    let normal = u.cross(v).normalize();
    if let Some(stated) = text.normal {
        let stated = direction(&name("normal"), stated)?;
        if stated.cross(normal).length() > SLANT || stated.dot(normal) < 0.0 {
            return refused(
                &name("normal"),
                format!("half_u x half_v points along {normal}; leave it out, or swap them"),
            );
        }
    }
    let Some(material) = materials.iter().position(|(name, _)| *name == text.material) else {
        let known: Vec<&str> = materials.iter().map(|(name, _)| name.as_str()).collect();
        return refused(
            &name("material"),
            format!("there is no `{}`; there are: {}", text.material, known.join(", ")),
        );
    };
    Ok(Surface {
        name: text.name,
        center: center.as_vec3(),
        half_u: half_u.as_vec3(),
        half_v: half_v.as_vec3(),
        normal: normal.as_vec3(),
        material,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use lobe_codegen::glam::Vec3;
    use serde_json::{Value, json};

    /// A floor under a light and a cone, from above.
    fn sound() -> Value {
        json!({
            "format": FORMAT,
            "name": "floor",
            "note": "what is not of the format is passed over",
            "camera": {
                "position": [0, 2, 2], "look_at": [0, 0, 0], "up": [0, 1, 0], "vfov_deg": 40, "width": 8, "height": 4
            },
            "lights": [
                { "type": "directional", "direction": [0, -2, 0], "irradiance": [1, 2, 3] },
                {
                    "type": "spot", "position": [0, 3, 0], "direction": [0, -1, 0], "cone_inner_deg": 10,
                    "cone_outer_deg": 20, "intensity": [5, 5, 5]
                }
            ],
            "materials": {
                "grey": {
                    "diffuse_albedo": [0.5, 0.5, 0.5], "specular_f0": [0.04, 0.04, 0.04], "specular_f90": 1,
                    "ggx_alpha": 0.2
                }
            },
            "rects": [
                { "center": [0, 0, 0], "half_u": [0, 0, 1], "half_v": [1, 0, 0], "normal": [0, 1, 0], "material": "grey" }
            ]
        })
    }

    #[test]
    fn a_scene_is_read() {
        let scene = Scene::from_json(&sound().to_string()).unwrap();
        assert_eq!((scene.name.as_str(), scene.camera.size), ("floor", [8, 4]));
        let Light::Directional { to_light, irradiance } = scene.lights[0] else { panic!("{scene:?}") };
        assert_eq!((to_light, irradiance), (Vec3::Y, Vec3::new(1.0, 2.0, 3.0)));
        let Light::Spot { inner, outer, .. } = scene.lights[1] else { panic!("{scene:?}") };
        assert_eq!((inner, outer), (10f32.to_radians(), 20f32.to_radians()));
        assert_eq!((scene.rectangles[0].normal, scene.rectangles[0].material), (Vec3::Y, 0));
        assert_eq!(scene.materials[0].1.alpha, 0.2);
    }

    /// What is refused of the sound scene with `value` at the place `pointer`.
    fn with(pointer: &str, value: Value) -> SceneError {
        let mut scene = sound();
        *scene.pointer_mut(pointer).unwrap() = value;
        Scene::from_json(&scene.to_string()).unwrap_err()
    }

    #[test]
    fn what_is_wrong_is_named() {
        for (pointer, value, message) in [
            ("/format", json!("glossy-oracle-scene/2"), "the format is \"glossy-oracle-scene/2\""),
            ("/camera/position", json!([0, 0, 0]), "camera: it looks at itself"),
            ("/camera/up", json!([0, 0, 0]), "camera.up: it has no direction"),
            ("/camera/up", json!([0, 1, 1]), "camera: it looks at itself, or along its up"),
            ("/camera/vfov_deg", json!(180), "camera.vfov_deg: 180 is not in"),
            ("/camera/width", json!(0), "camera.width: 0 is not in 1"),
            ("/lights", json!([]), "lights: there is none"),
            ("/lights/0/direction", json!([0, 0, 0]), "lights[0].direction: it has no direction"),
            ("/lights/0/irradiance", json!([1, -1, 1]), "lights[0].irradiance: -1 is not in"),
            ("/lights/1/cone_inner_deg", json!(20), "lights[1].cone_inner_deg: 20 is not in"),
            ("/lights/1/cone_outer_deg", json!(90), "lights[1].cone_outer_deg: 90 is not in"),
            ("/materials/grey/ggx_alpha", json!(0), "materials.grey.ggx_alpha: 0 is not in 0.02"),
            ("/materials/grey/ggx_alpha", json!(1.5), "materials.grey.ggx_alpha: 1.5 is not in"),
            ("/materials/grey/diffuse_albedo", json!([0, 2, 0]), "materials.grey.diffuse_albedo: 2 is not"),
            ("/rects", json!([]), "rects: there is none"),
            ("/rects/0/half_u", json!([0, 0, 0]), "rects[0].half_u: it is shorter"),
            ("/rects/0/half_u", json!([0.5, 0, 1]), "rects[0].half_v: it is not perpendicular"),
            ("/rects/0/normal", json!([0, -1, 0]), "rects[0].normal: half_u x half_v points along"),
            ("/rects/0/center", json!([1e300, 0, 0]), "rects[0].center: 1"),
            ("/rects/0/material", json!("gold"), "rects[0].material: there is no `gold`; there are: grey"),
            ("/lights/0/type", json!("area"), "unknown variant `area`"),
            ("/rects/0/center", json!([0, 0]), "invalid length 2"),
        ] {
            let said = with(pointer, value).to_string();
            assert!(said.contains(message), "{said} // {message}");
        }
    }

    #[test]
    fn text_that_is_no_scene_has_a_line() {
        let error = Scene::from_json("{\n  \"format\": }").unwrap_err();
        assert!(matches!(&error, SceneError::Json { line: 2, .. }), "{error}");
        let twice = sound().to_string().replacen("\"grey\":{", "\"grey\":{\"diffuse_albedo\":[0,0,0],\"specular_f0\":[0,0,0],\"specular_f90\":0,\"ggx_alpha\":1},\"grey\":{", 1);
        let said = Scene::from_json(&twice).unwrap_err().to_string();
        assert!(said.contains("materials.grey: there are two"), "{said}");
    }
}
