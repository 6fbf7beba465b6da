//! The mesh in grey, and rectangles that tint it.

use super::colour::hue;
use super::view::{Met, View};
use crate::proxies::Proxy;
use crate::render::encoded;
use crate::scene::Camera;
use lobe_codegen::prelude::Vec3;
use rayon::prelude::*;

/// Rays along each side of a pixel.
const RAYS: u32 = 2;
/// Share of a rectangle's colour where it tints.
const TINT: f32 = 0.42;
/// Where there is nothing.
const PAGE: Vec3 = Vec3::splat(1.0);
/// Share of its depth, and of its deviation, by which a rectangle may be behind the mesh and tint it.
const BEHIND: [f32; 2] = [2e-3, 1.05];

/// The pixels of the mesh and the rectangles, 8-bit RGB.
pub(super) fn ground(view: &View, proxies: &[Proxy]) -> Vec<u8> {
    let [width, height] = view.camera.size;
    let fine = view.camera.with_size([width * RAYS, height * RAYS]);
    let panes: Vec<Pane> =
        proxies.iter().enumerate().map(|(index, proxy)| Pane::new(view, index, proxy)).collect();
    let row = |row: u32| -> Vec<u8> {
        let lines: Vec<Vec<Vec3>> =
            (0..RAYS).map(|line| line_of(view, &fine, &panes, RAYS * row + line)).collect();
        let pixel = |column: u32| -> Vec3 {
            let part = (RAYS * column) as usize..(RAYS * (column + 1)) as usize;
            lines.iter().flat_map(|line| &line[part.clone()]).sum::<Vec3>() / (RAYS * RAYS) as f32
        };
        (0..width).flat_map(|column| pixel(column).to_array().map(encoded)).collect()
    };
    (0..height).into_par_iter().flat_map_iter(row).collect()
}

/// The colours along a line of rays, linear.
fn line_of(view: &View, fine: &Camera, panes: &[Pane], row: u32) -> Vec<Vec3> {
    let directions: Vec<Vec3> = (0..fine.size[0]).map(|column| fine.ray(column, row).direction).collect();
    let near: Vec<&Pane> = panes.iter().filter(|pane| pane.is_in_row(row / RAYS)).collect();
    let met = view.meet(&directions);
    let colour = |((column, dir), met): ((u32, &Vec3), &Option<Met>)| {
        let end = met.map_or(f32::INFINITY, |(dist, _)| dist);
        let mut layers: Vec<(f32, Vec3)> = near
            .iter()
            .filter(|pane| pane.is_in_column(column / RAYS))
            .filter_map(|pane| Some((pane.met(fine.position(), *dir, end)?, pane.colour)))
            .collect();
        layers.sort_by(|a, b| b.0.total_cmp(&a.0));
        let base = met.map_or(PAGE, |(_, normal)| Vec3::splat(grey(normal.dot(*dir))));
        layers.iter().fold(base, |below, (_, colour)| below.lerp(*colour, TINT))
    };
    (0..).zip(&directions).zip(&met).map(colour).collect()
}

/// The light of the mesh by the cosine between its normal and the ray: less than a half from behind.
fn grey(cosine: f32) -> f32 {
    if cosine < 0.0 { 0.22 - 0.5 * cosine } else { 0.13 + 0.25 * cosine }
}

/// A rectangle on its way into the picture.
struct Pane<'a> {
    proxy: &'a Proxy,
    colour: Vec3,
    /// The columns and the rows that it is in.
    columns: [f32; 2],
    rows: [f32; 2],
}

impl<'a> Pane<'a> {
    fn new(view: &View, index: usize, proxy: &'a Proxy) -> Self {
        let places: Option<Vec<[f32; 2]>> = proxy.corners().iter().map(|c| view.project(*c)).collect();
        let span = |axis: usize| match &places {
            Some(places) => places.iter().fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], place| {
                [low.min(place[axis] - 1.0), high.max(place[axis] + 1.0)]
            }),
            // Some of it is behind the camera, so that it may be anywhere.
            None => [f32::NEG_INFINITY, f32::INFINITY],
        };
        let colour = Vec3::from_array(hue(index, 0.72, 0.14));
        Self { proxy, colour, columns: span(0), rows: span(1) }
    }

    fn is_in_row(&self, row: u32) -> bool {
        self.rows[0] <= row as f32 + 1.0 && row as f32 <= self.rows[1]
    }

    fn is_in_column(&self, column: u32) -> bool {
        self.columns[0] <= column as f32 + 1.0 && column as f32 <= self.columns[1]
    }

    /// How far a ray goes to it, if it is met before `end` or not far behind.
    fn met(&self, origin: Vec3, dir: Vec3, end: f32) -> Option<f32> {
        let proxy = self.proxy;
        let cosine = proxy.normal.dot(dir);
        let dist = proxy.normal.dot(proxy.position - origin) / cosine;
        let slack = BEHIND[0] * dist + BEHIND[1] * proxy.deviation.max / cosine.abs().max(0.2);
        let offset = origin + dist * dir - proxy.position;
        let across = proxy.normal.cross(proxy.tangent);
        let is_inside =
            offset.dot(proxy.tangent).abs() <= proxy.half_x && offset.dot(across).abs() <= proxy.half_y;
        (dist > 0.0 && dist <= end + slack && is_inside).then_some(dist)
    }
}
