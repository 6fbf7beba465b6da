//! Puts the word `measured` into the attribute of a kernel whose file was written for the first time.

use lobe_codegen::def::FunctionDef;
use std::path::PathBuf;

/// A source file with the word put in: where it lies, and its new text.
pub type Edit = (PathBuf, String);

/// The source of `kernel` with `measured` in its attribute; `None` if the file is not the one that this was
/// built from, or the attribute is written in an unusual way.
#[must_use]
pub fn with_measured(kernel: &FunctionDef) -> Option<Edit> {
    let path = super::root().join(kernel.source.file);
    let text = std::fs::read_to_string(&path).ok()?;
    let item = kernel.source.text;
    if item.is_empty() || text.matches(item).count() != 1 {
        return None;
    }
    let changed = insert(item, kernel.name)?;
    Some((path, text.replacen(item, &changed, 1)))
}

/// The item with `measured` as the attribute's last argument.
fn insert(item: &str, name: &str) -> Option<String> {
    let function = item.find(&format!("fn {name}("))?;
    let start = item[..function].rfind("#[kernel")?;
    let attribute = &item[start..function];
    let end = start + attribute.find(")]\n").or_else(|| attribute.find("]\n"))?;
    let (before, after) = item.split_at(end);
    if before.ends_with("#[kernel") {
        return Some(format!("{before}(measured){after}"));
    }
    let stated = before.trim_end();
    let comma = if stated.ends_with(['(', ',']) { "" } else { "," };
    let is_on_lines = before.ends_with('\n');
    let blank = if is_on_lines {
        "\n    "
    } else if stated.ends_with('(') {
        ""
    } else {
        " "
    };
    let line_end = if is_on_lines { "\n" } else { "" };
    Some(format!("{stated}{comma}{blank}measured{line_end}{after}"))
}

#[cfg(test)]
mod tests {
    use super::insert;

    #[test]
    fn the_word_becomes_the_last_argument() {
        for (attribute, wanted) in [
            ("#[kernel]", "#[kernel(measured)]"),
            ("#[kernel(family = \"a\")]", "#[kernel(family = \"a\", measured)]"),
            ("#[kernel(\n    budget(1)\n)]", "#[kernel(\n    budget(1),\n    measured\n)]"),
            ("#[kernel(\n    budget(1),\n)]", "#[kernel(\n    budget(1),\n    measured\n)]"),
        ] {
            let item = format!("/// Doc.\n{attribute}\npub fn f(x: f32) -> f32 {{\n    x\n}}");
            let changed = format!("/// Doc.\n{wanted}\npub fn f(x: f32) -> f32 {{\n    x\n}}");
            assert_eq!(insert(&item, "f"), Some(changed));
        }
        assert_eq!(insert("fn f(x: f32) {}", "f"), None);
    }
}
