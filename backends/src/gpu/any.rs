//! One face for the two ways to a device.

use std::time::Duration;

use super::{DawnGpu, Driver, Gpu, GpuError, Job};

/// An opened device, by whichever way.
#[derive(Debug)]
pub enum AnyGpu {
    /// Through wgpu, in this process.
    Wgpu(Box<Gpu>),
    /// Through Dawn, in another.
    Dawn(Box<DawnGpu>),
}

impl AnyGpu {
    /// The driver that was opened.
    #[must_use]
    pub fn driver(&self) -> &Driver {
        match self {
            Self::Wgpu(gpu) => gpu.driver(),
            Self::Dawn(gpu) => gpu.driver(),
        }
    }

    /// Sets how long a job may take from now on.
    pub fn set_timeout(&mut self, timeout: Duration) {
        match self {
            Self::Wgpu(gpu) => gpu.set_timeout(timeout),
            Self::Dawn(gpu) => gpu.set_timeout(timeout),
        }
    }

    /// Runs one job and returns the final bytes of what it may write.
    ///
    /// # Errors
    ///
    /// As [`Gpu::run`] and [`DawnGpu::run`].
    pub fn run(&mut self, job: &Job) -> Result<Vec<Vec<u8>>, GpuError> {
        match self {
            Self::Wgpu(gpu) => gpu.run(job),
            Self::Dawn(gpu) => gpu.run(job),
        }
    }
}
