//! The pictures of `tests/cases/metrics/flip.py`, by the same formulas.

use lobe_codegen::glam::DVec3;
use lobe_tests::domain::Rng;
use lobe_tests::metrics::Image;

const SIZE: [u32; 2] = [64, 48];

/// The picture of this name.
pub(crate) fn picture(name: &str) -> Image {
    match name {
        "gradient" => by(|p| DVec3::new(p.u, p.v, 1.0 - p.u)),
        "gradient darkened" => by(|p| 0.9 * DVec3::new(p.u, p.v, 1.0 - p.u)),
        "gradient turned" => by(|p| DVec3::new(p.v, 1.0 - p.u, p.u)),
        "noise 1" => of(&noise(1)),
        "noise 2" => of(&noise(2)),
        "checkers" => by(|p| checker(p, 0)),
        "checkers shifted" => by(|p| checker(p, 3)),
        "ramp" => by(|p| ramp(p, 1.0)),
        "ramp bent" => by(|p| ramp(p, 0.8 + 0.4 * p.v)),
        "fireflies" => of(&fireflies(100.0)),
        "no fireflies" => of(&fireflies(1.0)),
        "dark" => by(|p| dark(p, 1.0)),
        "dark brightened" => by(|p| dark(p, 1.3)),
        name => panic!("there is no picture `{name}`"),
    }
}

/// A pixel, and where its middle is in 0 .. 1.
#[derive(Clone, Copy)]
struct Place {
    x: u32,
    y: u32,
    u: f64,
    v: f64,
}

fn by(colour: impl Fn(Place) -> DVec3) -> Image {
    let [width, height] = SIZE;
    let place = |i: u32| {
        let (x, y) = (i % width, i / width);
        Place {
            x,
            y,
            u: (f64::from(x) + 0.5) / f64::from(width),
            v: (f64::from(y) + 0.5) / f64::from(height),
        }
    };
    of(&(0..width * height).map(|i| colour(place(i))).collect::<Vec<_>>())
}

fn of(colours: &[DVec3]) -> Image {
    Image { size: SIZE, pixels: colours.iter().map(|colour| colour.as_vec3()).collect() }
}

fn noise(seed: u64) -> Vec<DVec3> {
    let mut rng = Rng::new(seed, "");
    let mut number = || rng.unit();
    (0..SIZE[0] * SIZE[1]).map(|_| DVec3::new(number(), number(), number())).collect()
}

fn checker(place: Place, shift: u32) -> DVec3 {
    let white = f64::from(((place.x + shift) / 8 + place.y / 8) % 2);
    DVec3::new(0.1, 0.1, 0.2) + white * DVec3::new(0.8, 0.6, 0.3)
}

fn ramp(place: Place, gain: f64) -> DVec3 {
    (16.0 * place.u - 8.0).exp2() * gain * DVec3::new(1.0, 0.5 + 0.5 * place.v, 0.25)
}

fn fireflies(gain: f64) -> Vec<DVec3> {
    let bright = noise(4);
    let light = noise(3).into_iter().zip(bright);
    light.map(|(c, bright)| c.powf(4.0) * if bright.x < 0.02 { gain } else { 1.0 }).collect()
}

fn dark(place: Place, gain: f64) -> DVec3 {
    if place.y < 30 { DVec3::ZERO } else { gain * DVec3::new(place.u, place.v, 1.0) }
}
