//! Passes on the interpreter.

use super::{Dispatcher, Memory, Pass};
use crate::executor::ExecError;
use crate::interp::{Buffer, Interpreter};
use crate::route::Route;
use std::collections::HashMap;

/// Interprets passes in strict f32; each is linked at its first use.
#[derive(Debug, Default)]
pub struct Interpreted<'p> {
    linked: HashMap<&'static str, Interpreter<'p>>,
}

impl<'p> Interpreted<'p> {
    fn interpreter(&mut self, pass: &'p Pass) -> Result<&Interpreter<'p>, ExecError> {
        if !self.linked.contains_key(pass.name()) {
            let made = Interpreter::new(pass.module());
            self.linked.insert(pass.name(), made.map_err(|cause| gave_up(pass, cause))?);
        }
        self.linked.get(pass.name()).ok_or(ExecError::Lost { kernel: pass.name() })
    }
}

impl<'p> Dispatcher<'p> for Interpreted<'p> {
    fn route(&self) -> &Route {
        &Route::Interp
    }

    fn dispatch(&mut self, pass: &'p Pass, invocations: u32, memory: &mut Memory) -> Result<(), ExecError> {
        memory.of(pass)?;
        let interpreter = self.interpreter(pass)?;
        let mut buffers: Vec<Buffer> = pass.buffers().iter().map(|at| lend(memory, at)).collect();
        let outcome = interpreter.run(0, pass.groups(invocations), &mut buffers);
        pass.buffers().iter().zip(buffers).for_each(|(at, buffer)| memory.put(&at.name, buffer.data));
        outcome.map_err(|cause| gave_up(pass, cause))
    }
}

/// Takes a buffer out of memory, for as long as the pass runs.
fn lend(memory: &mut Memory, at: &super::PassBuffer) -> Buffer {
    let data = memory.take(&at.name).unwrap_or_default();
    Buffer { group: at.layout.group, binding: at.layout.binding, data }
}

fn gave_up(pass: &Pass, cause: crate::interp::InterpError) -> ExecError {
    ExecError::Interp { kernel: pass.name(), cause: cause.into() }
}
