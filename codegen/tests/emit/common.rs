//! A module with everything that makes names go wrong.

use lobe_codegen::ValidModule;
use lobe_codegen::emit::{Artifact, Options, Target, emit};
use lobe_codegen::validate::from_wgsl;

pub const RICH: &str = r"
/// A lobe.
///
/// Unit axis.
struct Sg {
    /// Direction, unit length.
    axis: vec3<f32>,
    /// 1/sr
    sharpness: f32,
    log_amplitude: f32,
}

struct Frame { thin: mat3x2<f32>, wide: mat3x3<f32>, product: array<f32, 3>, distance: f32 }

/// Twice π.
const TWO_PI: f32 = 6.2831855;
const AXES: array<vec3<f32>, 2> = array<vec3<f32>, 2>(vec3<f32>(1.0, 0.0, 0.0), vec3<f32>(0.0, 1.0, 0.0));

/// The square, `x²`.
fn square(x: f32) -> f32 { return x * x; }

fn f1(x: f32, x2: f32) -> f32 {
    var half = x + x2;
    let y1 = square(half);
    if y1 > 1.0 {
        let y1 = y1 * 3.0;
        half = half + y1 / (y1 + 2.0);
    }
    let x_1 = half * half;
    let lerp = x_1 * x_1 + y1;
    return lerp * lerp + x_1;
}

fn product(x: Sg, b: Sg) -> Sg {
    var r: Sg;
    r.axis = normalize(x.axis * x.sharpness + b.axis * b.sharpness);
    r.sharpness = x.sharpness + b.sharpness;
    r.log_amplitude = f1(x.log_amplitude, b.log_amplitude) - square(r.sharpness);
    return r;
}

fn total(count: u32, values: array<f32, 4>) -> f32 {
    var copy = values;
    var sum = 0.0;
    for (var i = 0u; i < count; i = i + 1u) {
        if i == 7u { continue; }
        sum += copy[i % 4u] * AXES[i % 2u].x;
        switch i {
            case 1u, 2u: { let z = sum * sum; sum = z + z * z; }
            case 3u: { sum = sum * TWO_PI; }
            default: { }
        }
    }
    return sum;
}

fn framed(f: Frame, k: f32) -> Frame {
    var g = f;
    g.thin[1] = vec2<f32>(k, g.distance);
    g.product[2] = total(2u, array<f32, 4>(k, k, k, k));
    return Frame(g.thin, g.wide * k, g.product, k);
}

fn parts(v: vec3<f32>) -> array<f32, 3> { return array<f32, 3>(v.x, v.y, v.z); }

fn flags(a: bool, b: vec3<bool>, n: i32) -> vec2<bool> {
    return vec2<bool>(a && any(b), n / 3 == 2);
}
";

pub fn rich() -> ValidModule {
    module(RICH)
}

pub fn module(text: &str) -> ValidModule {
    from_wgsl(text).unwrap_or_else(|error| panic!("{error}"))
}

pub fn artifact(module: &ValidModule, target: Target) -> Artifact {
    emit(module, target, &Options::default()).unwrap_or_else(|error| panic!("{target}: {error}"))
}

pub fn text(module: &ValidModule, target: Target) -> String {
    artifact(module, target).content.text().unwrap_or_default().to_owned()
}

/// The identifiers of a text, comments left out.
pub fn words(text: &str) -> Vec<String> {
    let code: String =
        text.lines().map(|line| line.split("//").next().unwrap_or_default().to_owned() + "\n").collect();
    code.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).map(str::to_owned).collect()
}
