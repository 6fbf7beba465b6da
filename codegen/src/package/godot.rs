//! An include file for Godot 4, whose shading language is a part of GLSL ES 3.0 with names of its own.

use super::example::{self, Example};
use super::{Contents, PackageFile, file};
use crate::emit::scan::{self, Piece, PieceKind};
use crate::emit::{EmitError, Target};

pub(super) fn files(contents: &Contents<'_>) -> Result<Vec<PackageFile>, EmitError> {
    let mut files = vec![file("lobe/lobe.gdshaderinc", in_godot(&contents.library(Target::Essl)?)?)];
    if let Some(example) = example::of(contents) {
        files.push(file("lobe/example.gdshader", shader(&example)));
    }
    files.push(contents.readme("Lobe's kernels for Godot", USAGE));
    Ok(files)
}

/// GLSL ES in Godot's words: it has square matrices alone, with a single name for each, and hands numbers on with 14
/// decimals, so that what is smaller, such as the least divisor of a kernel, would become 0.
fn in_godot(library: &str) -> Result<String, EmitError> {
    let pieces = scan::pieces(library);
    let mut text = String::with_capacity(library.len());
    let mut i = 0;
    while let Some(piece) = pieces.get(i) {
        let number = number(&pieces[i..]);
        i += number.as_ref().map_or(1, |(_, n_pieces)| *n_pieces);
        match (piece.kind, piece.text, number) {
            (_, _, Some((number, _))) => text += &number,
            (PieceKind::Word, "mat2x2", _) => text += "mat2",
            (PieceKind::Word, "mat3x3", _) => text += "mat3",
            (PieceKind::Word, "mat4x4", _) => text += "mat4",
            (PieceKind::Word, "mat2x3" | "mat2x4" | "mat3x2" | "mat3x4" | "mat4x2" | "mat4x3", _) => {
                return Err(EmitError::Matrix(piece.text.to_owned()));
            }
            (_, other, _) => text += other,
        }
    }
    Ok(text)
}

/// The float that `pieces` begin with, if 14 decimals do not tell it, by its bits; and how many pieces it takes.
fn number(pieces: &[Piece<'_>]) -> Option<(String, usize)> {
    let first = pieces.first().filter(|p| p.text.starts_with(|c: char| c.is_ascii_digit()))?.text;
    let has_exponent = first.ends_with('e') && !first.starts_with("0x");
    let n_pieces = if has_exponent { 3 } else { 1 };
    let number: String = pieces.iter().take(n_pieces).map(|p| p.text).collect();
    let value: f32 = number.parse().ok().filter(|_| has_exponent || number.contains('.'))?;
    let handed_on = format!("{value:.14}").parse();
    (handed_on != Ok(value)).then(|| (format!("uintBitsToFloat({}u)", value.to_bits()), n_pieces))
}

/// A material that shines as a kernel says.
fn shader(example: &Example) -> String {
    let function = &example.function;
    let arguments: Vec<String> = function.parameters.iter().map(|p| example.value(&p.ty)).collect();
    let returns = function.returns.as_deref().unwrap_or_default();
    format!(
        "shader_type spatial;\nrender_mode unshaded;\n\n#include \"res://lobe/lobe.gdshaderinc\"\n\nuniform float \
         brightness = 1.0;\n\nvoid fragment() {{\n    {} result = {}({});\n    EMISSION = vec3(brightness * \
         float(result{}));\n}}\n",
        Example::spelled(returns, Target::Essl),
        function.name,
        arguments.join(", "),
        example.first(returns)
    )
}

const USAGE: &str = "\
Copy `lobe/` into your project, then, in a shader:

```glsl
#include \"res://lobe/lobe.gdshaderinc\"
```

Names begin with `lobe_`, since the language has `PI`, `TAU` and `E` as constants.
Godot hands numbers on to drivers with 14 decimals; smaller ones are written by their bits, `uintBitsToFloat(228737632u)`
for `1e-30`.
Godot 4.6 compiles every kernel, in its build for pages, with the renderer Compatibility; the others were not at hand.
";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_their_bits() {
        for (text, wanted) in [
            ("max(x, 1e-30);", "max(x, uintBitsToFloat(228737632u));"),
            ("const float A = -1.6059044e-10;", "const float A = -uintBitsToFloat(791712305u);"),
            ("0.33333334 + 1e-5 * 1e30 - 1.0 / 0.1e1", "0.33333334 + 1e-5 * 1e30 - 1.0 / 0.1e1"),
            ("0x1eu - 1 + v.x1e - 5u", "0x1eu - 1 + v.x1e - 5u"),
        ] {
            assert_eq!(in_godot(text).expect("no matrix"), wanted);
        }
    }

    #[test]
    fn matrices_have_godot_s_names() {
        let text = "mat3x3 a(vec3 mat3x3_) { return mat3x3(b.mat2x2, c, d); } // mat4x4\n";
        let wanted = "mat3 a(vec3 mat3x3_) { return mat3(b.mat2x2, c, d); } // mat4x4\n";
        assert_eq!(in_godot(text).expect("square"), wanted);
        assert!(in_godot("mat3x2 a;").is_err_and(|e| e.to_string().contains("mat3x2")));
    }
}
