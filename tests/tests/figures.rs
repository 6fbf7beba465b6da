//! The committed pictures are what the code draws.

use lobe_tests::figures::theme::Theme;
use lobe_tests::figures::{all, folder, svg};
use std::collections::BTreeSet;

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
