//! Imperfect shadow maps: every pass against the same in plain words, and shadows of scenes that have all or none.

use super::{picture_by, scene};
use lobe_backends::pipeline::{Dispatcher, Interpreted, Memory, Pipeline};
use lobe_codegen::glam::Vec3;
use lobe_kernels::reference::random::{pcg_hash, random_pair};
use lobe_kernels::registry::PASSES;
use lobe_kernels::rsm::imperfect::blocker::Blocker;
use lobe_kernels::rsm::imperfect::fill::{MapDepth, NO_DEPTH, PullStep};
use lobe_kernels::rsm::imperfect::share::ImperfectSettings;
use lobe_kernels::rsm::imperfect::splat::Splat;
use lobe_kernels::scene::{NOWHERE, Triangle};
use lobe_tests::render::{Method, Picture, Settings, VirtualLights, Visibility};
use lobe_tests::scene::{Scene, Surface};

/// Buffers, and what runs passes on them.
struct Bench<'p> {
    pipeline: &'p Pipeline,
    interp: Interpreted<'p>,
    memory: Memory,
}

impl<'p> Bench<'p> {
    fn new(pipeline: &'p Pipeline) -> Self {
        Self { pipeline, interp: Interpreted::default(), memory: Memory::default() }
    }

    fn put<T: lobe_codegen::def::KernelValue>(&mut self, name: &str, values: &[T]) {
        let bytes = self.pipeline.pack(name, values).unwrap_or_else(|e| panic!("{name}: {e}"));
        self.memory.put(name, bytes);
    }

    fn room(&mut self, name: &str, count: usize) {
        let bytes = self.pipeline.zeros(name, count).unwrap_or_else(|e| panic!("{name}: {e}"));
        self.memory.put(name, bytes);
    }

    fn run(&mut self, pass: &str, count: u32) {
        let made = self.pipeline.pass(pass).unwrap_or_else(|e| panic!("{e}"));
        self.interp.dispatch(made, count, &mut self.memory).unwrap_or_else(|e| panic!("{pass}: {e}"));
    }

    fn get<T: lobe_codegen::def::KernelValue>(&self, name: &str) -> Vec<T> {
        self.pipeline.unpack(name, self.memory.bytes(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }
}

fn pipeline() -> Pipeline {
    Pipeline::new(PASSES).unwrap_or_else(|e| panic!("{e}"))
}

fn settings(side: u32, points: u32, floor_share: f32) -> ImperfectSettings {
    ImperfectSettings { points, floor_share, side, first: 0, shift: 0 }
}

#[test]
fn the_nearest_of_each_texel_is_kept() {
    let pipeline = pipeline();
    let mut bench = Bench::new(&pipeline);
    let splat = |i: u32| {
        let texel = pcg_hash(i) % 20;
        // Some at the same depth.
        let depth = 0.1 + (16.0 * random_pair(i, 1, 2).x).floor();
        Splat { texel: if texel < 15 { texel } else { NOWHERE }, depth, blocker: pcg_hash(i + 1000) % 50 }
    };
    let splats: Vec<Splat> = (0..100).map(splat).collect();
    bench.put("splats", &splats);
    bench.room("codes", 16);
    bench.room("owners", 16);
    bench.run("splat_nearest_pass", 100);
    bench.run("splat_owner_pass", 100);
    let (codes, owners): (Vec<u32>, Vec<u32>) = (bench.get("codes"), bench.get("owners"));
    for texel in 0..16 {
        let own = || splats.iter().filter(|splat| splat.texel == texel as u32);
        let nearest = own().map(|splat| splat.depth).reduce(f32::min);
        assert_eq!(codes[texel], nearest.map_or(0, |depth| NOWHERE - depth.to_bits()), "texel {texel}");
        let owner = own().filter(|splat| Some(splat.depth) == nearest).map(|splat| splat.blocker + 1).max();
        assert_eq!(owners[texel], owner.unwrap_or(0), "texel {texel}");
    }
}

/// The depth of each level's squares in a map: `levels[l][y][x]` of squares of `2^l` texels.
type Levels = Vec<Vec<Vec<f32>>>;

/// The nearest of the points within a square, in levels below its own.
fn nearest_within(levels: &Levels, level: usize, x: usize, y: usize) -> f32 {
    let squares = |level: usize| {
        let rows = levels[level].iter().enumerate();
        rows.flat_map(|(row, depths)| {
            depths.iter().enumerate().map(move |(column, depth)| (column, row, *depth))
        })
    };
    let mut found = NO_DEPTH;
    for smaller in 0..level {
        let up = level - smaller;
        let within = squares(smaller).filter(|(column, row, _)| (column >> up, row >> up) == (x, y));
        found = within.map(|(_, _, depth)| depth).fold(found, f32::min);
    }
    found
}

/// The nearest of the points that cover a texel and of the smallest square about it that has any.
fn filled(levels: &Levels, x: usize, y: usize) -> f32 {
    let covering = (0..levels.len()).map(|level| levels[level][y >> level][x >> level]);
    let covering: Vec<f32> = covering.collect();
    let mut found = covering[0];
    let mut is_hole = found >= NO_DEPTH;
    for (level, own) in covering.iter().enumerate().skip(1) {
        found = found.min(*own);
        if is_hole {
            found = found.min(nearest_within(levels, level, x >> level, y >> level));
            is_hole = found >= NO_DEPTH;
        }
    }
    found
}

/// Levels of `maps` maps, in which a share of the squares has a point.
fn drawn(side: usize, maps: usize, share: f32) -> Vec<Levels> {
    let mut drawn = 0;
    let mut depth = || {
        drawn += 1;
        let [u, v] = random_pair(drawn, side as u32, maps as u32).to_array();
        if u < share { 0.5 + 3.0 * v } else { NO_DEPTH }
    };
    let mut level = |size: usize| (0..size).map(|_| (0..size).map(|_| depth()).collect()).collect();
    let sizes: Vec<usize> = (0..=side.ilog2()).map(|level| side >> level).collect();
    (0..maps).map(|_| sizes.iter().map(|size| level(*size)).collect()).collect()
}

/// What the passes make of them; the point of a depth is its bits.
fn filled_by_passes(maps: &[Levels]) -> Vec<MapDepth> {
    let pipeline = pipeline();
    let mut bench = Bench::new(&pipeline);
    let side = maps[0][0].len() as u32;
    let texels = side * side * maps.len() as u32;
    let level = |level: usize| maps.iter().flat_map(move |map| map[level].iter().flatten().copied());
    let depths: Vec<f32> = (0..maps[0].len()).flat_map(level).collect();
    let of_each = |of: fn(f32) -> u32| -> Vec<u32> {
        depths.iter().map(|depth| if *depth < NO_DEPTH { of(*depth) } else { 0 }).collect()
    };
    bench.put("codes", &of_each(|depth| NOWHERE - depth.to_bits()));
    bench.put("owners", &of_each(|depth| depth.to_bits() + 1));
    bench.put("imperfect", &[settings(side, 1, 1.0)]);
    bench.room("hole_depths", texels as usize);
    bench.room("map_depths", texels as usize);
    let (mut first, mut below, mut size) = (texels, 0, side);
    while size > 1 {
        let pass = if size == side { "pull_first_pass" } else { "pull_pass" };
        size /= 2;
        let count = size * size * maps.len() as u32;
        bench.put("pull_step", &[PullStep { side: size, count, first, below, texels }]);
        bench.run(pass, count);
        (below, first) = (first, first + count);
    }
    bench.run("hole_fill_pass", texels);
    bench.get("map_depths")
}

#[test]
fn holes_are_filled_from_the_smallest_square() {
    for (side, maps, share) in
        [(1, 3, 0.5), (2, 2, 0.3), (8, 3, 0.1), (16, 2, 0.02), (16, 2, 0.6), (4, 5, 0.0)]
    {
        let maps = drawn(side, maps, share);
        for (at, found) in filled_by_passes(&maps).iter().enumerate() {
            let within = at % (side * side);
            let wanted = filled(&maps[at / (side * side)], within % side, within / side);
            let blocker = if wanted < NO_DEPTH { wanted.to_bits() } else { NOWHERE };
            let what = format!("texel {at} of maps of {side} by {side}, {share}");
            assert_eq!((found.depth, found.blocker), (wanted, blocker), "{what}");
        }
    }
}

/// Runs of points for lights that send `powers`.
fn runs(powers: &[f32], points: u32, floor_share: f32) -> Vec<u32> {
    let pipeline = pipeline();
    let mut bench = Bench::new(&pipeline);
    let estimates: Vec<_> = powers.iter().map(|power| lobe_codegen::glam::Vec2::new(*power, 1.0)).collect();
    bench.put("estimates", &estimates);
    let blocks = powers.len().div_ceil(1024);
    bench.room("sums", powers.len());
    [("block_totals", blocks), ("block_sums", blocks), ("all_totals", 1), ("point_runs", powers.len() + 1)]
        .iter()
        .for_each(|(name, count)| bench.room(name, *count));
    bench.run("scan_pass", 64 * blocks as u32);
    bench.run("scan_block_pass", 64);
    bench.put("imperfect", &[settings(8, points, floor_share)]);
    bench.run("point_run_pass", powers.len() as u32 + 1);
    bench.get("point_runs")
}

#[test]
fn lights_have_points_by_what_they_send() {
    let powers: Vec<f32> = (0..1500).map(|i| 10.0 * random_pair(i, 3, 4).x.powi(4)).collect();
    let (points, total) = (60_000_u32, powers.iter().map(|p| f64::from(*p)).sum::<f64>());
    for floor_share in [0.0, 0.25, 1.0] {
        let runs = runs(&powers, points, floor_share);
        assert_eq!((runs[0], runs[powers.len()]), (0, points));
        for (pair, power) in runs.windows(2).zip(&powers) {
            let even = f64::from(floor_share) / powers.len() as f64;
            let by_power = (1.0 - f64::from(floor_share)) * f64::from(*power) / total;
            let found = f64::from(pair[1]) - f64::from(pair[0]);
            assert!((found - f64::from(points) * (even + by_power)).abs() < 1.2, "{found} points, {power} W");
        }
    }
    // Lights that send nothing share alike.
    assert_eq!(runs(&[0.0; 4], 40, 0.25), [0, 10, 20, 30, 40]);
}

#[test]
fn points_are_drawn_by_area_and_evenly() {
    let pipeline = pipeline();
    let mut bench = Bench::new(&pipeline);
    let triangle = |at: u32| {
        let size = 1.0 + at as f32;
        let a = Vec3::new(100.0 * at as f32, 0.0, 0.0);
        Triangle { a, surface: at, b: a + size * Vec3::X, c: a + size * Vec3::Y }
    };
    let triangles: Vec<Triangle> = (0..12).map(triangle).collect();
    bench.put("triangles", &triangles);
    for (name, count) in
        [("estimates", 12), ("sums", 12), ("block_totals", 1), ("block_sums", 1), ("all_totals", 1)]
    {
        bench.room(name, count);
    }
    bench.run("triangle_area_pass", 12);
    bench.run("scan_pass", 64);
    bench.run("scan_block_pass", 64);
    bench.room("blockers", 6500);
    bench.run("blocker_pass", 6500);
    let found: Vec<Blocker> = bench.get("blockers");
    for triangle in &triangles {
        let own: Vec<_> = found.iter().filter(|blocker| blocker.shape == triangle.surface).collect();
        // The squares of 1 to 12 add up to 650; half of the points are as many on each.
        let square = (1.0 + f64::from(triangle.surface)).powi(2);
        let wanted = 6500.0 * (0.5 / 12.0 + 0.5 * square / 650.0);
        assert!((own.len() as f64 - wanted).abs() < 4.0, "{} of {wanted} on {triangle:?}", own.len());
        let stands_for: f64 = own.iter().map(|blocker| f64::from(blocker.area) / 6500.0).sum();
        assert!((stands_for / (0.5 * square) - 1.0).abs() < 0.02, "{stands_for} of {} m²", 0.5 * square);
        for blocker in own {
            assert!(blocker.normal.distance(Vec3::Z) < 1e-6, "{blocker:?}");
            let local = (blocker.position - triangle.a) / (1.0 + triangle.surface as f32);
            let is_within = local.min_element() >= -1e-5 && local.x + local.y <= 1.0 + 1e-4;
            assert!(is_within, "{blocker:?} is not on {triangle:?}");
        }
    }
}

fn lights(visibility: Visibility) -> VirtualLights {
    VirtualLights { count: 64, visibility, ..VirtualLights::default() }
}

fn picture(scene: &Scene, method: Method, virtual_lights: VirtualLights) -> Picture {
    picture_by(scene, &Settings { method, virtual_lights, ..Settings::default() })
}

fn mean(picture: &Picture) -> f64 {
    let suffixes = ["indirect_total_vis", "indirect_total_la"];
    let pixels = suffixes.iter().find_map(|name| picture.layer(name)).unwrap_or_else(|| panic!("no layer"));
    pixels.iter().map(|p| f64::from(p.element_sum())).sum::<f64>() / (3 * pixels.len()) as f64
}

/// The light that there is, without shadows and with those of a kind.
fn shares(scene: &Scene, method: Method) -> (f64, f64) {
    shares_of(scene, method, VirtualLights::default().smoothing)
}

/// The same of lights that are read from squares so many times as large as usual.
fn shares_of(scene: &Scene, method: Method, smoothing: f32) -> (f64, f64) {
    let lights = |visibility| VirtualLights { smoothing, ..lights(visibility) };
    let all = mean(&picture(scene, method, lights(Visibility::None)));
    assert!(all > 1e-4, "{}: there is no light to hide", scene.name);
    let share = |visibility| mean(&picture(scene, method, lights(visibility))) / all;
    (share(Visibility::Imperfect), share(Visibility::Exact))
}

#[test]
fn two_surfaces_hide_nothing_of_each_other() {
    let mut scene = scene("plates_a010.json");
    scene.camera.size = [32; 2];
    // Squares that reach over both surfaces send light along the plane of their own texel, where a map is too coarse to
    // tell: `tests/SCENES.md` has how much `vsgl` loses by it. Lights of single texels send none.
    for (method, smoothing) in [(Method::Vpl, 4.0), (Method::VslWide, 4.0), (Method::Vsgl, 0.0)] {
        let (imperfect, exact) = shares_of(&scene, method, smoothing);
        println!("{method}: {imperfect}, exact {exact}");
        assert!((exact - 1.0).abs() < 1e-6, "{method}: exact {exact}");
        assert!((imperfect - 1.0).abs() < 1e-6, "{method}: {imperfect}");
    }
}

#[test]
fn an_empty_box_is_hardly_shadowed() {
    let mut scene = scene("cornell_L1.json");
    scene.camera.size = [32; 2];
    let is_wall = |surface: &Surface| !surface.name.contains('.');
    scene.rectangles.retain(is_wall);
    assert_eq!(scene.rectangles.len(), 5);
    let (imperfect, exact) = shares(&scene, Method::Vsgl);
    println!("{imperfect}, exact {exact}");
    assert!((exact - 1.0).abs() < 1e-3, "{exact}");
    assert!((imperfect - 1.0).abs() < 0.02, "{imperfect}");
}

/// A wall before a lamp, a floor, and a screen between them, `height` of 2 m high, of 32 rectangles.
fn screened(height: f32) -> Scene {
    let tile = |at: u32| {
        let (x, y) = (-2.8 + 0.8 * (at % 8) as f32, height * (0.25 + 0.5 * (at / 8) as f32));
        format!(
            r#"{{"center": [{x}, {y}, -1.2], "half_u": [0, {}, 0], "half_v": [0.4, 0, 0], "material": "all"}}"#,
            0.25 * height
        )
    };
    let text = format!(
        r#"{{"format": "glossy-oracle-scene/1", "name": "screened",
        "camera": {{"position": [0, 3, 4], "look_at": [0, 0, 0], "up": [0, 1, 0], "vfov_deg": 25, "width": 32, "height": 32}},
        "lights": [{{"type": "spot", "position": [0, 1, -1.4], "direction": [0, 0, -1], "cone_inner_deg": 30, "cone_outer_deg": 50, "intensity": [1, 1, 1]}}],
        "materials": {{"all": {{"diffuse_albedo": [0.5, 0.5, 0.5], "specular_f0": [0.5, 0.5, 0.5], "specular_f90": 1, "ggx_alpha": 0.3}}}},
        "rects": [
            {{"center": [0, 0, 0], "half_u": [0, 0, 1], "half_v": [1, 0, 0], "material": "all"}},
            {{"center": [0, 1, -2], "half_u": [2, 0, 0], "half_v": [0, 1, 0], "material": "all"}},
            {}]}}"#,
        (0..32).map(tile).collect::<Vec<String>>().join(",\n            ")
    );
    Scene::from_json(&text).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn a_screen_takes_most_light() {
    for method in [Method::Vpl, Method::VslWide, Method::Vsgl] {
        let (closed, exact) = shares(&screened(1.0), method);
        println!("{method}: closed {closed}");
        assert_eq!(exact, 0.0, "{method}");
        // Squares as large as what points stand for leave a share of e^-1 open to what is behind.
        assert!(closed < 0.45, "{method}: {closed} of the light comes through");
    }
}

#[test]
fn boxes_hide_about_as_much_as_by_rays() {
    for name in ["cornell_L1.json", "caustic_a010.json"] {
        let mut scene = scene(name);
        scene.camera.size = [32; 2];
        let (imperfect, exact) = shares(&scene, Method::Vsgl);
        println!("{name}: {imperfect}, exact {exact}");
        assert!((imperfect - exact).abs() < 0.03, "{name}: {imperfect}, exact {exact}");
        assert!(exact < 0.97, "{name}: nothing is hidden");
    }
}
