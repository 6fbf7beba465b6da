//! Meshes as triangles of the world.

use super::buffers::Buffers;
use super::elements;
use super::materials::Materials;
use super::nodes::Placed;
use super::notes::Notes;
use crate::scene::limits::{PLACES, refused};
use crate::scene::{SceneError, Triangle};
use gltf::mesh::Mode;
use gltf::{Primitive, Semantic};
use lobe_codegen::glam::{DMat4, DVec3, Vec3};

/// The most triangles of a scene, and a third of the most vertices: a mesh may be placed many times by few bytes.
const MOST_TRIANGLES: usize = 1 << 23;

/// A triangle whose height is this share of its longest side, or less, has no plane.
const LEAST_HEIGHT: f64 = 1e-6;

/// Reads meshes where nodes place them.
pub(super) struct Meshes<'a> {
    buffers: &'a Buffers,
    materials: &'a mut Materials,
    notes: &'a mut Notes,
    triangles: Vec<Triangle>,
    /// Vertices and triangles that may still come.
    left: [usize; 2],
    /// Triangles without a plane.
    flat: usize,
}

impl<'a> Meshes<'a> {
    pub(super) fn new(buffers: &'a Buffers, materials: &'a mut Materials, notes: &'a mut Notes) -> Self {
        Self {
            buffers,
            materials,
            notes,
            triangles: Vec::new(),
            left: [3 * MOST_TRIANGLES, MOST_TRIANGLES],
            flat: 0,
        }
    }

    /// The triangles of all nodes, at least one.
    pub(super) fn triangles(mut self, nodes: &[Placed]) -> Result<Vec<Triangle>, SceneError> {
        for placed in nodes {
            let Some(mesh) = placed.node.mesh() else { continue };
            if placed.node.skin().is_some() {
                self.notes.say("skins are passed over, meshes stand as they were bound", placed.at());
            }
            for primitive in mesh.primitives() {
                let at = place(&mesh, &primitive);
                self.add(&at, &primitive, placed.to_world)?;
            }
        }
        if self.flat > 0 {
            let n = self.flat;
            self.notes.say(&format!("triangles without an area are left out, {n} of them"), "");
        }
        match self.triangles.is_empty() {
            true => Err(SceneError::Missing { what: "triangle", add: ADD }),
            false => Ok(self.triangles),
        }
    }

    fn add(&mut self, at: &str, primitive: &Primitive, to_world: DMat4) -> Result<(), SceneError> {
        if matches!(primitive.mode(), Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip) {
            self.notes.say("points and lines are passed over", at);
            return Ok(());
        }
        if primitive.morph_targets().len() > 0 {
            self.notes.say("morph targets are passed over", at);
        }
        let points = self.points(at, primitive, to_world)?;
        let indices = self.indices(at, primitive, points.len())?;
        let corners = corners(primitive.mode(), &indices);
        self.spend(at, points.len(), corners.len())?;
        let (material, two_sided) = self.materials.of(primitive, self.notes)?;
        let mirrored = to_world.determinant() < 0.0;
        for corners in corners {
            let [a, b, c] = corners.map(|index| points[index as usize]);
            let vertices = if mirrored { [a, c, b] } else { [a, b, c] };
            match normal(vertices) {
                Some(normal) => self.triangles.push(Triangle { vertices, normal, material, two_sided }),
                None => self.flat += 1,
            }
        }
        Ok(())
    }

    fn points(&self, at: &str, primitive: &Primitive, to_world: DMat4) -> Result<Vec<Vec3>, SceneError> {
        let Some(accessor) = primitive.get(&Semantic::Positions) else {
            return refused(at, "it has no attribute POSITION");
        };
        let placed = |(index, point): (usize, [f32; 3])| {
            let point = DVec3::from_array(point.map(f64::from));
            let world = to_world.transform_point3(point);
            match world.to_array().iter().all(|x| PLACES.contains(x)) {
                true => Ok(world.as_vec3()),
                false => refused(
                    at,
                    format!("vertex {index}, {point}, is {world} in the world, not a number up to 1e9 m"),
                ),
            }
        };
        elements::points(&accessor, self.buffers)?.into_iter().enumerate().map(placed).collect()
    }

    /// Indices of vertices, each of one that is there.
    fn indices(&self, at: &str, primitive: &Primitive, count: usize) -> Result<Vec<u32>, SceneError> {
        let Some(accessor) = primitive.indices() else { return Ok((0..count as u32).collect()) };
        let indices = elements::indices(&accessor, self.buffers)?;
        match indices.iter().position(|&index| index as usize >= count) {
            Some(i) => refused(at, format!("index {i} is vertex {}, and there are {count}", indices[i])),
            None => Ok(indices),
        }
    }

    fn spend(&mut self, at: &str, vertices: usize, triangles: usize) -> Result<(), SceneError> {
        let [all_vertices, all_triangles] = self.left;
        match (all_vertices.checked_sub(vertices), all_triangles.checked_sub(triangles)) {
            (Some(vertices), Some(triangles)) => self.left = [vertices, triangles],
            _ => {
                let most = format!("{MOST_TRIANGLES} triangles, or three times as many vertices");
                return refused(at, format!("with it the scene has more than {most}; split the scene"));
            }
        }
        Ok(())
    }
}

const ADD: &str = "a node of the scene needs a mesh with an area";

fn place(mesh: &gltf::Mesh, primitive: &Primitive) -> String {
    let name = mesh.name().map(|name| format!(" ({name})")).unwrap_or_default();
    format!("meshes[{}]{name}.primitives[{}]", mesh.index(), primitive.index())
}

/// The corners of each triangle. What is left over of a list makes none.
fn corners(mode: Mode, indices: &[u32]) -> Vec<[u32; 3]> {
    let threes = || indices.windows(3).map(|three| [three[0], three[1], three[2]]);
    match mode {
        Mode::TriangleStrip => {
            let turned = |(i, [a, b, c]): (usize, [u32; 3])| if i % 2 == 0 { [a, b, c] } else { [a, c, b] };
            threes().enumerate().map(turned).collect()
        }
        Mode::TriangleFan => {
            let hub = indices.first().copied().unwrap_or_default();
            threes().map(|[_, b, c]| [b, c, hub]).collect()
        }
        _ => indices.as_chunks().0.to_vec(),
    }
}

/// Unit normal of a triangle; `None` if it has no area to speak of.
fn normal(vertices: [Vec3; 3]) -> Option<Vec3> {
    let [a, b, c] = vertices.map(|vertex| vertex.as_dvec3());
    let across = (b - a).cross(c - a);
    let longest = (b - a).length_squared().max((c - b).length_squared()).max((a - c).length_squared());
    if across.length() <= LEAST_HEIGHT * longest {
        return None;
    }
    across.try_normalize().map(|normal| normal.as_vec3())
}
