//! One face for everything that runs a kernel: rows of arguments in, rows of results out.

mod error;
mod gpu_route;
mod interp;
mod native;
mod program;
pub mod trace;

pub use error::ExecError;
pub use gpu_route::{Ahead, GpuRoute};
pub(crate) use gpu_route::{Artifacts, Source};
pub use interp::Interp;
pub use native::Native;
pub use program::Program;

use crate::route::Route;
use lobe_codegen::data::Columns;
use lobe_codegen::trace::Traced;

/// Runs kernels on one route.
///
/// ```
/// use lobe_backends::executor::Program;
/// use lobe_backends::routes::Machine;
/// use lobe_codegen::data::Columns;
/// use lobe_codegen::prelude::*;
///
/// /// Adds one.
/// #[kernel]
/// pub fn next(x: f32) -> f32 {
///     x + 1.0
/// }
///
/// let program = Program::new(lobe_codegen::kernels![next][0])?;
/// let args = Columns { columns: vec![vec![2.0_f32.to_bits()]], rows: 1 };
/// // `spirv@lavapipe` and its like open as this does, where the machine has them.
/// let mut executor = Machine::look().open(&"interp".parse()?)?;
/// assert_eq!(executor.run(&program, &args)?.columns[0], [3.0_f32.to_bits()]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Executor {
    /// The route.
    fn route(&self) -> &Route;

    /// What the route's driver says of itself, its version with it; nothing where there is no driver.
    fn driver_info(&self) -> &str {
        ""
    }

    /// What can be done for a kernel before the route runs it, meanwhile and elsewhere.
    fn ahead(&self) -> Option<Ahead> {
        None
    }

    /// The kernel's result for each row of `args`, whose columns are [`Program::params`].
    ///
    /// # Errors
    /// When the arguments have another shape, or the route cannot run the kernel.
    fn run(&mut self, kernel: &Program, args: &Columns) -> Result<Columns, ExecError>;

    /// Runs `traced`, the kernel's module with traces, on one row of `args`, the way [`Executor::run`] would run it.
    ///
    /// # Errors
    /// As of [`Executor::run`], and when the route runs no modules.
    fn trace(
        &mut self,
        kernel: &Program,
        traced: &Traced,
        args: &Columns,
    ) -> Result<trace::Trace, ExecError> {
        let _ = (traced, args);
        Err(ExecError::Untraced { kernel: kernel.name(), route: self.route().clone() })
    }
}
