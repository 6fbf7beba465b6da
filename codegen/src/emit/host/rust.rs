//! Structures in Rust.

use super::shape::{Element, Shape};
use super::{Field, Structure, remark};
use std::fmt::Write;

pub(super) fn write(structures: &[Structure], left_out: &[String]) -> String {
    let mut out = format!(
        "// Written by Lobe {}. Do not edit.\n// Needs the crate `bytemuck` with its feature `derive`.\n",
        env!("CARGO_PKG_VERSION")
    );
    for structure in structures {
        out.push('\n');
        out.push_str(&one(structure));
    }
    out + &remark(left_out, "//")
}

fn one(structure: &Structure) -> String {
    let name = &structure.name;
    let mut out = comment(&structure.docs, "");
    out.push_str("#[repr(C)]\n#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]\n");
    let _ = writeln!(out, "pub struct {name} {{");
    for field in &structure.fields {
        out.push_str(&comment(&field.docs, "    "));
        let visibility = if field.is_padding { "#[doc(hidden)]\n    pub" } else { "pub" };
        let _ = writeln!(out, "    {visibility} {}: {},", field.name, type_name(&field.shape));
    }
    let _ = writeln!(out, "}}\n\nconst _: () = {{");
    let _ = writeln!(out, "    assert!(core::mem::size_of::<{name}>() == {});", structure.size);
    for Field { name: field, offset, .. } in &structure.fields {
        let _ = writeln!(out, "    assert!(core::mem::offset_of!({name}, {field}) == {offset});");
    }
    out + "};\n"
}

fn type_name(shape: &Shape) -> String {
    let element = match &shape.element {
        Element::Float => "f32".to_owned(),
        Element::Signed => "i32".to_owned(),
        Element::Unsigned => "u32".to_owned(),
        Element::Structure(name) => name.clone(),
    };
    shape.dims.iter().rev().fold(element, |inner, count| format!("[{inner}; {count}]"))
}

fn comment(lines: &[String], indent: &str) -> String {
    lines.iter().map(|line| format!("{indent}/// {line}").trim_end().to_owned() + "\n").collect()
}
