//! An emitted artifact on a driver: emit, translate, pack, dispatch, unpack.

use super::trace::{self, Trace};
use super::{ExecError, Executor, Program};
use crate::gpu::{AnyGpu, Binding, BindingKind, Job, Shader};
use crate::route::{Road, Route};
use crate::translate::Translators;
use lobe_codegen::data::Columns;
use lobe_codegen::emit::{self, Artifact, Content, EntryLayout, Options, Target};
use lobe_codegen::layout::{pack, unpack};
use lobe_codegen::trace::Traced;
use std::sync::{Arc, OnceLock};

/// Invocations in a workgroup.
const WORKGROUP: u32 = 64;
/// Workgroups in a dispatch: the least that every driver starts along one axis.
const GROUPS: usize = 65_535;
/// Bytes in a buffer: WebGPU's default limit on storage bindings.
const BYTES: usize = 128 << 20;

/// What has been emitted of a program, each at its first use.
#[derive(Debug, Default)]
pub(crate) struct Artifacts {
    entry: OnceLock<(lobe_codegen::ValidModule, EntryLayout)>,
    roads: [OnceLock<Words>; Road::ALL.len()],
}

/// What a driver is given.
#[derive(Debug)]
pub(crate) enum Words {
    Wgsl(String),
    Spirv(Vec<u32>),
    Glsl(String),
}

/// Runs kernels on one driver, through one target and translator.
pub struct GpuRoute {
    route: Route,
    road: Road,
    gpu: AnyGpu,
    translators: Arc<Translators>,
}

impl GpuRoute {
    /// The route by `road` to the device `gpu`, which is Dawn's for [`Road::WgslTint`], through the road's own of
    /// `translators`.
    #[must_use]
    pub fn new(route: Route, road: Road, gpu: AnyGpu, translators: Arc<Translators>) -> Self {
        Self { route, road, gpu, translators }
    }

    fn dispatch(
        &mut self,
        kernel: &Program,
        words: &Words,
        layout: &EntryLayout,
        args: &Columns,
    ) -> Result<Columns, ExecError> {
        let buffers = pack_arguments(layout, args);
        let results = vec![0; layout.result.stride as usize * args.rows];
        let count = (args.rows as u32).to_le_bytes();
        let mut bindings: Vec<Binding<'_>> = layout
            .arguments
            .iter()
            .zip(&buffers)
            .map(|(at, data)| bind(at.group, at.binding, BindingKind::StorageRead, data))
            .collect();
        let result = &layout.result;
        bindings.push(bind(result.group, result.binding, BindingKind::StorageReadWrite, &results));
        bindings.push(bind(result.group, layout.count_binding, BindingKind::Uniform, &count));
        let outputs = self.gpu.run(&Job {
            shader: words.shader(),
            entry: self.road.target().entry_name(&layout.entry_name),
            workgroup_size: [layout.workgroup_size, 1, 1],
            groups: [(args.rows as u32).div_ceil(layout.workgroup_size), 1, 1],
            bindings: &bindings,
            immediates: &[],
        });
        let outputs = outputs.map_err(|cause| ExecError::Gpu { kernel: kernel.name(), cause })?;
        let bytes = outputs.first().map_or(&[][..], Vec::as_slice);
        Ok(Columns { columns: unpack(result, bytes, args.rows), rows: args.rows })
    }
}

/// Translates kernels before their route runs them.
#[derive(Clone, Debug)]
pub struct Ahead {
    road: Road,
    translators: Arc<Translators>,
}

impl Ahead {
    /// Translates `kernel`, unless that was done.
    ///
    /// What goes wrong goes wrong again when the kernel is run, and is reported then.
    pub fn prepare(&self, kernel: &Program) {
        let _ = kernel.words(self.road, &self.translators);
    }
}

impl Executor for GpuRoute {
    fn route(&self) -> &Route {
        &self.route
    }

    fn driver_info(&self) -> &str {
        &self.gpu.driver().driver_info
    }

    fn ahead(&self) -> Option<Ahead> {
        Some(Ahead { road: self.road, translators: Arc::clone(&self.translators) })
    }

    fn run(&mut self, kernel: &Program, args: &Columns) -> Result<Columns, ExecError> {
        kernel.check_shape(args)?;
        let layout = &kernel.entry()?.1;
        let words = kernel.words(self.road, &self.translators)?;
        let rows = rows_at_once(layout);
        let mut out = Columns::zeros(kernel.results().len(), 0);
        let mut start = 0;
        while start < args.rows {
            let end = (start + rows).min(args.rows);
            out.append(&self.dispatch(kernel, words, layout, &args.slice(start..end))?);
            start = end;
        }
        Ok(out)
    }

    fn trace(&mut self, kernel: &Program, traced: &Traced, args: &Columns) -> Result<Trace, ExecError> {
        let source =
            Source { kernel: kernel.name(), module: &traced.module, entry: &traced.layout.entry_name };
        let words = source.words(self.road, &self.translators)?;
        let entry = self.road.target().entry_name(source.entry);
        trace::dispatch(&mut self.gpu, (words.shader(), entry), kernel.name(), traced, args)
    }
}

/// A module with an entry point, on its way to a driver.
pub(crate) struct Source<'a> {
    /// The kernel, for messages.
    pub(crate) kernel: &'static str,
    /// Its module.
    pub(crate) module: &'a lobe_codegen::ValidModule,
    /// The entry point's name.
    pub(crate) entry: &'a str,
}

impl Artifacts {
    /// What a driver is given by `road`, which `make` makes at the first use.
    pub(crate) fn words(
        &self,
        road: Road,
        make: impl FnOnce() -> Result<Words, ExecError>,
    ) -> Result<&Words, ExecError> {
        let place = &self.roads[road as usize];
        if let Some(ready) = place.get() {
            return Ok(ready);
        }
        let made = make()?;
        Ok(place.get_or_init(|| made))
    }
}

impl Source<'_> {
    fn artifact(&self, target: Target) -> Result<Artifact, ExecError> {
        emit::emit(self.module, target, &Options::default())
            .map_err(|cause| ExecError::Emit { kernel: self.kernel, cause: cause.into() })
    }

    pub(crate) fn words(&self, road: Road, translators: &Translators) -> Result<Words, ExecError> {
        let artifact = self.artifact(road.target())?;
        match road {
            Road::Spirv | Road::WgslNaga | Road::WgslTint => Ok(content(artifact.content)),
            Road::Glsl => Ok(Words::Glsl(artifact.content.text().unwrap_or_default().to_owned())),
            Road::HlslDxc | Road::HlslSlang | Road::GlslGlslang => {
                let text = artifact.content.text().unwrap_or_default();
                let words = translators.spirv(road, text, self.entry);
                words.map(Words::Spirv).map_err(|cause| ExecError::Translate { kernel: self.kernel, cause })
            }
        }
    }
}

impl std::fmt::Debug for GpuRoute {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("GpuRoute").field("route", &self.route).finish_non_exhaustive()
    }
}

impl Words {
    pub(crate) fn shader(&self) -> Shader<'_> {
        match self {
            Self::Wgsl(text) => Shader::Wgsl(text),
            Self::Spirv(words) => Shader::Spirv(words),
            Self::Glsl(text) => Shader::Glsl(text),
        }
    }
}

fn bind(group: u32, binding: u32, kind: BindingKind, data: &[u8]) -> Binding<'_> {
    Binding { group, binding, element: None, kind, data }
}

/// A buffer for each parameter; the columns of `args` follow the parameters.
pub(super) fn pack_arguments(layout: &EntryLayout, args: &Columns) -> Vec<Vec<u8>> {
    let mut rest = &args.columns[..];
    let buffers = layout.arguments.iter().map(|at| {
        let (own, others) = rest.split_at(at.leaves.len().min(rest.len()));
        rest = others;
        pack(at, own, args.rows)
    });
    buffers.collect()
}

fn rows_at_once(layout: &EntryLayout) -> usize {
    let strides = layout.arguments.iter().map(|at| at.stride).chain([layout.result.stride, 4]);
    let widest = strides.max().unwrap_or(4) as usize;
    (GROUPS * layout.workgroup_size as usize).min(BYTES / widest.max(4)).max(1)
}

impl Program {
    /// The module with a compute entry point that applies the kernel to rows of buffers, and its layout.
    ///
    /// # Errors
    /// When a parameter or the result is something that no buffer holds.
    pub fn entry(&self) -> Result<&(lobe_codegen::ValidModule, EntryLayout), ExecError> {
        if let Some(ready) = self.artifacts.entry.get() {
            return Ok(ready);
        }
        let made = emit::with_entry(self.module(), self.handle(), WORKGROUP)
            .map_err(|cause| ExecError::Emit { kernel: self.name(), cause: cause.into() })?;
        Ok(self.artifacts.entry.get_or_init(|| made))
    }

    /// What the buffers of the parameters hold when that entry point is run on `args`, in the order of the parameters.
    ///
    /// # Errors
    /// When the arguments have another shape, and as of [`Program::entry`].
    pub fn argument_buffers(&self, args: &Columns) -> Result<Vec<Vec<u8>>, ExecError> {
        self.check_shape(args)?;
        Ok(pack_arguments(&self.entry()?.1, args))
    }

    /// The complete compute shader for `target`, as a user gets it.
    ///
    /// # Errors
    /// When the kernel cannot be emitted.
    pub fn artifact(&self, target: Target) -> Result<Artifact, ExecError> {
        self.source()?.artifact(target)
    }

    fn source(&self) -> Result<Source<'_>, ExecError> {
        let (module, layout) = self.entry()?;
        Ok(Source { kernel: self.name(), module, entry: &layout.entry_name })
    }

    fn words(&self, road: Road, translators: &Translators) -> Result<&Words, ExecError> {
        self.artifacts.words(road, || self.source()?.words(road, translators))
    }
}

fn content(content: Content) -> Words {
    match content {
        Content::Text(text) => Words::Wgsl(text),
        Content::Words(words) => Words::Spirv(words),
    }
}
