//! WGSL: the shader, and lines that say to `lobe run` what its buffers hold.

use super::{Case, ExportError, commented};
use lobe_codegen::emit::Target;

/// The case as WGSL.
pub(super) fn write(case: &Case<'_>) -> Result<String, ExportError> {
    let layout = case.layout()?;
    let mut options = vec![format!("--entry {} --workgroups {}", layout.entry_name, case.workgroups()?)];
    options.extend(case.accuracy().unusual_name().map(|model| format!("--model {model}")));
    for buffer in case.buffers()? {
        let words: Vec<String> = buffer.words.iter().map(|word| format!("{word:#x}")).collect();
        options.push(format!("--input {}=words:{}", buffer.name, words.join(",")));
    }
    options.push(format!("--input results=zeros --size results={}", case.result_bytes()?));
    let mut notes = case.notes()?;
    notes.push(
        "`lobe run` on this file compares the interpreter with every driver at these arguments:".to_owned(),
    );
    let shader = case.shader(Target::Wgsl)?;
    Ok(commented("//", &notes) + &commented("// lobe:", &options) + "\n" + shader.text().unwrap_or_default())
}
