//! What throughput is measured of: one face over the interpreter, native code and drivers.

use super::workload::{SIZE, Workload};
use lobe_backends::gpu::{Binding, BindingKind, Gpu, GpuError, Job, Shader};
use lobe_backends::interp::{Buffer, InterpError, Interpreter, Isa};
use lobe_backends::route::{Road, Route};
use lobe_codegen::ValidModule;
use lobe_codegen::emit::{Content, EmitError, Target, plain};
use lobe_codegen::validate::{self, ValidateError};
use std::time::{Duration, Instant};

/// Dispatches of a driver that make one measurement, their median.
const DISPATCHES: usize = 3;

/// Why there is no measurement.
#[derive(Debug, thiserror::Error)]
pub enum BenchError {
    /// The workload is no shader.
    #[error("the workload {name} does not validate: {cause}")]
    Validate {
        /// The workload.
        name: &'static str,
        /// Why.
        cause: ValidateError,
    },
    /// Its words cannot be written.
    #[error("the workload {name} cannot be written: {cause}")]
    Emit {
        /// The workload.
        name: &'static str,
        /// Why.
        cause: EmitError,
    },
    /// The interpreter gave up.
    #[error("{name} on the interpreter: {cause}")]
    Interp {
        /// The workload.
        name: &'static str,
        /// Why.
        cause: InterpError,
    },
    /// The driver gave up.
    #[error("{name} on {route}: {cause}")]
    Gpu {
        /// The workload.
        name: &'static str,
        /// The route.
        route: String,
        /// Why.
        cause: GpuError,
    },
    /// Other compilers are not measured.
    #[error("throughput by {0} is not measured; take spirv or wgsl+naga")]
    Road(String),
}

/// Something whose throughput is measured.
#[derive(Debug)]
pub enum Executor {
    /// The interpreter, on one instruction set.
    Interp(Isa),
    /// The workload's Rust.
    Native,
    /// A driver.
    Gpu {
        /// What it is given.
        road: Road,
        /// The opened device.
        gpu: Box<Gpu>,
    },
}

impl Executor {
    /// Its name among others: `interp/avx2`, `native`, `spirv@lavapipe`.
    #[must_use]
    pub fn name(&self) -> String {
        match self {
            Self::Interp(isa) => format!("interp/{isa}"),
            Self::Native => "native".to_owned(),
            Self::Gpu { road, gpu } => {
                Route::Gpu { road: *road, driver: gpu.driver().name.clone() }.to_string()
            }
        }
    }
}

/// The module of a workload's text.
pub(super) fn module(workload: &Workload) -> Result<ValidModule, BenchError> {
    let name = workload.name;
    validate::from_wgsl(&workload.text).map_err(|cause| BenchError::Validate { name, cause })
}

/// A workload, ready for every executor.
pub(super) struct Subject<'w> {
    workload: &'w Workload,
    /// It links once for each instruction set, as a driver compiles once.
    interpreter: Interpreter<'w>,
    spirv: Vec<u32>,
    /// The interpreter's buffers, which it updates in place.
    buffers: Vec<Buffer>,
    /// What drivers are given.
    data: Vec<Vec<u8>>,
}

impl<'w> Subject<'w> {
    pub(super) fn new(workload: &'w Workload, module: &'w ValidModule) -> Result<Self, BenchError> {
        let name = workload.name;
        let interpreter = Interpreter::new(module).map_err(|cause| BenchError::Interp { name, cause })?;
        // SPIR-V has an input for the number of workgroups.
        let written =
            plain(module, Target::Spirv, "main", [1; 3]).map_err(|cause| BenchError::Emit { name, cause })?;
        let spirv = match written.content {
            Content::Words(words) => words,
            Content::Text(_) => Vec::new(),
        };
        let bytes = |floats: &Vec<f32>| floats.iter().flat_map(|x| x.to_le_bytes()).collect();
        let data: Vec<Vec<u8>> =
            workload.inputs.iter().map(bytes).chain([vec![0; workload.items * 4]]).collect();
        let buffer = |(binding, data): (u32, &Vec<u8>)| Buffer::copied(0, binding, data);
        let buffers = (0..).zip(&data).map(buffer).collect();
        Ok(Self { workload, interpreter, spirv, buffers, data })
    }

    /// How long one pass over all items takes.
    pub(super) fn time(&mut self, executor: &mut Executor) -> Result<Duration, BenchError> {
        match executor {
            Executor::Interp(isa) => self.interpret(*isa),
            Executor::Native => {
                let begin = Instant::now();
                std::hint::black_box(self.workload.run_native());
                Ok(begin.elapsed())
            }
            Executor::Gpu { road, gpu } => self.dispatch(*road, gpu),
        }
    }

    /// What the interpreter left.
    #[cfg(test)]
    pub(super) fn output(&self) -> Vec<f32> {
        let bytes = self.buffers.last().map_or(&[][..], |b| &b.data);
        bytes.as_chunks().0.iter().map(|c| f32::from_le_bytes(*c)).collect()
    }

    fn groups(&self) -> [u32; 3] {
        [(self.workload.items as u32).div_ceil(SIZE), 1, 1]
    }

    fn interpret(&mut self, isa: Isa) -> Result<Duration, BenchError> {
        let name = self.workload.name;
        let groups = self.groups();
        let interpreter = self.interpreter.clone().with_isa(isa);
        let begin = Instant::now();
        let outcome = interpreter.run(0, groups, &mut self.buffers);
        outcome.map(|()| begin.elapsed()).map_err(|cause| BenchError::Interp { name, cause })
    }

    fn dispatch(&self, road: Road, gpu: &mut Gpu) -> Result<Duration, BenchError> {
        let last = self.data.len() - 1;
        let kind = |at| if at == last { BindingKind::StorageReadWrite } else { BindingKind::StorageRead };
        let bind = |(at, data)| Binding { group: 0, binding: at as u32, element: None, kind: kind(at), data };
        let bindings: Vec<Binding<'_>> = self.data.iter().map(Vec::as_slice).enumerate().map(bind).collect();
        let shader = match road {
            Road::Spirv => Shader::Spirv(&self.spirv),
            Road::WgslNaga => Shader::Wgsl(&self.workload.text),
            Road::HlslDxc | Road::HlslSlang | Road::GlslGlslang | Road::WgslTint | Road::Glsl => {
                return Err(BenchError::Road(road.name().to_owned()));
            }
        };
        let job = Job {
            shader,
            entry: "main",
            workgroup_size: [SIZE, 1, 1],
            groups: self.groups(),
            bindings: &bindings,
            immediates: &[],
        };
        let timed = gpu.time(&job, DISPATCHES);
        let mut times = timed.map_err(|cause| BenchError::Gpu {
            name: self.workload.name,
            route: format!("{}@{}", road.name(), gpu.driver().name),
            cause,
        })?;
        times.sort_unstable();
        Ok(times[times.len() / 2])
    }
}
