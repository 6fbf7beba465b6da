//! Corners of triangles: normals, tangents, coordinates in textures.

use super::buffers::Buffers;
use super::elements::{self, Form, POSITIONS};
use super::mesh::normal;
use super::notes::Notes;
use super::textures::Slot;
use crate::scene::limits::refused;
use crate::scene::{Corner, SceneError};
use bevy_mikktspace::{Geometry, TangentSpace};
use gltf::accessor::Dimensions;
use gltf::{Primitive, Semantic};
use lobe_codegen::glam::{DMat3, DMat4, DVec2, DVec3, Vec2, Vec3};

/// Normals.
const NORMALS: Form = Form { told: "normals are VEC3 of 32-bit floats", ..POSITIONS };
/// Tangents.
const TANGENTS: Form =
    Form { dimensions: Dimensions::Vec4, may_be_shares: false, told: "tangents are VEC4 of 32-bit floats" };
/// Coordinates in textures.
const COORDINATES: Form = Form {
    dimensions: Dimensions::Vec2,
    may_be_shares: true,
    told: "texture coordinates are VEC2 of 32-bit floats, or of 8 or 16 bits, normalized",
};

/// The largest coordinate in a texture.
const MOST_TURNS: f64 = 1e6;
/// By how much less than 1 the cosine may be between a corner's normal and a flat triangle's.
const FLAT: f32 = 1e-6;

/// A primitive whose corners are asked for.
pub(super) struct Faces<'a> {
    /// Its place in messages.
    pub(super) at: &'a str,
    pub(super) primitive: &'a Primitive<'a>,
    pub(super) to_world: DMat4,
    /// Vertices in the world.
    pub(super) points: &'a [Vec3],
    /// Vertices of each triangle, counter-clockwise from its front in the world.
    pub(super) triangles: &'a [[u32; 3]],
    pub(super) buffers: &'a Buffers,
}

/// Corners, and those of each triangle among them.
pub(super) struct Found {
    pub(super) corners: Vec<Corner>,
    pub(super) of: Vec<[u32; 3]>,
}

impl Faces<'_> {
    /// The corners, by the textures in `slots`; `None` where the triangles are flat and there are no textures.
    pub(super) fn corners(
        &self,
        slots: &[Option<Slot>; 3],
        notes: &mut Notes,
    ) -> Result<Option<Found>, SceneError> {
        let has_textures = slots.iter().any(Option::is_some);
        let normals = self.normals(notes)?;
        if !has_textures && normals.as_ref().is_none_or(|normals| self.are_flat(normals)) {
            return Ok(None);
        }
        let mut uvs = [const { None }; 3];
        for (uvs, slot) in uvs.iter_mut().zip(slots) {
            *uvs = slot.as_ref().map(|slot| self.coordinates(slot, notes)).transpose()?;
        }
        let wants_tangents = slots[2].is_some();
        let tangents = match (&normals, wants_tangents) {
            (Some(_), true) => self.tangents()?,
            (None, _) | (_, false) => None,
        };
        let of_vertex = |vertex: u32, normal: Vec3, tangent: [f32; 4]| {
            let [x, y, z, handedness] = tangent;
            Corner {
                normal,
                handedness,
                tangent: Vec3::new(x, y, z),
                uvs: uvs.each_ref().map(|uvs| uvs.as_ref().map_or(Vec2::ZERO, |uvs| uvs[vertex as usize])),
            }
        };
        if let Some(normals) = &normals
            && (tangents.is_some() || !wants_tangents)
        {
            let tangent = |vertex: usize| tangents.as_ref().map_or(NONE, |tangents| tangents[vertex]);
            let corner = |vertex: usize| of_vertex(vertex as u32, normals[vertex], tangent(vertex));
            let corners = (0..self.points.len()).map(corner).collect();
            return Ok(Some(Found { corners, of: self.triangles.to_vec() }));
        }
        let mut corners: Vec<Corner> = Vec::with_capacity(3 * self.triangles.len());
        for triangle in self.triangles {
            let flat = self.flat(*triangle);
            let normal = |vertex: u32| normals.as_ref().map_or(flat, |normals| normals[vertex as usize]);
            corners.extend(triangle.map(|vertex| of_vertex(vertex, normal(vertex), NONE)));
        }
        if wants_tangents {
            derive_tangents(self, &mut corners);
        }
        let of = (0..self.triangles.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        Ok(Some(Found { corners, of }))
    }

    /// Unit normal of a triangle; any where it has no area, since nobody sees it.
    fn flat(&self, triangle: [u32; 3]) -> Vec3 {
        normal(triangle.map(|vertex| self.points[vertex as usize])).unwrap_or(Vec3::Z)
    }

    fn are_flat(&self, normals: &[Vec3]) -> bool {
        self.triangles.iter().all(|triangle| {
            let flat = self.flat(*triangle);
            triangle.iter().all(|vertex| normals[*vertex as usize].dot(flat) > 1.0 - FLAT)
        })
    }

    /// An attribute, an element for each vertex; `None` if there is none of this name.
    fn attribute<const N: usize>(
        &self,
        semantic: &Semantic,
        form: &Form,
    ) -> Result<Option<Vec<[f32; N]>>, SceneError> {
        let Some(accessor) = self.primitive.get(semantic) else { return Ok(None) };
        let found = elements::vectors(&accessor, self.buffers, form)?;
        let (count, vertices) = (found.len(), self.points.len());
        match count == vertices {
            true => Ok(Some(found)),
            false => {
                let name = semantic.to_string();
                refused(self.at, format!("{name} has {count} elements, and there are {vertices} vertices"))
            }
        }
    }

    /// Unit normals in the world; `None` where there are none, or one has no length.
    fn normals(&self, notes: &mut Notes) -> Result<Option<Vec<Vec3>>, SceneError> {
        let Some(found) = self.attribute::<3>(&Semantic::Normals, &NORMALS)? else { return Ok(None) };
        let turn = normals_to_world(&self.to_world);
        let unit = |normal: &[f32; 3]| {
            let world = turn * DVec3::from_array(normal.map(f64::from));
            world.try_normalize().map(|normal| normal.as_vec3())
        };
        let normals: Option<Vec<Vec3>> = found.iter().map(unit).collect();
        if normals.is_none() {
            notes.say(
                "normals without a length are passed over, and with them their mesh's: it is flat",
                self.at,
            );
        }
        Ok(normals)
    }

    /// Unit tangents in the world, each with its handedness; `None` where there are none, or one has no length.
    fn tangents(&self) -> Result<Option<Vec<[f32; 4]>>, SceneError> {
        let Some(found) = self.attribute::<4>(&Semantic::Tangents, &TANGENTS)? else { return Ok(None) };
        let mirror = if self.to_world.determinant() < 0.0 { -1.0 } else { 1.0 };
        let unit = |[x, y, z, handedness]: &[f32; 4]| {
            let tangent = DVec3::new((*x).into(), (*y).into(), (*z).into());
            let world = self.to_world.transform_vector3(tangent).try_normalize()?.as_vec3();
            Some([world.x, world.y, world.z, if *handedness < 0.0 { -mirror } else { mirror }])
        };
        Ok(found.iter().map(unit).collect())
    }

    /// Coordinates in a texture, all 0 if the mesh has none for it.
    fn coordinates(&self, slot: &Slot, notes: &mut Notes) -> Result<Vec<Vec2>, SceneError> {
        let Some(found) = self.attribute::<2>(&Semantic::TexCoords(slot.set), &COORDINATES)? else {
            notes.say("a texture for which a mesh has no coordinates is of one colour there", self.at);
            return Ok(vec![Vec2::ZERO; self.points.len()]);
        };
        let placed = |(vertex, uv): (usize, &[f32; 2])| {
            let placed = slot.transform.transform_point2(DVec2::from_array(uv.map(f64::from)));
            match placed.to_array().iter().all(|x| x.abs() <= MOST_TURNS) {
                true => Ok(placed.as_vec2()),
                false => {
                    let message = format!(
                        "vertex {vertex} is at {placed} in {}, not a number up to {MOST_TURNS}",
                        slot.at
                    );
                    refused(self.at, message)
                }
            }
        };
        found.iter().enumerate().map(placed).collect()
    }
}

/// A tangent where none is needed.
const NONE: [f32; 4] = [0.0, 0.0, 0.0, 1.0];

/// The matrix that takes normals to the world, of whatever length: the inverse transposed, or where there is none what is
/// left of it.
fn normals_to_world(to_world: &DMat4) -> DMat3 {
    let linear = DMat3::from_mat4(*to_world);
    let (x, y, z) = (linear.x_axis, linear.y_axis, linear.z_axis);
    let sign = if linear.determinant() < 0.0 { -1.0 } else { 1.0 };
    sign * DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y))
}

/// Gives corners, three of each triangle, the tangents of MikkTSpace by their third coordinates.
fn derive_tangents(faces: &Faces, corners: &mut [Corner]) {
    // The crate's error has no variants.
    let _ = bevy_mikktspace::generate_tangents(&mut Tangents { faces, corners });
}

struct Tangents<'a> {
    faces: &'a Faces<'a>,
    corners: &'a mut [Corner],
}

impl Geometry for Tangents<'_> {
    fn num_faces(&self) -> usize {
        self.faces.triangles.len()
    }

    fn num_vertices_of_face(&self, _: usize) -> usize {
        3
    }

    fn position(&self, face: usize, corner: usize) -> [f32; 3] {
        self.faces.points[self.faces.triangles[face][corner] as usize].to_array()
    }

    fn normal(&self, face: usize, corner: usize) -> [f32; 3] {
        self.corners[3 * face + corner].normal.to_array()
    }

    fn tex_coord(&self, face: usize, corner: usize) -> [f32; 2] {
        // Rows of images are counted from above, and the space's second axis is upwards.
        let uv = self.corners[3 * face + corner].uvs[2];
        [uv.x, 1.0 - uv.y]
    }

    fn set_tangent(&mut self, found: Option<TangentSpace>, face: usize, corner: usize) {
        let corner = &mut self.corners[3 * face + corner];
        let [x, y, z, handedness] = found.unwrap_or_default().tangent_encoded();
        corner.tangent = Vec3::new(x, y, z);
        corner.handedness = handedness;
    }
}
