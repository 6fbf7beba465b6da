//! What a user asks of a shader.

use super::feed::Feed;
use super::report::Status;
use super::texture::{SamplerWords, Sketch};
use crate::expectation::Expectation;
use std::path::PathBuf;

/// A run of a shader's entry points.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Job {
    /// The shader: WGSL, SPIR-V or GLSL, by its extension.
    pub file: PathBuf,
    /// Which entry points.
    pub entry: Entry,
    /// Workgroups along each axis.
    pub workgroups: [u32; 3],
    /// What buffers and textures hold, by name or `group:binding`.
    pub inputs: Vec<(String, Feed)>,
    /// What resources hold of which nothing is said.
    #[serde(default = "usual")]
    pub usual: Feed,
    /// Where the interpreter's results go.
    pub outputs: Vec<(String, PathBuf)>,
    /// Bytes of buffers.
    pub sizes: Vec<(String, usize)>,
    /// Elements of binding arrays that do not say how many they have.
    #[serde(default)]
    pub elements: Vec<(String, u32)>,
    /// Shapes of textures.
    pub textures: Vec<(String, Sketch)>,
    /// Samplers.
    pub samplers: Vec<(String, SamplerWords)>,
    /// How far floats may be from the interpreter's where no bound is derived.
    pub within: Vec<(String, f64)>,
    /// Whether to look for mistakes of the program itself.
    pub sanitize: bool,
    /// Values of pipeline-overridable constants.
    pub overrides: Vec<(String, f64)>,
    /// Routes to compare with; all that are ready when empty.
    pub routes: Vec<String>,
    /// What drivers are permitted: the name of an accuracy model; the default where there is none.
    #[serde(default)]
    pub model: Option<String>,
    /// Rounds of loops that a batch of invocations, or a workgroup, may run.
    pub fuel: u64,
    /// Seconds that each step may take.
    pub timeout: u64,
    /// Whether it is part of a [check](super::check): the bounds of all outputs are derived, and what routes to one driver
    /// leave is compared with each other.
    #[serde(default)]
    pub check: bool,
    /// Faults of routes that are known.
    #[serde(default)]
    pub expected: Vec<Expectation>,
    /// Steps that are known to end badly, from runs before.
    #[serde(default)]
    pub given_up: Vec<GivenUp>,
}

/// Rounds of loops, unless said otherwise.
pub const FUEL: u64 = 1 << 22;

/// Seconds of each step, unless said otherwise.
pub const TIMEOUT: u64 = 20;

impl Job {
    /// A job of which nothing else is said.
    #[must_use]
    pub fn new(file: PathBuf, entry: Entry) -> Self {
        Self {
            file,
            entry,
            workgroups: [1; 3],
            inputs: Vec::new(),
            usual: usual(),
            outputs: Vec::new(),
            sizes: Vec::new(),
            elements: Vec::new(),
            textures: Vec::new(),
            samplers: Vec::new(),
            within: Vec::new(),
            sanitize: false,
            overrides: Vec::new(),
            routes: Vec::new(),
            model: None,
            fuel: FUEL,
            timeout: TIMEOUT,
            check: false,
            expected: Vec::new(),
            given_up: Vec::new(),
        }
    }

    /// What expectations call the shader: its file's name without the ending.
    #[must_use]
    pub fn stem(&self) -> String {
        self.file.file_stem().unwrap_or_default().to_string_lossy().into_owned()
    }
}

/// What a resource holds of which nothing is said.
#[must_use]
pub fn usual() -> Feed {
    Feed::Random(0)
}

/// Which entry points to run.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Entry {
    /// This one.
    Named(String),
    /// The only one; it is an error if there are more.
    Only,
    /// Each, one after the other.
    Each,
}

/// A step of a job.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Step {
    /// The entry point; `None` while the file is read.
    pub entry: Option<String>,
    /// `read`, `interp`, or a route.
    pub name: String,
}

/// A step that crashed or did not end.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct GivenUp {
    /// The step.
    pub step: Step,
    /// [`Status::Crashed`] or [`Status::Timeout`].
    pub status: Status,
    /// What was seen.
    pub message: String,
}
