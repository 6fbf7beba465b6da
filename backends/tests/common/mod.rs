//! What the tests of drivers and tools share: skipping aloud, one kernel in every form, and small helpers.
#![allow(dead_code, reason = "each test file uses a part of it")]

use std::io::Write;
use std::sync::OnceLock;

use lobe_backends::gpu::{self, Binding, BindingKind, Driver, Job, Shader};
use lobe_backends::translate::TranslateError;

/// `out[i] = in[i] * 2 + 1`.
pub(crate) const WGSL: &str = "
@group(0) @binding(0) var<storage, read> input: array<f32>;
@group(0) @binding(1) var<storage, read_write> output: array<f32>;

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    if id.x < arrayLength(&input) {
        output[id.x] = input[id.x] * 2.0 + 1.0;
    }
}
";

/// A kernel on which compilers could differ: transcendental functions, a loop, a branch.
pub(crate) const DEMANDING_WGSL: &str = "
@group(0) @binding(0) var<storage, read> input: array<f32, 4096>;
@group(0) @binding(1) var<storage, read_write> output: array<f32, 4096>;

fn series(x: f32) -> f32 {
    var sum = 0.0;
    var term = 1.0;
    for (var k = 1u; k < 12u; k += 1u) {
        sum += term;
        term *= x / f32(k);
    }
    return sum;
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u) {
    let x = input[id.x];
    var y = sin(x) * exp(-x) + sqrt(abs(x)) / (1.0 + log2(1.0 + abs(x)));
    // A comparison of which DXC would warn, for naga puts it in two pairs of parentheses.
    if x == 0.25 {
        y += 1.0;
    }
    if x > 0.5 {
        y = y * series(x) - atan2(x, 0.25);
    }
    output[id.x] = y;
}
";

/// Says that a test does not run and how to change that; fails instead where `LOBE_REQUIRE_TOOLS=1`.
#[track_caller]
pub(crate) fn skip(what: &str, mend: &str) {
    let required = std::env::var_os("LOBE_REQUIRE_TOOLS").is_some_and(|value| value == "1");
    assert!(!required, "{what} is required (LOBE_REQUIRE_TOOLS=1) but missing: {mend}");
    // Not eprintln!, which the test runner swallows when the test passes.
    let _ = writeln!(std::io::stderr(), "SKIPPED: {what} ({mend})");
}

/// The driver called `name`, or a skip.
#[track_caller]
pub(crate) fn driver(name: &str) -> Option<Driver> {
    static DRIVERS: OnceLock<Vec<Driver>> = OnceLock::new();
    let found = DRIVERS.get_or_init(gpu::drivers).iter().find(|driver| driver.name == name);
    if found.is_none() {
        skip(&format!("driver {name}"), "run tests/setup.sh");
    }
    found.cloned()
}

/// A tool, or a skip with the tool's own words.
#[track_caller]
pub(crate) fn tool<T>(found: Result<T, TranslateError>) -> Option<T> {
    match found {
        Ok(tool) => Some(tool),
        Err(TranslateError::NotFound { tool, mend, .. }) => {
            skip(tool, mend);
            None
        }
        Err(error) => panic!("{error}"),
    }
}

/// As bytes.
pub(crate) fn bytes(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

/// And back.
pub(crate) fn floats(bytes: &[u8]) -> Vec<f32> {
    bytes.as_chunks::<4>().0.iter().map(|&chunk| f32::from_le_bytes(chunk)).collect()
}

/// 4096 values from -8 to 8.
pub(crate) fn ramp() -> Vec<f32> {
    (0..4096u16).map(|i| f32::from(i) / 256.0 - 8.0).collect()
}

/// Bindings for the kernels above: `input`, and an `output` of the same size, filled with a value that none writes.
pub(crate) fn bindings<'a>(input: &'a [u8], output: &'a [u8]) -> [Binding<'a>; 2] {
    [
        Binding { group: 0, binding: 0, element: None, kind: BindingKind::StorageRead, data: input },
        Binding { group: 0, binding: 1, element: None, kind: BindingKind::StorageReadWrite, data: output },
    ]
}

/// A job for the kernels above.
pub(crate) fn job<'a>(shader: Shader<'a>, bindings: &'a [Binding<'a>]) -> Job<'a> {
    let items = bindings.first().map_or(0, |binding| binding.data.len() / 4);
    let groups = u32::try_from(items.div_ceil(64)).expect("small");
    Job {
        shader,
        entry: "main",
        workgroup_size: [64, 1, 1],
        groups: [groups, 1, 1],
        bindings,
        immediates: &[],
    }
}

/// `wgsl` as naga reads and validates it.
pub(crate) fn module(wgsl: &str) -> (naga::Module, naga::valid::ModuleInfo) {
    let module = naga::front::wgsl::parse_str(wgsl).expect("test kernels parse");
    let flags = naga::valid::ValidationFlags::all();
    let mut validator = naga::valid::Validator::new(flags, naga::valid::Capabilities::all());
    let info = validator.validate(&module).expect("test kernels are valid");
    (module, info)
}

/// `wgsl` as naga's SPIR-V.
pub(crate) fn spirv(wgsl: &str) -> Vec<u32> {
    let (module, info) = module(wgsl);
    let options = naga::back::spv::Options {
        lang_version: (1, 3),
        flags: naga::back::spv::WriterFlags::empty(),
        ..Default::default()
    };
    naga::back::spv::write_vec(&module, &info, &options, None).expect("test kernels can be written")
}

/// `wgsl` as naga's HLSL.
pub(crate) fn hlsl(wgsl: &str) -> String {
    let (module, info) = module(wgsl);
    let options = naga::back::hlsl::Options {
        shader_model: naga::back::hlsl::ShaderModel::V6_0,
        restrict_indexing: false,
        force_loop_bounding: false,
        ..Default::default()
    };
    let pipeline = naga::back::hlsl::PipelineOptions::default();
    let mut text = String::new();
    naga::back::hlsl::Writer::new(&mut text, &options, &pipeline)
        .write(&module, &info, None)
        .expect("test kernels can be written");
    text
}
