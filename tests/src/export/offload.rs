//! LLVM's offload test suite: HLSL, a pipeline in YAML, and the lines that run them.
//!
//! The suite compares a whole buffer by one rule: floats within one epsilon, the largest that a scalar is permitted;
//! integers exactly.

use super::{Buffer, Case, Expected, ExportError, Wanted, commented, tolerance};
use lobe_codegen::emit::Target;
use std::fmt::Write;

/// The case as a test.
pub(super) fn write(case: &Case<'_>) -> Result<String, ExportError> {
    let layout = case.layout()?;
    let (entry, rule) = (&layout.entry_name, rule(case)?);
    let shader = case.shader(Target::Hlsl)?;
    let source = shader.text().unwrap_or_default();
    let mut out = format!("#--- source.hlsl\n{}\n{source}", commented("//", &case.notes()?));
    let _ = writeln!(out, "#--- pipeline.yaml\n---\nShaders:\n  - Stage: Compute\n    Entry: {entry}");
    let _ = writeln!(out, "DispatchParameters:\n  DispatchGroupCount: [{}, 1, 1]", case.workgroups()?);
    out += &buffers(case, &rule, source)?;
    out += &rule.text;
    out += "DescriptorSets:\n  - Resources:\n";
    for Buffer { name, binding, .. } in case.buffers()? {
        out += &resource(&name, kind(source, &name), binding);
    }
    out += &resource("results", kind(source, "results"), layout.result.binding);
    let _ = writeln!(out, "...\n#--- end\n\n# RUN: split-file %s %t");
    let _ = writeln!(out, "# RUN: %dxc_target -T cs_6_0 -E {entry} -Fo %t.o %t/source.hlsl");
    out += "# RUN: %offloader %t/pipeline.yaml %t.o\n";
    Ok(out)
}

/// How results are compared.
struct Rule {
    /// Of the buffers compared.
    format: &'static str,
    expected: Vec<Expected>,
    text: String,
}

fn rule(case: &Case<'_>) -> Result<Rule, ExportError> {
    let kernel = case.subject().def().name;
    let expected = case.expected()?;
    if let Some(unknown) = expected.iter().find(|e| e.wanted == Wanted::Unknown) {
        return Err(match expected.iter().all(|e| e.wanted == Wanted::Unknown) {
            true => ExportError::NothingKnown { kernel },
            false => ExportError::PartlyKnown { kernel, path: unknown.path.clone() },
        });
    }
    let floats: Vec<f64> = expected.iter().filter_map(epsilon).collect();
    let (format, rule) = match floats.len() {
        0 => ("Hex32", "BufferExact".to_owned()),
        n if n == expected.len() => {
            let largest = floats.into_iter().fold(0.0, f64::max);
            ("Float32", format!("BufferFloatEpsilon\n    Epsilon: {largest:?}\n    DenormMode: Any"))
        }
        _ => return Err(ExportError::Mixed { kernel }),
    };
    let text = format!(
        "Results:\n  - Result: within\n    Rule: {rule}\n    Actual: results\n    Expected: expected\n"
    );
    Ok(Rule { format, expected, text })
}

/// What a float may be off by. The suite takes the difference and the epsilon as f32, and asks for less than it.
fn epsilon(expected: &Expected) -> Option<f64> {
    let Wanted::Float { exact, bound } = expected.wanted else { return None };
    let tolerance = tolerance(exact, bound);
    // Equal floats are never compared by the epsilon.
    let epsilon = if tolerance == 0.0 { 0.0 } else { (tolerance as f32).next_up().next_up() };
    Some(epsilon.into())
}

/// What the shader declares `name` as.
fn kind<'s>(source: &'s str, name: &str) -> &'s str {
    let declared = format!(" {name} : register(");
    let before = source.lines().find_map(|line| line.split_once(&declared)).map_or("", |(before, _)| before);
    match before.split_once('<').map_or(before, |(kind, _)| kind) {
        "cbuffer" => "ConstantBuffer",
        kind => kind,
    }
}

/// The line that says how many bytes an element of a structured buffer has.
fn stride(source: &str, name: &str, stride: u32) -> String {
    match kind(source, name).ends_with("StructuredBuffer") {
        true => format!("Stride: {stride}\n    "),
        false => String::new(),
    }
}

fn buffers(case: &Case<'_>, rule: &Rule, source: &str) -> Result<String, ExportError> {
    let layout = case.layout()?;
    let mut out = "Buffers:\n".to_owned();
    for Buffer { name, binding, mut words, is_uniform } in case.buffers()? {
        if is_uniform {
            // Direct3D counts constants in vectors of four.
            words.resize(words.len().next_multiple_of(4), 0);
        }
        let argument = layout.arguments.iter().find(|argument| argument.binding == binding);
        let stride = argument.map(|argument| stride(source, &name, argument.stride)).unwrap_or_default();
        let data = data(words.iter().map(|word| format!("{word:#010x}")));
        out += &buffer(&name, "Hex32", &(stride + &data));
    }
    let size = case.result_bytes()?;
    let stride = stride(source, "results", layout.result.stride);
    out += &buffer("results", rule.format, &format!("{stride}FillSize: {size}"));
    let mut expected = vec!["0".to_owned(); size / 4];
    for Expected { offset, wanted, .. } in &rule.expected {
        expected[offset / 4] = match wanted {
            Wanted::Float { exact, .. } => format!("{:?}", *exact as f32),
            Wanted::Word(word) => format!("{word:#010x}"),
            Wanted::Unknown => continue,
        };
    }
    Ok(out + &buffer("expected", rule.format, &(stride + &data(expected.into_iter()))))
}

fn buffer(name: &str, format: &str, data: &str) -> String {
    format!("  - Name: {name}\n    Format: {format}\n    {data}\n")
}

fn data(values: impl Iterator<Item = String>) -> String {
    format!("Data: [ {} ]", values.collect::<Vec<_>>().join(", "))
}

fn resource(name: &str, kind: &str, binding: u32) -> String {
    format!(
        "    - Name: {name}\n      Kind: {kind}\n      DirectXBinding:\n        Register: {binding}\n        Space: 0\n      \
         VulkanBinding:\n        Binding: {binding}\n"
    )
}
