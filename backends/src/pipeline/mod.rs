//! Passes over named buffers: compute entry points of kernels, one after the other, on whatever runs them.
//!
//! A pass's parameters name its buffers, so passes whose parameters share a name share a buffer, and a list of passes
//! needs no wiring. Every executor runs the same list: the interpreter its module, a driver what was emitted of it.
//!
//! ```
//! use lobe_backends::pipeline::{Dispatcher, Interpreted, Memory, Pipeline};
//! use lobe_codegen::prelude::*;
//!
//! /// Squares numbers.
//! #[kernel(workgroup_size(64))]
//! pub fn square_pass(
//!     #[builtin(global_invocation_id)] id: UVec3,
//!     #[storage(0, 0)] numbers: &[f32],
//!     #[storage(0, 1)] squares: &mut [f32],
//! ) {
//!     if id.x < squares.len() as u32 {
//!         squares[id.x as usize] = numbers[id.x as usize] * numbers[id.x as usize];
//!     }
//! }
//!
//! let pipeline = Pipeline::new(&lobe_codegen::kernels![square_pass])?;
//! let mut memory = Memory::default();
//! memory.put("numbers", pipeline.pack("numbers", &[1.0_f32, 2.0, 3.0])?);
//! memory.put("squares", pipeline.zeros("squares", 3)?);
//! Interpreted::default().dispatch(pipeline.pass("square_pass")?, 3, &mut memory)?;
//! assert_eq!(pipeline.unpack::<f32>("squares", memory.bytes("squares"))?, [1.0, 4.0, 9.0]);
//! # Ok::<(), lobe_backends::executor::ExecError>(())
//! ```

mod bounds;
mod dispatch;
mod driver;
mod interpreted;
mod pass;

pub use dispatch::{Dispatcher, Memory};
pub use driver::OnDriver;
pub use interpreted::Interpreted;
pub use pass::{Access, Pass, PassBuffer};

use crate::executor::ExecError;
use lobe_codegen::data::WordReader;
use lobe_codegen::def::{FunctionRef, KernelValue};
use lobe_codegen::layout::{BufferLayout, pack, unpack};

/// Passes, made ready once for all executors.
#[derive(Debug)]
pub struct Pipeline {
    passes: Vec<Pass>,
}

impl Pipeline {
    /// Lowers `kernels`, all of them entry points.
    ///
    /// # Errors
    /// When one is no entry point, binds what has no layout, or two mean different things by one name.
    pub fn new(kernels: &[FunctionRef]) -> Result<Self, ExecError> {
        let passes: Vec<Pass> = kernels.iter().map(|kernel| Pass::new(*kernel)).collect::<Result<_, _>>()?;
        let pipeline = Self { passes };
        pipeline.passes.iter().try_for_each(|pass| pipeline.check(pass))?;
        Ok(pipeline)
    }

    /// The same passes, of which one has another module in the place of its own, for tests of what notices a change.
    ///
    /// # Errors
    /// When there is no such pass.
    #[doc(hidden)]
    pub fn with_module(mut self, pass: &str, module: lobe_codegen::ValidModule) -> Result<Self, ExecError> {
        let found = self.passes.iter_mut().find(|known| known.name() == pass);
        let found = found.ok_or_else(|| ExecError::NoPass { pass: pass.to_owned() })?;
        found.replace_module(module);
        Ok(self)
    }

    /// The passes, in the order in which they were given.
    #[must_use]
    pub fn passes(&self) -> &[Pass] {
        &self.passes
    }

    /// The pass of this name.
    ///
    /// # Errors
    /// When there is none.
    pub fn pass(&self, name: &str) -> Result<&Pass, ExecError> {
        let found = self.passes.iter().find(|pass| pass.name() == name);
        found.ok_or_else(|| ExecError::NoPass { pass: name.to_owned() })
    }

    /// `values` as the bytes of `buffer`.
    ///
    /// # Errors
    /// When no pass has such a buffer, or it holds something else.
    pub fn pack<T: KernelValue>(&self, buffer: &str, values: &[T]) -> Result<Vec<u8>, ExecError> {
        let layout = self.layout(buffer)?;
        let mut columns = vec![Vec::with_capacity(values.len()); layout.leaves.len()];
        let mut words = Vec::with_capacity(columns.len());
        for value in values {
            words.clear();
            value.write(&mut words);
            if words.len() != columns.len() {
                return Err(mismatch(buffer, columns.len(), words.len()));
            }
            columns.iter_mut().zip(&words).for_each(|(column, word)| column.push(*word));
        }
        Ok(pack(layout, &columns, values.len()))
    }

    /// The values in the bytes of `buffer`.
    ///
    /// # Errors
    /// When no pass has such a buffer, or it holds something else.
    pub fn unpack<T: KernelValue>(&self, buffer: &str, bytes: &[u8]) -> Result<Vec<T>, ExecError> {
        let layout = self.layout(buffer)?;
        let rows = bytes.len() / layout.stride.max(1) as usize;
        let columns = unpack(layout, bytes, rows);
        let found = lobe_codegen::data::leaves(buffer, &T::TYPE).len();
        if found != columns.len() {
            return Err(mismatch(buffer, columns.len(), found));
        }
        let row = |at: usize| -> Vec<u32> { columns.iter().map(|column| column[at]).collect() };
        Ok((0..rows).map(|at| T::read(&mut WordReader::new(&row(at)))).collect())
    }

    /// The bytes of `buffer` with `elements` elements that are 0.
    ///
    /// # Errors
    /// When no pass has such a buffer.
    pub fn zeros(&self, buffer: &str, elements: usize) -> Result<Vec<u8>, ExecError> {
        Ok(vec![0; self.layout(buffer)?.stride as usize * elements])
    }

    /// How an element of `buffer` lies in memory.
    ///
    /// # Errors
    /// When no pass has such a buffer.
    pub fn layout(&self, buffer: &str) -> Result<&BufferLayout, ExecError> {
        let found = self.passes.iter().find_map(|pass| pass.buffer(buffer));
        let found = found.ok_or_else(|| ExecError::NoBuffer { buffer: buffer.to_owned() })?;
        Ok(&found.layout)
    }

    /// Whether `pass` means by its buffers what the first pass with them does.
    fn check(&self, pass: &Pass) -> Result<(), ExecError> {
        for buffer in pass.buffers() {
            let known = self.layout(&buffer.name)?;
            let is_same = (known.stride, &known.leaves) == (buffer.layout.stride, &buffer.layout.leaves);
            if !is_same {
                let reason = "it holds something else in an earlier pass; give it a name of its own";
                return Err(pass.refused(&buffer.name, reason));
            }
        }
        Ok(())
    }
}

fn mismatch(buffer: &str, expected: usize, found: usize) -> ExecError {
    ExecError::Element { buffer: buffer.to_owned(), expected, found }
}
