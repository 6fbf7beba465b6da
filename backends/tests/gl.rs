//! OpenGL drivers: GLSL goes to them unchanged, under its own binding numbers.

mod common;

use common::{bytes, floats};
use lobe_backends::gpu::{self, Api, Binding, BindingKind, Driver, Gpu, GpuError, Job, Shader};

/// Storage buffers and a uniform one, with gaps between their numbers.
const GLSL: &str = "#version 450 core
layout(local_size_x = 4, local_size_y = 1, local_size_z = 1) in;
layout(std430, binding = 1) readonly buffer In { float x[]; };
layout(std430, binding = 3) buffer Out { float y[]; };
layout(std140, binding = 4) uniform Count { uint rows; };
void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < rows) { y[i] = x[i] * 2.0 + 1.0; }
}
";

#[track_caller]
fn driver() -> Option<Driver> {
    let found = gpu::gl_drivers().into_iter().find(|driver| driver.name == "llvmpipe");
    if found.is_none() {
        common::skip("OpenGL driver llvmpipe", "run tests/setup.sh");
    }
    found
}

fn bindings<'a>(x: &'a [u8], y: &'a [u8], rows: &'a [u8]) -> [Binding<'a>; 3] {
    let bind = |binding, kind, data| Binding { group: 0, binding, element: None, kind, data };
    [
        bind(1, BindingKind::StorageRead, x),
        bind(3, BindingKind::StorageReadWrite, y),
        bind(4, BindingKind::Uniform, rows),
    ]
}

fn job<'a>(shader: Shader<'a>, bindings: &'a [Binding<'a>]) -> Job<'a> {
    Job { shader, entry: "main", workgroup_size: [4, 1, 1], groups: [2, 1, 1], bindings, immediates: &[] }
}

fn run(gpu: &mut Gpu, glsl: &str, x: [f32; 6], rows: u32) -> Result<Vec<f32>, GpuError> {
    let (x, y, rows) = (bytes(&x), bytes(&[-1.0; 6]), rows.to_le_bytes());
    let outputs = gpu.run(&job(Shader::Glsl(glsl), &bindings(&x, &y, &rows)))?;
    Ok(floats(&outputs[0]))
}

#[track_caller]
fn works(gpu: &mut Gpu) {
    for (rows, expected) in [(5, [1.0, 3.0, 5.0, 7.0, 9.0, -1.0]), (2, [1.0, 3.0, -1.0, -1.0, -1.0, -1.0])] {
        assert_eq!(run(gpu, GLSL, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0], rows).expect("runs"), expected);
    }
}

#[test]
fn glsl_reaches_its_buffers_by_its_own_numbers() {
    let Some(driver) = driver() else { return };
    assert_eq!(driver.api, Api::OpenGl);
    let mut gpu = Gpu::open(&driver).expect("opens");
    works(&mut gpu);
}

#[test]
fn errors_are_the_drivers_words_and_the_next_job_runs() {
    let Some(driver) = driver() else { return };
    let mut gpu = Gpu::open(&driver).expect("opens");
    let error =
        run(&mut gpu, &GLSL.replace("* 2.0", "* undeclared"), [0.0; 6], 1).expect_err("should be refused");
    assert!(matches!(error, GpuError::InvalidGlsl { .. }), "{error:?}");
    assert!(error.to_string().contains("undeclared"), "{error}");
    works(&mut gpu);
}

#[test]
fn what_does_not_fit_the_driver_is_refused() {
    let Some(driver) = driver() else { return };
    let mut gpu = Gpu::open(&driver).expect("opens");
    let (data, rows) = (bytes(&[0.0; 6]), 1_u32.to_le_bytes());
    let good = bindings(&data, &data, &rows);
    let shader = Shader::Glsl(GLSL);
    let moved = good.map(|b| Binding { group: 1, ..b });
    let high = good.map(|b| Binding { binding: b.binding + 200, ..b });
    let words = common::spirv(common::WGSL);
    for (bad, part) in [
        (Job { entry: "other", ..job(shader, &good) }, "one entry point, main"),
        (Job { immediates: &[0; 4], ..job(shader, &good) }, "immediates"),
        (job(shader, &moved), "no groups but 0"),
        (job(shader, &high), "too high a number"),
        (
            Job { workgroup_size: [64, 1, 1], bindings: &good[..0], ..job(Shader::Spirv(&words), &good) },
            "SPIR-V",
        ),
    ] {
        let error = gpu.run(&bad).expect_err(part).to_string();
        assert!(error.contains(part), "{error}");
    }
    works(&mut gpu);
}

#[test]
fn vulkan_drivers_take_no_glsl() {
    let Some(driver) = common::driver("lavapipe") else { return };
    let mut gpu = Gpu::open(&driver).expect("opens");
    let error = run(&mut gpu, GLSL, [0.0; 6], 1).expect_err("should be refused");
    assert!(matches!(error, GpuError::Unsupported { .. }), "{error:?}");
}

#[test]
fn listings_of_either_kind_do_not_disturb_the_other() {
    let before = gpu::drivers();
    let gl = gpu::gl_drivers();
    assert_eq!(gpu::drivers(), before);
    assert_eq!(gpu::gl_drivers(), gl);
    assert!(gl.iter().all(|driver| driver.api == Api::OpenGl));
    assert!(before.iter().all(|driver| driver.api == Api::Vulkan));
}
