//! What is drawn besides the scenes of the tests: a vase of fine triangles, and a bush of leaves in it.

use crate::domain::Rng;
use crate::figures::sheets::SheetError;
use crate::scene::{Scene, Triangle};
use lobe_codegen::prelude::Vec3;

/// Camera, light, materials and the table.
const TABLE: &str = r#"{
  "format": "glossy-oracle-scene/1", "name": "vase",
  "camera": {"position": [1.1, 1.75, 3.6], "look_at": [0, 0.83, 0], "up": [0, 1, 0], "vfov_deg": 28, "width": 400, "height": 400},
  "lights": [{"type": "directional", "direction": [-1, -2, -1], "irradiance": [3, 3, 3]}],
  "materials": {
    "clay": {"diffuse_albedo": [0.5, 0.3, 0.2], "specular_f0": [0.1, 0.1, 0.1], "specular_f90": 1, "ggx_alpha": 0.2},
    "leaf": {"diffuse_albedo": [0.1, 0.4, 0.1], "specular_f0": [0.04, 0.04, 0.04], "specular_f90": 1, "ggx_alpha": 0.3}
  },
  "rects": [{"center": [0, 0, 0], "half_u": [0, 0, 0.9], "half_v": [0.9, 0, 0], "material": "clay"}]
}"#;
/// Squares around the vase, and up.
const SQUARES: [u32; 2] = [96, 64];
/// Leaves of the bush.
const LEAVES: u32 = 900;
/// Half the length of a leaf, m.
const LEAF: f32 = 0.06;

/// The vase with the bush on its table.
pub(super) fn vase_and_bush() -> Result<Scene, SheetError> {
    let told = |reason: String| SheetError::Scene { name: "the vase".to_owned(), reason };
    let mut scene = Scene::from_json(TABLE).map_err(|e| told(e.to_string()))?;
    scene.triangles = vase().into_iter().chain(bush()).collect();
    Ok(scene)
}

fn triangle([a, b, c]: [Vec3; 3], material: usize, two_sided: bool) -> Option<Triangle> {
    let normal = (b - a).as_dvec3().cross((c - a).as_dvec3()).try_normalize()?.as_vec3();
    Some(Triangle { vertices: [a, b, c], normal, material, two_sided, detail: None })
}

fn square([a, b, c, d]: [Vec3; 4], material: usize, two_sided: bool) -> impl Iterator<Item = Triangle> {
    [[a, b, c], [a, c, d]].into_iter().filter_map(move |corners| triangle(corners, material, two_sided))
}

/// A surface of revolution.
fn vase() -> Vec<Triangle> {
    let [around, up] = SQUARES;
    let corner = |i: u32, j: u32| {
        let (angle, t) = (std::f32::consts::TAU * (i % around) as f32 / around as f32, j as f32 / up as f32);
        let radius = 0.2 + 0.17 * (5.0 * t + 0.1).sin() * (1.0 - 0.4 * t);
        Vec3::new(radius * angle.cos(), 0.85 * t, -radius * angle.sin())
    };
    (0..up)
        .flat_map(|j| (0..around).map(move |i| (i, j)))
        .flat_map(|(i, j)| {
            square([corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)], 0, false)
        })
        .collect()
}

/// Leaves in a ball, turned every way.
fn bush() -> Vec<Triangle> {
    let mut rng = Rng::new(1, "bush");
    let mut number = || (2.0 * rng.unit() - 1.0) as f32;
    let mut place = || Vec3::new(number(), number(), number());
    (0..LEAVES)
        .flat_map(|_| {
            let at = place();
            let along = place().normalize_or(Vec3::X);
            let middle =
                Vec3::new(0.0, 1.2, 0.0) + 0.42 * at.normalize_or(Vec3::Y) * at.length().min(1.0).sqrt();
            let (x, y) = (
                LEAF * along,
                0.5 * LEAF * along.cross(place()).normalize_or(along.any_orthonormal_vector()),
            );
            square([middle - x, middle - y, middle + x, middle + y], 1, true)
        })
        .collect()
}
