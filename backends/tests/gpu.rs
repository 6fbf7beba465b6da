//! Shaders on real drivers: the same kernel by every road, and everything that can go wrong on the way.

mod common;

use std::time::{Duration, Instant};

use common::{DEMANDING_WGSL, WGSL, bindings, bytes, driver, floats, job, ramp, spirv, tool};
use lobe_backends::gpu::{self, Binding, BindingKind, Gpu, GpuError, Job, Shader};
use lobe_backends::translate::{Dxc, DxcOutput, Slang, spirv_words};

fn open(name: &str) -> Option<Gpu> {
    driver(name).map(|driver| Gpu::open(&driver).expect("a listed driver opens"))
}

/// Runs one of the shared kernels over `input`.
fn run(gpu: &mut Gpu, shader: Shader, input: &[f32]) -> Result<Vec<f32>, GpuError> {
    let (input, output) = (bytes(input), bytes(&vec![f32::MAX; input.len()]));
    let outputs = gpu.run(&job(shader, &bindings(&input, &output)))?;
    assert_eq!(outputs.len(), 1);
    Ok(floats(&outputs[0]))
}

/// That the device is fit for work, whatever was asked of it before.
#[track_caller]
fn works(gpu: &mut Gpu) {
    assert_eq!(run(gpu, Shader::Wgsl(WGSL), &[1.0, 2.0, -0.5]).expect("a good job runs"), [3.0, 5.0, 0.0]);
}

fn bits(values: &[f32]) -> Vec<u32> {
    values.iter().map(|value| value.to_bits()).collect()
}

#[test]
fn lavapipe_comes_first() {
    if driver("lavapipe").is_some() {
        let drivers = gpu::drivers();
        assert_eq!(drivers[0].name, "lavapipe");
        assert!(drivers[0].is_software && drivers[0].has_f64 && drivers[0].has_passthrough, "{drivers:?}");
    }
}

#[test]
fn wgsl_computes() {
    for name in ["lavapipe", "swiftshader"] {
        let Some(mut gpu) = open(name) else { continue };
        let input = ramp();
        let expected: Vec<f32> = input.iter().map(|x| x * 2.0 + 1.0).collect();
        assert_eq!(run(&mut gpu, Shader::Wgsl(WGSL), &input).expect("runs"), expected, "{name}");
    }
}

#[test]
fn every_road_gives_the_same_bits() {
    for name in ["lavapipe", "swiftshader"] {
        let (Some(mut gpu), Some(dxc), Some(slang)) = (open(name), tool(Dxc::find()), tool(Slang::find()))
        else {
            continue;
        };
        let words = spirv(DEMANDING_WGSL);
        let hlsl = common::hlsl(DEMANDING_WGSL);
        let dxc = dxc.compile(&hlsl, "cs_6_0", Some("main"), DxcOutput::Spirv).expect("DXC compiles");
        let slang = slang.compile(&hlsl, "main").expect("slang compiles");
        let [dxc, slang] = [dxc, slang].map(|object| spirv_words(&object).expect("words"));
        assert!(words != dxc && words != slang && dxc != slang);

        let input = ramp();
        let wgsl = run(&mut gpu, Shader::Wgsl(DEMANDING_WGSL), &input).expect("WGSL runs");
        assert!(wgsl.iter().all(|&y| y != f32::MAX), "every output was written");
        for (compiler, words) in [("naga", words), ("DXC", dxc), ("slang", slang)] {
            let passed = run(&mut gpu, Shader::Spirv(&words), &input).expect("SPIR-V runs");
            assert_eq!(bits(&wgsl), bits(&passed), "{name}: WGSL against {compiler}'s SPIR-V");
        }
    }
}

#[test]
fn every_kind_of_binding_arrives() {
    let wgsl = "
        @group(0) @binding(3) var<uniform> scale: vec4f;
        @group(2) @binding(0) var<storage, read> input: array<f32, 4>;
        @group(2) @binding(7) var<storage, read_write> sum: array<f32, 1>;
        @group(0) @binding(1) var<storage, read_write> scaled: array<f32, 4>;
        @compute @workgroup_size(1) fn main() {
            for (var i = 0; i < 4; i++) { scaled[i] += input[i] * scale[i]; sum[0] += scaled[i]; }
        }";
    let Some(mut gpu) = open("lavapipe") else { return };
    let [scale, input, sum, scaled] =
        [&[1.0, 2.0, 3.0, 4.0][..], &[1.0, 1.0, 2.0, 2.0], &[100.0], &[0.5, 0.0, 0.0, 0.0]].map(bytes);
    let at = |group, binding, kind, data| Binding { group, binding, element: None, kind, data };
    let bindings = [
        at(0, 3, BindingKind::Uniform, scale.as_slice()),
        at(2, 0, BindingKind::StorageRead, &input),
        at(2, 7, BindingKind::StorageReadWrite, &sum),
        at(0, 1, BindingKind::StorageReadWrite, &scaled),
    ];
    for shader in [Shader::Wgsl(wgsl), Shader::Spirv(&spirv(wgsl))] {
        let job = Job {
            shader,
            entry: "main",
            workgroup_size: [1; 3],
            groups: [1; 3],
            bindings: &bindings,
            immediates: &[],
        };
        let outputs: Vec<_> = gpu.run(&job).expect("runs").iter().map(|b| floats(b)).collect();
        // In the order of the bindings, group 1 left out.
        assert_eq!(outputs, [vec![117.5], vec![1.5, 2.0, 6.0, 8.0]]);
    }
}

/// What a driver makes of a buffer that nobody bound is undefined in Vulkan, up to a crash.
#[test]
fn spirv_that_uses_what_is_not_bound_never_reaches_the_driver() {
    let Some(mut gpu) = open("lavapipe") else { return };
    let (words, data) = (spirv(WGSL), bytes(&[1.0]));
    let input =
        [Binding { group: 0, binding: 0, element: None, kind: BindingKind::StorageRead, data: &data }];
    let error = gpu.run(&job(Shader::Spirv(&words), &input)).expect_err("should be refused");
    assert!(error.to_string().contains("uses group 0, binding 1"), "{error}");
}

#[test]
fn one_device_serves_many_shapes() {
    let Some(mut gpu) = open("lavapipe") else { return };
    for length in [1, 100, 3, 100, 4096, 1] {
        let input: Vec<f32> = ramp().into_iter().take(length).collect();
        let expected: Vec<f32> = input.iter().map(|x| x * 2.0 + 1.0).collect();
        assert_eq!(run(&mut gpu, Shader::Wgsl(WGSL), &input).expect("runs"), expected);
    }
}

/// More shaders than are kept, in turns, with the same bindings.
#[test]
fn shaders_are_not_mistaken_for_each_other() {
    let Some(mut gpu) = open("lavapipe") else { return };
    let shaders: Vec<_> = (0..70).map(|k| WGSL.replace("+ 1.0", &format!("+ {k}.0"))).collect();
    for (k, wgsl) in (0u8..).zip(&shaders).chain((0..).zip(&shaders)) {
        assert_eq!(run(&mut gpu, Shader::Wgsl(wgsl), &[1.0]).expect("runs"), [2.0 + f32::from(k)]);
    }
}

#[test]
fn wrong_wgsl_is_quoted() {
    let Some(mut gpu) = open("lavapipe") else { return };
    for (wgsl, part) in [
        ("fn main( {", "wgsl:1:10"),
        ("@compute @workgroup_size(64) fn main() { let x: u32 = 1.5; }", "1.5"),
        // Valid, but it wants a binding that the job does not have, or has no such entry point.
        (
            "@group(1) @binding(0) var<storage> x: array<f32>; @compute @workgroup_size(64) fn main() { _ = x[0]; }",
            "1",
        ),
        ("@compute @workgroup_size(64) fn other() { }", "main"),
    ] {
        let error = run(&mut gpu, Shader::Wgsl(wgsl), &[1.0]).expect_err("should be refused");
        assert!(matches!(error, GpuError::InvalidWgsl { .. }), "{wgsl}: {error:?}");
        assert!(error.to_string().contains(part), "{wgsl}: {error}");
        works(&mut gpu);
    }
}

#[test]
fn words_that_are_no_spirv_never_reach_the_driver() {
    let Some(mut gpu) = open("lavapipe") else { return };
    for words in [&[][..], &[0xdead_beef; 100], &spirv(WGSL)[..40]] {
        let error = run(&mut gpu, Shader::Spirv(words), &[1.0]).expect_err("should be refused");
        assert!(matches!(error, GpuError::BadSpirv { .. }), "{error:?}");
        works(&mut gpu);
    }
}

#[test]
fn spirv_that_the_driver_refuses_costs_one_device() {
    let Some(mut gpu) = open("lavapipe") else { return };
    // Every `OpFMul` becomes an opcode that does not exist: sound in form, so only the driver can say no.
    let mut words = spirv(WGSL);
    let mut at = 5;
    while at < words.len() {
        let (length, opcode) = (words[at] >> 16, words[at] & 0xffff);
        if opcode == 133 {
            words[at] = length << 16 | 0x7ffe;
        }
        at += length as usize;
    }
    let error = run(&mut gpu, Shader::Spirv(&words), &[1.0]).expect_err("should be refused");
    assert!(matches!(error, GpuError::Refused { .. }), "{error:?}");
    assert!(error.to_string().contains("lavapipe: the driver refused the shader"), "{error}");
    works(&mut gpu);
}

#[test]
fn limits_are_told() {
    let Some(mut gpu) = open("lavapipe") else { return };
    let data = bytes(&[1.0]);
    let job = Job { groups: [u32::MAX, 1, 1], ..job(Shader::Wgsl(WGSL), &[]) };
    assert!(matches!(gpu.run(&job), Err(GpuError::TooManyGroups { limit: 65_535, .. })));

    let bindings = [Binding {
        group: 0,
        binding: 0,
        element: None,
        kind: BindingKind::Uniform,
        data: &vec![0; 1 << 20],
    }];
    let error = gpu.run(&Job { groups: [1; 3], bindings: &bindings, ..job }).expect_err("should be refused");
    assert!(matches!(error, GpuError::BufferTooLarge { bytes: 0x10_0000, .. }), "{error:?}");

    // Large enough for the driver, too small for the shader.
    let bindings = [Binding { group: 0, binding: 0, element: None, kind: BindingKind::Uniform, data: &data }];
    let wgsl =
        "@group(0) @binding(0) var<uniform> x: vec4f; @compute @workgroup_size(64) fn main() { _ = x; }";
    let small = Job { shader: Shader::Wgsl(wgsl), groups: [1; 3], bindings: &bindings, ..job };
    let error = gpu.run(&small).expect_err("should be refused");
    assert!(matches!(error, GpuError::Rejected { .. }), "{error:?}");
    works(&mut gpu);
}

#[test]
fn a_shader_that_never_ends_is_left_behind() {
    let Some(mut gpu) = open("lavapipe") else { return };
    let wgsl = "
        @group(0) @binding(0) var<storage, read> input: array<f32>;
        @group(0) @binding(1) var<storage, read_write> output: array<f32>;
        @compute @workgroup_size(64) fn main() { while input[0] > 0.0 { output[0] += 1.0; } }";
    let words = spirv(wgsl);
    gpu.set_timeout(Duration::from_millis(500));
    let start = Instant::now();
    let error = run(&mut gpu, Shader::Spirv(&words), &[1.0]).expect_err("should be given up");
    assert!(matches!(error, GpuError::Timeout { .. }), "{error:?}");
    assert!(error.to_string().contains("no result after 500ms"), "{error}");
    assert!(start.elapsed() < Duration::from_secs(4), "{:?}", start.elapsed());
    gpu.set_timeout(gpu::DEFAULT_TIMEOUT);
    works(&mut gpu);
}

#[test]
fn a_driver_that_went_away_is_named() {
    let Some(mut driver) = driver("lavapipe") else { return };
    driver.adapter_name = "another card".to_owned();
    let error = Gpu::open(&driver).expect_err("should be refused");
    assert!(error.to_string().contains("`another card` is not there any more"), "{error}");
}
