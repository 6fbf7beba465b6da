//! A kernel made ready to run: its definition, its module, and what executors derive from them.

use super::ExecError;
use crate::interp::{Checks, Finding, Interpreter, ShadowColumns};
use lobe_codegen::ValidModule;
use lobe_codegen::accuracy::Model;
use lobe_codegen::data::{Columns, Leaf, leaves};
use lobe_codegen::def::{FunctionDef, FunctionRef};

/// A kernel, lowered once and shared by all executors.
pub struct Program {
    def: &'static FunctionDef,
    module: ValidModule,
    handle: naga::Handle<naga::Function>,
    params: Vec<Leaf>,
    results: Vec<Leaf>,
    accuracy: &'static Model,
    pub(super) artifacts: super::gpu_route::Artifacts,
}

impl Program {
    /// Lowers `kernel` with all that it calls.
    ///
    /// # Errors
    /// When it is no kernel-language function, or an entry point.
    pub fn new(kernel: FunctionRef) -> Result<Self, ExecError> {
        let def = kernel();
        if def.entry.is_some() {
            return Err(ExecError::EntryPoint { kernel: def.name });
        }
        let module = lobe_codegen::lower(&[kernel])?;
        let handle = module.function(def.name).ok_or(ExecError::Lost { kernel: def.name })?;
        Ok(Self {
            def,
            module,
            handle,
            params: def.params.iter().flat_map(|p| leaves(p.name, &p.ty)).collect(),
            results: def.ret.iter().flat_map(|ty| leaves("", ty)).collect(),
            accuracy: Model::portable(),
            artifacts: Default::default(),
        })
    }

    /// The same, but drivers are permitted what `accuracy` permits, instead of [`Model::portable`].
    #[must_use]
    pub fn with_accuracy(self, accuracy: &'static Model) -> Self {
        Self { accuracy, ..self }
    }

    /// The same kernel with another module in the place of its own, for tests of what notices a change.
    ///
    /// # Errors
    /// When it holds no function of the kernel's name.
    #[doc(hidden)]
    pub fn with_module(self, module: ValidModule) -> Result<Self, ExecError> {
        let handle = module.function(self.def.name).ok_or(ExecError::Lost { kernel: self.def.name })?;
        Ok(Self { module, handle, artifacts: Default::default(), ..self })
    }

    /// The definition.
    #[must_use]
    pub fn def(&self) -> &'static FunctionDef {
        self.def
    }

    /// The kernel's name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.def.name
    }

    /// The module that holds the kernel and all that it calls.
    #[must_use]
    pub fn module(&self) -> &ValidModule {
        &self.module
    }

    /// The kernel within [`Program::module`].
    #[must_use]
    pub fn handle(&self) -> naga::Handle<naga::Function> {
        self.handle
    }

    /// The scalars of the parameters: the columns of the arguments.
    #[must_use]
    pub fn params(&self) -> &[Leaf] {
        &self.params
    }

    /// The scalars of the result: the columns that executors return.
    #[must_use]
    pub fn results(&self) -> &[Leaf] {
        &self.results
    }

    /// The interpreter of the module.
    ///
    /// # Errors
    /// When the interpreter does not know something in the module.
    pub fn interpreter(&self) -> Result<Interpreter<'_>, ExecError> {
        let made = Interpreter::new(&self.module).map(|made| made.with_accuracy(self.accuracy));
        made.map_err(|cause| ExecError::Interp { kernel: self.name(), cause: cause.into() })
    }

    /// The kernel on the shadow lane: f32 value, f64 value and error bound of every scalar of the result.
    ///
    /// `exact` gives the f64 values of the arguments, where they are not those of `args`.
    ///
    /// # Errors
    /// When the arguments have another shape, or the interpreter gives up.
    pub fn shadow(&self, args: &Columns, exact: Option<&[Vec<f64>]>) -> Result<ShadowColumns, ExecError> {
        self.check_shape(args)?;
        let outcome = self.interpreter()?.shadow(self.handle, args, exact);
        outcome.map_err(|cause| ExecError::Interp { kernel: self.name(), cause: cause.into() })
    }

    /// The exact values, with bounds that are wider than [`Program::shadow`]'s; see [`Interpreter::exact`].
    ///
    /// # Errors
    /// When the arguments have another shape, or the interpreter gives up.
    pub fn exact(&self, args: &Columns, exact: Option<&[Vec<f64>]>) -> Result<ShadowColumns, ExecError> {
        self.check_shape(args)?;
        let outcome = self.interpreter()?.exact(self.handle, args, exact);
        outcome.map_err(|cause| ExecError::Interp { kernel: self.name(), cause: cause.into() })
    }

    /// Mistakes that the kernel makes on these rows; see [`Interpreter::sanitize_call`].
    ///
    /// # Errors
    /// When the arguments have another shape, or the interpreter gives up.
    pub fn sanitize(&self, args: &Columns, checks: Checks) -> Result<Vec<Finding>, ExecError> {
        self.check_shape(args)?;
        let outcome = self.interpreter()?.sanitize_call(self.handle, args, checks);
        outcome.map_err(|cause| ExecError::Interp { kernel: self.name(), cause: cause.into() })
    }

    /// Runs every row as a permitted driver would that errs by chance; see [`Interpreter::perturbed`].
    ///
    /// # Errors
    /// When the arguments have another shape, or the interpreter gives up.
    pub fn perturbed(&self, args: &Columns, seed: u64) -> Result<Columns, ExecError> {
        self.check_shape(args)?;
        let outcome = self.interpreter()?.perturbed(self.handle, args, seed);
        outcome.map_err(|cause| ExecError::Interp { kernel: self.name(), cause: cause.into() })
    }

    /// Whether `args` has a column for each scalar of the parameters.
    ///
    /// # Errors
    /// When it has not.
    pub fn check_shape(&self, args: &Columns) -> Result<(), ExecError> {
        let (expected, found) = (self.params.len(), args.width());
        if expected == found {
            return Ok(());
        }
        Err(ExecError::Shape { kernel: self.name(), expected, found })
    }
}

impl std::fmt::Debug for Program {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Program").field("kernel", &self.name()).finish_non_exhaustive()
    }
}
