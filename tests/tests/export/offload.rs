//! A reader of the part of LLVM's offload tests that is written.

use super::common::skip;
use super::driver;
use lobe_backends::gpu::Gpu;
use lobe_backends::translate::{Dxc, DxcOutput, spirv_words};
use serde::Deserialize;
use serde_yaml_ng::Value;

/// A test.
pub(crate) struct Test {
    source: String,
    pipeline: Pipeline,
}

#[derive(Deserialize)]
#[serde(rename_all = "PascalCase", deny_unknown_fields)]
struct Pipeline {
    shaders: Vec<Stage>,
    dispatch_parameters: Dispatch,
    buffers: Vec<Buffer>,
    results: Vec<Rule>,
    descriptor_sets: Vec<Set>,
}

#[derive(Deserialize)]
#[serde(rename_all = "PascalCase", deny_unknown_fields)]
struct Stage {
    stage: String,
    entry: String,
}

#[derive(Deserialize)]
#[serde(rename_all = "PascalCase", deny_unknown_fields)]
struct Dispatch {
    dispatch_group_count: [u32; 3],
}

#[derive(Deserialize)]
#[serde(rename_all = "PascalCase", deny_unknown_fields)]
struct Buffer {
    name: String,
    format: String,
    data: Option<Vec<Value>>,
    fill_size: Option<usize>,
    stride: Option<u32>,
}

#[derive(Deserialize)]
#[serde(rename_all = "PascalCase", deny_unknown_fields)]
struct Rule {
    #[serde(rename = "Result")]
    _result: String,
    rule: String,
    epsilon: Option<f64>,
    denorm_mode: Option<String>,
    actual: String,
    expected: String,
}

#[derive(Deserialize)]
#[serde(rename_all = "PascalCase", deny_unknown_fields)]
struct Set {
    resources: Vec<Resource>,
}

#[derive(Deserialize)]
#[serde(rename_all = "PascalCase", deny_unknown_fields)]
struct Resource {
    name: String,
    kind: String,
    #[serde(rename = "DirectXBinding")]
    directx: Register,
    vulkan_binding: Binding,
}

#[derive(Deserialize)]
#[serde(rename_all = "PascalCase", deny_unknown_fields)]
struct Register {
    register: u32,
    space: u32,
}

#[derive(Deserialize)]
#[serde(rename_all = "PascalCase", deny_unknown_fields)]
struct Binding {
    binding: u32,
}

pub(crate) fn compiler() -> Option<Dxc> {
    match Dxc::find() {
        Ok(dxc) => Some(dxc),
        Err(error) => {
            skip("DXC", &error.to_string());
            None
        }
    }
}

/// Reads a test.
#[track_caller]
pub(crate) fn read(text: &str) -> Test {
    let (source, rest) = text.split_once("#--- pipeline.yaml\n").expect("a pipeline");
    let (pipeline, rest) = rest.split_once("#--- end\n").expect("an end");
    let source = source.strip_prefix("#--- source.hlsl\n").expect("a source").to_owned();
    let pipeline: Pipeline = serde_yaml_ng::from_str(pipeline.trim_end_matches("...\n")).expect("YAML");
    let entry = &pipeline.shaders[0].entry;
    assert!(rest.contains(&format!("-T cs_6_0 -E {entry} ")), "{rest}");
    assert_eq!(pipeline.shaders[0].stage, "Compute");
    Test { source, pipeline }
}

impl Test {
    fn buffer(&self, name: &str) -> &Buffer {
        self.pipeline.buffers.iter().find(|buffer| buffer.name == name).expect("a buffer")
    }

    /// Runs the shader.
    pub(crate) fn run(&self, dxc: &Dxc, driver: &mut Gpu) -> Vec<u32> {
        let entry = &self.pipeline.shaders[0].entry;
        let compile = |output| dxc.compile(&self.source, "cs_6_0", Some(entry), output);
        compile(DxcOutput::Dxil).unwrap_or_else(|e| panic!("{e}"));
        let words = spirv_words(&compile(DxcOutput::Spirv).unwrap_or_else(|e| panic!("{e}"))).expect("words");
        let (mut inputs, mut results) = (Vec::new(), None);
        for Resource { name, kind, directx, vulkan_binding } in &self.pipeline.descriptor_sets[0].resources {
            assert_eq!((directx.space, directx.register), (0, vulkan_binding.binding));
            let buffer = self.buffer(name);
            assert_eq!(buffer.stride.is_some(), kind.ends_with("StructuredBuffer"), "{name}");
            match kind.as_str() {
                "RWByteAddressBuffer" | "RWStructuredBuffer" => {
                    results = Some((vulkan_binding.binding, buffer.fill_size.expect("a size") / 4));
                }
                _ => inputs.push((vulkan_binding.binding, kind == "ConstantBuffer", buffer.words())),
            }
        }
        let groups = self.pipeline.dispatch_parameters.dispatch_group_count[0];
        driver::run(driver, (&words, entry), groups, &inputs, results.expect("results"))
    }

    /// Words that the rule does not let pass, by the comparisons of the suite.
    pub(crate) fn failures(&self, results: &[u32]) -> usize {
        let [rule] = &self.pipeline.results[..] else { panic!("one rule") };
        assert_eq!(rule.actual, "results");
        let expected = self.buffer(&rule.expected).words();
        assert_eq!(expected.len(), results.len());
        let passes = |found: u32, wanted: u32| match (rule.rule.as_str(), rule.epsilon) {
            ("BufferExact", None) => found == wanted,
            ("BufferFloatEpsilon", Some(epsilon)) => {
                assert_eq!(rule.denorm_mode.as_deref(), Some("Any"));
                let (found, wanted) = (f32::from_bits(found), f32::from_bits(wanted));
                found == wanted
                    || (wanted.is_subnormal() && found == 0.0)
                    || (found - wanted).abs() < epsilon as f32
            }
            _ => panic!("no rule that is written"),
        };
        results.iter().zip(expected).filter(|(found, wanted)| !passes(**found, *wanted)).count()
    }

    /// Results of which the first is wrong, by little.
    pub(crate) fn spoilt(&self, results: &[u32]) -> Vec<u32> {
        let rule = &self.pipeline.results[0];
        let wanted = self.buffer(&rule.expected).words()[0];
        let mut spoilt = results.to_vec();
        spoilt[0] = match rule.epsilon {
            None => wanted ^ 1,
            Some(epsilon) => {
                let wanted = f32::from_bits(wanted);
                (wanted + 1.01 * epsilon as f32).max(wanted.next_up()).next_up().to_bits()
            }
        };
        spoilt
    }
}

impl Buffer {
    fn words(&self) -> Vec<u32> {
        let number = |value: &Value| value.as_f64().unwrap_or_else(|| panic!("no number: {value:?}"));
        let word = |value| match self.format.as_str() {
            "Hex32" => number(value) as u32,
            "Float32" => (number(value) as f32).to_bits(),
            other => panic!("no format that is written: {other}"),
        };
        self.data.iter().flatten().map(word).collect()
    }
}
