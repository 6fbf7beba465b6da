//! Dawn and its Tint: what they make of good shaders, what they say of bad ones, and what becomes of a dead process.

mod common;

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::time::{Duration, Instant};

use common::{DEMANDING_WGSL, WGSL, bindings, bytes, driver, floats, job, ramp, spirv, tool};
use lobe_backends::gpu::{AnyGpu, Binding, BindingKind, DawnGpu, Driver, Gpu, GpuError, Job, Shader};
use lobe_backends::texture::Sampler;
use lobe_backends::translate::{Dawn, Tint, TranslateError};

#[track_caller]
fn dawn() -> Option<Dawn> {
    tool(Dawn::find())
}

#[track_caller]
fn opened(name: &str) -> Option<DawnGpu> {
    Some(DawnGpu::open(&dawn()?, &driver(name)?).expect("Dawn opens it"))
}

fn run(gpu: &mut DawnGpu, wgsl: &str, input: &[f32]) -> Result<Vec<f32>, GpuError> {
    let (input, output) = (bytes(input), bytes(&vec![-1.0; input.len()]));
    let outputs = gpu.run(&job(Shader::Wgsl(wgsl), &bindings(&input, &output)))?;
    Ok(floats(&outputs[0]))
}

#[test]
fn results_are_those_of_wgpu_on_the_same_driver() {
    for name in ["lavapipe", "swiftshader"] {
        let (Some(mut by_dawn), Some(driver)) = (opened(name), driver(name)) else { continue };
        let mut by_wgpu = AnyGpu::Wgpu(Box::new(Gpu::open(&driver).expect("opens")));
        let (input, output) = (bytes(&ramp()), bytes(&vec![-1.0; ramp().len()]));
        let bindings = bindings(&input, &output);
        let job = job(Shader::Wgsl(DEMANDING_WGSL), &bindings);
        assert_eq!(
            by_dawn.run(&job).expect("Dawn runs it"),
            by_wgpu.run(&job).expect("wgpu runs it"),
            "{name}"
        );
    }
}

#[test]
fn a_device_runs_one_job_after_another() {
    let Some(mut gpu) = opened("lavapipe") else { return };
    for length in [1, 1000, 3, 3, 1 << 20, 7] {
        let input: Vec<f32> = (0..length).map(|n| n as f32 / 8.0).collect();
        let job_length = u32::try_from(length).expect("small").div_ceil(64);
        let (input_bytes, output) = (bytes(&input), bytes(&vec![-1.0; input.len()]));
        let bindings = bindings(&input_bytes, &output);
        let job = Job { groups: [job_length, 1, 1], ..job(Shader::Wgsl(WGSL), &bindings) };
        let outputs = gpu.run(&job).expect("runs");
        let expected: Vec<f32> = input.iter().map(|x| x * 2.0 + 1.0).collect();
        assert!(floats(&outputs[0]) == expected, "{length} values");
    }
}

#[test]
fn groups_and_gaps_are_kept() {
    let Some(mut gpu) = opened("lavapipe") else { return };
    let wgsl = "
        @group(2) @binding(5) var<uniform> a: u32;
        @group(0) @binding(3) var<storage, read_write> out: array<u32, 2>;
        @compute @workgroup_size(1) fn main() { out[0] += a; }";
    let bind = |group, binding, kind, data| Binding { group, binding, element: None, kind, data };
    let bindings = [
        bind(2, 5, BindingKind::Uniform, &[5, 0, 0, 0][..]),
        bind(0, 3, BindingKind::StorageReadWrite, &[1, 0, 0, 0, 9, 0, 0, 0][..]),
    ];
    let one = Job { workgroup_size: [1; 3], groups: [1; 3], ..job(Shader::Wgsl(wgsl), &bindings) };
    assert_eq!(gpu.run(&one).expect("runs"), [vec![6, 0, 0, 0, 9, 0, 0, 0]]);
}

#[test]
fn what_is_wrong_is_said_with_its_place_and_the_next_job_runs() {
    let Some(mut gpu) = opened("lavapipe") else { return };
    let unknown = WGSL.replace("input[id.x] * 2.0", "inputs[id.x] * 2.0");
    let other_type = WGSL
        .replace("var<storage, read> input", "var<uniform> input")
        .replace("array<f32>;\n@group(0) @binding(1)", "array<vec4f, 4>;\n@group(0) @binding(1)")
        .replace("arrayLength(&input)", "4")
        .replace("input[id.x] * 2.0", "input[id.x].x");
    for (wgsl, part) in [
        (unknown.as_str(), "8:24: error: unresolved value 'inputs'"),
        (other_type.as_str(), "binding"),
        ("fn f() {}", "main"),
    ] {
        let error = run(&mut gpu, wgsl, &[1.0]).expect_err(wgsl);
        assert!(matches!(error, GpuError::InvalidWgsl { .. }), "{error:?}");
        assert!(error.to_string().contains(part), "{error}");
        assert_eq!(run(&mut gpu, WGSL, &[1.0]).expect("runs"), [3.0]);
    }
}

#[test]
fn what_dawn_is_not_handed_is_refused_aloud() {
    let Some(mut gpu) = opened("lavapipe") else { return };
    let sampler = Binding {
        group: 0,
        binding: 0,
        element: None,
        kind: BindingKind::Sampler(Sampler { lod: [0.0, 1.0], ..Sampler::default() }),
        data: &[],
    };
    let words = spirv(WGSL);
    let (input, output) = (bytes(&[1.0]), bytes(&[0.0]));
    let good = bindings(&input, &output);
    for (bad, part) in [
        (Job { groups: [1; 3], ..job(Shader::Wgsl(WGSL), &[sampler]) }, "textures and samplers"),
        (job(Shader::Spirv(&words), &good), "not WGSL"),
        (Job { immediates: &[0; 4], ..job(Shader::Wgsl(WGSL), &good) }, "immediates"),
        (Job { groups: [u32::MAX, 1, 1], ..job(Shader::Wgsl(WGSL), &good) }, "split the job"),
    ] {
        let error = gpu.run(&bad).expect_err("should be refused").to_string();
        assert!(error.contains(part), "{error}");
    }
}

#[test]
fn a_shader_that_hangs_is_given_up() {
    let Some(mut gpu) = opened("lavapipe") else { return };
    let wgsl =
        WGSL.replace("output[id.x] =", "while output[id.x] < 1e9 { output[id.x] -= 1.0; } output[id.x] =");
    gpu.set_timeout(Duration::from_secs(2));
    let begin = Instant::now();
    let error = run(&mut gpu, &wgsl, &[1.0]).expect_err("should be given up");
    assert!(matches!(error, GpuError::Timeout { .. }), "{error}");
    assert!(begin.elapsed() < Duration::from_secs(20), "{:?}", begin.elapsed());
    gpu.set_timeout(Duration::from_secs(60));
    assert_eq!(run(&mut gpu, WGSL, &[1.0]).expect("runs"), [3.0]);
}

/// What a node says that has opened a device.
const OPENED: &str = r#"{"limits":{"maxBufferSize":1000,"maxStorageBufferBindingSize":1000,"maxUniformBufferBindingSize":1000,"maxStorageBuffersPerShaderStage":8,"maxComputeInvocationsPerWorkgroup":64,"maxComputeWorkgroupSizeX":64,"maxComputeWorkgroupSizeY":64,"maxComputeWorkgroupSizeZ":64,"maxComputeWorkgroupsPerDimension":9,"maxBindGroups":4,"maxBindingsPerBindGroup":9}}"#;

/// A Dawn whose node is a shell script; it first says that a device is open.
fn false_dawn(folder: &Path, then: &str) -> Dawn {
    let write = |name: &str, text: &str| fs::write(folder.join(name), text).expect("writable");
    write("index.js", "");
    write("package.json", r#"{ "name": "webgpu", "version": "0" }"#);
    let [low, high] = u16::try_from(OPENED.len()).expect("short").to_le_bytes();
    let lengths = format!("\\{low:03o}\\{high:03o}\\0\\0\\0\\0\\0\\0");
    write("node", &format!("#!/bin/sh\nprintf '{lengths}%s' '{OPENED}'\n{then}\n"));
    let node = folder.join("node");
    fs::set_permissions(&node, fs::Permissions::from_mode(0o755)).expect("ours");
    Dawn::at(node, folder.to_owned()).expect("has the form of the package")
}

fn any_driver() -> Option<Driver> {
    driver("lavapipe")
}

#[test]
fn a_process_that_dies_or_babbles_is_an_error() {
    let Some(driver) = any_driver() else { return };
    for (then, part) in [
        ("echo last words >&2; exit 3", "and said: last words"),
        ("head -c 20 >/dev/null; kill -9 $$", "has ended without a word"),
        ("head -c 20 >/dev/null; printf 'babble, and more babble'; exec sleep 0.1", "has ended"),
        (r"head -c 20 >/dev/null; printf '\2\0\0\0\0\0\0\0{}'; exec sleep 5", "no answer"),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        let mut gpu = DawnGpu::open(&false_dawn(folder.path(), then), &driver).expect("says that it opens");
        let error = run(&mut gpu, WGSL, &[1.0]).expect_err(then);
        assert!(matches!(error, GpuError::DeviceLost { .. }), "{error:?}");
        assert!(error.to_string().contains(part), "{error}");
    }
}

#[test]
fn a_process_that_is_silent_is_given_up() {
    let Some(driver) = any_driver() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let dawn = false_dawn(folder.path(), "exec sleep 1000");
    let mut gpu = DawnGpu::open(&dawn, &driver).expect("says that it opens");
    gpu.set_timeout(Duration::from_millis(100));
    let error = run(&mut gpu, WGSL, &[1.0]).expect_err("should be given up");
    assert!(matches!(error, GpuError::Timeout { .. }), "{error}");
}

#[test]
fn a_node_that_is_none_opens_nothing() {
    let Some(driver) = any_driver() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let real = false_dawn(folder.path(), "");
    for (node, part) in [("/bin/true", "has ended"), ("/nowhere/node", "/nowhere/node")] {
        let dawn = Dawn::at(node.into(), real.package().to_owned()).expect("the package is there");
        let error = DawnGpu::open(&dawn, &driver).expect_err(node);
        assert!(matches!(error, GpuError::Open { .. }), "{error:?}");
        assert!(error.to_string().contains(part), "{error}");
        let error = Tint::start(&dawn).expect_err(node).to_string();
        assert!(error.contains("Tint"), "{error}");
    }
}

#[test]
fn a_device_that_dawn_does_not_see_is_named() {
    let (Some(dawn), Some(mut driver)) = (dawn(), any_driver()) else { return };
    driver.adapter_name = "No Such Card".to_owned();
    let error = DawnGpu::open(&dawn, &driver).expect_err("should not open").to_string();
    assert!(error.contains("No Such Card"), "{error}");
}

#[test]
fn tint_judges_libraries_and_shaders_one_after_another() {
    let Some(dawn) = dawn() else { return };
    let mut tint = Tint::start(&dawn).expect("starts");
    for round in 0..3 {
        for good in
            [WGSL, DEMANDING_WGSL, "fn f(x: f32) -> f32 { return x; }", "enable f16; fn f(x: f16) {}", ""]
        {
            tint.validate(good).unwrap_or_else(|e| panic!("round {round}: {e}"));
        }
        let error = tint.validate("fn f() {}\nfn g() -> f32 { return 1u; }").expect_err("should be refused");
        assert!(matches!(error, TranslateError::Rejected { .. }), "{error:?}");
        assert!(error.to_string().contains("2:17: error: "), "{error}");
    }
}
