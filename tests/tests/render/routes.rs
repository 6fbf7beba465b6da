//! Every pass on every route of the drivers, inside the derived bounds.

use lobe_backends::executor::ExecError;
use lobe_backends::pipeline::{Dispatcher, Interpreted, Memory, Pass};
use lobe_backends::route::Route;
use lobe_backends::routes::{Machine, State};
use lobe_tests::proxies::{self, Options};
use lobe_tests::render::{Density, Judged, Method, Renderer, Settings, VirtualLights, Visibility, summary};

fn check(name: &str, settings: &Settings, size: [u32; 2]) {
    let machine = Machine::look();
    let renderer = Renderer::new().unwrap_or_else(|e| panic!("{e}"));
    let mut routes = Vec::new();
    for (route, state) in machine.routes().into_iter().filter(|(route, _)| *route != Route::Native) {
        match state {
            State::Ready => routes.push(machine.dispatcher(&route).unwrap_or_else(|e| panic!("{e}"))),
            State::Missing { what, mend } => crate::common::skip(&what, &mend),
        }
    }
    let mut scene = crate::scene(name);
    scene.camera.size = size;
    let proxies = proxies::proxies(&scene, &Options::default()).unwrap_or_else(|e| panic!("{e}"));
    let mut judged = Judged::new(routes);
    renderer.render(&scene, &proxies, settings, &mut judged, &|_| {}).unwrap_or_else(|e| panic!("{e}"));
    for verdict in summary(&judged.verdicts) {
        assert!(verdict.words > 0, "{verdict:?}");
        assert!(verdict.holds(), "{name}, {settings:?}: {verdict:?}");
        assert!(verdict.disagrees_with.is_empty(), "{name}, {settings:?}: {verdict:?}");
    }
}

#[test]
fn rectangles_on_every_route() {
    check("cornell_L0.json", &Settings::default(), [8, 8]);
    for method in [Method::RectPaper, Method::RectLaplace] {
        check("plates_a010.json", &Settings { method, ..Settings::default() }, [6, 6]);
    }
}

#[test]
fn shadows_on_every_route() {
    for method in [Method::RectLaplace, Method::RectQuadrature] {
        check("plates_a010.json", &Settings { method, shadows: true, ..Settings::default() }, [4, 4]);
    }
}

#[test]
fn virtual_lights_on_every_route() {
    let lights = VirtualLights {
        count: 6,
        map: 9,
        directions: 2,
        bias: 0.05,
        visibility: Visibility::Exact,
        ..VirtualLights::default()
    };
    for method in [Method::Vsgl, Method::Vsgl2, Method::VslWide] {
        check(
            "plates_a010.json",
            &Settings { method, virtual_lights: lights, ..Settings::default() },
            [3, 3],
        );
    }
    let by_points = VirtualLights { density: Density::Vpl, visibility: Visibility::None, ..lights };
    for method in [Method::Vpl, Method::Vsl] {
        check(
            "caustic_a010.json",
            &Settings { method, virtual_lights: by_points, ..Settings::default() },
            [3, 3],
        );
    }
}

#[test]
fn imperfect_shadows_on_every_route() {
    let lights = VirtualLights {
        count: 5,
        map: 9,
        visibility: Visibility::Imperfect,
        shadow_points: 12,
        shadow_map: 8,
        ..VirtualLights::default()
    };
    let settings = Settings { method: Method::VslWide, virtual_lights: lights, ..Settings::default() };
    check("cornell_L1.json", &settings, [3, 3]);
}

#[test]
fn sampling_on_every_route() {
    let settings = Settings { method: Method::Reference, samples: 2, ..Settings::default() };
    check("caustic_a005.json", &settings, [6, 6]);
}

#[test]
fn textures_on_every_route() {
    check("textured.gltf", &Settings { method: Method::Direct, ..Settings::default() }, [8, 8]);
    let settings = Settings { method: Method::Reference, samples: 2, ..Settings::default() };
    check("textured.gltf", &settings, [4, 4]);
}

/// A route that is right but for the first float of the direct light.
struct Wrong<'p>(Interpreted<'p>);

impl<'p> Dispatcher<'p> for Wrong<'p> {
    fn route(&self) -> &Route {
        self.0.route()
    }

    fn dispatch(&mut self, pass: &'p Pass, invocations: u32, memory: &mut Memory) -> Result<(), ExecError> {
        self.0.dispatch(pass, invocations, memory)?;
        for buffer in pass.buffers().iter().filter(|buffer| buffer.name == "direct") {
            let mut bytes = memory.take(&buffer.name).unwrap_or_default();
            bytes[0..4].copy_from_slice(&1.25_f32.to_le_bytes());
            memory.put(&buffer.name, bytes);
        }
        Ok(())
    }
}

#[test]
fn a_wrong_word_is_outside() {
    let renderer = Renderer::new().unwrap_or_else(|e| panic!("{e}"));
    let mut scene = crate::scene("plates_a010.json");
    scene.camera.size = [4, 4];
    let proxies = proxies::proxies(&scene, &Options::default()).unwrap_or_else(|e| panic!("{e}"));
    let settings = Settings { method: Method::Direct, ..Settings::default() };
    let mut judged = Judged::new(vec![Box::new(Wrong(Interpreted::default()))]);
    renderer.render(&scene, &proxies, &settings, &mut judged, &|_| {}).unwrap_or_else(|e| panic!("{e}"));
    let short: Vec<_> = summary(&judged.verdicts).into_iter().filter(|verdict| !verdict.holds()).collect();
    assert_eq!(short.len(), 1, "{short:?}");
    assert_eq!((short[0].pass.as_str(), short[0].outside), ("direct_pass", 1));
    assert!(short[0].first.as_ref().is_some_and(|first| first.starts_with("direct, word 0: 1.25")));
}
