//! Sums of all that comes before each: within blocks, and of blocks.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::HillisSteele86;
use crate::rsm::chain::MapLevel;
use crate::rsm::curve::curve_texel;
use crate::scene::NOWHERE;
use lobe_codegen::prelude::*;

/// Numbers that an invocation adds up.
#[kernel]
pub const SCAN_EACH: u32 = 16;
/// Numbers of a block: 64 invocations'.
#[kernel]
pub const SCAN_BLOCK: u32 = 1024;

/// A pass that sums what `$read` gives at each place within blocks of [`SCAN_BLOCK`].
macro_rules! scan_pass {
    (
        $(#[$doc:meta])* $name:ident, $values:ident, $sums:ident, $totals:ident,
        [$($levels:ident: $level:ty)?], |$at:ident| $read:expr
    ) => {
        $(#[$doc])*
        ///
        /// Source: [HillisSteele86] across invocations, one after the other within.
        #[kernel(workgroup_size(64))]
        pub fn $name(
            #[builtin(local_invocation_index)] index: u32,
            #[builtin(workgroup_id)] group: UVec3,
            #[storage(0, 0)] $values: &[Vec2],
            #[storage(0, 1)] $sums: &mut [Vec2],
            #[storage(0, 2)] $totals: &mut [Vec2],
            $(#[storage(0, 3)] $levels: &[$level],)?
            #[workgroup] partial: &mut [Vec2; 64],
        ) {
            let count = $sums.len() as u32;
            let first = SCAN_BLOCK * group.x + SCAN_EACH * index;
            let mut own = Vec2::ZERO;
            for k in 0_u32..16 {
                let $at = first + k;
                if $at < count {
                    own += $read;
                }
            }
            partial[index as usize] = own;
            let mut back = 1_u32;
            for _ in 0_u32..6 {
                workgroup_barrier();
                let before = select(0_u32, index - min(back, index), index >= back);
                let added = select(Vec2::ZERO, partial[before as usize], index >= back);
                workgroup_barrier();
                partial[index as usize] += added;
                back *= 2;
            }
            workgroup_barrier();
            let mut sum = select(Vec2::ZERO, partial[(max(index, 1) - 1) as usize], index > 0);
            for k in 0_u32..16 {
                let $at = first + k;
                if $at < count {
                    sum += $read;
                    $sums[$at as usize] = sum;
                }
            }
            if index == 63 && group.x < $totals.len() as u32 {
                $totals[group.x as usize] = partial[63];
            }
        }
    };
}

scan_pass!(
    /// Sums of the estimates of each block up to each: a pass of 64 invocations a block.
    scan_pass,
    estimates,
    sums,
    block_totals,
    [],
    |at| estimates[at as usize]
);

scan_pass!(
    /// The same along [`crate::rsm::curve`]: of the estimates of a map's texels.
    scan_curve_pass,
    estimates,
    sums,
    block_totals,
    [levels: MapLevel],
    |at| {
        let texel = curve_texel(at, levels[0]);
        let last = estimates.len() as u32 - 1;
        select(Vec2::ZERO, estimates[min(texel, last) as usize], texel != NOWHERE)
    }
);

scan_pass!(
    /// Sums of the blocks up to each: a pass of 64 invocations.
    scan_block_pass,
    block_totals,
    block_sums,
    all_totals,
    [],
    |at| block_totals[at as usize]
);
