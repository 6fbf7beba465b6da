//! One face for everything that runs a kernel: rows of arguments in, rows of results out.

mod error;
mod gpu_route;
mod interp;
mod native;
mod program;

pub use error::ExecError;
pub use gpu_route::GpuRoute;
pub use interp::Interp;
pub use native::Native;
pub use program::Program;

use crate::route::Route;
use lobe_codegen::data::Columns;

/// Runs kernels on one route.
pub trait Executor {
    /// The route.
    fn route(&self) -> &Route;

    /// The kernel's result for each row of `args`, whose columns are [`Program::params`].
    ///
    /// # Errors
    /// When the arguments have another shape, or the route cannot run the kernel.
    fn run(&mut self, kernel: &Program, args: &Columns) -> Result<Columns, ExecError>;
}
