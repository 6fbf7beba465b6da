//! Rectangle proxies: a few rectangles in place of a mesh, for what lights by rectangles.
//!
//! 1. Regions grow over triangles that share an edge and a material, from the largest on (`regions.rs`): as long as normals
//!    stay within an angle of the region's area-weighted mean, and corners within a distance of its mean plane.
//! 2. Where a mesh is of many small pieces, space is partitioned, and the regions of a cell are put together (`partition.rs`).
//! 3. Down to a wanted number, the pair is merged that adds least error (`merge.rs`, `moments.rs`).
//! 4. A region's proxy is the rectangle of least area around its corners in its mean plane (`rectangle.rs`).
//!
//! Rectangles of a scene are proxies as they are.

mod adjacency;
mod json;
mod merge;
mod moments;
mod partition;
mod rectangle;
mod regions;
mod report;

pub use report::Summary;

use crate::scene::{Scene, Surface, Triangle};
use lobe_codegen::prelude::Vec3;
use moments::Moments;
use rectangle::Rectangle;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// How proxies are made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// How far normals may be from their region's mean, rad, above 0 and at most π/2.
    pub angle: f64,
    /// How far corners may be from their region's plane, m, above 0; [`SHARE`] of the diagonal of the scene's bounds without.
    pub distance: Option<f64>,
    /// How often space is halved, at most [`DEEPEST`], to put together what is in one cell; without it regions stay as they
    /// are.
    pub partition: Option<u32>,
    /// The most proxies, if there is to be such a number; at least 1.
    pub count: Option<usize>,
    /// Whether regions of several materials may be merged; the proxy has that of most area.
    pub merge_materials: bool,
}

/// The distance that is permitted, in diagonals of the scene's bounds.
pub const SHARE: f64 = 0.005;
/// The most halvings of space.
pub const DEEPEST: u32 = 24;

impl Default for Options {
    /// 10 degrees, and as many proxies as there are regions.
    fn default() -> Self {
        Self {
            angle: 10f64.to_radians(),
            distance: None,
            partition: None,
            count: None,
            merge_materials: false,
        }
    }
}

/// Rectangles in place of a scene's surfaces.
#[derive(Debug, Clone, PartialEq)]
pub struct Proxies {
    /// At least one.
    pub rectangles: Vec<Proxy>,
    /// Area of what they stand for, m².
    pub area: f64,
}

/// A rectangle `position + a half_x tangent + b half_y (normal × tangent)`, a and b in -1 ..= 1.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Proxy {
    /// Its middle, m.
    #[serde(with = "json::triple")]
    pub position: Vec3,
    /// Unit normal, on whose side it reflects.
    #[serde(with = "json::triple")]
    pub normal: Vec3,
    /// Unit direction of its first sides, perpendicular to the normal.
    #[serde(with = "json::triple")]
    pub tangent: Vec3,
    /// Half the length of its first sides, m.
    pub half_x: f32,
    /// Half the length of the others, m.
    pub half_y: f32,
    /// Index into [`Scene::materials`].
    pub material: usize,
    /// Name of the material.
    pub material_name: String,
    /// Whether it reflects on its back too.
    pub two_sided: bool,
    /// Share of its area that triangles cover, as seen along its normal, above 0 and at most 1.
    pub fill: f32,
    /// How many triangles it stands for; 0 of a rectangle of the scene.
    pub triangles: usize,
    /// How far it is from them.
    pub deviation: Deviation,
}

/// How far triangles are from a plane.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Deviation {
    /// The largest distance of a corner, m.
    pub max: f32,
    /// Root of the mean square of the corners' distances, weighted by area, m.
    pub rms: f32,
    /// The largest angle between a normal and the plane's, degrees.
    pub angle_deg: f32,
}

/// Why there are no proxies.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ProxiesError {
    /// An option is out of its range.
    #[error("{option} is {value}: it must be {range}")]
    Option {
        /// Its name.
        option: &'static str,
        /// What was given.
        value: f64,
        /// What may be given.
        range: &'static str,
    },
    /// There are more materials than proxies.
    #[error(
        "{count} proxies are too few: {least} are left when all is merged that has one material; permit more, or merging of materials"
    )]
    Count {
        /// What was asked for.
        count: usize,
        /// What can be reached.
        least: usize,
    },
    /// The text is no JSON, or lacks something of the format.
    #[error("{message}")]
    Json {
        /// What is wrong, with line and column.
        message: String,
    },
    /// A number of a file, or what follows from several.
    #[error("{at}: {message}")]
    Value {
        /// What it is, as a path: `proxies[3].normal`.
        at: String,
        /// What is wrong, and what would be right.
        message: String,
    },
}

/// Proxies of a scene.
///
/// ```
/// use lobe_tests::proxies::{Options, proxies};
/// use lobe_tests::scene::{Choices, Scene};
/// use std::path::Path;
///
/// let scene = Scene::open(Path::new("cases/scenes/room.gltf"), &Choices::default())?;
/// assert_eq!(proxies(&scene, &Options::default())?.rectangles.len(), 5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// When an option is out of its range, or fewer proxies are wanted than there are materials.
pub fn proxies(scene: &Scene, options: &Options) -> Result<Proxies, ProxiesError> {
    let limits = Limits::new(scene, options)?;
    let (triangles, region_of) = regions_of(scene, options, &limits)?;
    let own = scene.rectangles.iter().map(|surface| of_surface(scene, surface));
    let members = members(&region_of);
    let made = members.iter().filter(|members| !members.is_empty()).map(|members| {
        let region: Vec<&Triangle> = members.iter().map(|&i| &triangles[i as usize]).collect();
        of_region(scene, &region)
    });
    let area = scene.rectangles.iter().map(|s| 4.0 * f64::from(s.half_u.length() * s.half_v.length()));
    let area = area.sum::<f64>() + triangles.iter().map(moments::area).sum::<f64>();
    Ok(Proxies { rectangles: own.chain(made).collect(), area })
}

/// The triangles of a scene, as they are or turned, and the region of each.
fn regions_of<'a>(
    scene: &'a Scene,
    options: &Options,
    limits: &Limits,
) -> Result<(Cow<'a, [Triangle]>, Vec<u32>), ProxiesError> {
    let triangles = match options.partition {
        Some(_) => partition::turned(&scene.triangles),
        None => Cow::Borrowed(scene.triangles.as_slice()),
    };
    let neighbours = adjacency::neighbours(&triangles);
    let mut region_of = regions::grow(&triangles, &neighbours, limits);
    if let Some(depth) = options.partition {
        partition::partition(&triangles, &mut region_of, depth, limits);
    }
    if let Some(count) = options.count {
        let left = count.saturating_sub(scene.rectangles.len());
        let across = options.merge_materials;
        let reached = merge::merge(&triangles, &neighbours, &mut region_of, left, limits, across);
        if reached > left {
            return Err(ProxiesError::Count { count, least: reached + scene.rectangles.len() });
        }
    }
    Ok((triangles, region_of))
}

/// What regions may be, in numbers that are sound.
#[derive(Debug, Clone, Copy)]
struct Limits {
    least_cosine: f64,
    distance: f64,
}

impl Limits {
    fn new(scene: &Scene, options: &Options) -> Result<Self, ProxiesError> {
        let distance = options.distance.unwrap_or_else(|| SHARE * diagonal(&scene.triangles));
        let right = std::f64::consts::FRAC_PI_2;
        let count = options.count.map_or(1.0, |count| count as f64);
        let depth = f64::from(options.partition.unwrap_or(0));
        for (holds, option, value, range) in [
            (
                options.angle > 0.0 && options.angle <= right,
                "the angle in degrees",
                options.angle.to_degrees(),
                "above 0 and at most 90",
            ),
            (
                options.distance.is_none_or(|d| d > 0.0 && d < f64::INFINITY),
                "the distance in metres",
                distance,
                "a number above 0",
            ),
            (count >= 1.0, "the number of proxies", count, "at least 1"),
            (depth <= f64::from(DEEPEST), "the depth of the partition", depth, "at most 24"),
        ] {
            if !holds {
                return Err(ProxiesError::Option { option, value, range });
            }
        }
        Ok(Self { least_cosine: options.angle.cos(), distance })
    }
}

fn diagonal(triangles: &[Triangle]) -> f64 {
    let points = || triangles.iter().flat_map(|triangle| triangle.vertices);
    let low = points().fold(Vec3::INFINITY, Vec3::min);
    let high = points().fold(Vec3::NEG_INFINITY, Vec3::max);
    if triangles.is_empty() { 0.0 } else { (high - low).as_dvec3().length() }
}

/// Triangles of each region. Of regions that are part of others there are none.
fn members(region_of: &[u32]) -> Vec<Vec<u32>> {
    let count = region_of.iter().max().map_or(0, |&last| last as usize + 1);
    let mut members = vec![Vec::new(); count];
    for (triangle, &region) in region_of.iter().enumerate() {
        members[region as usize].push(triangle as u32);
    }
    members
}

fn of_surface(scene: &Scene, surface: &Surface) -> Proxy {
    Proxy {
        position: surface.center,
        normal: surface.normal,
        tangent: surface.half_u.normalize(),
        half_x: surface.half_u.length(),
        half_y: surface.half_v.length(),
        material: surface.material,
        material_name: name(scene, surface.material),
        two_sided: false,
        fill: 1.0,
        triangles: 0,
        deviation: Deviation::default(),
    }
}

fn name(scene: &Scene, material: usize) -> String {
    scene.materials.get(material).map(|(name, _)| name.clone()).unwrap_or_default()
}

fn of_region(scene: &Scene, members: &[&Triangle]) -> Proxy {
    let triangles = || members.iter().copied();
    let moments: Moments = triangles().map(Moments::of).sum();
    let plane = moments.plane();
    let points: Vec<_> = triangles().flat_map(|t| t.vertices.map(|v| v.as_dvec3())).collect();
    let Rectangle { middle, tangent, half } = rectangle::around(&points, &plane);
    let covered: f64 =
        triangles().map(|t| moments::area(t) * t.normal.as_dvec3().dot(plane.normal).max(0.0)).sum();
    let material = dominant(triangles());
    Proxy {
        position: middle.as_vec3(),
        normal: plane.normal.as_vec3(),
        tangent: tangent.as_vec3(),
        half_x: half[0] as f32,
        half_y: half[1] as f32,
        material,
        material_name: name(scene, material),
        two_sided: triangles().any(|t| t.two_sided),
        // Sheets of one plane that overlap cover it more than once.
        fill: (covered / (4.0 * half[0] * half[1])).clamp(f64::from(f32::MIN_POSITIVE), 1.0) as f32,
        triangles: members.len(),
        deviation: plane.deviation(triangles()),
    }
}

/// The material of most area.
fn dominant<'a>(triangles: impl Iterator<Item = &'a Triangle>) -> usize {
    let mut areas: Vec<(usize, f64)> = Vec::new();
    for triangle in triangles {
        match areas.iter_mut().find(|(material, _)| *material == triangle.material) {
            Some((_, sum)) => *sum += moments::area(triangle),
            None => areas.push((triangle.material, moments::area(triangle))),
        }
    }
    areas.into_iter().max_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(material, _)| material)
}

#[cfg(test)]
mod tests;
