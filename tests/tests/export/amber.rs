//! A reader of the part of AmberScript that is written.

use super::common::skip;
use super::driver;
use lobe_backends::gpu::Gpu;
use std::collections::BTreeMap;
use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Stdio};

/// A script.
#[derive(Default)]
pub(crate) struct Script {
    assembly: String,
    /// By name: whether of floats, and the words.
    buffers: BTreeMap<String, (bool, Vec<u32>)>,
    pipelines: BTreeMap<String, Pipeline>,
    runs: Vec<(String, u32)>,
    expectations: Vec<Expectation>,
}

#[derive(Default)]
struct Pipeline {
    entry: String,
    /// Name, whether a uniform, binding.
    buffers: Vec<(String, bool, u32)>,
}

struct Expectation {
    buffer: String,
    offset: usize,
    tolerance: Option<f64>,
    value: String,
}

/// What was left in the buffers of results.
pub(crate) type Results = BTreeMap<String, Vec<u32>>;

pub(crate) fn assembler() -> Option<PathBuf> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let found =
        std::env::split_paths(&path).map(|folder| folder.join("spirv-as")).find(|file| file.is_file());
    if found.is_none() {
        skip("spirv-as", "run tests/setup.sh, or install your system's spirv-tools package");
    }
    found
}

/// Reads a script.
#[track_caller]
pub(crate) fn read(text: &str) -> Script {
    let mut script = Script::default();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("#!amber"));
    while let Some(line) = lines.next() {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words[..] {
            [] => {}
            [first, ..] if first.starts_with('#') => {}
            ["SHADER", "compute", "shader", "SPIRV-ASM", "TARGET_ENV", "vulkan1.1"] => {
                script.assembly = block(&mut lines).join("\n");
            }
            ["BUFFER", name, "DATA_TYPE", "uint32", "DATA"] => {
                let data = block(&mut lines).join(" ");
                let word = |text: &str| u32::from_str_radix(&text[2..], 16).expect("a hexadecimal word");
                let data = data.split_whitespace().map(word).collect();
                script.buffers.insert(name.to_owned(), (false, data));
            }
            ["BUFFER", name, "DATA_TYPE", kind, "SIZE", size, "FILL", zero] => {
                let is_float = kind == "float";
                assert_eq!(zero, if is_float { "0.0" } else { "0" });
                script.buffers.insert(name.to_owned(), (is_float, vec![0; size.parse().expect("a size")]));
            }
            ["PIPELINE", "compute", name] => {
                script.pipelines.insert(name.to_owned(), pipeline(&block(&mut lines)));
            }
            ["RUN", pipeline, x, "1", "1"] => {
                script.runs.push((pipeline.to_owned(), x.parse().expect("a count")));
            }
            ["EXPECT", buffer, "IDX", offset, ref rest @ ..] => {
                let (tolerance, value) = match rest {
                    ["TOLERANCE", tolerance, "EQ", value] => (Some(*tolerance), *value),
                    ["EQ", value] => (None, *value),
                    other => panic!("no expectation: {other:?}"),
                };
                script.expectations.push(Expectation {
                    buffer: buffer.to_owned(),
                    offset: offset.parse().expect("an offset"),
                    tolerance: tolerance.map(number),
                    value: value.to_owned(),
                });
            }
            _ => panic!("no command: {line}"),
        }
    }
    script
}

/// A float; Amber takes one without a point for an integer.
fn number(text: &str) -> f64 {
    assert!(text.contains('.'), "{text}");
    text.parse().expect("a number")
}

fn block<'a>(lines: &mut std::str::Lines<'a>) -> Vec<&'a str> {
    lines.take_while(|line| !line.contains("END")).collect()
}

fn pipeline(lines: &[&str]) -> Pipeline {
    let mut made = Pipeline::default();
    for line in lines {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words[..] {
            ["ATTACH", "shader", "ENTRY_POINT", entry] => made.entry = entry.to_owned(),
            ["BIND", "BUFFER", name, "AS", kind, "DESCRIPTOR_SET", "0", "BINDING", binding] => {
                made.buffers.push((name.to_owned(), kind == "uniform", binding.parse().expect("a binding")));
            }
            _ => panic!("no part of a pipeline: {line}"),
        }
    }
    made
}

impl Script {
    /// The words of the shader.
    pub(crate) fn assemble(&self, assembler: &PathBuf) -> Vec<u32> {
        let mut child = Command::new(assembler)
            .args(["--target-env", "vulkan1.1", "--preserve-numeric-ids", "-o", "-", "-"])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the assembler runs");
        child.stdin.take().expect("a pipe").write_all(self.assembly.as_bytes()).expect("it reads");
        let output = child.wait_with_output().expect("it ends");
        assert!(output.status.success(), "the assembler refuses:\n{}", self.assembly);
        output.stdout.as_chunks::<4>().0.iter().map(|word| u32::from_le_bytes(*word)).collect()
    }

    /// Runs all pipelines.
    pub(crate) fn run(&self, assembler: &PathBuf, driver: &mut Gpu) -> Results {
        let words = self.assemble(assembler);
        let run = |(name, groups): &(String, u32)| {
            let Pipeline { entry, buffers } = &self.pipelines[name];
            let (results, inputs): (Vec<_>, Vec<_>) =
                buffers.iter().partition(|(name, ..)| name.starts_with("results_"));
            let inputs: Vec<driver::Bound> = inputs
                .iter()
                .map(|(name, is_uniform, at)| (*at, *is_uniform, self.buffers[name].1.clone()))
                .collect();
            let [(name, _, at)] = results[..] else { panic!("one buffer of results") };
            let size = self.buffers[name].1.len();
            (name.clone(), driver::run(driver, (&words, entry), *groups, &inputs, (*at, size)))
        };
        self.runs.iter().map(run).collect()
    }

    pub(crate) fn expectations(&self) -> usize {
        self.expectations.len()
    }

    /// Expectations that are not met, by Amber's comparisons.
    pub(crate) fn failures(&self, results: &Results) -> Vec<String> {
        let is_met = |e: &Expectation| {
            let word = results[&e.buffer][e.offset / 4];
            match (self.buffers[&e.buffer].0, e.tolerance) {
                // What is expected is taken as an f32, the difference as an f64.
                (true, Some(tolerance)) => {
                    let wanted = f64::from(number(&e.value) as f32);
                    (f64::from(f32::from_bits(word)) - wanted).abs() <= tolerance
                }
                (false, None) => word == e.value.parse::<u32>().expect("a word"),
                _ => panic!("no comparison that is written"),
            }
        };
        let failed = self.expectations.iter().filter(|e| !is_met(e));
        failed.map(|e| format!("{} at {}: {}", e.buffer, e.offset, e.value)).collect()
    }

    /// Results that are wrong everywhere, by little.
    pub(crate) fn spoilt(&self, results: &Results) -> Results {
        let mut spoilt = results.clone();
        for Expectation { buffer, offset, tolerance, value } in &self.expectations {
            let word = &mut spoilt.get_mut(buffer).expect("results")[*offset / 4];
            *word = match tolerance {
                None => *word ^ 1,
                Some(tolerance) => {
                    let value = number(value);
                    ((value + 1.01 * tolerance) as f32).max((value as f32).next_up()).next_up().to_bits()
                }
            };
        }
        spoilt
    }
}
