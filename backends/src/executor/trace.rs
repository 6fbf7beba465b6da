//! What a kernel computes on the way, on one row.

use super::ExecError;
use crate::gpu::{AnyGpu, Binding, BindingKind, Job, Shader};
use crate::interp::{Buffer, InterpError, Interpreter, ShadowBuffer};
use lobe_codegen::data::Columns;
use lobe_codegen::layout::unpack;
use lobe_codegen::trace::{Record, Traced};

/// A run of a kernel that writes down what it computes.
#[derive(Debug, Clone)]
pub struct Trace {
    /// What it returned.
    pub results: Columns,
    /// What it computed, in order.
    pub records: Vec<Record>,
}

/// The buffers of one row, in the order of their bindings: arguments, results, the number of rows, records.
#[must_use]
pub fn buffers(traced: &Traced, args: &Columns) -> Vec<Buffer> {
    let layout = &traced.layout;
    let buffer = |binding, data| Buffer { group: 0, binding, data };
    let mut buffers: Vec<Buffer> = super::gpu_route::pack_arguments(layout, args)
        .into_iter()
        .zip(&layout.arguments)
        .map(|(data, at)| buffer(at.binding, data))
        .collect();
    buffers.push(buffer(layout.result.binding, vec![0; layout.result.stride as usize]));
    buffers.push(buffer(layout.count_binding, 1_u32.to_le_bytes().to_vec()));
    buffers.push(buffer(traced.binding, vec![0; traced.bytes()]));
    buffers
}

/// What such buffers hold after the run.
#[must_use]
pub fn finish(traced: &Traced, buffers: &[Buffer]) -> Trace {
    let bytes = |binding| buffers.iter().find(|b| b.binding == binding).map_or(&[][..], |b| &b.data);
    let result = &traced.layout.result;
    Trace {
        results: Columns { columns: unpack(result, bytes(result.binding), 1), rows: 1 },
        records: traced.records(bytes(traced.binding)),
    }
}

/// The run in strict f32.
///
/// # Errors
/// As [`Interpreter::run`].
pub fn interpret(traced: &Traced, args: &Columns) -> Result<Trace, InterpError> {
    let mut buffers = buffers(traced, args);
    Interpreter::new(&traced.module)?.run(0, [1, 1, 1], &mut buffers)?;
    Ok(finish(traced, &buffers))
}

/// The run of a permitted driver that errs by chance.
///
/// # Errors
/// As [`Interpreter::run`].
pub fn perturbed(traced: &Traced, args: &Columns, seed: u64) -> Result<Trace, InterpError> {
    let mut buffers = buffers(traced, args);
    Interpreter::new(&traced.module)?.perturbed_run(0, [1, 1, 1], &mut buffers, seed)?;
    Ok(finish(traced, &buffers))
}

/// The buffer of records with the exact value and a bound beside each float.
///
/// # Errors
/// As [`Interpreter::shadow_run`].
pub fn shadow(traced: &Traced, args: &Columns) -> Result<Option<ShadowBuffer>, InterpError> {
    let mut buffers = buffers(traced, args);
    let written = Interpreter::new(&traced.module)?.shadow_run(0, [1, 1, 1], &mut buffers)?.buffers;
    Ok(written.into_iter().find(|buffer| buffer.binding == traced.binding))
}

/// The run of a shader's entry point on a driver.
pub(super) fn dispatch(
    gpu: &mut AnyGpu,
    (shader, entry): (Shader<'_>, &str),
    kernel: &'static str,
    traced: &Traced,
    args: &Columns,
) -> Result<Trace, ExecError> {
    let mut buffers = buffers(traced, args);
    let kind = |binding: u32| match binding {
        at if at == traced.layout.count_binding => BindingKind::Uniform,
        at if at == traced.binding || at == traced.layout.result.binding => BindingKind::StorageReadWrite,
        _ => BindingKind::StorageRead,
    };
    let bindings: Vec<Binding<'_>> = buffers
        .iter()
        .map(|b| Binding {
            group: b.group,
            binding: b.binding,
            element: None,
            kind: kind(b.binding),
            data: &b.data,
        })
        .collect();
    let outputs = gpu.run(&Job {
        shader,
        entry,
        workgroup_size: [traced.layout.workgroup_size, 1, 1],
        groups: [1, 1, 1],
        bindings: &bindings,
        immediates: &[],
    });
    let outputs = outputs.map_err(|cause| ExecError::Gpu { kernel, cause })?;
    let is_written = |b: &&mut Buffer| matches!(kind(b.binding), BindingKind::StorageReadWrite);
    for (buffer, data) in buffers.iter_mut().filter(is_written).zip(outputs) {
        buffer.data = data;
    }
    Ok(finish(traced, &buffers))
}
