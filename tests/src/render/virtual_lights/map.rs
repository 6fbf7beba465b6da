//! What a map shows, and the levels of its chain.

use lobe_codegen::glam::{Vec2, Vec3};
use lobe_kernels::rsm::chain::MapLevel;
use lobe_kernels::rsm::view::MapView;
use lobe_kernels::scene::Triangle;
use lobe_kernels::scene::light::SceneLight;

/// By how much more than the scene a directional light's map shows: what is on its edge is within.
const MARGIN: f32 = 1.0001;

/// The map of `light`, of `side` by `side` texels.
pub(super) fn view(light: &SceneLight, at: u32, side: u32, triangles: &[Triangle], place: Vec2) -> MapView {
    let corners = || triangles.iter().flat_map(|t| [t.a, t.b, t.c]);
    let low = corners().fold(Vec3::INFINITY, Vec3::min);
    let high = corners().fold(Vec3::NEG_INFINITY, Vec3::max);
    let middle = 0.5 * (low + high);
    let (right, up) = light.axis.any_orthonormal_pair();
    let reach = |along: Vec3| {
        let spans = corners().map(|corner| (corner - middle).dot(along));
        let (least, most) = spans.fold((f32::INFINITY, f32::NEG_INFINITY), |(a, b), s| (a.min(s), b.max(s)));
        (0.5 * (least + most), 0.5 * (most - least))
    };
    let ((x, half_x), (y, half_y), (z, half_z)) = (reach(right), reach(up), reach(light.axis));
    // A scene that is flat to the light has a width all the same.
    let width = |half: f32| MARGIN * half.max(1e-3 * (half_x + half_y + half_z)).max(1e-6);
    let before = z + MARGIN * half_z + 1e-2 * (half_x + half_y + half_z);
    let (origin, right, up) = match light.is_spot {
        1 => (middle, Vec3::ZERO, Vec3::ZERO),
        _ => (middle + x * right + y * up + before * light.axis, width(half_x) * right, width(half_y) * up),
    };
    MapView { origin, width: side, right, height: side, up, light: at, place }
}

/// The levels of a map: its points, then means until there is one.
pub(super) fn levels(width: u32, height: u32) -> Vec<MapLevel> {
    let mut levels = vec![MapLevel { first: 0, width, height }];
    let (mut first, mut size) = (0, [width, height]);
    loop {
        size = size.map(|side| side.div_ceil(2));
        levels.push(MapLevel { first, width: size[0], height: size[1] });
        first += size[0] * size[1];
        if size == [1, 1] {
            return levels;
        }
    }
}

/// How many means the levels have.
pub(super) fn means(levels: &[MapLevel]) -> u32 {
    levels.last().map_or(1, |last| last.first + last.width * last.height)
}

/// The first level of means that has no more than `count` of them.
pub(super) fn level_of(levels: &[MapLevel], count: u32) -> usize {
    let found = levels.iter().skip(1).position(|level| level.width * level.height <= count);
    found.map_or(levels.len() - 1, |at| at + 1)
}
