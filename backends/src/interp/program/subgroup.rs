//! What the invocations of a subgroup do together.

use super::{Reg, Value};
use naga::Span;

/// An operation of the active lanes of each subgroup.
#[derive(Debug, Clone)]
pub(crate) struct Subgroup {
    pub(crate) op: SubgroupOp,
    /// What each lane brings.
    pub(crate) value: Value,
    /// The lane, or the number that makes one, of a gathering.
    pub(crate) index: Option<Value>,
    pub(crate) to: Reg,
    /// Where the source has it.
    pub(crate) at: Span,
}

/// What it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum SubgroupOp {
    /// Word `0..4` of the mask of lanes in which the value holds.
    Ballot(u32),
    /// The value of another lane.
    Gather(Gather),
    /// All values in one, or those of the lanes before.
    Collect(naga::SubgroupOperation, naga::CollectiveOperation),
}

/// Which lane a value comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Gather {
    /// The first active one.
    First,
    /// The one of this number.
    Lane,
    /// So many further on.
    Down,
    /// So many further back.
    Up,
    /// The one whose number differs in these bits.
    Xor,
    /// The one of this number in the same four.
    Quad,
    /// The one in the same four whose number differs in these bits.
    QuadSwap(u32),
}
