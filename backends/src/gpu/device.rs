//! One opened device: pipeline, buffers, dispatch, read back.

use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use super::bindings::{Bindings, Spare};
use super::driver::{self, block_on};
use super::pipelines::{self, Key, Pipeline, Pipelines};
use super::{Api, Driver, GpuError, Job, Shader};

/// Asked for where the adapter has them; none changes what a shader without them computes.
pub(super) const WANTED: wgpu::Features = wgpu::Features::PASSTHROUGH_SHADERS
    .union(wgpu::Features::SHADER_F64)
    .union(wgpu::Features::SHADER_F16)
    .union(wgpu::Features::SHADER_INT64)
    .union(wgpu::Features::SHADER_I16)
    .union(wgpu::Features::SHADER_INT64_ATOMIC_MIN_MAX)
    .union(wgpu::Features::SHADER_INT64_ATOMIC_ALL_OPS)
    .union(wgpu::Features::SHADER_FLOAT32_ATOMIC)
    .union(wgpu::Features::IMMEDIATES)
    .union(wgpu::Features::SUBGROUP)
    .union(wgpu::Features::SUBGROUP_BARRIER)
    .union(wgpu::Features::TEXTURE_ADAPTER_SPECIFIC_FORMAT_FEATURES)
    .union(wgpu::Features::TEXTURE_FORMAT_16BIT_NORM)
    .union(wgpu::Features::TEXTURE_ATOMIC)
    .union(wgpu::Features::TEXTURE_INT64_ATOMIC)
    .union(wgpu::Features::FLOAT32_FILTERABLE)
    .union(wgpu::Features::BGRA8UNORM_STORAGE)
    .union(wgpu::Features::TEXTURE_BINDING_ARRAY)
    .union(wgpu::Features::BUFFER_BINDING_ARRAY)
    .union(wgpu::Features::STORAGE_RESOURCE_BINDING_ARRAY)
    .union(wgpu::Features::SAMPLED_TEXTURE_AND_STORAGE_BUFFER_ARRAY_NON_UNIFORM_INDEXING)
    .union(wgpu::Features::STORAGE_TEXTURE_ARRAY_NON_UNIFORM_INDEXING)
    .union(wgpu::Features::UNIFORM_BUFFER_BINDING_ARRAYS);

/// Bytes of what is bound where a job has nothing: a `vec4` for uniform buffers.
const FILLER: u64 = 16;

/// A device with what was made on it.
pub(super) struct Device {
    name: String,
    api: Api,
    device: wgpu::Device,
    queue: wgpu::Queue,
    faults: Arc<Faults>,
    pipelines: Pipelines,
    spare: Spare,
    /// Bound where a job skips a number (`pipelines::fillers`).
    filler: wgpu::Buffer,
}

/// What the device reports by callback, from whatever thread.
#[derive(Default)]
struct Faults {
    lost: Mutex<Option<String>>,
    uncaptured: Mutex<Option<String>>,
}

/// Why a step failed, before it is known which step it was.
enum Fault {
    Lost(String),
    OutOfMemory,
    Rejected(String),
}

fn keep_first(slot: &Mutex<Option<String>>, message: String) {
    slot.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(message);
}

fn taken(slot: &Mutex<Option<String>>) -> Option<String> {
    slot.lock().unwrap_or_else(PoisonError::into_inner).take()
}

fn held(slot: &Mutex<Option<String>>) -> Option<String> {
    slot.lock().unwrap_or_else(PoisonError::into_inner).clone()
}

impl Device {
    pub(super) fn open(driver: &Driver) -> Result<Self, GpuError> {
        let failed = |reason: String| GpuError::Open { driver: driver.name.clone(), reason };
        let adapter = driver::adapter(driver).map_err(failed)?;
        let descriptor = wgpu::DeviceDescriptor {
            required_features: adapter.features() & WANTED,
            required_limits: adapter.limits(),
            ..Default::default()
        };
        let opened = block_on(adapter.request_device(&descriptor));
        let (device, queue) = opened.map_err(|error| failed(error.to_string()))?;
        let faults = Arc::new(Faults::default());
        watch(&device, &faults);
        let filler = device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: FILLER,
            usage: wgpu::BufferUsages::STORAGE.union(wgpu::BufferUsages::UNIFORM),
            mapped_at_creation: false,
        });
        let (pipelines, spare) = Default::default();
        Ok(Self {
            name: driver.name.clone(),
            api: driver.api,
            device,
            queue,
            faults,
            pipelines,
            spare,
            filler,
        })
    }

    pub(super) fn limits(&self) -> wgpu::Limits {
        self.device.limits()
    }

    /// Whether nothing more can be run on it.
    pub(super) fn is_lost(&self) -> bool {
        held(&self.faults.lost).is_some()
    }

    /// Runs a job that has passed `check`.
    pub(super) fn run(&mut self, job: &Job) -> Result<Vec<Vec<u8>>, GpuError> {
        let pipeline = self.pipeline(job)?;
        let mut spare = std::mem::take(&mut self.spare);
        let step = self.scoped(|| {
            let bindings = Bindings::fill(&mut spare, &self.device, &self.queue, job.bindings);
            self.submit(&pipeline, &bindings, job, true);
            bindings.map();
            bindings
        });
        let bindings = step.map_err(|fault| self.runtime_error(fault))?;
        self.wait()?;
        let outputs = bindings.read().map_err(|error| self.runtime_error(Fault::Rejected(error)))?;
        self.spare = bindings.into_spare();
        Ok(outputs)
    }

    /// Times one dispatch of a job that has passed `check` after another, its data staying where it is.
    pub(super) fn time(&mut self, job: &Job, rounds: usize) -> Result<Vec<Duration>, GpuError> {
        let pipeline = self.pipeline(job)?;
        let mut spare = std::mem::take(&mut self.spare);
        let filled = self.scoped(|| Bindings::fill(&mut spare, &self.device, &self.queue, job.bindings));
        let bindings = filled.map_err(|fault| self.runtime_error(fault))?;
        self.queue.submit([]);
        self.wait()?;
        let round = |_| {
            let begin = Instant::now();
            let step = self.scoped(|| self.submit(&pipeline, &bindings, job, false));
            step.map_err(|fault| self.runtime_error(fault))?;
            self.wait().map(|()| begin.elapsed())
        };
        let times = (0..rounds).map(round).collect();
        self.spare = bindings.into_spare();
        times
    }

    /// Waits for what was submitted.
    fn wait(&self) -> Result<(), GpuError> {
        let waited = self.device.poll(wgpu::PollType::wait_indefinitely());
        self.report().map_err(|fault| self.runtime_error(fault))?;
        waited.map(drop).map_err(|error| self.runtime_error(Fault::Rejected(error.to_string())))
    }

    fn pipeline(&mut self, job: &Job) -> Result<Pipeline, GpuError> {
        if let Some(feature) = self.lacking(job.shader) {
            return Err(GpuError::Unsupported { driver: self.name.clone(), feature });
        }
        let key = Key::of(job, self.device.features());
        if let Some(pipeline) = self.pipelines.get(&key) {
            return Ok(pipeline);
        }
        let built = self.scoped(|| pipelines::build(&self.device, job));
        let pipeline = built.map_err(|fault| self.pipeline_error(fault, job.shader))?;
        self.pipelines.keep(key, pipeline.clone());
        Ok(pipeline)
    }

    /// What the device would have to offer for such a shader.
    fn lacking(&self, shader: Shader) -> Option<&'static str> {
        let passes = self.device.features().contains(wgpu::Features::PASSTHROUGH_SHADERS);
        match (shader, self.api) {
            (Shader::Wgsl(_), _) => None,
            (Shader::Spirv(_), Api::Vulkan) | (Shader::Glsl(_), Api::OpenGl) if passes => None,
            (Shader::Spirv(_), _) => Some("unchanged SPIR-V (wgpu's PASSTHROUGH_SHADERS, on Vulkan)"),
            (Shader::Glsl(_), _) => Some("unchanged GLSL (wgpu's PASSTHROUGH_SHADERS, on OpenGL)"),
        }
    }

    fn submit(&self, pipeline: &Pipeline, bindings: &Bindings, job: &Job, back: bool) {
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(&pipeline.pipeline);
            for (group, layout) in (0..).zip(&pipeline.groups) {
                if let Some(layout) = layout {
                    pass.set_bind_group(group, &self.bind_group(group, layout, bindings, job), &[]);
                }
            }
            if !job.immediates.is_empty() {
                pass.set_immediates(0, job.immediates);
            }
            let [x, y, z] = job.groups;
            pass.dispatch_workgroups(x, y, z);
        }
        if back {
            bindings.copy_back(&mut encoder);
        }
        self.queue.submit([encoder.finish()]);
    }

    fn bind_group(
        &self,
        group: u32,
        layout: &wgpu::BindGroupLayout,
        bindings: &Bindings,
        job: &Job,
    ) -> wgpu::BindGroup {
        let of_group = job.bindings.iter().enumerate().filter(|(_, b)| b.group == group);
        let alone = of_group.clone().filter(|(_, b)| b.element.is_none());
        let bound = alone.map(|(index, b)| (pipelines::place(job.shader, b), bindings.bound(index)));
        let arrays: Vec<_> = of_group
            .filter(|(_, b)| b.element == Some(0))
            .map(|(_, b)| (b.binding, bindings.array(job, (group, b.binding))))
            .collect();
        let arrays = arrays.iter().map(|(binding, array)| (*binding, array.lend()));
        let fillers = pipelines::fillers(job, group).into_iter();
        let fillers = fillers.map(|filler| (filler.place, self.filler.as_entire_binding()));
        let entries: Vec<_> = bound
            .chain(arrays)
            .chain(fillers)
            .map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource })
            .collect();
        self.device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout, entries: &entries })
    }

    /// Does `body` and collects what wgpu reports about it.
    fn scoped<T>(&self, body: impl FnOnce() -> T) -> Result<T, Fault> {
        use wgpu::ErrorFilter::{Internal, OutOfMemory, Validation};
        let scopes = [Internal, Validation, OutOfMemory].map(|filter| self.device.push_error_scope(filter));
        let value = body();
        // Scopes nest: the last pushed is the first popped.
        let errors: Vec<wgpu::Error> =
            scopes.into_iter().rev().filter_map(|scope| block_on(scope.pop())).collect();
        self.report()?;
        errors.into_iter().next().map_or(Ok(value), |error| Err(fault_of(error)))
    }

    /// What the callbacks have reported since the last look.
    fn report(&self) -> Result<(), Fault> {
        if let Some(message) = held(&self.faults.lost) {
            return Err(Fault::Lost(message));
        }
        taken(&self.faults.uncaptured).map_or(Ok(()), |message| Err(Fault::Rejected(message)))
    }

    fn pipeline_error(&self, fault: Fault, shader: Shader) -> GpuError {
        let driver = self.name.clone();
        match fault {
            Fault::Lost(message) => GpuError::Refused { driver, message },
            Fault::OutOfMemory => GpuError::OutOfMemory { driver },
            Fault::Rejected(message) => match shader {
                Shader::Wgsl(_) => GpuError::InvalidWgsl { driver, message },
                Shader::Spirv(_) => GpuError::Refused { driver, message },
                Shader::Glsl(_) => GpuError::InvalidGlsl { driver, message },
            },
        }
    }

    fn runtime_error(&self, fault: Fault) -> GpuError {
        let driver = self.name.clone();
        match fault {
            Fault::Lost(message) => GpuError::DeviceLost { driver, message },
            Fault::OutOfMemory => GpuError::OutOfMemory { driver },
            Fault::Rejected(message) => GpuError::Rejected { driver, message },
        }
    }
}

fn watch(device: &wgpu::Device, faults: &Arc<Faults>) {
    let lost = Arc::clone(faults);
    device.set_device_lost_callback(move |reason, message| {
        keep_first(&lost.lost, if message.is_empty() { format!("{reason:?}") } else { message });
    });
    let uncaptured = Arc::clone(faults);
    device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
        keep_first(&uncaptured.uncaptured, error.to_string());
    }));
}

fn fault_of(error: wgpu::Error) -> Fault {
    match error {
        wgpu::Error::OutOfMemory { .. } => Fault::OutOfMemory,
        wgpu::Error::Validation { description, .. } | wgpu::Error::Internal { description, .. } => {
            Fault::Rejected(plain(&description))
        }
    }
}

/// wgpu's description without the heading that every one has.
fn plain(description: &str) -> String {
    let text = description.trim();
    let text = text.strip_prefix("Validation Error").unwrap_or(text).trim_start();
    text.strip_prefix("Caused by:").unwrap_or(text).trim().to_owned()
}
