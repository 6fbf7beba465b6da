//! Pictures: passes on every target, the tree against brute force, the reference against an independent renderer,
//! methods against the reference, routes against the derived bounds, and scenes that are none.

mod bvh;
#[path = "../common/mod.rs"]
mod common;
mod field;
mod field_tree;
mod imperfect;
mod passes;
mod reference;
mod reflectors;
mod routes;
mod shadows;
mod spoil;
mod spoilt;
mod textures;
mod two_lights;
mod virtual_lights;
mod wild;

use lobe_backends::pipeline::Interpreted;
use lobe_tests::proxies::{self, Options};
use lobe_tests::render::{Method, Picture, Renderer, Settings};
use lobe_tests::scene::{Choices, Scene};
use std::path::PathBuf;

/// A scene of the tests.
fn scene(name: &str) -> Scene {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("cases/scenes").join(name);
    Scene::open(&path, &Choices::default()).unwrap_or_else(|e| panic!("{name}: {e}"))
}

/// Its picture on the interpreter.
fn picture(scene: &Scene, method: Method, samples: u32) -> Picture {
    picture_by(scene, &Settings { method, samples, ..Settings::default() })
}

fn picture_by(scene: &Scene, settings: &Settings) -> Picture {
    let renderer = Renderer::new().unwrap_or_else(|e| panic!("{e}"));
    let proxies =
        proxies::proxies(scene, &Options::default()).unwrap_or_else(|e| panic!("{}: {e}", scene.name));
    let made = renderer.render(scene, &proxies, settings, &mut Interpreted::default(), &|_| {});
    made.unwrap_or_else(|e| panic!("{}, {}: {e}", scene.name, settings.method))
}
