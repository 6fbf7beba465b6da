//! The camera: one of the file's, or one that sees everything.

use super::Choices;
use super::nodes::Placed;
use super::notes::Notes;
use crate::scene::limits::{self, refused};
use crate::scene::{Camera, SceneError, Triangle};
use gltf::camera::Projection;
use lobe_codegen::glam::DVec3;

/// From where a camera is placed that the file does not have, as seen from the middle.
const ASIDE: DVec3 = DVec3::new(0.5, 0.4, 1.0);
/// Its angle from the bottom of the picture to its top, in degrees.
const VIEW_DEGREES: f64 = 40.0;

/// The camera that was chosen.
pub(super) fn camera(
    nodes: &[Placed],
    choices: &Choices,
    triangles: &[Triangle],
    notes: &mut Notes,
) -> Result<Camera, SceneError> {
    let size = limits::picture(choices.size)?;
    let found = nodes
        .iter()
        .find_map(|placed| Some((placed, vertical(placed)?)).filter(|_| is_wanted(placed, choices)));
    match (found, &choices.camera) {
        (Some((placed, angle)), _) => of_node(placed, angle, size),
        (None, Some(name)) => refused("cameras", no_such(name, nodes)),
        (None, None) => {
            notes.say("there is no perspective camera, so one was placed that sees everything", "");
            overview(triangles, size)
        }
    }
}

fn is_wanted(placed: &Placed, choices: &Choices) -> bool {
    choices.camera.as_deref().is_none_or(|wanted| names(placed).contains(&Some(wanted)))
}

/// What a camera goes by.
fn names<'a>(placed: &Placed<'a>) -> [Option<&'a str>; 2] {
    [placed.node.camera().and_then(|camera| camera.name()), placed.node.name()]
}

/// The vertical angle of a perspective camera, in radians.
fn vertical(placed: &Placed) -> Option<f64> {
    match placed.node.camera()?.projection() {
        Projection::Perspective(perspective) => Some(f64::from(perspective.yfov())),
        Projection::Orthographic(_) => None,
    }
}

fn no_such(name: &str, nodes: &[Placed]) -> String {
    let known: Vec<&str> = nodes
        .iter()
        .filter(|placed| vertical(placed).is_some())
        .map(|placed| names(placed).into_iter().flatten().next().unwrap_or("one without a name"))
        .collect();
    format!("there is no perspective camera `{name}`; there are: {}", known.join(", "))
}

fn of_node(placed: &Placed, angle: f64, size: [u32; 2]) -> Result<Camera, SceneError> {
    let at = placed.at();
    let angle = limits::view_angle(&format!("{at}, yfov in degrees"), angle.to_degrees())?;
    let position = placed.position()?;
    let target = position + placed.direction(DVec3::NEG_Z)?;
    limits::camera(&at, [position, target, placed.direction(DVec3::Y)?], angle, size)
}

fn overview(triangles: &[Triangle], size: [u32; 2]) -> Result<Camera, SceneError> {
    let points = || triangles.iter().flat_map(|triangle| triangle.vertices.map(|vertex| vertex.as_dvec3()));
    let (low, high) = points()
        .fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), point| (low.min(point), high.max(point)));
    let (middle, radius) = (0.5 * (low + high), 0.5 * (high - low).length());
    let [width, height] = size.map(f64::from);
    let angle = VIEW_DEGREES.to_radians();
    // The smaller of the two angles must hold the sphere around everything.
    let half = (0.5 * angle).tan().atan2(1.0).min(((0.5 * angle).tan() * width / height).atan());
    let position = middle + ASIDE.normalize() * radius / half.sin();
    limits::camera("camera", [position, middle, DVec3::Y], angle, size)
}
