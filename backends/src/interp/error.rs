//! What can go wrong while a module is interpreted.

use naga::Span;
use std::ops::Range;

/// Why a call or a dispatch has no result.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum InterpError {
    /// The interpreter does not execute this.
    #[error("the interpreter does not execute {what} (in `{function}`)")]
    Unsupported {
        /// The expression, statement or type.
        what: String,
        /// The function that contains it.
        function: String,
        /// Its bytes in the source, if it was made from text.
        at: Option<Range<usize>>,
    },
    /// The arguments do not fit the function's parameters.
    #[error("`{function}` takes {expected} scalars a row, but {found} were given")]
    Arguments {
        /// The function.
        function: String,
        /// Scalars of its parameters.
        expected: usize,
        /// Columns given.
        found: usize,
    },
    /// The columns of exact values do not fit the arguments.
    #[error("`{function}` needs {expected} columns of exact values as long as the arguments")]
    ExactColumns {
        /// The function.
        function: String,
        /// Scalars of its parameters.
        expected: usize,
    },
    /// No entry point has this index.
    #[error("the module has no entry point {0}")]
    NoEntryPoint(usize),
    /// An entry point uses a buffer that was not given.
    #[error("no buffer was given for `{name}` (group {group}, binding {binding})")]
    MissingBuffer {
        /// Name of the variable.
        name: String,
        /// Its group.
        group: u32,
        /// Its binding within the group.
        binding: u32,
    },
    /// A binding array was given too few elements.
    #[error(
        "`{name}` (group {group}, binding {binding}) is a binding array of {expected} elements or more, but {found} \
         were given"
    )]
    MissingElements {
        /// Name of the variable.
        name: String,
        /// Its group.
        group: u32,
        /// Its binding within the group.
        binding: u32,
        /// How many it needs.
        expected: usize,
        /// How many were given.
        found: usize,
    },
    /// The buffers of a binding array are too large to be addressed.
    #[error("the buffers of the binding array `{name}` have 4 GiB or more together")]
    ElementsTooLarge {
        /// Name of the variable.
        name: String,
    },
    /// A buffer is shorter than its type.
    #[error("the buffer of `{name}` has {found} bytes, its type needs {expected}")]
    BufferTooSmall {
        /// Name of the variable.
        name: String,
        /// Bytes of the type (for a runtime-sized array: of one element and what precedes it).
        expected: usize,
        /// Bytes given.
        found: usize,
    },
    /// An entry point uses a texture that was not given.
    #[error("no texture was given for `{name}` (group {group}, binding {binding})")]
    MissingTexture {
        /// Name of the variable.
        name: String,
        /// Its group.
        group: u32,
        /// Its binding within the group.
        binding: u32,
    },
    /// An entry point uses a sampler that was not given.
    #[error("no sampler was given for `{name}` (group {group}, binding {binding})")]
    MissingSampler {
        /// Name of the variable.
        name: String,
        /// Its group.
        group: u32,
        /// Its binding within the group.
        binding: u32,
    },
    /// A texture is not what its variable wants.
    #[error("`{name}` is {expected}; it cannot be {found}")]
    TextureMisfit {
        /// Name of the variable.
        name: String,
        /// What it is.
        expected: String,
        /// Shape of the texture given.
        found: String,
    },
    /// A sampler compares where its variable does not, or the reverse.
    #[error(
        "`{name}` is a {} sampler; give it one {} comparison",
        if *comparison { "comparison" } else { "filtering" },
        if *comparison { "with a" } else { "without" }
    )]
    SamplerMisfit {
        /// Name of the variable.
        name: String,
        /// Whether it compares.
        comparison: bool,
    },
    /// Some invocations of a workgroup reached a barrier that others did not.
    #[error("a barrier in `{function}` is reached by a part of the workgroup only")]
    NonUniformBarrier {
        /// The function that contains it.
        function: String,
    },
    /// Loops ran longer than the fuel allows.
    #[error("a loop in `{function}` runs too long")]
    OutOfFuel {
        /// The function that contains it.
        function: String,
    },
    /// Overrides without a value, or with one that does not fit.
    #[error("{0}")]
    Override(String),
    /// The module breaks a rule that validation should have caught.
    #[error("malformed module: {0}")]
    Malformed(&'static str),
}

impl InterpError {
    /// Line and column, counted from 1, of what is not executed.
    #[must_use]
    pub fn line(&self, source: &str) -> Option<(u32, u32)> {
        match self {
            Self::Unsupported { at: Some(at), .. } => line(at, source),
            _ => None,
        }
    }

    /// The same at `place`, if it has none yet.
    pub(super) fn placed(self, place: Span) -> Self {
        match self {
            Self::Unsupported { what, function, at: None } => {
                Self::Unsupported { what, function, at: place.to_range() }
            }
            other => other,
        }
    }
}

/// Line and column of bytes of a text, counted from 1.
pub(super) fn line(range: &Range<usize>, source: &str) -> Option<(u32, u32)> {
    let before = source.get(..range.start).filter(|_| range.end <= source.len())?;
    let line = before.matches('\n').count() as u32 + 1;
    let column = before.rsplit('\n').next().unwrap_or("").chars().count() as u32 + 1;
    Some((line, column))
}

/// Result of the interpreter's parts.
pub(super) type Res<T> = Result<T, InterpError>;
