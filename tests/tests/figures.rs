//! The committed pictures are what the code draws.

use lobe_backends::pipeline::Interpreted;
use lobe_tests::figures::theme::Theme;
use lobe_tests::figures::{all, folder, sheets, svg};
use lobe_tests::flicker::{self, Flicker, Take, Turn};
use lobe_tests::proxies::{self, Options};
use lobe_tests::render::{Renderer, Settings, VirtualLights};
use lobe_tests::scene::{Choices, Scene};
use std::collections::BTreeSet;
use std::path::Path;

const MEND: &str = "cargo run --release -- figures kernels/figures";

#[test]
fn the_committed_pictures_are_those_of_today() {
    let mut names = BTreeSet::new();
    for figure in all().unwrap_or_else(|e| panic!("{e}")) {
        for theme in Theme::ALL {
            let text = svg::render(&figure, theme);
            assert_eq!(text, svg::render(&figure, theme), "{}: drawn twice, it differs", figure.name);
            let path = folder().join(svg::file_name(&figure, theme));
            let name = path.display();
            let committed = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{name}: {e}; {MEND}"));
            assert!(text == committed, "{name} is stale; {MEND}");
            names.extend([path.clone(), path.with_extension("png")]);
        }
    }
    for entry in std::fs::read_dir(folder()).expect("the folder").flatten() {
        let (path, size) = (entry.path(), entry.metadata().expect("its size").len());
        assert!(names.remove(&path), "{} outlived its figure: remove it", path.display());
        assert!(size < 100_000, "{} has {size} bytes; draw less", path.display());
    }
    assert!(names.is_empty(), "missing: {names:?}; {MEND}");
}

const MEND_SHEETS: &str = "cargo run --release -- figures tests/pictures --pictures tests/cases/scenes";

/// 8-bit RGB of a file, and how many pixels a row has.
fn read(path: &Path) -> (Vec<u8>, usize) {
    let file = std::fs::File::open(path).unwrap_or_else(|e| panic!("{}: {e}; {MEND_SHEETS}", path.display()));
    let decoder = png::Decoder::new(std::io::BufReader::new(file));
    let mut reader = decoder.read_info().unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let mut bytes = vec![0; reader.output_buffer_size().unwrap_or(0)];
    let info = reader.next_frame(&mut bytes).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    assert_eq!(info.color_type, png::ColorType::Rgb, "{}", path.display());
    (bytes, info.width as usize)
}

/// All of the sheets but the truth, which takes minutes, and the difference from it.
#[test]
fn the_committed_sheets_are_those_of_today() {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR"));
    for name in sheets::names() {
        let tiles = sheets::tiles(name, &tests.join("cases/scenes"), false).unwrap_or_else(|e| panic!("{e}"));
        let tiles = tiles.expect("a sheet that is listed");
        let (bytes, width) = read(&tests.join("pictures").join(tiles.name).with_extension("png"));
        for (y, row) in tiles.rows.iter().enumerate() {
            let drawn = row.iter().enumerate().filter_map(|(x, tile)| Some((x, tile.as_ref()?)));
            for (x, tile) in drawn {
                let side = tile.len().isqrt();
                for (at, colour) in tile.iter().enumerate() {
                    let place = 3 * ((y * side + at / side) * width + x * side + at % side);
                    let committed = &bytes[place..place + 3];
                    let name = tiles.name;
                    assert_eq!(
                        committed,
                        sheets::shown(*colour),
                        "{name}, row {y}, {x}: stale; {MEND_SHEETS}"
                    );
                }
            }
        }
    }
}

const MEND_FLICKER: &str = "cd tests/cases/scenes && cargo run --release -- flicker cornell_L1.json caustic_a005.json plates_a005.json \
     --plot ../../pictures/flicker.svg --format json > ../../pictures/flicker.jsonl";

/// The first of its pictures, in the pixel that is shown.
#[test]
fn the_committed_flicker_is_that_of_today() {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = |name: &str| {
        let path = tests.join("pictures").join(name);
        std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}; {MEND_FLICKER}", path.display()))
    };
    let measured = read("flicker.jsonl");
    let measured: Vec<Flicker> =
        measured.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    let drawn = svg::render(&flicker::plot(&measured), Theme::Light);
    assert!(drawn == read("flicker.svg"), "flicker.svg is stale; {MEND_FLICKER}");
    let renderer = Renderer::new().unwrap_or_else(|e| panic!("{e}"));
    for old in measured {
        let path = tests.join("cases/scenes").join(&old.scene).with_extension("json");
        let mut scene = Scene::open(&path, &Choices::default()).unwrap_or_else(|e| panic!("{e}"));
        scene.camera.size = old.size;
        let proxies = proxies::proxies(&scene, &Options::default()).unwrap_or_else(|e| panic!("{e}"));
        let turn = Turn { degrees: old.degrees, pictures: 2 };
        let take = Take { name: &old.scene, scene: &scene, proxies: &proxies, turn };
        let virtual_lights = VirtualLights { count: old.lights, ..VirtualLights::default() };
        let method = old.method.parse().expect("a method");
        let settings = Settings { method, virtual_lights, ..Settings::default() };
        let found = flicker::series(&renderer, take, &settings, old.pixel, &mut Interpreted::default());
        let found = found.unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(found, old.series[..2], "{}, {}: stale; {MEND_FLICKER}", old.scene, old.method);
    }
}
