//! Textures in pictures: a wall of two colours by a texture is the wall of two pieces.

use crate::picture;
use lobe_codegen::glam::{Vec2, Vec3};
use lobe_kernels::scene::texture::{VALUES_SRGB, WRAP_CLAMP, skin_material};
use lobe_tests::render::Method;
use lobe_tests::scene::{Corner, Detail, Details, Scene, Skin, TexelImage, Triangle};

/// A floor before a wall that is yet to come, from above.
const FLOOR: &str = r#"{
  "format": "glossy-oracle-scene/1", "name": "floor",
  "camera": {"position": [0, 2, 3], "look_at": [0, 0.5, -0.5], "up": [0, 1, 0], "vfov_deg": 50, "width": 16, "height": 16},
  "lights": [{"type": "directional", "direction": [0.1, -0.5, -1], "irradiance": [3, 3, 3]}],
  "materials": {
    "floor": {"diffuse_albedo": [0.5, 0.5, 0.5], "specular_f0": [0.3, 0.3, 0.3], "specular_f90": 1, "ggx_alpha": 0.2}
  },
  "rects": [{"center": [0, 0, 0], "half_u": [0, 0, 1], "half_v": [1, 0, 0], "material": "floor"}]
}"#;

/// Left and right half, sRGB.
const COLOURS: [[u8; 3]; 2] = [[255, 0, 0], [0, 0, 255]];

fn skin() -> Skin {
    let images =
        [TexelImage { first: 0, width: 0, height: 0, wrap_x: 0, wrap_y: 0, is_smooth: 0, values: 0 }; 3];
    let (base, dielectric) = (Vec3::ONE, Vec3::splat(0.04));
    Skin { base, metallic: 0.5, dielectric, dielectric_f90: 1.0, roughness: 0.5, steepness: 1.0, images }
}

/// Two triangles at the back, from `left` to `right`.
fn wall(left: f32, right: f32, material: usize) -> [Triangle; 2] {
    let corner = |x, y| Vec3::new(x, y, -1.0);
    let triangle =
        |vertices| Triangle { vertices, normal: Vec3::Z, material, two_sided: false, detail: None };
    let [a, b, c, d] = [corner(left, 0.0), corner(right, 0.0), corner(right, 1.5), corner(left, 1.5)];
    [triangle([a, b, c]), triangle([a, c, d])]
}

fn in_pieces() -> Scene {
    let mut scene = Scene::from_json(FLOOR).unwrap_or_else(|e| panic!("{e}"));
    for colour in COLOURS {
        let colour = Vec3::from(colour.map(|byte| f32::from(byte) / 255.0));
        scene.materials.push((format!("{colour}"), skin_material(skin(), colour, Vec3::ONE)));
    }
    scene.triangles = [wall(-1.0, 0.0, 1), wall(0.0, 1.0, 2)].concat();
    scene
}

/// The same by a texture of two texels, with normals that are those of the wall.
fn by_texture() -> Scene {
    let mut scene = Scene::from_json(FLOOR).unwrap_or_else(|e| panic!("{e}"));
    let mean = skin_material(skin(), Vec3::new(0.5, 0.0, 0.5), Vec3::ONE);
    scene.materials.push(("wall".to_owned(), mean));
    let mut skin = skin();
    skin.images[0] = TexelImage {
        width: 2,
        height: 1,
        wrap_x: WRAP_CLAMP,
        wrap_y: WRAP_CLAMP,
        values: VALUES_SRGB,
        ..skin.images[0]
    };
    let texels = COLOURS.map(|[r, g, b]| u32::from_le_bytes([r, g, b, 255])).to_vec();
    scene.details = Details { corners: Vec::new(), skins: vec![skin], texels };
    scene.triangles = wall(-1.0, 1.0, 1).to_vec();
    for triangle in &mut scene.triangles {
        let first = scene.details.corners.len() as u32;
        triangle.detail = Some(Detail { corners: [first, first + 1, first + 2], skin: 0 });
        scene.details.corners.extend(triangle.vertices.map(|vertex| Corner {
            normal: Vec3::Z,
            handedness: 1.0,
            tangent: Vec3::ZERO,
            uvs: [Vec2::new(0.5 * (vertex.x + 1.0), 0.5); 3],
        }));
    }
    scene
}

#[test]
fn a_texture_is_seen_as_its_pieces_are() {
    let [pieces, texture] = [in_pieces(), by_texture()].map(|scene| picture(&scene, Method::Direct, 1));
    for layer in ["direct_vis", "direct_novis", "direct_specular_novis"] {
        let [one, other] = [&pieces, &texture].map(|picture| picture.layer(layer).expect("a layer"));
        assert!(one.iter().any(|pixel| pixel.x > 0.0 && pixel.x != pixel.z), "{layer}");
        for (a, b) in one.iter().zip(other) {
            assert!(a.distance(*b) <= 1e-4 * a.length(), "{layer}: {a} {b}");
        }
    }
}

/// Which surface a sample meets is drawn otherwise, so pictures are equal within their noise.
#[test]
fn a_texture_reflects_as_its_pieces_do() {
    const SAMPLES: u32 = 16384;
    let [pieces, texture] =
        [in_pieces(), by_texture()].map(|scene| picture(&scene, Method::Reference, SAMPLES));
    for lobe in ["diffuse", "specular"] {
        let layer = format!("indirect_{lobe}_novis");
        let of = |picture: &lobe_tests::render::Picture, name: &str| {
            picture.layer(name).expect("a layer").to_vec()
        };
        let error = |picture| {
            let all = of(picture, &format!("se_indirect_{lobe}_novis"));
            all.iter().map(|pixel| f64::from(pixel.x).powi(2)).sum::<f64>()
        };
        let bound = 4.0 * (error(&pieces) + error(&texture)).sqrt();
        // Left and right are told apart: red is on the left.
        for (colour, weight) in [(0, 0.2126), (2, 0.0722)] {
            for half in 0..2 {
                let sum = |picture| -> f64 {
                    let all = of(picture, &layer);
                    let is_there = |at: &usize| at % 16 / 8 == half;
                    (0..256).filter(is_there).map(|at| f64::from(all[at][colour])).sum()
                };
                let (a, b) = (sum(&pieces), sum(&texture));
                assert!(
                    a > 0.0 && weight * (a - b).abs() < bound,
                    "{layer}, {colour}, {half}: {a} {b} {bound}"
                );
                assert!((a - b).abs() < 0.03 * a, "{layer}, {colour}, {half}: {a} {b}");
            }
        }
    }
}
