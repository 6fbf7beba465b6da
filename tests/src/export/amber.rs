//! AmberScript: the shader as SPIR-V assembly, buffers as words, an expectation for each scalar.
//!
//! A buffer of Amber has one type, and expectations are read as that type: a result of floats and integers is run
//! twice, into a buffer of each.

use super::{Buffer, Case, Expected, ExportError, Wanted, commented, tolerance};
use lobe_codegen::emit::{Content, Target};
use rspirv::binary::Disassemble;
use std::fmt::Write;

/// What a buffer of results is read as.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Reading {
    Floats,
    Words,
}

/// The case as AmberScript.
pub(super) fn write(case: &Case<'_>) -> Result<String, ExportError> {
    let (layout, buffers, expected) = (case.layout()?, case.buffers()?, case.expected()?);
    let reads = |reading| expected.iter().any(|e| reading_of(e) == Some(reading));
    let readings: Vec<Reading> =
        [Reading::Floats, Reading::Words].into_iter().filter(|r| reads(*r)).collect();
    if readings.is_empty() {
        return Err(ExportError::NothingKnown { kernel: case.subject().def().name });
    }
    let mut notes = case.notes()?;
    notes.push("The shader is SPIR-V 1.3: run it with amber -t spv1.3 -v 1.1.".to_owned());
    let mut out = format!("#!amber\n{}\n", commented("#", &notes));
    let _ = writeln!(out, "SHADER compute shader SPIRV-ASM TARGET_ENV vulkan1.1\n{}END\n", assembly(case)?);
    buffers.iter().for_each(|buffer| out += &data(buffer));
    for reading in readings {
        let (kind, zero) = match reading {
            Reading::Floats => ("float", "0.0"),
            Reading::Words => ("uint32", "0"),
        };
        let results = format!("results_{kind}");
        let _ =
            writeln!(out, "BUFFER {results} DATA_TYPE {kind} SIZE {} FILL {zero}", case.result_bytes()? / 4);
        let _ =
            writeln!(out, "PIPELINE compute into_{kind}\n  ATTACH shader ENTRY_POINT {}", layout.entry_name);
        buffers.iter().for_each(|buffer| out += &bind(&buffer.name, buffer.is_uniform, buffer.binding));
        out += &bind(&results, false, layout.result.binding);
        let _ = writeln!(out, "END\nRUN into_{kind} {} 1 1", case.workgroups()?);
        let of_reading = expected.iter().filter(|e| reading_of(e) == Some(reading));
        of_reading.for_each(|e| out += &expect(&results, e));
        out.push('\n');
    }
    Ok(out.trim_end().to_owned() + "\n")
}

fn reading_of(expected: &Expected) -> Option<Reading> {
    match expected.wanted {
        Wanted::Float { .. } => Some(Reading::Floats),
        Wanted::Word(_) => Some(Reading::Words),
        Wanted::Unknown => None,
    }
}

/// The words that checks run, as `spirv-as` reads them.
fn assembly(case: &Case<'_>) -> Result<String, ExportError> {
    let kernel = case.subject().def().name;
    let words = match case.shader(Target::Spirv)? {
        Content::Words(words) => words,
        Content::Text(text) => return Ok(text),
    };
    let module = rspirv::dr::load_words(&words)
        .map_err(|error| ExportError::Disassembly { kernel, reason: error.to_string() })?;
    // Amber takes the text up to the first `END`; names are all that could hold one.
    let text = module.disassemble();
    let lines = text.lines().filter(|line| !line.contains("END"));
    Ok(lines.map(|line| format!("{line}\n")).collect())
}

fn data(buffer: &Buffer) -> String {
    let words: Vec<String> = buffer.words.iter().map(|word| format!("{word:#010x}")).collect();
    let lines: String = words.chunks(8).map(|line| format!("  {}\n", line.join(" "))).collect();
    format!("BUFFER {} DATA_TYPE uint32 DATA\n{lines}END\n", buffer.name)
}

fn bind(name: &str, is_uniform: bool, binding: u32) -> String {
    let kind = if is_uniform { "uniform" } else { "storage" };
    format!("  BIND BUFFER {name} AS {kind} DESCRIPTOR_SET 0 BINDING {binding}\n")
}

fn expect(results: &str, expected: &Expected) -> String {
    let at = expected.offset;
    match expected.wanted {
        Wanted::Float { exact, bound } => {
            let (tolerance, nearest) = (number(tolerance(exact, bound)), number(f64::from(exact as f32)));
            format!("EXPECT {results} IDX {at} TOLERANCE {tolerance} EQ {nearest}\n")
        }
        Wanted::Word(word) => format!("EXPECT {results} IDX {at} EQ {word}\n"),
        Wanted::Unknown => String::new(),
    }
}

/// A number with a point, without which Amber takes it for an integer.
fn number(value: f64) -> String {
    let text = format!("{value:?}");
    match text.split_once('e') {
        Some((digits, power)) if !digits.contains('.') => format!("{digits}.0e{power}"),
        _ => text,
    }
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_have_a_point_and_come_back() {
        for value in [0.0, -0.0, 1.0, 1e-45, -3e300, 0.1, 123_456_789.25, 5e-324] {
            let text = number(value);
            assert!(text.contains('.'), "{text}");
            assert_eq!(text.parse::<f64>().map(f64::to_bits), Ok(value.to_bits()), "{text}");
        }
    }
}
