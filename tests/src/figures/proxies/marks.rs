//! Outlines and normals of rectangles as SVG, dashed and faint where the mesh hides them.

use super::colour::hue;
use super::view::View;
use crate::proxies::Proxy;
use crate::render::encoded;
use lobe_codegen::prelude::Vec3;
use rayon::prelude::*;
use std::fmt::Write;

/// Pixels of a piece of an outline, which is seen or hidden as a whole.
const PIECE: f32 = 3.0;
/// The most pieces of a side.
const MOST: usize = 400;
/// Length of a normal, over the root of the rectangle's half sides' product.
const NORMAL: f32 = 0.3;

/// The marks of all, the farthest first.
pub(super) fn marks(view: &View, proxies: &[Proxy]) -> String {
    let eye = view.camera.position();
    let mut order: Vec<usize> = (0..proxies.len()).collect();
    let depth = |index: &usize| proxies[*index].position.distance_squared(eye);
    order.sort_by(|a, b| depth(b).total_cmp(&depth(a)));
    order.par_iter().map(|&index| mark(view, index, &proxies[index])).collect()
}

/// Strokes of one rectangle.
fn mark(view: &View, index: usize, proxy: &Proxy) -> String {
    let mut strokes = Strokes::default();
    let corners = proxy.corners();
    let slack = proxy.deviation.max / leaning(view, proxy).max(0.2);
    for (i, from) in corners.iter().enumerate() {
        outline(view, *from, corners[(i + 1) % 4], slack, &mut strokes);
    }
    normal(view, proxy, slack, &mut strokes);
    let [red, green, blue] = hue(index, 0.5, 0.16).map(encoded);
    let colour = format!("rgb({red},{green},{blue})");
    format!("<g fill=\"none\" stroke=\"{colour}\" stroke-linecap=\"round\">{}</g>\n", strokes.text(&colour))
}

/// The cosine at which a rectangle's middle is seen.
fn leaning(view: &View, proxy: &Proxy) -> f32 {
    (proxy.position - view.camera.position()).normalize_or_zero().dot(proxy.normal).abs()
}

/// Paths of what is seen, and of what is hidden.
#[derive(Default)]
struct Strokes {
    seen: String,
    hidden: String,
    /// Where a normal begins that is seen.
    dot: Option<[f32; 2]>,
}

impl Strokes {
    fn of(&mut self, is_seen: bool) -> &mut String {
        if is_seen { &mut self.seen } else { &mut self.hidden }
    }

    fn text(&self, colour: &str) -> String {
        let Self { seen, hidden, dot } = self;
        let mut text = String::new();
        for (path, style) in [
            (hidden, "stroke-width=\"1\" stroke-opacity=\"0.35\" stroke-dasharray=\"3 4\""),
            (seen, "stroke-width=\"1.4\""),
        ] {
            if !path.is_empty() {
                let _ = write!(text, "<path {style} d=\"{path}\"/>");
            }
        }
        if let Some([x, y]) = dot {
            let _ = write!(
                text,
                "<circle fill=\"{colour}\" stroke=\"none\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"1.8\"/>"
            );
        }
        text
    }
}

/// A side, in pieces.
fn outline(view: &View, from: Vec3, to: Vec3, slack: f32, strokes: &mut Strokes) {
    let pixels = match (view.project(from), view.project(to)) {
        (Some([x0, y0]), Some([x1, y1])) => (x1 - x0).hypot(y1 - y0),
        _ => f32::INFINITY,
    };
    let count = ((pixels / PIECE).ceil() as usize).clamp(1, MOST);
    let at = |i: f32| from.lerp(to, i / count as f32);
    let middles: Vec<Vec3> = (0..count).map(|i| at(i as f32 + 0.5)).collect();
    let seen = view.sees(&middles, slack);
    // What the pen is on: a stroke goes on while nothing changes.
    let mut pen = None;
    for (i, is_seen) in seen.into_iter().enumerate() {
        let (Some(a), Some(b)) = (view.project(at(i as f32)), view.project(at(i as f32 + 1.0))) else {
            pen = None;
            continue;
        };
        let path = strokes.of(is_seen);
        if pen != Some(is_seen) {
            let _ = write!(path, "M{:.1} {:.1}", a[0], a[1]);
        }
        let _ = write!(path, "L{:.1} {:.1}", b[0], b[1]);
        pen = Some(is_seen);
    }
}

/// The normal, from the middle on.
fn normal(view: &View, proxy: &Proxy, slack: f32, strokes: &mut Strokes) {
    let tip = proxy.position + NORMAL * (proxy.half_x * proxy.half_y).sqrt() * proxy.normal;
    let is_seen = view.sees(&[proxy.position], slack).contains(&true);
    let (Some(a), Some(b)) = (view.project(proxy.position), view.project(tip)) else { return };
    let _ = write!(strokes.of(is_seen), "M{:.1} {:.1}L{:.1} {:.1}", a[0], a[1], b[0], b[1]);
    strokes.dot = is_seen.then_some(a);
}
