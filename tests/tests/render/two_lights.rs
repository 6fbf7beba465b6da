//! Two lights in place of a whole map, by the passes, against the sum of the map's points.

use lobe_backends::pipeline::{Dispatcher, Interpreted, Memory, Pipeline};
use lobe_codegen::glam::{Vec2, Vec3};
use lobe_kernels::brdf::Material;
use lobe_kernels::brdf::sampling::circle_of_turn;
use lobe_kernels::rect::Rectangle;
use lobe_kernels::reference::pass::BounceSample;
use lobe_kernels::reference::running_mean::luminance;
use lobe_kernels::registry::PASSES;
use lobe_kernels::rsm::chain::{ChainStep, MapLevel};
use lobe_kernels::rsm::light::{Receiver, vpl_light};
use lobe_kernels::rsm::mean::{MapMean, OF_DIFFUSE, OF_GLOSSY};
use lobe_kernels::rsm::point::MapPoint;
use lobe_kernels::rsm::shade::VirtualPixel;
use lobe_kernels::rsm::two::{WholeLight, whole_glossy};
use lobe_kernels::rsm::view::concentric_disk;
use lobe_kernels::scene::texture::SurfacePoint;
use lobe_kernels::scene::{NOWHERE, Seen, Surface};
use lobe_kernels::vsgl::{Vsgl, vsgl_diffuse, vsgl_diffuse_paper};

/// Texels along a side.
const SIDE: u32 = 256;

/// By how much the disk does not face the surface, in degrees, if nothing else is said: a sharpness of 2 for a cosine is 1.9 % too
/// bright along the normal, and 2.7 % too dark here.
const TILT: f32 = 17.548;

/// A disk at distance 1 above the origin, where a surface looks up; its texels reflect as a cosine.
#[derive(Clone, Copy, Debug)]
struct Case {
    radius: f32,
    /// Of the surface at the origin, and of the disk, in degrees from facing each other.
    receiver: f32,
    emitter: f32,
}

/// What is half diffuse and half glossy; the points reflect with the first half.
fn material() -> Material {
    Material { diffuse_albedo: Vec3::splat(0.5), f0: Vec3::splat(0.5), f90: 0.5, alpha: 0.3 }
}

fn tilted(degrees: f32) -> Vec3 {
    let angle = f64::from(degrees).to_radians();
    Vec3::new(libm::sin(angle) as f32, 0.0, libm::cos(angle) as f32)
}

impl Case {
    fn points(self) -> Vec<MapPoint> {
        let normal = -tilted(self.emitter);
        let (x, y) = normal.any_orthonormal_pair();
        let count = (SIDE * SIDE) as f32;
        let texels = (0..SIDE).flat_map(|row| (0..SIDE).map(move |column| (column, row)));
        let point = |(column, row): (u32, u32)| {
            let p = 2.0 * (Vec2::new(column as f32, row as f32) + 0.5) / SIDE as f32 - 1.0;
            let disk = concentric_disk(p);
            let circle = self.radius * disk.y * circle_of_turn(disk.x);
            MapPoint {
                position: Vec3::Z + circle.x * x + circle.y * y,
                surface: 0,
                normal,
                area: std::f32::consts::PI * self.radius * self.radius / count,
                dir: normal,
                flux: Vec3::splat(1.0 / count),
                material: Material { f0: Vec3::ZERO, f90: 0.0, ..material() },
            }
        };
        texels.map(point).collect()
    }

    fn receiver(self) -> Receiver {
        let normal = tilted(self.receiver);
        // Seen so that the middle of the disk is mirrored.
        let view = 2.0 * normal.z * normal - Vec3::Z;
        Receiver { position: Vec3::ZERO, normal, view, material: material() }
    }
}

/// The levels of a map of 256 by 256 texels, of which the first is the texels.
fn levels() -> Vec<MapLevel> {
    let sides: Vec<u32> = (0..=SIDE.ilog2()).map(|level| SIDE >> level).collect();
    let first = |at: usize| sides[1.min(at)..at].iter().map(|side| side * side).sum();
    sides
        .iter()
        .enumerate()
        .map(|(at, side)| MapLevel { first: first(at), width: *side, height: *side })
        .collect()
}

/// What two lights have and give.
struct Found {
    /// Trace of the positions' covariance.
    trace: f32,
    diffuse: WholeLight,
    parts: BounceSample,
}

fn by_passes(case: Case) -> Found {
    let pipeline = Pipeline::new(PASSES).unwrap_or_else(|e| panic!("{e}"));
    let mut memory = Memory::default();
    macro_rules! put {
        ($name:literal, $values:expr) => {
            memory.put($name, pipeline.pack($name, $values).unwrap_or_else(|e| panic!("{e}")))
        };
    }
    let levels = levels();
    let receiver = case.receiver();
    let seen = Seen {
        position: receiver.position,
        surface: 0,
        normal: receiver.normal,
        point_index: NOWHERE,
        view: receiver.view,
    };
    let rectangle = Rectangle {
        position: Vec3::ZERO,
        normal: receiver.normal,
        tangent: Vec3::Y,
        half_x: 1.0,
        half_y: 1.0,
    };
    put!("map_points", &case.points());
    put!("levels", &levels);
    put!("seen", &[seen]);
    put!("surfaces", &[Surface { rectangle, material: 0, shape: 0, back: NOWHERE, apex: 2.0 }]);
    put!("materials", &[receiver.material]);
    put!("points", &[SurfacePoint { material: receiver.material, normal: receiver.normal }]);
    let means = levels.iter().skip(1).map(|level| level.width * level.height).sum::<u32>();
    for (name, count) in [("map_means", means), ("whole_lights", 2), ("virtual_pixels", 1)] {
        memory.put(name, pipeline.zeros(name, count as usize).unwrap_or_else(|e| panic!("{e}")));
    }
    let mut interpreted = Interpreted::default();
    let mut run = |pass: &str, count: u32, memory: &mut Memory| {
        let pass = pipeline.pass(pass).unwrap_or_else(|e| panic!("{e}"));
        interpreted.dispatch(pass, count, memory).unwrap_or_else(|e| panic!("{e}"));
    };
    let mut trace = 0.0;
    for part in [OF_GLOSSY, OF_DIFFUSE] {
        for (pass, level) in [("chain_first_pass", 0_u32), ("chain_pass", 4)] {
            let step = ChainStep { origin: Vec3::Z, level, part };
            memory.put("chain_step", pipeline.pack("chain_step", &[step]).unwrap_or_else(|e| panic!("{e}")));
            run(pass, 64 * (SIDE >> (level + 4)).pow(2), &mut memory);
        }
        run("whole_light_pass", 1, &mut memory);
        let means: Vec<MapMean> = pipeline.unpack("map_means", memory.bytes("map_means")).expect("means");
        trace = means.last().expect("the mean of all").positions.spread;
    }
    run("vsgl_two_pass", 1, &mut memory);
    let pixels: Vec<VirtualPixel> =
        pipeline.unpack("virtual_pixels", memory.bytes("virtual_pixels")).expect("pixels");
    let whole: Vec<WholeLight> =
        pipeline.unpack("whole_lights", memory.bytes("whole_lights")).expect("lights");
    Found { trace, diffuse: whole[0], parts: pixels[0].parts }
}

/// What the points give: by the surface's diffuse and by its glossy lobe.
fn by_points(case: Case) -> [f64; 2] {
    let receiver = case.receiver();
    case.points().into_iter().fold([0.0; 2], |[diffuse, glossy], point| {
        let parts = vpl_light(receiver, point, 1.0, 0.0);
        let of = |colour: Vec3| f64::from(luminance(colour));
        [diffuse + of(parts.diffuse_of_diffuse), glossy + of(parts.glossy_of_diffuse)]
    })
}

/// Ratios to the points: diffuse as printed, by the hemispherical integral and glossy, with the variance as printed; and the same
/// with half of it, which is what the pass does.
fn ratios(case: Case) -> [f64; 6] {
    let (found, receiver, [diffuse, glossy]) = (by_passes(case), case.receiver(), by_points(case));
    let ours = found.diffuse.light;
    let printed = Vsgl { variance: found.trace, ..ours };
    let albedo = receiver.material.diffuse_albedo.x;
    let by = |of: fn(Vsgl, Vec3, Vec3, f32) -> f32, light| {
        f64::from(of(light, receiver.position, receiver.normal, albedo)) / diffuse
    };
    let of = |colour: Vec3| f64::from(luminance(colour));
    [
        by(vsgl_diffuse_paper, printed),
        by(vsgl_diffuse, printed),
        of(whole_glossy(receiver, printed)) / glossy,
        by(vsgl_diffuse_paper, ours),
        of(found.parts.diffuse_of_diffuse) / diffuse,
        of(found.parts.glossy_of_diffuse) / glossy,
    ]
}

const fn usual(radius: f32) -> Case {
    Case { radius, receiver: 0.0, emitter: TILT }
}

/// Ratios of the diffuse light by the hemispherical integral, with the variance as printed and with half of it.
#[test]
fn two_lights_are_the_sum_of_65536_points() {
    let table = [
        (usual(0.01), [0.973, 0.973]),
        (usual(0.1), [0.968, 0.975]),
        (usual(0.3), [0.930, 0.985]),
        (usual(1.0), [0.731, 1.067]),
        (usual(3.0), [0.607, 1.152]),
        (Case { emitter: 60.0, ..usual(0.3) }, [0.698, 0.709]),
    ];
    for (case, wanted) in table {
        let found = ratios(case);
        eprintln!("{case:?} {found:.3?}");
        for (ratio, wanted) in [found[1], found[4]].iter().zip(wanted) {
            assert!((ratio - wanted).abs() < 3e-3, "{case:?}: {found:.3?} instead of {wanted:?}");
        }
    }
}

/// A small light's lobe is met where it is looked at: the cosines count once.
#[test]
fn glossy_light_of_a_small_disk_is_that_of_its_points() {
    for receiver in [0.0, 30.0, 60.0] {
        let found = ratios(Case { receiver, ..usual(0.03) });
        eprintln!("{receiver} {found:.3?}");
        assert!((0.93..1.07).contains(&found[5]), "{receiver} degrees: {found:.3?}");
    }
}

#[test]
fn half_the_printed_variance_is_the_right_one() {
    for radius in [0.01, 0.1, 0.3] {
        let [_, printed, _, _, ours, _] = ratios(usual(radius));
        assert!((0.95..1.05).contains(&ours), "radius {radius}: {ours}");
        assert!(radius < 0.3 || printed < 0.95, "radius {radius}: {printed}");
    }
}
