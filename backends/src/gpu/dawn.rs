//! A driver behind Dawn, which compiles WGSL by Tint: a process for each device.
//!
//! It takes buffers only. Textures and samplers are refused, as are immediates, which WebGPU does not have.

use std::time::Duration;

use serde_json::{Value, json};

use super::{Binding, BindingKind, DEFAULT_TIMEOUT, Driver, GpuError, Job, Shader, check};
use crate::translate::Dawn;
use crate::translate::dawn::process::{Fault, Frame, Process};

/// A device that Dawn has opened, with the pipelines and buffers of its recent jobs.
#[derive(Debug)]
pub struct DawnGpu {
    dawn: Dawn,
    driver: Driver,
    limits: wgpu::Limits,
    timeout: Duration,
    /// `None` after the device was lost, until the next job.
    process: Option<Process>,
}

impl DawnGpu {
    /// Has `dawn` open a device on `driver`.
    ///
    /// # Errors
    ///
    /// [`GpuError::Open`], or [`GpuError::Timeout`] if the driver hangs.
    pub fn open(dawn: &Dawn, driver: &Driver) -> Result<Self, GpuError> {
        let (process, limits) = start(dawn, driver, DEFAULT_TIMEOUT)?;
        let (dawn, driver) = (dawn.clone(), driver.clone());
        Ok(Self { dawn, driver, limits, timeout: DEFAULT_TIMEOUT, process: Some(process) })
    }

    /// The driver that was opened.
    #[must_use]
    pub fn driver(&self) -> &Driver {
        &self.driver
    }

    /// Sets how long a job may take from now on.
    pub fn set_timeout(&mut self, timeout: Duration) {
        self.timeout = timeout;
    }

    /// Runs one job of WGSL, as [`Gpu::run`](super::Gpu::run) does.
    ///
    /// # Errors
    ///
    /// A [`GpuError`] that says whose fault it was. After any of them the next job runs, in a fresh process if need be.
    pub fn run(&mut self, job: &Job) -> Result<Vec<Vec<u8>>, GpuError> {
        check::check(&self.driver.name, &self.limits, job)?;
        let header = json!({ "job": self.describe(job)? });
        let parts: Vec<&[u8]> = job.bindings.iter().map(|b| b.data).collect();
        let process = match self.process.take() {
            Some(process) => process,
            None => start(&self.dawn, &self.driver, self.timeout)?.0,
        };
        match process.send(&header, &parts).and_then(|()| process.answer(self.timeout)) {
            Ok(frame) => {
                let outputs = outputs(&self.driver, &frame);
                if !matches!(outputs, Err(GpuError::DeviceLost { .. })) {
                    self.process = Some(process);
                }
                outputs
            }
            Err(fault) => Err(given_up(process, &self.driver, fault, self.timeout)),
        }
    }

    /// The job as the process is told of it.
    fn describe(&self, job: &Job) -> Result<Value, GpuError> {
        let unsupported =
            |feature| GpuError::Unsupported { driver: format!("{} by Dawn", self.driver.name), feature };
        let Shader::Wgsl(wgsl) = job.shader else { return Err(unsupported("shaders that are not WGSL")) };
        if !job.immediates.is_empty() {
            return Err(unsupported("immediates"));
        }
        let binding = |b: &Binding| {
            let kind = kind(b.kind).ok_or_else(|| unsupported("textures and samplers, only buffers"))?;
            Ok(json!({ "group": b.group, "binding": b.binding, "kind": kind, "bytes": b.data.len() }))
        };
        let bindings: Vec<Value> = job.bindings.iter().map(binding).collect::<Result<_, GpuError>>()?;
        Ok(json!({ "wgsl": wgsl, "entry": job.entry, "groups": job.groups, "bindings": bindings }))
    }
}

fn kind(kind: BindingKind) -> Option<&'static str> {
    match kind {
        BindingKind::Uniform => Some("uniform"),
        BindingKind::StorageRead => Some("read"),
        BindingKind::StorageReadWrite => Some("read_write"),
        BindingKind::Texture(_) | BindingKind::StorageTexture(..) | BindingKind::Sampler(_) => None,
    }
}

fn start(dawn: &Dawn, driver: &Driver, timeout: Duration) -> Result<(Process, wgpu::Limits), GpuError> {
    let failed = |reason: String| GpuError::Open { driver: driver.name.clone(), reason };
    let options = ["backend=vulkan".to_owned(), format!("adapter={}", driver.adapter_name)];
    let started = dawn.start(&options, driver.vulkan_icd.as_deref());
    let process = started.map_err(|error| failed(format!("{}: {error}", dawn.node().display())))?;
    match process.answer(timeout) {
        Ok(frame) => match frame.error() {
            None => Ok((process, limits(&frame.header["limits"]))),
            Some((_, message)) => Err(failed(format!("Dawn: {message}"))),
        },
        Err(fault @ Fault::Late) => Err(given_up(process, driver, fault, timeout)),
        Err(Fault::Ended(reason)) => Err(failed(format!("Dawn: {reason}"))),
    }
}

/// What a job is checked against.
fn limits(told: &Value) -> wgpu::Limits {
    let wide = |name: &str| told[name].as_u64().unwrap_or_default();
    let narrow = |name: &str| u32::try_from(wide(name)).unwrap_or(u32::MAX);
    wgpu::Limits {
        max_buffer_size: wide("maxBufferSize"),
        max_storage_buffer_binding_size: wide("maxStorageBufferBindingSize"),
        max_uniform_buffer_binding_size: wide("maxUniformBufferBindingSize"),
        max_storage_buffers_per_shader_stage: narrow("maxStorageBuffersPerShaderStage"),
        max_compute_invocations_per_workgroup: narrow("maxComputeInvocationsPerWorkgroup"),
        max_compute_workgroup_size_x: narrow("maxComputeWorkgroupSizeX"),
        max_compute_workgroup_size_y: narrow("maxComputeWorkgroupSizeY"),
        max_compute_workgroup_size_z: narrow("maxComputeWorkgroupSizeZ"),
        max_compute_workgroups_per_dimension: narrow("maxComputeWorkgroupsPerDimension"),
        max_bind_groups: narrow("maxBindGroups"),
        max_bindings_per_bind_group: narrow("maxBindingsPerBindGroup"),
        ..wgpu::Limits::default()
    }
}

/// The bytes of each buffer that was written, or what went wrong.
fn outputs(driver: &Driver, frame: &Frame) -> Result<Vec<Vec<u8>>, GpuError> {
    let driver = driver.name.clone();
    if let Some((fault, message)) = frame.error() {
        let message = message.to_owned();
        return Err(match fault {
            "wgsl" => GpuError::InvalidWgsl { driver, message },
            "memory" => GpuError::OutOfMemory { driver },
            "lost" => GpuError::DeviceLost { driver, message },
            _ => GpuError::Rejected { driver, message: format!("Dawn: {message}") },
        });
    }
    let lengths: Option<Vec<usize>> = frame.header["outputs"]
        .as_array()
        .and_then(|all| all.iter().map(|n| usize::try_from(n.as_u64()?).ok()).collect());
    let mut rest = &frame.bytes[..];
    let cut = lengths.and_then(|lengths| {
        let take = |length| rest.split_off(..length).map(<[u8]>::to_vec);
        lengths.into_iter().map(take).collect::<Option<Vec<_>>>()
    });
    cut.ok_or_else(|| GpuError::DeviceLost { driver, message: "Dawn's answer is no answer".to_owned() })
}

fn given_up(process: Process, driver: &Driver, fault: Fault, limit: Duration) -> GpuError {
    process.kill();
    let driver = driver.name.clone();
    match fault {
        Fault::Late => GpuError::Timeout { driver, limit },
        Fault::Ended(message) => GpuError::DeviceLost { driver, message: format!("Dawn: {message}") },
    }
}
