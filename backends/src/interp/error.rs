//! What the interpreter refuses, and what a program does wrong.

/// Why a module did not run to its end.
#[derive(Debug, Clone, thiserror::Error)]
pub enum InterpError {
    /// The module uses something that this interpreter does not have.
    #[error("in `{function}`: {what} is not supported by the interpreter")]
    Unsupported {
        /// Name of the function.
        function: String,
        /// The expression, statement or type.
        what: String,
    },
    /// The arguments do not fit the function.
    #[error("`{function}` takes {expected} scalars a row, got {found}")]
    Arguments {
        /// Name of the function.
        function: String,
        /// Scalars of its parameters.
        expected: usize,
        /// Columns given.
        found: usize,
    },
    /// A buffer is missing or too small for its binding.
    #[error("the buffer for group {group}, binding {binding} {what}")]
    Buffer {
        /// Bind group.
        group: u32,
        /// Binding.
        binding: u32,
        /// What is wrong with it.
        what: String,
    },
    /// A loop ran longer than it may.
    #[error("in `{function}`: a loop ran {rounds} rounds without an end; it is taken to be endless")]
    OutOfFuel {
        /// Name of the function.
        function: String,
        /// Rounds.
        rounds: u64,
    },
    /// A barrier that not all invocations of the workgroup reach.
    #[error("in `{function}`: a barrier is reached by {reached} of {lanes} invocations")]
    NonUniformBarrier {
        /// Name of the function.
        function: String,
        /// Invocations that reach it.
        reached: usize,
        /// Invocations of the workgroup.
        lanes: usize,
    },
}

/// A fault before the function it lies in is known.
#[derive(Debug, Clone, Copy, thiserror::Error)]
pub(super) enum Internal {
    #[error("a value of this kind at this place")]
    Kind,
    #[error("a type of this kind (textures, pointers in memory, or scalars that are not 32 bits wide)")]
    Type,
    #[error("an expression that was not evaluated before its use")]
    NotEvaluated,
}

/// A fault inside a function.
#[derive(Debug, Clone)]
pub(super) enum Fault {
    /// Something unsupported.
    Unsupported(String),
    /// An error that knows its function.
    Known(InterpError),
}

impl From<Internal> for Fault {
    fn from(internal: Internal) -> Self {
        Self::Unsupported(internal.to_string())
    }
}

impl Fault {
    /// The error, in this function.
    pub(super) fn within(self, function: &str) -> InterpError {
        match self {
            Self::Unsupported(what) => InterpError::Unsupported { function: function.to_owned(), what },
            Self::Known(error) => error,
        }
    }
}

pub(super) type Result<T> = std::result::Result<T, Fault>;
