//! What sanitizing finds in the program that runs.

use super::error::line;
use naga::Span;

/// A mistake of a program, where it showed.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// What kind of mistake.
    pub kind: Fault,
    /// Where the source has it; undefined for what was not made from text.
    pub span: Span,
    /// The invocation that made it.
    pub invocation: Invocation,
    /// What happened, with its numbers.
    pub message: String,
}

/// Kinds of mistakes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Fault {
    /// An index beyond the end of what it indexes; WGSL clamps it.
    OutOfBounds,
    /// The value of a function, private or workgroup variable that nothing was written to is used; WGSL makes it zero.
    Unwritten,
    /// Two invocations touch the same word, one of them writes, and no barrier lies between.
    Race,
    /// A value is gathered from an invocation of the subgroup that is not active, or not there; WGSL leaves it open.
    AbsentLane,
    /// A part of a workgroup reaches a barrier.
    NonUniformBarrier,
    /// An integer is divided by zero, or the quotient overflows.
    DivisionByZero,
    /// An operation on numbers returns NaN.
    NanBirth,
    /// A loop runs longer than the fuel allows.
    EndlessLoop,
}

/// Who executes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Invocation {
    /// A row of a function's arguments.
    Row(usize),
    /// An invocation of a dispatch.
    Global {
        /// Its workgroup.
        group: [u32; 3],
        /// Its place in the workgroup.
        local: [u32; 3],
    },
}

/// Which mistakes are looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Checks {
    /// Look for [`Fault::Unwritten`] too: what WGSL defines to be zero is not always meant to be.
    pub unwritten: bool,
    /// At most so many findings; one for each kind and place of the source.
    pub limit: usize,
}

impl Default for Checks {
    fn default() -> Self {
        Self { unwritten: false, limit: 100 }
    }
}

impl Finding {
    /// Its line and column in the source text, counted from 1.
    pub fn line(&self, source: &str) -> Option<(u32, u32)> {
        line(&self.span.to_range()?, source)
    }
}
