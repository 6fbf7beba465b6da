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
//! `lower` turns naga's IR into a `program` on scalars, once.
//! The strict way is made for speed: `passes` rewrite the program; `fast` runs it on arrays of lanes, by vector
//! instructions that are chosen at run time.
//! For the other two `judge` runs the program as it was lowered; what a lane's numbers are is a model's
//! business (`model`). A strict model of the same machine judges the fast one, and the program that runs
//! ([`Interpreter::sanitize`]).
//!
//! Integers are as in WGSL: wrapping, `x / 0 = x`, `x % 0 = 0`, shifts by the lower five bits, conversions
//! saturate; indices out of bounds are clamped.

mod bounds;
mod buffer;
mod error;
mod fast;
mod finding;
mod formula;
mod judge;
mod lower;
mod mask;
mod model;
mod overrides;
mod passes;
mod perturbed;
mod precision;
mod program;
mod resources;
mod scalar;
mod shadow;
mod signature;
mod strict;
mod subgroup;
mod texture;

pub use bounds::{
    ShadowBuffer, ShadowColumn, ShadowColumns, ShadowFloat, ShadowRun, ShadowTexel, ShadowTexture, ShadowWord,
};
pub use buffer::{Buffer, IMMEDIATES};
pub use error::InterpError;
pub use fast::Isa;
pub use finding::{Checks, Fault, Finding, Invocation};
pub use resources::{BoundSampler, BoundTexture, Resources};

use lobe_codegen::ValidModule;
use lobe_codegen::accuracy::Model;
use lobe_codegen::data::Columns;
use lobe_codegen::module::Scope;
use lower::Reader;
use naga::{Function, Handle};

/// Rounds of loops that a batch may run, unless [`Interpreter::with_fuel`] says otherwise.
const FUEL: u64 = 1 << 24;

/// Invocations of a subgroup, unless [`Interpreter::with_subgroup_size`] says otherwise: what most GPUs have.
const SUBGROUP: u32 = 32;

/// Executes the functions and entry points of a module; each is lowered and linked when it first runs.
///
/// ```
/// use lobe_backends::interp::{Buffer, Interpreter, ShadowColumn};
/// use lobe_codegen::data::Columns;
/// use lobe_codegen::validate::from_wgsl;
///
/// let module = from_wgsl(
///     "fn third(x: f32) -> f32 { return x / 3.0; }
///      @group(0) @binding(0) var<storage, read_write> values: array<f32>;
///      @compute @workgroup_size(2) fn thirds(@builtin(global_invocation_id) id: vec3<u32>) {
///          values[id.x] = third(values[id.x]);
///      }",
/// )?;
/// let interpreter = Interpreter::new(&module)?;
///
/// // An entry point, on buffers.
/// let mut buffers = [Buffer { group: 0, binding: 0, data: [1.0_f32, 6.0].map(f32::to_le_bytes).concat() }];
/// interpreter.run(0, [1, 1, 1], &mut buffers[..])?;
/// assert_eq!(buffers[0].data[4..], 2.0_f32.to_le_bytes());
///
/// // A function, with the exact value and how far from it any driver may be: division may err by 2.5 ULP.
/// let function = module.function("third").ok_or("it is there")?;
/// let args = Columns { columns: vec![vec![1.0_f32.to_bits()]], rows: 1 };
/// let shadow = interpreter.shadow(function, &args, None)?;
/// let ShadowColumn::Float { exact, bound, .. } = &shadow.columns[0] else { return Err("a float".into()) };
/// assert_eq!(exact[0], 1.0 / 3.0);
/// assert!(bound[0] > 0.0 && bound[0] < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Interpreter<'m> {
    module: &'m ValidModule,
    fuel: u64,
    isa: Isa,
    subgroup: u32,
    accuracy: &'static Model,
    overrides: Vec<lobe_codegen::foreign::Override>,
    cache: fast::cache::Cache,
}

impl<'m> Interpreter<'m> {
    /// An interpreter of `module`.
    ///
    /// # Errors
    /// None yet: what is not supported is reported when it is met.
    pub fn new(module: &'m ValidModule) -> Result<Self, InterpError> {
        Ok(Self {
            module,
            fuel: FUEL,
            isa: Isa::best(),
            subgroup: SUBGROUP,
            accuracy: Model::portable(),
            overrides: Vec::new(),
            cache: fast::cache::Cache::default(),
        })
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

    /// The same, but drivers are permitted what `accuracy` permits, instead of [`Model::portable`].
    #[must_use]
    pub fn with_accuracy(self, accuracy: &'static Model) -> Self {
        Self { accuracy, ..self }
    }

    /// Calls function `f` on every row, in strict f32: one column of words for each scalar of the arguments,
    /// likewise for the result.
    ///
    /// # Errors
    /// When the columns do not fit the parameters, the function does something that the interpreter does not
    /// execute, or a loop does not end.
    pub fn call(&self, f: Handle<Function>, args: &Columns) -> Result<Columns, InterpError> {
        let lower = || lower::function(self.module, f, Reader::Lanes);
        let code = self.cache.get(Scope::Function(f), self.isa, lower)?;
        self.fitting(&code.program, f, args, None)?;
        fast::rows::call(&code, args, self.fuel)
    }

    /// What [`Interpreter::call`] returns, by the judge of the machine that is fast.
    ///
    /// # Errors
    /// As [`Interpreter::call`].
    #[doc(hidden)]
    pub fn call_judged(&self, f: Handle<Function>, args: &Columns) -> Result<Columns, InterpError> {
        self.calls(f, args, |call| call.words(|_| strict::Strict))
    }

    /// Calls `f` as a permitted driver would that errs by chance; the same seed gives the same results.
    ///
    /// # Errors
    /// As [`Interpreter::call`].
    pub fn perturbed(&self, f: Handle<Function>, args: &Columns, seed: u64) -> Result<Columns, InterpError> {
        self.calls(f, args, |call| call.words(|chunk| perturbed::Perturbed::nth(self.accuracy, seed, chunk)))
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
        self.shadowed(f, args, exact, shadow::Shadow::new)
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
        model: fn(shadow::Promises) -> shadow::Shadow,
    ) -> Result<ShadowColumns, InterpError> {
        let code = judge::Code::new(self.lowered(f, args, exact, Reader::Judge)?);
        let promise = shadow::Promises::of(self.accuracy);
        judge::rows::Call { code: &code, args, exact, fuel: self.fuel }.shadow(|| model(promise))
    }

    /// Runs `f` by the judge.
    fn calls<T>(
        &self,
        f: Handle<Function>,
        args: &Columns,
        run: impl FnOnce(judge::rows::Call<'_>) -> Result<T, InterpError>,
    ) -> Result<T, InterpError> {
        let code = judge::Code::new(self.lowered(f, args, None, Reader::Judge)?);
        run(judge::rows::Call { code: &code, args, exact: None, fuel: self.fuel })
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
        let (module, resolved) = self.resolved(entry)?;
        let size = module.module().entry_points[resolved].workgroup_size;
        let lower = || lower::entry(&module, resolved, Reader::Lanes);
        let code = self.cache.get(Scope::Entry(entry), self.isa, lower)?;
        let (fuel, subgroup) = (self.fuel, self.subgroup);
        fast::dispatch::Dispatch { code: &code, size, groups, fuel, subgroup }.run(resources.into())
    }

    /// What [`Interpreter::run`] does, by the judge of the machine that is fast.
    ///
    /// # Errors
    /// As [`Interpreter::run`].
    #[doc(hidden)]
    pub fn run_judged<'a>(
        &self,
        entry: usize,
        groups: [u32; 3],
        resources: impl Into<Resources<'a>>,
    ) -> Result<(), InterpError> {
        let mut resources = resources.into();
        self.dispatches(entry, groups, Reader::Judge, |d| d.run(&mut resources, |_| strict::Strict))
    }

    /// Runs an entry point by the judge.
    fn dispatches<T>(
        &self,
        entry: usize,
        groups: [u32; 3],
        reader: Reader,
        run: impl FnOnce(&judge::dispatch::Dispatch<'_>) -> Result<T, InterpError>,
    ) -> Result<T, InterpError> {
        let (module, entry) = self.resolved(entry)?;
        let size = module.module().entry_points[entry].workgroup_size;
        let code = judge::Code::new(lower::entry(&module, entry, reader)?);
        let (fuel, subgroup) = (self.fuel, self.subgroup);
        run(&judge::dispatch::Dispatch { code: &code, size, groups, fuel, subgroup })
    }

    /// Runs entry point `entry` as [`Interpreter::run`] does, with the exact value and a bound beside each float;
    /// the buffers and textures that the program may write come back, word by word and texel by texel.
    ///
    /// Nothing is promised of what depends on the order of invocations, and of blended texels; races are taken to be
    /// absent.
    ///
    /// # Errors
    /// As [`Interpreter::run`], except that a loop that does not end makes all that the program may write unknown.
    pub fn shadow_run<'a>(
        &self,
        entry: usize,
        groups: [u32; 3],
        resources: impl Into<Resources<'a>>,
    ) -> Result<ShadowRun, InterpError> {
        let mut resources = resources.into();
        self.dispatches(entry, groups, Reader::Judge, |d| {
            d.shadow(shadow::Promises::of(self.accuracy), &mut resources)
        })
    }

    /// Runs entry point `entry` as a permitted driver would that errs by chance; the same seed gives the same results.
    ///
    /// # Errors
    /// As [`Interpreter::run`].
    pub fn perturbed_run<'a>(
        &self,
        entry: usize,
        groups: [u32; 3],
        resources: impl Into<Resources<'a>>,
        seed: u64,
    ) -> Result<(), InterpError> {
        let mut resources = resources.into();
        let model = |group| perturbed::Perturbed::nth(self.accuracy, seed, group);
        self.dispatches(entry, groups, Reader::Judge, |d| d.run(&mut resources, model))
    }

    /// Runs entry point `entry` as [`Interpreter::run`] does and reports its mistakes, in the order in which they are
    /// met. A loop that does not end ends the run.
    ///
    /// # Errors
    /// As [`Interpreter::run`], except for what is a finding.
    pub fn sanitize<'a>(
        &self,
        entry: usize,
        groups: [u32; 3],
        resources: impl Into<Resources<'a>>,
        checks: Checks,
    ) -> Result<Vec<Finding>, InterpError> {
        let mut resources = resources.into();
        self.dispatches(entry, groups, Reader::Sanitizer, |d| d.sanitize(&mut resources, checks))
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
        let code = judge::Code::new(self.lowered(f, args, None, Reader::Sanitizer)?);
        judge::rows::Call { code: &code, args, exact: None, fuel: self.fuel }.sanitize(checks)
    }
}
