//! Why a foreign tool gave no result.

use std::path::PathBuf;

/// Everything that can go wrong between a shader and a foreign tool's verdict on it.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum TranslateError {
    /// The tool is not installed.
    #[error("{tool} was not found (looked at {}); {mend}", looked_at.join(", "))]
    NotFound {
        /// The tool.
        tool: &'static str,
        /// Where it was looked for.
        looked_at: Vec<String>,
        /// How to get it.
        mend: &'static str,
    },

    /// The tool is there but does not load or start.
    #[error("{tool}: {} cannot be used: {reason}", path.display())]
    Unusable {
        /// The tool.
        tool: &'static str,
        /// Its file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },

    /// An argument that the tool cannot be given.
    #[error("{tool}: {reason}")]
    BadInput {
        /// The tool.
        tool: &'static str,
        /// What is wrong, and what would be right.
        reason: String,
    },

    /// The tool rejected the shader.
    #[error("{tool} rejected the shader:\n{}", message.trim_end())]
    Rejected {
        /// The tool.
        tool: &'static str,
        /// Its own message, whole.
        message: String,
    },

    /// The tool went wrong, or its output is not what it should be.
    #[error("{tool} went wrong: {reason}")]
    BadOutput {
        /// The tool.
        tool: &'static str,
        /// What was seen.
        reason: String,
    },
}
