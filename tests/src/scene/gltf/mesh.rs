//! Meshes as triangles of the world.

use super::Files;
use super::buffers::Buffers;
use super::corners::{Faces, Found};
use super::elements::{self, POSITIONS};
use super::images::Images;
use super::materials::Materials;
use super::nodes::Placed;
use super::notes::Notes;
use crate::scene::limits::{PLACES, refused};
use crate::scene::{Detail, Details, SceneError, Triangle};
use gltf::mesh::Mode;
use gltf::{Document, Primitive, Semantic};
use lobe_codegen::glam::{DMat4, DVec3, Vec3};

/// The most triangles of a scene, and a third of the most vertices: a mesh may be placed many times by few bytes.
const MOST_TRIANGLES: usize = 1 << 23;

/// A triangle whose height is this share of its longest side, or less, has no plane.
const LEAST_HEIGHT: f64 = 1e-6;

/// Reads meshes where nodes place them.
pub(super) struct Meshes<'a> {
    document: &'a Document,
    buffers: &'a Buffers,
    images: Images<'a>,
    materials: &'a mut Materials,
    notes: &'a mut Notes,
    triangles: Vec<Triangle>,
    details: Details,
    /// Vertices and triangles that may still come.
    left: [usize; 2],
    /// Triangles without a plane.
    flat: usize,
}

impl<'a> Meshes<'a> {
    pub(super) fn new(
        (document, buffers, files): (&'a Document, &'a Buffers, Files<'a>),
        materials: &'a mut Materials,
        notes: &'a mut Notes,
    ) -> Self {
        Self {
            document,
            buffers,
            images: Images::new(document, buffers, files),
            materials,
            notes,
            triangles: Vec::new(),
            details: Details::default(),
            left: [3 * MOST_TRIANGLES, MOST_TRIANGLES],
            flat: 0,
        }
    }

    /// The triangles of all nodes, at least one.
    pub(super) fn triangles(mut self, nodes: &[Placed]) -> Result<(Vec<Triangle>, Details), SceneError> {
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
            false => {
                self.details.texels = self.images.texels;
                Ok((self.triangles, self.details))
            }
        }
    }

    fn add(&mut self, at: &str, primitive: &Primitive, to_world: DMat4) -> Result<(), SceneError> {
        if matches!(primitive.mode(), Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip) {
            self.notes.say("points and lines are passed over", at);
            return Ok(());
        }
        if primitive.get(&Semantic::Colors(0)).is_some() {
            self.notes.say("colours of vertices are passed over", at);
        }
        if primitive.morph_targets().len() > 0 {
            self.notes.say("morph targets are passed over", at);
        }
        let points = self.points(at, primitive, to_world)?;
        let indices = self.indices(at, primitive, points.len())?;
        let mut corners = corners(primitive.mode(), &indices);
        self.spend(at, points.len(), corners.len())?;
        if to_world.determinant() < 0.0 {
            corners.iter_mut().for_each(|corners| corners.swap(1, 2));
        }
        let (material, two_sided) = self.materials.of(primitive, self.notes)?;
        let (points, triangles) = (&points, &corners);
        let faces = Faces { at, primitive, to_world, points, triangles, buffers: self.buffers };
        let details = self.details(&faces, material)?;
        for (i, corners) in corners.iter().enumerate() {
            let vertices = corners.map(|index| points[index as usize]);
            let detail = details.as_ref().map(|details| details[i]);
            match normal(vertices) {
                Some(normal) => {
                    self.triangles.push(Triangle { vertices, normal, material, two_sided, detail });
                }
                None => self.flat += 1,
            }
        }
        Ok(())
    }

    /// What each triangle has besides its plane and material, if they have anything.
    fn details(&mut self, faces: &Faces, material: usize) -> Result<Option<Vec<Detail>>, SceneError> {
        let found = faces.corners(self.materials.slots(material), self.notes)?;
        let Some(Found { corners, of }) = found else { return Ok(None) };
        let first = self.details.corners.len() as u32;
        let skin = self.materials.skin(material, self.document, &mut self.images, &mut self.details.skins)?;
        self.details.corners.extend(corners);
        Ok(Some(of.into_iter().map(|of| Detail { corners: of.map(|at| first + at), skin }).collect()))
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
        elements::vectors(&accessor, self.buffers, &POSITIONS)?.into_iter().enumerate().map(placed).collect()
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
pub(super) fn normal(vertices: [Vec3; 3]) -> Option<Vec3> {
    let [a, b, c] = vertices.map(|vertex| vertex.as_dvec3());
    let across = (b - a).cross(c - a);
    let longest = (b - a).length_squared().max((c - b).length_squared()).max((a - c).length_squared());
    if across.length() <= LEAST_HEIGHT * longest {
        return None;
    }
    across.try_normalize().map(|normal| normal.as_vec3())
}
