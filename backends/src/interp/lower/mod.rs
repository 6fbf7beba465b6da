//! From naga's IR to programs.
//!
//! A [`Lowerer`] walks a function once, as an interpreter would, and writes down what there is to do.
//! Calls are walked where they stand.
//!
//! - `build` is the pen: it numbers registers and does not write an operation twice.
//! - `scan` tells beforehand which variables are indexed and what loops write.
//! - `frame` is a function being walked: values of its expressions, its variables.
//! - `control` and `switch` turn statements to structured control flow; `call` enters functions.
//! - `access` and `memory` resolve pointers, `binding` the elements of binding arrays; `layout` says where scalars lie.
//! - `mark` tells judges what they want to know beside the operations.
//! - `expression` sends each expression to its family: `constant`, `arithmetic`, `cast`, `relational`, `math`,
//!   `geometry`, `matrix`, `integer`, `packing`, `texture`.
//!
//! The operations, their names and their order are those of the native functions, so that results agree bit
//! for bit.

mod access;
mod arithmetic;
mod atomic;
mod binding;
mod build;
mod call;
mod cast;
mod constant;
mod control;
mod entry;
mod expression;
mod frame;
mod geometry;
mod integer;
mod layout;
mod limits;
mod mark;
mod math;
mod matrix;
mod memory;
mod packing;
mod relational;
mod scan;
mod statement;
mod subgroup;
mod switch;
mod texture;

use layout::Types;

use super::error::{InterpError, Res};
use super::program::{Program, Scalar, Value};
use build::Builder;
use frame::{Item, Pointer};
use lobe_codegen::ValidModule;
use lobe_codegen::module::Scope;
use naga::{Function, Handle};
use scan::Scan;

/// Statements that a program may have: what inlining makes of deep call graphs is bounded.
/// A statement takes about 350 bytes and 15 microseconds on its way to code, so this many 350 MB and 15 s;
/// drivers inline too, and take longer.
const LARGEST: usize = 1 << 20;

/// Scalars of a variable beyond which it lies in memory even if no index is dynamic.
const MANY: usize = 256;

/// Walks a module's functions.
pub(crate) struct Lowerer<'m> {
    module: &'m ValidModule,
    b: Builder,
    scan: Scan,
    /// What the scalars of variables hold here; see `control`.
    variables: Vec<Value>,
    /// Private variables, by index.
    globals: Vec<Option<Pointer>>,
    /// Where lanes can leave to, innermost last.
    exits: Vec<control::Exit>,
    /// What is being lowered.
    root: Option<Scope>,
    reader: Reader,
    /// Where the source has statements.
    spans: mark::Spans,
}

/// Whom a program is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Reader {
    /// The executor on lanes, which wants results.
    Lanes,
    /// A judge of numbers, which wants each operation that errs, and marks.
    Judge,
    /// A judge of the program, which also wants to know what nothing was written to.
    Sanitizer,
}

/// Lowers function `f`; its parameters' scalars are the input columns.
pub(crate) fn function(module: &ValidModule, f: Handle<Function>, reader: Reader) -> Res<Program> {
    Lowerer::walk(module, Scope::Function(f), reader)
}

/// Lowers compute entry point `index`.
pub(crate) fn entry(module: &ValidModule, index: usize, reader: Reader) -> Res<Program> {
    Lowerer::walk(module, Scope::Entry(index), reader)
}

impl<'m> Lowerer<'m> {
    /// The program of a function or an entry point; what is refused is refused at its place.
    fn walk(module: &'m ValidModule, root: Scope, reader: Reader) -> Res<Program> {
        limits::check(module.module(), root)?;
        let mut lowerer = Self::new(module, reader)?;
        lowerer.root = Some(root);
        match lowerer.root_results(root) {
            Ok(results) => Ok(lowerer.b.finish(results)),
            Err(error) => Err(error.placed(lowerer.b.at)),
        }
    }

    fn root_results(&mut self, root: Scope) -> Res<Vec<Value>> {
        let arguments = match root {
            Scope::Function(f) => self.columns(&self.module.module().functions[f])?,
            Scope::Entry(index) => self.builtins(index)?,
            Scope::Global => return Err(malformed("global expressions are no function")),
        };
        let results = self.invoke(root, arguments)?;
        Ok(if matches!(root, Scope::Function(_)) { results } else { Vec::new() })
    }

    fn new(module: &'m ValidModule, reader: Reader) -> Res<Self> {
        let count = module.module().global_variables.len();
        let mut lowerer = Self {
            module,
            b: Builder::new(),
            scan: Scan::of(module.module()),
            variables: Vec::new(),
            globals: vec![None; count],
            exits: Vec::new(),
            root: None,
            reader,
            spans: mark::Spans::new(),
        };
        lowerer.b.repeat = reader != Reader::Lanes;
        lowerer.private_variables()?;
        Ok(lowerer)
    }

    fn types(&self) -> Types<'m> {
        Types(self.module.module())
    }

    /// Zero of these kinds.
    fn zeros(&mut self, scalars: &[Scalar]) -> Vec<Value> {
        scalars.iter().map(|s| self.b.zero(*s)).collect()
    }
}

fn malformed(what: &'static str) -> InterpError {
    InterpError::Malformed(what)
}
