//! What runs a pass, and what it runs on.

use super::Pass;
use crate::executor::ExecError;
use crate::route::Route;
use std::collections::BTreeMap;

/// Buffers by name.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Memory(BTreeMap<String, Vec<u8>>);

impl Memory {
    /// Puts a buffer in the place of whatever had its name.
    pub fn put(&mut self, name: &str, bytes: Vec<u8>) {
        self.0.insert(name.to_owned(), bytes);
    }

    /// The bytes of a buffer; none if it is not there.
    #[must_use]
    pub fn bytes(&self, name: &str) -> &[u8] {
        self.0.get(name).map_or(&[], Vec::as_slice)
    }

    /// Takes a buffer out.
    pub fn take(&mut self, name: &str) -> Option<Vec<u8>> {
        self.0.remove(name)
    }

    /// The bytes of all buffers of `pass`, in its order.
    ///
    /// # Errors
    /// When one is missing or empty.
    pub fn of<'m>(&'m self, pass: &Pass) -> Result<Vec<&'m [u8]>, ExecError> {
        let bytes = |buffer: &super::PassBuffer| match self.bytes(&buffer.name) {
            [] => Err(pass.refused(&buffer.name, "it is not in memory, or empty; put it there first")),
            bytes => Ok(bytes),
        };
        pass.buffers().iter().map(bytes).collect()
    }
}

/// Runs passes.
pub trait Dispatcher<'p> {
    /// The route by which it does.
    fn route(&self) -> &Route;

    /// Runs `pass` for at least `invocations` invocations; what it writes is in `memory` then.
    ///
    /// # Errors
    /// When a buffer is missing, or the route cannot run the pass.
    fn dispatch(&mut self, pass: &'p Pass, invocations: u32, memory: &mut Memory) -> Result<(), ExecError>;
}
