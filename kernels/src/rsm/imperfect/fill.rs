//! Holes of maps: the nearest of ever larger squares, and what of them a texel takes.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::Ritschel08;
use crate::rsm::imperfect::share::ImperfectSettings;
use crate::scene::NOWHERE;
use lobe_codegen::prelude::*;

/// The depth of what is nowhere.
#[kernel]
pub const NO_DEPTH: f32 = 1e30;

/// What a light sees in a texel of its map, or in a square of several.
#[kernel]
pub struct MapDepth {
    /// How far it is, in m; [`NO_DEPTH`] where there is nothing.
    #[domain(0.0..=1e30)]
    pub depth: f32,
    /// Which point it is; [`NOWHERE`] for none.
    pub blocker: u32,
}

/// What is in a texel of `codes` and `owners`.
#[kernel]
pub fn coded_depth(code: u32, owner: u32) -> MapDepth {
    let depth = f32::from_bits(NOWHERE - max(code, 2155872256));
    MapDepth {
        depth: select(NO_DEPTH, depth, code > 0),
        blocker: select(NOWHERE, max(owner, 1) - 1, code > 0),
    }
}

/// The nearer of two; of two at the same depth the first.
#[kernel]
pub fn nearer_depth(a: MapDepth, b: MapDepth) -> MapDepth {
    let is_second = b.depth < a.depth;
    MapDepth { depth: select(a.depth, b.depth, is_second), blocker: select(a.blocker, b.blocker, is_second) }
}

/// The level that a pass makes: of all maps together.
///
/// Levels lie one after the other, the maps' own first; that is not pulled, so `hole_depths` begins with the next one.
#[kernel]
pub struct PullStep {
    /// Texels along a side of a map in the level that is made, a power of 2.
    #[domain(1.0..=64.0)]
    pub side: u32,
    /// How many texels that level has.
    pub count: u32,
    /// Where it begins.
    pub first: u32,
    /// Where the level below it begins.
    pub below: u32,
    /// How many texels the maps have.
    pub texels: u32,
}

/// A pass of the pull: `$read` gives what the level below has at a place.
macro_rules! pull_pass {
    ($(#[$doc:meta])* $name:ident, |$at:ident, $step:ident, $codes:ident, $owners:ident, $depths:ident| $read:expr) => {
        $(#[$doc])*
        ///
        /// Source: [Ritschel08], pull; of several depths the nearest and not a mean, since it is of one point.
        #[kernel(workgroup_size(64))]
        pub fn $name(
            #[builtin(global_invocation_id)] id: UVec3,
            #[uniform(0, 0)] $step: &PullStep,
            #[storage(0, 1)] $codes: &[u32],
            #[storage(0, 2)] $owners: &[u32],
            #[storage(0, 3)] $depths: &mut [MapDepth],
        ) {
            let i = id.x;
            if i >= $step.count {
                return;
            }
            let side = $step.side;
            let within = i % (side * side);
            // Both levels have as many maps, of which a side is twice as long below.
            let corner = 4 * (i - within) + 2 * ((within / side) * (2 * side) + within % side);
            let mut found = MapDepth { depth: NO_DEPTH, blocker: NOWHERE };
            for k in 0_u32..4 {
                let $at = $step.below + corner + (k / 2) * (2 * side) + k % 2;
                found = nearer_depth(found, $read);
            }
            $depths[($step.first + i - $step.texels) as usize] = found;
        }
    };
}

pull_pass!(
    /// The first level, of points alone: a pass of an invocation for each texel.
    pull_first_pass,
    |at, pull_step, codes, owners, hole_depths| coded_depth(codes[at as usize], owners[at as usize])
);

pull_pass!(
    /// A level after one that is there, of that and of its points: a pass of an invocation for each texel.
    pull_pass,
    |at, pull_step, codes, owners, hole_depths| nearer_depth(
        coded_depth(codes[at as usize], owners[at as usize]),
        hole_depths[(at - pull_step.texels) as usize]
    )
);

/// What is in each texel: the nearest of the points that cover it, and of the smallest square about it that has any. A pass.
///
/// All of the push in one step, since squares are not blended.
/// Source: [Ritschel08], push.
#[kernel(workgroup_size(64))]
pub fn hole_fill_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] imperfect: &ImperfectSettings,
    #[storage(0, 1)] codes: &[u32],
    #[storage(0, 2)] owners: &[u32],
    #[storage(0, 3)] hole_depths: &[MapDepth],
    #[storage(0, 4)] map_depths: &mut [MapDepth],
) {
    let i = id.x;
    let texels = map_depths.len() as u32;
    if i >= texels {
        return;
    }
    let mut side = imperfect.side;
    let map = i / (side * side);
    let row = (i / side) % side;
    let column = i % side;
    let mut found = coded_depth(codes[i as usize], owners[i as usize]);
    let mut first = texels;
    let mut count = texels;
    let mut up = 0_u32;
    // Whether no smaller square has anything.
    let mut is_hole = found.blocker == NOWHERE;
    while side > 1 {
        side /= 2;
        count /= 4;
        up += 1;
        let at = first + map * (side * side) + (row >> up) * side + (column >> up);
        found = nearer_depth(found, coded_depth(codes[at as usize], owners[at as usize]));
        if is_hole {
            found = nearer_depth(found, hole_depths[(at - texels) as usize]);
            is_hole = found.blocker == NOWHERE;
        }
        first += count;
    }
    map_depths[i as usize] = found;
}
