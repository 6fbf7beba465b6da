//! The CPU executor.
//!
//! Three questions have an answer each:
//!
//! - *strict* ([`Interpreter::call`], [`Interpreter::run`]): what are the results in IEEE f32, each operation
//!   as [`lobe_codegen::math`] has it?
//!   They equal the native functions' bit for bit, since both call the same functions in the same order.
//! - *shadow* ([`Interpreter::shadow`]): what is the exact result, and how far from it may any driver be
//!   that keeps the shading languages' accuracy rules?
//! - *perturbed* ([`Interpreter::perturbed`]): what does one such driver return, drawn by chance?
//!   It is how the bounds are put to the test.
//!
//! The strict way is made for speed: `lower` turns naga's IR into a `program` on scalars, once; `passes` rewrite it;
//! `fast` runs it on arrays of lanes, by vector instructions that are chosen at run time.
//! The other two walk naga's IR itself (`exec`), for a batch of lanes; what a lane's numbers are is a model's
//! business (`model`). A strict model of the same machine judges the fast one.
//!
//! Integers are as in WGSL: wrapping, `x / 0 = x`, `x % 0 = 0`, shifts by the lower five bits, conversions
//! saturate; indices out of bounds are clamped.

mod batch;
mod dispatch;
mod error;
mod exec;
mod fast;
mod finding;
mod formula;
mod layout;
mod leaf;
mod lower;
mod mask;
mod memory;
mod model;
mod passes;
mod perturbed;
mod program;
mod resources;
mod scalar;
mod shadow;
mod strict;
mod subgroup;
mod texture;

pub use dispatch::Buffer;
pub use error::InterpError;
pub use fast::Isa;
pub use finding::{Checks, Fault, Finding, Invocation};
pub use resources::{BoundSampler, BoundTexture, Resources};

use batch::Batch;
use lobe_codegen::ValidModule;
use lobe_codegen::data::Columns;
use naga::{Function, Handle};
use rayon::prelude::*;

/// Rows that are computed together.
const LANES: usize = 256;

/// The same in the shadow lane, whose tape shall stay in a cache.
const SHADOW_LANES: usize = 64;

/// Rounds of loops that a batch may run, unless [`Interpreter::with_fuel`] says otherwise.
const FUEL: u64 = 1 << 24;

/// Invocations of a subgroup, unless [`Interpreter::with_subgroup_size`] says otherwise: what most GPUs have.
const SUBGROUP: u32 = 32;

/// Executes the functions and entry points of a module.
#[derive(Debug, Clone)]
pub struct Interpreter<'m> {
    module: &'m ValidModule,
    fuel: u64,
    isa: Isa,
    subgroup: u32,
}

/// Results of the shadow lane.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ShadowColumns {
    /// One for each scalar of the result.
    pub columns: Vec<ShadowColumn>,
    /// Number of rows.
    pub rows: usize,
    /// Rows that met a decision which drivers may take either way; both ways were followed and joined.
    pub ambiguous: Vec<bool>,
    /// Rows without bound for a reason other than arithmetic: an ambiguous exit of a loop, the bits of an
    /// inexact number, an index that is not known.
    pub indeterminate: Vec<bool>,
}

/// One scalar of the result in all rows.
#[derive(Debug, Clone, PartialEq)]
pub enum ShadowColumn {
    /// Floats.
    Float {
        /// In strict f32.
        value: Vec<f32>,
        /// Of the formula in real numbers, along the decisions that these take.
        exact: Vec<f64>,
        /// Largest distance from `exact` of any permitted driver's result; infinite when there is none.
        bound: Vec<f64>,
    },
    /// Integers and booleans.
    Word {
        /// In strict f32.
        value: Vec<u32>,
        /// Whether every permitted driver returns `value`.
        known: Vec<bool>,
    },
}

/// What a dispatch leaves in a storage buffer, in the shadow lane.
#[derive(Debug, Clone, PartialEq)]
pub struct ShadowBuffer {
    /// Bind group.
    pub group: u32,
    /// Binding within the group.
    pub binding: u32,
    /// One for each 32-bit word.
    pub words: Vec<ShadowWord>,
}

/// One word of a buffer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ShadowWord {
    /// Written as a float.
    Float {
        /// In strict f32.
        value: f32,
        /// Of the formula in real numbers.
        exact: f64,
        /// Largest distance from `exact` of any permitted driver's result; infinite when there is none.
        bound: f64,
    },
    /// Never written, or written as anything else.
    Word {
        /// In strict f32.
        value: u32,
        /// Whether every permitted driver leaves `value`.
        known: bool,
    },
}

impl<'m> Interpreter<'m> {
    /// An interpreter of `module`.
    ///
    /// # Errors
    /// None yet: what is not supported is reported when it is met.
    pub fn new(module: &'m ValidModule) -> Result<Self, InterpError> {
        Ok(Self { module, fuel: FUEL, isa: Isa::best(), subgroup: SUBGROUP })
    }

    /// The same, but a batch of rows, or a workgroup, runs at most `rounds` rounds of loops.
    #[must_use]
    pub fn with_fuel(self, rounds: u64) -> Self {
        Self { fuel: rounds, ..self }
    }

    /// The same, but with this instruction set, if the machine has it; all give the same bits.
    #[must_use]
    pub fn with_isa(self, isa: Isa) -> Self {
        let isa = if Isa::available().contains(&isa) { isa } else { self.isa };
        Self { isa, ..self }
    }

    /// The same, but with so many invocations in a subgroup: a power of two from 4 to 128, to which others are rounded
    /// up or clamped. Subgroups are consecutive invocations of a workgroup.
    #[must_use]
    pub fn with_subgroup_size(self, invocations: u32) -> Self {
        let subgroup = invocations.clamp(4, fast::LANES as u32).next_power_of_two();
        Self { subgroup, ..self }
    }

    /// Calls function `f` on every row, in strict f32: one column of words for each scalar of the arguments,
    /// likewise for the result.
    ///
    /// # Errors
    /// When the columns do not fit the parameters, the function does something that the interpreter does not
    /// execute, or a loop does not end.
    pub fn call(&self, f: Handle<Function>, args: &Columns) -> Result<Columns, InterpError> {
        let signature = batch::Signature::of(self.module, f, args, None)?;
        let program = lower::function(self.module, f)?;
        debug_assert_eq!(program.results.len(), signature.results.len());
        fast::rows::call(&fast::Code::new(program, false, self.isa)?, args, self.fuel)
    }

    /// What [`Interpreter::call`] returns, by the machine that walks naga's IR: the judge of the fast one.
    ///
    /// # Errors
    /// As [`Interpreter::call`].
    #[doc(hidden)]
    pub fn call_walking(&self, f: Handle<Function>, args: &Columns) -> Result<Columns, InterpError> {
        self.plain(f, args, |_| strict::Strict)
    }

    /// What [`Interpreter::run`] does, by the machine that walks naga's IR.
    ///
    /// # Errors
    /// As [`Interpreter::run`].
    #[doc(hidden)]
    pub fn run_walking(
        &self,
        entry: usize,
        groups: [u32; 3],
        buffers: &mut [Buffer],
    ) -> Result<(), InterpError> {
        dispatch::run(self.module, self.fuel, entry, groups, buffers)
    }

    /// Calls `f` as a permitted driver would that errs by chance; the same seed gives the same results.
    ///
    /// # Errors
    /// As [`Interpreter::call`].
    pub fn perturbed(&self, f: Handle<Function>, args: &Columns, seed: u64) -> Result<Columns, InterpError> {
        self.plain(f, args, |chunk| {
            perturbed::Perturbed::new(seed ^ (chunk as u64).wrapping_mul(0x5851_f42d_4c95_7f2d))
        })
    }

    fn plain<M: model::Model>(
        &self,
        f: Handle<Function>,
        args: &Columns,
        model: impl Fn(usize) -> M + Sync,
    ) -> Result<Columns, InterpError> {
        let signature = batch::Signature::of(self.module, f, args, None)?;
        let chunks = batch::chunks(args.rows, LANES).into_par_iter();
        let parts = chunks
            .map(|range| Batch::new(self.module, model(range.start), self.fuel, &signature).words(range))
            .collect::<Result<Vec<_>, _>>()?;
        let mut out = Columns::zeros(signature.results.len(), 0);
        parts.iter().for_each(|part| out.append(part));
        Ok(out)
    }

    /// Calls `f` on every row with the exact value and a bound beside each float.
    ///
    /// `exact` holds the exact values of the arguments' scalars (those of integers are ignored): the bound
    /// then allows for the difference. Without it arguments are exactly their f32.
    ///
    /// # Errors
    /// As [`Interpreter::call`], except that a loop that does not end makes its rows indeterminate.
    pub fn shadow(
        &self,
        f: Handle<Function>,
        args: &Columns,
        exact: Option<&[Vec<f64>]>,
    ) -> Result<ShadowColumns, InterpError> {
        self.shadowed(f, args, exact, shadow::Shadow::default)
    }

    /// The same without the tape, so cheaper, with bounds that do not know which numbers share an error: for exact values.
    ///
    /// # Errors
    /// As [`Interpreter::shadow`].
    pub fn exact(
        &self,
        f: Handle<Function>,
        args: &Columns,
        exact: Option<&[Vec<f64>]>,
    ) -> Result<ShadowColumns, InterpError> {
        self.shadowed(f, args, exact, shadow::Shadow::forgetful)
    }

    fn shadowed(
        &self,
        f: Handle<Function>,
        args: &Columns,
        exact: Option<&[Vec<f64>]>,
        model: fn() -> shadow::Shadow,
    ) -> Result<ShadowColumns, InterpError> {
        let signature = batch::Signature::of(self.module, f, args, exact)?;
        let chunks = batch::chunks(args.rows, SHADOW_LANES).into_par_iter();
        let parts = chunks
            .map(|range| Batch::new(self.module, model(), self.fuel, &signature).shadow(range))
            .collect::<Result<Vec<_>, _>>()?;
        let mut out = batch::no_rows(&signature.results);
        parts.into_iter().for_each(|part| batch::append(&mut out, part));
        Ok(out)
    }

    /// Runs compute entry point `entry`, in strict f32, over `groups` workgroups; storage buffers and textures are
    /// updated in place. `resources` is [`Resources`], or a list of buffers.
    ///
    /// The invocations of a workgroup run in lockstep, workgroups one after the other.
    ///
    /// # Errors
    /// When there is no such entry point, a resource lacks or does not fit its variable, the entry point does
    /// something that the interpreter does not execute, a barrier is not uniform, or a loop does not end.
    pub fn run<'a>(
        &self,
        entry: usize,
        groups: [u32; 3],
        resources: impl Into<Resources<'a>>,
    ) -> Result<(), InterpError> {
        let point = self.module.module().entry_points.get(entry).ok_or(InterpError::NoEntryPoint(entry))?;
        if point.stage != naga::ShaderStage::Compute || point.workgroup_size_overrides.is_some() {
            let what = "an entry point that is no compute shader of fixed workgroup size".to_owned();
            return Err(InterpError::Unsupported { what, function: point.name.clone() });
        }
        let program = lower::entry(self.module, entry)?;
        let packed = !program.cooperative;
        let code = fast::Code::new(program, packed, self.isa)?;
        let dispatch = fast::dispatch::Dispatch {
            code: &code,
            size: point.workgroup_size,
            groups,
            fuel: self.fuel,
            subgroup: self.subgroup,
        };
        dispatch.run(resources.into())
    }

    /// Runs entry point `entry` as [`Interpreter::run`] does, with the exact value and a bound beside each float;
    /// the buffers that the program may write come back, word by word.
    ///
    /// # Errors
    /// As [`Interpreter::run`], except that a loop that does not end makes what its invocations write unknown.
    pub fn shadow_run(
        &self,
        entry: usize,
        groups: [u32; 3],
        buffers: &[Buffer],
    ) -> Result<Vec<ShadowBuffer>, InterpError> {
        let _ = (groups, buffers);
        Err(self.not_yet(entry, "shadow values in buffers"))
    }

    /// Runs entry point `entry` as a permitted driver would that errs by chance; the same seed gives the same results.
    ///
    /// # Errors
    /// As [`Interpreter::run`].
    pub fn perturbed_run(
        &self,
        entry: usize,
        groups: [u32; 3],
        buffers: &mut [Buffer],
        seed: u64,
    ) -> Result<(), InterpError> {
        let _ = (groups, buffers, seed);
        Err(self.not_yet(entry, "entry points by chance"))
    }

    /// Runs entry point `entry` as [`Interpreter::run`] does and reports its mistakes; what it computes stays as it is.
    ///
    /// # Errors
    /// As [`Interpreter::run`], except for what is a finding.
    pub fn sanitize(
        &self,
        entry: usize,
        groups: [u32; 3],
        buffers: &mut [Buffer],
        checks: Checks,
    ) -> Result<Vec<Finding>, InterpError> {
        let _ = (groups, buffers, checks);
        Err(self.not_yet(entry, "entry points that are sanitized"))
    }

    /// The same of a function, called on every row.
    ///
    /// # Errors
    /// As [`Interpreter::call`], except for what is a finding.
    pub fn sanitize_call(
        &self,
        f: Handle<Function>,
        args: &Columns,
        checks: Checks,
    ) -> Result<Vec<Finding>, InterpError> {
        let _ = (f, args, checks);
        Err(self.not_yet(0, "functions that are sanitized"))
    }

    fn not_yet(&self, entry: usize, what: &str) -> InterpError {
        let point = self.module.module().entry_points.get(entry);
        let function = point.map_or_else(String::new, |p| p.name.clone());
        InterpError::Unsupported { what: what.to_owned(), function }
    }
}
