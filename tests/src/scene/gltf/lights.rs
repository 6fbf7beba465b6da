//! Lights of `KHR_lights_punctual`.

use super::nodes::Placed;
use super::notes::Notes;
use crate::scene::limits::{LEAST_BLEND_DEGREES, OUTER_DEGREES, POWERS, triple};
use crate::scene::{Light, SceneError};
use gltf::khr_lights_punctual::Kind;
use lobe_codegen::glam::{DVec3, Vec3};

/// The lights of all nodes, or `otherwise`.
pub(super) fn all(
    nodes: &[Placed],
    otherwise: Option<Light>,
    notes: &mut Notes,
) -> Result<Vec<Light>, SceneError> {
    let mut lights = Vec::new();
    for placed in nodes {
        if let Some(found) = placed.node.light() {
            lights.push(light(placed, &found, notes)?);
        }
    }
    if lights.is_empty() {
        lights.extend(otherwise);
    }
    match lights.is_empty() {
        true => Err(SceneError::Missing { what: "light", add: ADD }),
        false => Ok(lights),
    }
}

const ADD: &str = "give a node a directional light or a spotlight of KHR_lights_punctual";

fn light(
    placed: &Placed,
    light: &gltf::khr_lights_punctual::Light,
    notes: &mut Notes,
) -> Result<Light, SceneError> {
    let at = format!("{}, extensions.KHR_lights_punctual.lights[{}]", placed.at(), light.index());
    // glTF has colours in shares of an intensity, and lights that shine along -z.
    let power = light.color().map(|share| f64::from(share) * f64::from(light.intensity()));
    let power = triple(&format!("{at}.intensity"), power, &POWERS)?;
    if light.range().is_some() {
        notes.say(
            "the range of a light is passed over, it falls off with the square of the distance",
            placed.at(),
        );
    }
    match light.kind() {
        Kind::Directional => {
            Ok(Light::Directional { to_light: placed.direction(DVec3::Z)?.as_vec3(), irradiance: power })
        }
        Kind::Spot { inner_cone_angle, outer_cone_angle } => {
            spot(placed, power, [inner_cone_angle, outer_cone_angle], notes)
        }
        Kind::Point => {
            Err(SceneError::Unsupported { at, what: "a point light".to_owned(), instead: INSTEAD })
        }
    }
}

const INSTEAD: &str = "make it a spotlight, or several that look apart";

fn spot(placed: &Placed, intensity: Vec3, angles: [f32; 2], notes: &mut Notes) -> Result<Light, SceneError> {
    let [inner, outer] = angles.map(|angle| f64::from(angle).to_degrees());
    let within = outer.clamp(*OUTER_DEGREES.start(), *OUTER_DEGREES.end());
    let inside = inner.clamp(0.0, within - LEAST_BLEND_DEGREES);
    if inside != inner || (within - outer).abs() > 1e-6 {
        let sentence = format!(
            "a cone is changed to half angles that are known here, {} to {} degrees, the inner one {LEAST_BLEND_DEGREES} \
             narrower",
            OUTER_DEGREES.start(),
            OUTER_DEGREES.end(),
        );
        notes.say(&sentence, placed.at());
    }
    Ok(Light::Spot {
        position: placed.position()?.as_vec3(),
        axis: placed.direction(DVec3::NEG_Z)?.as_vec3(),
        inner: inside.to_radians() as f32,
        outer: within.to_radians() as f32,
        intensity,
    })
}
