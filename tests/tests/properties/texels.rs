//! Textures at points: the kernels against the same in 64 bits, written independently; edges; normals.

use crate::support::{check, close, unit};
use crate::textured::{data, png, textured};
use lobe_codegen::glam::{DVec2, DVec3, UVec3, Vec2, Vec3};
use lobe_kernels::brdf::Material;
use lobe_kernels::rect::Rectangle;
use lobe_kernels::scene::point::textured_point_pass;
use lobe_kernels::scene::texture::{
    Corner, LEAST_FACING, Skin, SurfaceDetail, SurfacePoint, TexelImage, VALUES_LINEAR, VALUES_SIGNED,
    VALUES_SRGB, WRAP_CLAMP, WRAP_MIRROR, WRAP_REPEAT, facing_normal, is_behind_plane, texel_wrapped,
};
use lobe_kernels::scene::{NOWHERE, Seen, Surface};
use lobe_tests::proxies::{Options, proxies};
use lobe_tests::render::Uploaded;
use lobe_tests::scene::{Choices, Details, Scene, texel_values};
use proptest::prelude::*;
use proptest::test_runner::TestCaseError;
use serde_json::json;

/// What stands for a column beyond an image's edges: pieces of the image laid side by side until it is reached.
fn laid(index: i64, size: i64, wrap: u32) -> i64 {
    let turned: Vec<i64> = (0..size).rev().collect();
    let image: Vec<i64> = (0..size).collect();
    let (piece, within) = (index.div_euclid(size), index.rem_euclid(size) as usize);
    match wrap {
        WRAP_REPEAT => image[within],
        WRAP_MIRROR => [&image, &turned][piece.rem_euclid(2) as usize][within],
        _ => index.max(0).min(size - 1),
    }
}

#[test]
fn edges_are_wrapped() {
    for (wrap, size, pairs) in [
        (WRAP_REPEAT, 4, [(-5, 3), (-1, 3), (0, 0), (3, 3), (4, 0), (9, 1)]),
        (WRAP_MIRROR, 4, [(-5, 3), (-1, 0), (0, 0), (3, 3), (4, 3), (8, 0)]),
        (WRAP_CLAMP, 4, [(-5, 0), (-1, 0), (0, 0), (3, 3), (4, 3), (9, 3)]),
        (WRAP_REPEAT, 1, [(-5, 0), (-1, 0), (0, 0), (3, 0), (4, 0), (1 << 30, 0)]),
        (WRAP_MIRROR, 1, [(-(1 << 30), 0), (-1, 0), (0, 0), (1, 0), (2, 0), (1 << 30, 0)]),
    ] {
        for (index, place) in pairs {
            assert_eq!(texel_wrapped(index, size, wrap), place, "{index} of {size}, {wrap}");
            assert_eq!(
                laid(i64::from(index), i64::from(size), wrap),
                i64::from(place),
                "{index} of {size}, {wrap}"
            );
        }
    }
}

/// An image in 64 bits.
struct Image<'a> {
    texels: &'a [u32],
    image: TexelImage,
}

impl Image<'_> {
    fn value(&self, byte: u32) -> f64 {
        let share = f64::from(byte) / 255.0;
        match self.image.values {
            VALUES_SRGB if share <= 0.04045 => share / 12.92,
            VALUES_SRGB => ((share + 0.055) / 1.055).powf(2.4),
            VALUES_LINEAR => share,
            _ if byte == 127 || byte == 128 => 0.0,
            _ => 2.0 * share - 1.0,
        }
    }

    fn texel(&self, [column, row]: [i64; 2]) -> DVec3 {
        let TexelImage { first, width, height, wrap_x, wrap_y, .. } = self.image;
        let column = laid(column, i64::from(width), wrap_x);
        let row = laid(row, i64::from(height), wrap_y);
        let [red, green, blue, _] =
            self.texels[first as usize + (row * i64::from(width) + column) as usize].to_le_bytes();
        DVec3::from([red, green, blue].map(|byte| self.value(byte.into())))
    }

    fn at(&self, uv: DVec2) -> DVec3 {
        let place = uv * DVec2::new(self.image.width.into(), self.image.height.into());
        if self.image.is_smooth == 0 {
            return self.texel([place.x.floor() as i64, place.y.floor() as i64]);
        }
        let (corner, rest) = ((place - 0.5).floor(), (place - 0.5) - (place - 0.5).floor());
        let row = |down: i64| {
            let [x, y] = [corner.x as i64, corner.y as i64 + down];
            self.texel([x, y]).lerp(self.texel([x + 1, y]), rest.x)
        };
        row(0).lerp(row(1), rest.y)
    }

    /// How far a point is from where another texel is the nearest one, in texels.
    fn clearance(&self, uv: DVec2) -> f64 {
        let place = uv * DVec2::new(self.image.width.into(), self.image.height.into());
        (place - place.round()).abs().min_element()
    }
}

fn image(first: u32) -> impl Strategy<Value = TexelImage> {
    let wrap = || prop::sample::select(vec![WRAP_REPEAT, WRAP_MIRROR, WRAP_CLAMP]);
    (1..=4_u32, 1..=4_u32, wrap(), wrap(), 0..=1_u32).prop_map(
        move |(width, height, wrap_x, wrap_y, is_smooth)| TexelImage {
            first,
            width,
            height,
            wrap_x,
            wrap_y,
            is_smooth,
            values: VALUES_SRGB,
        },
    )
}

/// A triangle with its base along x, and a point on it by the weights of left, right and apex.
#[derive(Debug, Clone)]
struct Case {
    apex: f32,
    corners: [Corner; 3],
    skin: Skin,
    texels: Vec<u32>,
    weights: [f64; 3],
    view: Vec3,
}

fn corner() -> impl Strategy<Value = Corner> {
    let uv = || (-3.0..3.0_f32, -3.0..3.0_f32).prop_map(|(u, v)| Vec2::new(u, v));
    (-0.5..0.5_f32, -0.5..0.5_f32, uv(), uv(), uv()).prop_map(|(x, y, a, b, c)| {
        let normal = Vec3::new(x, y, 1.0).normalize();
        Corner { normal, handedness: 1.0, tangent: Vec3::Y.cross(normal).normalize(), uvs: [a, b, c] }
    })
}

fn case() -> impl Strategy<Value = Case> {
    let share = || 0.05..1.0_f32;
    let factors = (share(), share(), share(), -2.0..2.0_f32);
    let images = (image(0), image(16), image(32));
    let texels = prop::collection::vec(any::<u32>(), 48);
    let weights = [0.0..1.0_f64, 0.0..1.0_f64, 0.0..1.0_f64];
    (-1.0..1.0_f32, [corner(), corner(), corner()], factors, images, texels, weights, unit()).prop_map(
        |(
            apex,
            corners,
            (base, metallic, roughness, steepness),
            (colour, shares, bumps),
            texels,
            weights,
            view,
        )| {
            let images = [
                colour,
                TexelImage { values: VALUES_LINEAR, ..shares },
                TexelImage { values: VALUES_SIGNED, ..bumps },
            ];
            let dielectric = Vec3::splat(0.04);
            let base = Vec3::new(base, 0.5 * base, 1.0);
            let skin =
                Skin { base, metallic, dielectric, dielectric_f90: 0.75, roughness, steepness, images };
            let sum: f64 = weights.iter().sum::<f64>().max(1e-3);
            Case {
                apex,
                corners,
                skin,
                texels,
                weights: weights.map(|w| w / sum),
                view: view.with_z(view.z.abs()),
            }
        },
    )
}

/// The surface of a case, and the point.
fn surface(case: &Case) -> (Surface, Vec3) {
    let rectangle = Rectangle {
        position: Vec3::new(0.5, -0.25, 2.0),
        normal: Vec3::Z,
        tangent: Vec3::X,
        half_x: 1.5,
        half_y: 0.5,
    };
    let corner = |x: f64, y: f64| DVec3::new(0.5 + 1.5 * x, -0.25 + 0.5 * y, 2.0);
    let [a, b, c] = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(f64::from(case.apex), 1.0)];
    let position = case.weights[0] * a + case.weights[1] * b + case.weights[2] * c;
    (Surface { rectangle, material: 0, shape: 0, back: NOWHERE, apex: case.apex }, position.as_vec3())
}

/// What the pass leaves of a point that is seen from the side of `normal`, as surface `at` of two.
fn passed(case: &Case, normal: Vec3, at: u32) -> SurfacePoint {
    let (surface, position) = surface(case);
    let mut seen = [Seen { position, surface: at, normal, point_index: NOWHERE, view: case.view }];
    let detail = SurfaceDetail { left: 0, right: 1, apex: 2, skin: 0 };
    let nothing = Material { diffuse_albedo: Vec3::ZERO, f0: Vec3::ZERO, f90: 0.0, alpha: 1.0 };
    let mut points = [SurfacePoint { material: nothing, normal: Vec3::ZERO }];
    textured_point_pass(
        UVec3::ZERO,
        &mut seen,
        &[surface; 2],
        &[detail; 2],
        &case.corners,
        &[case.skin],
        &case.texels,
        &texel_values(),
        &mut points,
    );
    assert_eq!(seen[0].point_index, 0);
    points[0]
}

/// The coordinates of a slot in 64 bits.
fn uv(case: &Case, slot: usize) -> DVec2 {
    let part = |(corner, weight): (&Corner, &f64)| *weight * corner.uvs[slot].as_dvec2();
    case.corners.iter().zip(&case.weights).map(part).sum()
}

#[test]
fn points_are_those_of_64_bits() {
    check(case(), |case| {
        let image = |slot: usize| Image { texels: &case.texels, image: case.skin.images[slot] };
        let is_clear =
            |slot: usize| image(slot).image.is_smooth == 1 || image(slot).clearance(uv(&case, slot)) > 1e-4;
        prop_assume!((0..3).all(is_clear));
        let [colour, shares, bump] = [0, 1, 2].map(|slot| image(slot).at(uv(&case, slot)));
        let (skin, found) = (case.skin, passed(&case, Vec3::Z, 0));
        let base = skin.base.as_dvec3() * colour;
        let metallic = f64::from(skin.metallic) * shares.z;
        let roughness = f64::from(skin.roughness) * shares.y;
        let near = |a: Vec3, b: DVec3, what: &str| -> Result<(), TestCaseError> {
            (0..3).try_for_each(|i| close(a[i], b[i], 1e-4, what))
        };
        near(found.material.diffuse_albedo, base * (1.0 - metallic), "diffuse")?;
        near(found.material.f0, DVec3::splat(0.04).lerp(base, metallic), "f0")?;
        close(found.material.f90, 0.75 + 0.25 * metallic, 1e-4, "f90")?;
        close(found.material.alpha, (roughness * roughness).clamp(0.02, 1.0), 1e-4, "alpha")?;
        let mean = |of: fn(&Corner) -> Vec3| -> DVec3 {
            case.corners.iter().zip(case.weights).map(|(corner, weight)| weight * of(corner).as_dvec3()).sum()
        };
        let (normal, tangent) = (mean(|corner| corner.normal), mean(|corner| corner.tangent));
        let steepness = f64::from(skin.steepness);
        let shading = steepness * (bump.x * tangent + bump.y * normal.cross(tangent)) + bump.z * normal;
        // Where the sum nearly vanishes its direction is anything.
        prop_assume!(shading.length() > 0.05);
        let shading = shading.normalize();
        let view = case.view.as_dvec3();
        let turned = (shading + (0.01 - shading.dot(view)).max(0.0) * view).normalize();
        prop_assume!(shading.dot(view) > -0.99);
        (0..3).try_for_each(|i| close(found.normal[i], turned[i], 2e-3, "normal"))
    });
}

/// A flat texel leaves the normal that the corners make, from the front and, turned, from the back.
#[test]
fn flat_texels_leave_normals() {
    check(case(), |case| {
        let texels = vec![u32::from_le_bytes([128, 127, 255, 255]); 48];
        let flat = Case { texels, view: Vec3::Z, ..case.clone() };
        let mean: Vec3 = flat.corners.iter().zip(flat.weights).map(|(c, w)| w as f32 * c.normal).sum();
        let front = passed(&flat, Vec3::Z, 0).normal;
        prop_assert!(front.distance(mean.normalize()) < 1e-5, "{front} {mean}");
        let back = passed(&Case { view: Vec3::NEG_Z, ..flat }, Vec3::NEG_Z, 1).normal;
        prop_assert!(back.distance(-mean.normalize()) < 1e-5, "{back} {mean}");
        Ok(())
    });
}

#[test]
fn normals_face_the_viewer() {
    check((unit(), unit()), |(normal, view)| {
        let turned = facing_normal(normal, view);
        prop_assert!((turned.length() - 1.0).abs() < 1e-5 || normal.dot(view) < -0.9999, "{turned}");
        prop_assert!(turned.dot(view) > 0.9 * LEAST_FACING, "{turned}");
        prop_assert!(normal.dot(view) < LEAST_FACING || turned.distance(normal) < 1e-6, "{turned}");
        prop_assert!(!is_behind_plane(normal, normal, view));
        prop_assert_eq!(is_behind_plane(normal, -normal, view), normal.dot(view) < 0.0);
        Ok(())
    });
}

/// A picture of four colours lies on the floor as its coordinates have it, from the file to the point.
#[test]
fn pictures_lie_as_they_should() {
    let colours = [[255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 255]];
    let mut file = textured();
    file["images"][0]["uri"] = json!(data("image/png", &png(2, |x, y| colours[(2 * y + x) as usize])));
    let read = || -> Result<Scene, lobe_tests::scene::SceneError> {
        Scene::from_gltf(file.to_string().as_bytes(), &|_| Err(String::new()), &Choices::default())
    };
    let scene = read().expect("a scene");
    let made = proxies(&scene, &Options::default()).expect("proxies");
    let Uploaded { surfaces, surface_details, details, .. } = Uploaded::new(&scene, &made);
    let Details { corners, skins, texels } = details;
    // The floor's coordinates grow from its left to its right and from its far side to its near one, 2.5 over 2 m.
    for (x, z, colour) in
        [(0.2, 0.2, 0), (0.6, 0.2, 1), (0.2, 0.6, 2), (0.6, 0.6, 3), (1.0, 1.0, 0), (1.4, 1.8, 1)]
    {
        let position = Vec3::new(x - 1.0, 0.0, z - 1.0);
        let at = (0..8).find(|i| is_inside(&scene.triangles[*i].vertices, position)).expect("a triangle");
        let mut seen =
            [Seen { position, surface: at as u32, normal: Vec3::Y, point_index: NOWHERE, view: Vec3::Y }];
        let mut points = [SurfacePoint { material: scene.materials[0].1, normal: Vec3::ZERO }];
        textured_point_pass(
            UVec3::ZERO,
            &mut seen,
            &surfaces,
            &surface_details,
            &corners,
            &skins,
            &texels,
            &texel_values(),
            &mut points,
        );
        let wanted = Vec3::from(colours[colour].map(|byte| f32::from(byte) / 255.0));
        assert_eq!(points[0].material.diffuse_albedo, wanted, "{x} {z}");
        assert!(points[0].normal.distance(Vec3::Y) < 1e-6, "{:?}", points[0]);
    }
}

fn is_inside(vertices: &[Vec3; 3], point: Vec3) -> bool {
    (0..3).all(|i| (vertices[(i + 1) % 3] - vertices[i]).cross(point - vertices[i]).y >= 0.0)
}
