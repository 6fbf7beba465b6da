//! What the camera sees of the mesh, and where points are in the picture.

use crate::proxies::Proxies;
use crate::render::Uploaded;
use crate::scene::{Camera, Scene};
use lobe_codegen::prelude::{UVec3, Vec3};
use lobe_kernels::scene::bvh::nearest_pass;
use lobe_kernels::scene::{Hit, NOWHERE, SceneRay};
use rayon::prelude::*;

/// Rays that are traced by one call.
const BATCH: usize = 1024;
/// The end of every ray, in m.
const FAR: f32 = 1e30;
/// Share of a distance within which two are the same.
const SAME: f32 = 2e-3;

/// Distance and unit normal of what a ray meets.
pub(super) type Met = (f32, Vec3);

/// The mesh and the camera.
pub(super) struct View {
    /// Of the size of the picture.
    pub(super) camera: Camera,
    axes: [Vec3; 3],
    mesh: Uploaded,
}

impl View {
    pub(super) fn new(scene: &Scene, size: [u32; 2]) -> Self {
        let camera = scene.camera.with_size(size);
        let none = Proxies { rectangles: Vec::new(), area: 0.0 };
        Self { camera, axes: camera.axes(), mesh: Uploaded::new(scene, &none) }
    }

    /// What each direction from the camera meets first.
    pub(super) fn meet(&self, directions: &[Vec3]) -> Vec<Option<Met>> {
        let rays: Vec<SceneRay> = directions.iter().map(|dir| self.ray(*dir)).collect();
        let mut hits = vec![Hit { dist: FAR, surface: NOWHERE }; rays.len()];
        hits.par_chunks_mut(BATCH).zip(rays.par_chunks(BATCH)).for_each(|(hits, rays)| {
            for i in 0..rays.len() as u32 {
                nearest_pass(UVec3::new(i, 0, 0), &self.mesh.bvh.nodes, &self.mesh.bvh.triangles, rays, hits);
            }
        });
        hits.iter().map(|hit| self.met(hit)).collect()
    }

    fn ray(&self, dir: Vec3) -> SceneRay {
        let origin = self.camera.position();
        SceneRay { origin, reach: FAR, dir, leaving: NOWHERE, reaching: NOWHERE }
    }

    fn met(&self, hit: &Hit) -> Option<Met> {
        let surface = self.mesh.surfaces.get(hit.surface as usize)?;
        Some((hit.dist, surface.rectangle.normal))
    }

    /// Whether nothing is before each point, but what is within `slack` of it.
    pub(super) fn sees(&self, points: &[Vec3], slack: f32) -> Vec<bool> {
        let ways: Vec<Vec3> = points.iter().map(|point| *point - self.camera.position()).collect();
        let directions: Vec<Vec3> = ways.iter().map(|way| way.normalize_or(Vec3::X)).collect();
        let met = self.meet(&directions);
        let is_free = |(way, met): (&Vec3, Option<Met>)| {
            met.is_none_or(|(dist, _)| dist >= way.length() * (1.0 - SAME) - slack)
        };
        ways.iter().zip(met).map(is_free).collect()
    }

    /// Column and row of a point, and fractions of them; `None` of one that is not before the camera.
    pub(super) fn project(&self, point: Vec3) -> Option<[f32; 2]> {
        let [forward, right, up] = self.axes;
        let way = point - self.camera.position();
        let depth = way.dot(forward);
        let [width, height] = self.camera.size.map(|side| side as f32);
        let along = |axis: Vec3| way.dot(axis) / (depth * axis.length_squared());
        let place = [0.5 * width * (1.0 + along(right)), 0.5 * height * (1.0 - along(up))];
        (depth > 1e-4 * way.length() && place.iter().all(|x| x.abs() < 1e6)).then_some(place)
    }
}
