//! A scene as the passes want it.

use super::bvh::Bvh;
use super::reflectors::reflectors;
use crate::proxies::{Proxies, Proxy};
use crate::scene::{self, Camera, Detail, Details, Light, Scene};
use lobe_codegen::glam::Vec3;
use lobe_kernels::brdf::Material;
use lobe_kernels::rect::Rectangle;
use lobe_kernels::rect::pass::RectProxy;
use lobe_kernels::reference::reflector::Reflector;
use lobe_kernels::scene::camera::PinholeCamera;
use lobe_kernels::scene::light::SceneLight;
use lobe_kernels::scene::texture::SurfaceDetail;
use lobe_kernels::scene::{NOWHERE, Surface, Triangle};

/// The apex of a whole rectangle.
const WHOLE: f32 = 2.0;
/// What a box of the tree is wider than what is in it, over the scene's extent: more than rounding moves a ray.
const SLACK: f32 = 2e-6;
/// The cone's inner angle is at least this less than its outer one, in rad.
const LEAST_BLEND: f32 = 1e-3;

/// The buffers that a scene fills, but the tree.
#[derive(Debug, Clone)]
pub struct Uploaded {
    /// The camera.
    pub camera: PinholeCamera,
    /// The triangles and their tree.
    pub bvh: Bvh,
    /// The surfaces.
    pub surfaces: Vec<Surface>,
    /// What the surfaces are made of.
    pub materials: Vec<Material>,
    /// What each surface has besides; empty where none has anything.
    pub surface_details: Vec<SurfaceDetail>,
    /// What these are made of.
    pub details: Details,
    /// The lights.
    pub lights: Vec<SceneLight>,
    /// Rectangles in their place, for the methods of rectangles.
    pub proxies: Vec<RectProxy>,
    /// How far each of these is from what it stands for, in m.
    pub slacks: Vec<f32>,
    /// Those surfaces that a light can shine on, once for each light; at least one.
    pub reflectors: Vec<Reflector>,
}

impl Uploaded {
    /// The buffers of `scene`, with `proxies` in its place.
    #[must_use]
    pub fn new(scene: &Scene, proxies: &Proxies) -> Self {
        let mut surfaces: Vec<Surface> = (0_u32..).zip(&scene.rectangles).map(surface).collect();
        let mut triangles: Vec<Triangle> = surfaces.iter().flat_map(halves).collect();
        let mut surface_details = vec![FLAT; surfaces.len()];
        for triangle in &scene.triangles {
            let at = surfaces.len() as u32;
            for (surface, detail) in sides(at, triangle) {
                surfaces.push(surface);
                surface_details.push(detail);
            }
            let [a, b, c] = triangle.vertices;
            triangles.push(Triangle { a, surface: at, b, c });
        }
        let camera = camera(&scene.camera);
        let bvh = Bvh::new(&triangles, SLACK * extent(&triangles, camera.position));
        let lights: Vec<SceneLight> = scene.lights.iter().map(light).collect();
        let materials: Vec<Material> = scene.materials.iter().map(|(_, material)| *material).collect();
        let reflectors = reflectors(&surfaces, &materials, &lights);
        if surface_details.iter().all(|detail| detail.skin == NOWHERE) {
            surface_details.clear();
        }
        let details = scene.details.clone();
        let sides = |p: &Proxy| proxy(p).into_iter().map(|side| (side, p.deviation.max)).collect::<Vec<_>>();
        let (proxies, slacks) = proxies.rectangles.iter().flat_map(sides).unzip();
        Self {
            camera,
            bvh,
            surfaces,
            materials,
            surface_details,
            details,
            lights,
            proxies,
            slacks,
            reflectors,
        }
    }
}

fn camera(camera: &Camera) -> PinholeCamera {
    let [width, height] = camera.size;
    let [forward, right, up] = camera.axes();
    PinholeCamera { position: camera.position(), width, forward, height, right, up }
}

fn surface((at, surface): (u32, &scene::Surface)) -> Surface {
    let (half_x, half_y) = (surface.half_u.length(), surface.half_v.length());
    let rectangle = Rectangle {
        position: surface.center,
        normal: surface.normal,
        tangent: surface.half_u / half_x,
        half_x,
        half_y,
    };
    Surface { rectangle, material: surface.material as u32, shape: at, back: NOWHERE, apex: WHOLE }
}

/// The two triangles of a rectangle.
fn halves(surface: &Surface) -> [Triangle; 2] {
    let rectangle = surface.rectangle;
    let u = rectangle.half_x * rectangle.tangent;
    let v = rectangle.half_y * rectangle.normal.cross(rectangle.tangent);
    let corner = |a: f32, b: f32| rectangle.position + a * u + b * v;
    let triangle = |b: Vec3, c: Vec3| Triangle { a: corner(-1.0, -1.0), surface: surface.shape, b, c };
    [triangle(corner(1.0, -1.0), corner(1.0, 1.0)), triangle(corner(1.0, 1.0), corner(-1.0, 1.0))]
}

/// What a surface has besides that is flat and of one material.
const FLAT: SurfaceDetail = SurfaceDetail { left: 0, right: 0, apex: 0, skin: NOWHERE };

/// The surface of a triangle, the `at`-th, and its back if it has one, each with what it has besides.
fn sides(at: u32, triangle: &scene::Triangle) -> Vec<(Surface, SurfaceDetail)> {
    let side = |order: [usize; 3], normal, back| {
        let (order, rectangle, apex) = around(order, triangle.vertices, normal);
        let surface = Surface { rectangle, material: triangle.material as u32, shape: at, back, apex };
        (surface, triangle.detail.map_or(FLAT, |detail| turned(detail, order)))
    };
    if triangle.two_sided {
        vec![side([0, 1, 2], triangle.normal, at + 1), side([0, 2, 1], -triangle.normal, at)]
    } else {
        vec![side([0, 1, 2], triangle.normal, NOWHERE)]
    }
}

/// A detail with its corners in another order.
fn turned(detail: Detail, order: [usize; 3]) -> SurfaceDetail {
    let [left, right, apex] = order.map(|i| detail.corners[i]);
    SurfaceDetail { left, right, apex, skin: detail.skin }
}

/// The rectangle around a triangle, on its longest side, and where its apex is; and its corners in the order left, right,
/// apex. They are given in one that is counter-clockwise about `normal`.
fn around(order: [usize; 3], vertices: [Vec3; 3], normal: Vec3) -> ([usize; 3], Rectangle, f32) {
    let given = order.map(|i| vertices[i]);
    let length = |i: usize| (given[(i + 1) % 3] - given[i]).length_squared();
    let longest = (0..3).max_by(|i, j| length(*i).total_cmp(&length(*j))).unwrap_or(0);
    let order = [0, 1, 2].map(|i| order[(longest + i) % 3]);
    let [a, b, c] = order.map(|i| vertices[i]);
    let base = b - a;
    let tangent = base.normalize();
    let across = normal.cross(tangent);
    let (half_x, half_y) = (0.5 * base.length(), 0.5 * (c - a).dot(across));
    let position = a + half_x * tangent + half_y * across;
    let apex = ((c - a).dot(tangent) / half_x - 1.0).clamp(-1.0, 1.0);
    (order, Rectangle { position, normal, tangent, half_x, half_y }, apex)
}

/// A proxy, and its back if it has one.
fn proxy(proxy: &Proxy) -> Vec<RectProxy> {
    let side = |normal: Vec3| RectProxy {
        rectangle: Rectangle {
            position: proxy.position,
            normal,
            tangent: proxy.tangent,
            half_x: proxy.half_x,
            half_y: proxy.half_y,
        },
        material: proxy.material as u32,
        fill: proxy.fill,
    };
    let back = proxy.two_sided.then(|| side(-proxy.normal));
    std::iter::once(side(proxy.normal)).chain(back).collect()
}

/// The greatest coordinate, or distance from the camera along an axis.
fn extent(triangles: &[Triangle], camera: Vec3) -> f32 {
    let corners = triangles.iter().flat_map(|t| [t.a, t.b, t.c]);
    let reach = |p: Vec3| p.abs().max((p - camera).abs()).max_element();
    corners.map(reach).fold(camera.abs().max_element(), f32::max)
}

fn light(light: &Light) -> SceneLight {
    match *light {
        Light::Directional { to_light, irradiance } => SceneLight {
            axis: to_light,
            is_spot: 0,
            position: Vec3::ZERO,
            outer: 1.0,
            strength: irradiance,
            blend: 1.0,
        },
        Light::Spot { position, axis, inner, outer, intensity } => SceneLight {
            axis,
            is_spot: 1,
            position,
            outer,
            strength: intensity,
            blend: (outer - inner).max(LEAST_BLEND),
        },
    }
}
