//! How many instructions compilers made of a shader.

/// Instructions of the functions of a SPIR-V module: what frames a function or a block, and debug lines, count as none.
#[must_use]
pub fn spirv(words: &[u32]) -> usize {
    const HEADER: usize = 5;
    const FUNCTION: u32 = 54;
    const PARAMETER: u32 = 55;
    const FUNCTION_END: u32 = 56;
    const FRAMES: [u32; 5] = [FUNCTION, PARAMETER, FUNCTION_END, 248, 8];
    const NO_LINE: u32 = 317;
    let (mut count, mut is_inside) = (0, false);
    let mut rest = words.get(HEADER..).unwrap_or_default();
    while let Some(&first) = rest.first() {
        let opcode = first & 0xffff;
        is_inside = (is_inside || opcode == FUNCTION) && opcode != FUNCTION_END;
        count += usize::from(is_inside && !FRAMES.contains(&opcode) && opcode != NO_LINE);
        // A length of 0 is none that SPIR-V has.
        rest = rest.get((first >> 16).max(1) as usize..).unwrap_or_default();
    }
    count
}

/// Instructions of the functions of a DXIL module in LLVM's text.
#[must_use]
pub fn dxil(text: &str) -> usize {
    let (mut count, mut is_inside) = (0, false);
    for line in text.lines() {
        match line {
            line if line.starts_with("define ") => is_inside = true,
            "}" => is_inside = false,
            line => count += usize::from(is_inside && is_instruction(line)),
        }
    }
    count
}

/// Blocks begin with a comment or a label, at the margin; a switch goes on in further lines.
fn is_instruction(line: &str) -> bool {
    line.strip_prefix("  ").is_some_and(|text| !text.starts_with([' ', ';', ']']) && !text.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn instructions_of_functions_count_in_spirv() {
        let word = |opcode: u32, length: u32| {
            let mut words = vec![length << 16 | opcode];
            words.resize(length as usize, 0);
            words
        };
        let module = [
            vec![0; 5],
            word(17, 2),  // OpCapability
            word(54, 5),  // OpFunction
            word(248, 2), // OpLabel
            word(129, 5), // OpFAdd
            word(62, 3),  // OpStore
            word(253, 1), // OpReturn
            word(56, 1),  // OpFunctionEnd
            word(129, 5),
        ];
        assert_eq!(spirv(&module.concat()), 3);
        assert_eq!(spirv(&[]), 0);
    }

    #[test]
    fn instructions_of_functions_count_in_dxil() {
        let text = "\
; a comment
declare float @dx.op.unary.f32(i32, float) #0
define void @main() {
  %1 = fadd fast float %0, 1.000000e+00  ; a comment
  switch i32 %2, label %3 [
    i32 0, label %4
  ]

; <label>:3                                       ; preds = %0
  ret void
}
  attributes";
        assert_eq!(dxil(text), 3);
    }
}
