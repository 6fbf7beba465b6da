//! Everything that can keep a job from running, told apart by whose move it is.

/// Why a driver could not be opened or a job gave no result.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum GpuError {
    /// The driver was listed but does not open.
    #[error("{driver}: the driver does not open: {reason}")]
    Open {
        /// [`Driver::name`](super::Driver::name).
        driver: String,
        /// What the driver or wgpu said.
        reason: String,
    },

    /// The driver lacks something that this kind of shader needs.
    #[error("{driver}: the driver does not offer {feature}; run this shader on another one")]
    Unsupported {
        /// [`Driver::name`](super::Driver::name).
        driver: String,
        /// What is lacking.
        feature: &'static str,
    },

    /// The job contradicts itself; nothing was sent to the driver.
    #[error("the job cannot be run: {reason}")]
    BadJob {
        /// Which part is wrong, and what would be right.
        reason: String,
    },

    /// The words are no SPIR-V module, or not one that has the job's entry point; nothing was sent to the driver.
    #[error("the SPIR-V is malformed: {reason}")]
    BadSpirv {
        /// What is wrong, with the index of the word.
        reason: String,
    },

    /// The WGSL does not parse or validate, or the job's bindings do not fit it.
    #[error("{driver}: the WGSL was rejected before it reached the driver: {message}")]
    InvalidWgsl {
        /// [`Driver::name`](super::Driver::name).
        driver: String,
        /// naga's or wgpu's message, with the source line where there is one.
        message: String,
    },

    /// The driver itself would not make a pipeline from the shader.
    #[error(
        "{driver}: the driver refused the shader: {message}. spirv-val may say what is wrong with it; \
         if it passes there, this is the driver's defect or a feature it lacks"
    )]
    Refused {
        /// [`Driver::name`](super::Driver::name).
        driver: String,
        /// What the driver said; often little.
        message: String,
    },

    /// The driver would not make a pipeline from the GLSL.
    #[error("{driver}: the driver refused the GLSL: {message}")]
    InvalidGlsl {
        /// [`Driver::name`](super::Driver::name).
        driver: String,
        /// What the driver said, with the line where it states one.
        message: String,
    },

    /// More workgroups along one axis than the driver starts.
    #[error(
        "{driver}: {asked:?} workgroups are more than the {limit} per axis that the driver allows; split the job"
    )]
    TooManyGroups {
        /// [`Driver::name`](super::Driver::name).
        driver: String,
        /// The job's `groups`.
        asked: [u32; 3],
        /// The most along any axis.
        limit: u32,
    },

    /// A workgroup larger than the driver runs.
    #[error(
        "{driver}: a workgroup of {asked:?} is larger than the driver allows (at most {limit:?}, {total} in all)"
    )]
    WorkgroupTooLarge {
        /// [`Driver::name`](super::Driver::name).
        driver: String,
        /// The job's `workgroup_size`.
        asked: [u32; 3],
        /// The most along each axis.
        limit: [u32; 3],
        /// The most invocations in one workgroup.
        total: u32,
    },

    /// A buffer larger than the driver binds.
    #[error(
        "{driver}: the buffer at group {group}, binding {binding} has {bytes} bytes, the driver allows {limit}; \
         split the job"
    )]
    BufferTooLarge {
        /// [`Driver::name`](super::Driver::name).
        driver: String,
        /// The binding's group.
        group: u32,
        /// The binding's number.
        binding: u32,
        /// Its size.
        bytes: u64,
        /// The largest allowed.
        limit: u64,
    },

    /// The driver has no memory left.
    #[error("{driver}: out of memory; use smaller buffers")]
    OutOfMemory {
        /// [`Driver::name`](super::Driver::name).
        driver: String,
    },

    /// The driver did not come back in time. What hangs is left behind, the next job starts on a fresh device.
    #[error(
        "{driver}: no result after {limit:?}, the job was given up: the shader may not terminate, \
         else raise the limit with Gpu::set_timeout"
    )]
    Timeout {
        /// [`Driver::name`](super::Driver::name).
        driver: String,
        /// The limit that was passed.
        limit: std::time::Duration,
    },

    /// The device was lost while the job ran. The next job starts on a fresh one.
    #[error("{driver}: the device was lost while the shader ran: {message}")]
    DeviceLost {
        /// [`Driver::name`](super::Driver::name).
        driver: String,
        /// What the driver said; often little.
        message: String,
    },

    /// wgpu rejected a step for a reason that has no variant of its own.
    #[error("{driver}: wgpu rejected the job: {message}")]
    Rejected {
        /// [`Driver::name`](super::Driver::name).
        driver: String,
        /// wgpu's message.
        message: String,
    },
}
