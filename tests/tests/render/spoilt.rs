//! Spoilt scenes of any kind: refused with a reason, or pictures of light.
//!
//! `LOBE_CASES=100000` draws so many, `LOBE_SEED=n` others; each case is a stream of its own, so its number and the seed are
//! all that it takes to see it again (`LOBE_CASE=n` runs it alone).

use crate::spoil::spoilt;
use lobe_backends::pipeline::Interpreted;
use lobe_tests::domain::Rng;
use lobe_tests::proxies::{self, Options};
use lobe_tests::render::{Method, Renderer, Settings};
use lobe_tests::scene::Scene;
use rayon::prelude::*;
use serde_json::Value;

const METHODS: [Method; 4] = [Method::Rect, Method::RectLaplace, Method::RectQuadrature, Method::Reference];

/// What came of a case.
enum Outcome {
    Refused,
    Dark,
    Lit,
    Wrong(String),
}

fn from_environment(name: &str) -> Option<u64> {
    std::env::var(name).ok().and_then(|text| text.parse().ok())
}

/// Scenes that are spoilt: a room, plates, a ring of mirrors under a spotlight.
fn sound() -> Vec<Value> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/scenes");
    let read = |name: &str| {
        let text = std::fs::read_to_string(folder.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"));
        serde_json::from_str(&text).unwrap_or_else(|e| panic!("{name}: {e}"))
    };
    ["cornell_L1.json", "plates_a005.json", "caustic_a002.json"].map(read).to_vec()
}

fn judged<'p>(renderer: &'p Renderer, dispatcher: &mut Interpreted<'p>, text: &str) -> Outcome {
    let mut scene = match Scene::from_json(text) {
        Ok(scene) => scene,
        Err(error) if error.to_string().is_empty() => return Outcome::Wrong("no reason is given".to_owned()),
        Err(_) => return Outcome::Refused,
    };
    scene.camera.size = [4, 4];
    let proxies = match proxies::proxies(&scene, &Options::default()) {
        Ok(proxies) => proxies,
        Err(error) => return Outcome::Wrong(format!("no proxies: {error}")),
    };
    let mut is_lit = false;
    for method in METHODS {
        let settings = Settings { method, samples: 2, ..Settings::default() };
        match renderer.render(&scene, &proxies, &settings, dispatcher, &|_| {}) {
            Ok(picture) if picture.is_sound() => {
                is_lit |= picture.layers.iter().any(|layer| {
                    layer.name.starts_with("indirect") && layer.pixels.iter().any(|v| v.max_element() > 0.0)
                });
            }
            Ok(picture) => {
                let is_bad = |v: &lobe_codegen::glam::Vec3| !v.is_finite() || v.min_element() < 0.0;
                let layers = picture.layers.iter().filter_map(|layer| {
                    layer.pixels.iter().find(|v| is_bad(v)).map(|v| format!("{} {v}", layer.name))
                });
                return Outcome::Wrong(format!("{method}: {}", layers.collect::<Vec<_>>().join("; ")));
            }
            Err(error) => return Outcome::Wrong(format!("{method}: {error}")),
        }
    }
    if is_lit { Outcome::Lit } else { Outcome::Dark }
}

/// What all cases have in common.
struct Cases<'p> {
    renderer: &'p Renderer,
    scenes: Vec<Value>,
    seed: u64,
    is_shown: bool,
}

impl<'p> Cases<'p> {
    fn run(&self, dispatcher: &mut Interpreted<'p>, case: u64) -> Outcome {
        let mut rng = Rng::new(self.seed, &format!("spoilt scene {case}"));
        let scene = self.scenes[rng.below(self.scenes.len())].clone();
        let (text, done) = spoilt(scene, &mut rng);
        if self.is_shown {
            println!("{text}");
        }
        let outcome = lobe_codegen::quietly(|| judged(self.renderer, dispatcher, &text));
        match outcome.unwrap_or_else(|message| Outcome::Wrong(format!("it panicked: {message}"))) {
            Outcome::Wrong(why) => {
                Outcome::Wrong(format!("seed {}, case {case}, {done:?}: {why}", self.seed))
            }
            outcome => outcome,
        }
    }
}

#[test]
fn spoilt_scenes_are_refused_or_pictures_of_light() {
    let only = from_environment("LOBE_CASE");
    let renderer = Renderer::new().unwrap_or_else(|e| panic!("{e}"));
    let seed = from_environment("LOBE_SEED").unwrap_or(7);
    let all = Cases { renderer: &renderer, scenes: sound(), seed, is_shown: only.is_some() };
    let numbers = only.map_or(0..from_environment("LOBE_CASES").unwrap_or(256), |case| case..case + 1);
    let outcomes: Vec<Outcome> = numbers
        .into_par_iter()
        .map_init(Interpreted::default, |dispatcher, case| all.run(dispatcher, case))
        .collect();
    let reason = |outcome: &Outcome| if let Outcome::Wrong(why) = outcome { Some(why.clone()) } else { None };
    let wrong: Vec<String> = outcomes.iter().filter_map(reason).collect();
    let lit = outcomes.iter().filter(|outcome| matches!(outcome, Outcome::Lit)).count();
    let refused = outcomes.iter().filter(|outcome| matches!(outcome, Outcome::Refused)).count();
    println!(
        "{} cases: {refused} refused, {lit} show light of one bounce, {} wrong",
        outcomes.len(),
        wrong.len()
    );
    let shown = wrong.iter().take(20).cloned().collect::<Vec<_>>().join("\n");
    assert!(wrong.is_empty(), "{} of {} went wrong:\n{shown}", wrong.len(), outcomes.len());
    // Else the test would say nothing of rendering.
    assert!(only.is_some() || 5 * lit > outcomes.len(), "{lit} of {} show any light", outcomes.len());
}
