//! Emitted HLSL costs what HLSL by hand costs, and its buffers lie where the host puts them.

mod common;

use common::tool;
use lobe_backends::executor::Program;
use lobe_backends::translate::{Dxc, DxcOutput};
use lobe_codegen::emit::Target;
use lobe_kernels::registry::KERNELS;
use lobe_tests::overhead::{LISTINGS, ratio};
use std::collections::BTreeMap;

/// DXC makes no more instructions of what is emitted than the limits permit.
#[test]
fn emitted_functions_need_no_instruction_more_than_by_hand() {
    let Some(dxc) = tool(Dxc::find()) else { return };
    for listing in LISTINGS {
        let program = listing.program().unwrap_or_else(|e| panic!("{e}"));
        let [hand, parts @ ..] = listing.compile(&program, &dxc).unwrap_or_else(|e| panic!("{e}"));
        for part in parts {
            let (name, counts) = (part.part.name(), part.counts);
            let ratio = ratio(counts, hand.counts);
            let kernel = listing.kernel;
            assert!(
                ratio <= part.part.most_instructions(),
                "{kernel}, {name}: {counts:?}, {:?} by hand",
                hand.counts
            );
        }
    }
}

/// The bytes of an element of each structured buffer of a DXIL module, by binding: a resource names the node of its
/// properties last, and behind its own name its space and its binding.
fn strides(text: &str) -> BTreeMap<u32, u32> {
    let nodes: BTreeMap<&str, &str> = text.lines().filter_map(|line| line.split_once(" = !{")).collect();
    let number = |text: &str| text.strip_prefix("i32 ")?.trim_end_matches('}').parse().ok();
    let stride = |resource: &&str| {
        let parts: Vec<&str> = resource.split(", ").collect();
        let name = parts.iter().position(|part| part.starts_with("!\""))?;
        let properties = nodes.get(parts.last()?.trim_end_matches('}'))?;
        Some((number(parts.get(name + 2)?)?, number(properties.strip_prefix("i32 1, ")?)?))
    };
    nodes.values().filter(|node| node.contains("StructuredBuffer<")).filter_map(stride).collect()
}

/// Elements are as large in DXIL as the layout says, for every kernel.
#[test]
fn elements_of_structured_buffers_are_as_large_as_the_layout_says() {
    let Some(dxc) = tool(Dxc::find()) else { return };
    let mut structured = 0;
    for kernel in KERNELS {
        let program = Program::new(*kernel).unwrap_or_else(|e| panic!("{e}"));
        let Ok((_, layout)) = program.entry() else { continue };
        let hlsl = program.artifact(Target::Hlsl).unwrap_or_else(|e| panic!("{e}"));
        let source = hlsl.content.text().expect("text");
        let dxil = dxc.compile(source, "cs_6_0", Some(&layout.entry_name), DxcOutput::Dxil);
        let text = dxc.disassemble(&dxil.unwrap_or_else(|e| panic!("{e}"))).unwrap_or_else(|e| panic!("{e}"));
        let found = strides(&text);
        for buffer in layout.arguments.iter().chain([&layout.result]) {
            let is_structured = ["t", "u"].iter().any(|register| {
                let place = format!(" : register({register}{});", buffer.binding);
                source.lines().any(|line| line.contains("StructuredBuffer<") && line.ends_with(&place))
            });
            if is_structured {
                structured += 1;
                let stride = found.get(&buffer.binding);
                assert_eq!(stride, Some(&buffer.stride), "{}: {buffer:?}", program.name());
            }
        }
    }
    assert!(structured > 2 * KERNELS.len(), "only {structured} buffers are structured");
}
