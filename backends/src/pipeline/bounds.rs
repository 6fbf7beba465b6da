//! What permitted drivers may leave of a pass.

use super::{Access, Memory, Pass};
use crate::executor::ExecError;
use crate::interp::{Buffer, Interpreter, ShadowWord};

/// Rounds of loops of a workgroup, after which a loop that drivers may leave in different rounds is given up, and nothing
/// promised of what it writes.
const ROUNDS: u64 = 1 << 13;

impl Pass {
    /// What the pass leaves in each buffer that it may write, word by word, and what a permitted driver may leave there
    /// in its place, given `memory`.
    ///
    /// # Errors
    /// When a buffer is missing, or the interpreter gives up.
    pub fn permitted(
        &self,
        invocations: u32,
        memory: &Memory,
    ) -> Result<Vec<(&str, Vec<ShadowWord>)>, ExecError> {
        let bytes = memory.of(self)?;
        let gave_up = |cause: crate::interp::InterpError| ExecError::Interp {
            kernel: self.name(),
            cause: cause.into(),
        };
        let bound = self.buffers().iter().zip(bytes);
        let mut buffers: Vec<Buffer> =
            bound.map(|(at, data)| Buffer::copied(at.layout.group, at.layout.binding, data)).collect();
        let interpreter = Interpreter::new(self.module()).map_err(gave_up)?.with_fuel(ROUNDS);
        let left = interpreter.shadow_run(0, self.groups(invocations), &mut buffers).map_err(gave_up)?;
        let written = self.buffers().iter().filter(|at| at.access == Access::ReadWrite);
        let named = written.filter_map(|at| {
            let place = (at.layout.group, at.layout.binding);
            let found = left.buffers.iter().find(|buffer| (buffer.group, buffer.binding) == place)?;
            Some((at.name.as_str(), found.words.clone()))
        });
        Ok(named.collect())
    }
}
