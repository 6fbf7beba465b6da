//! Structures in a header for C11 and C++11.

use super::shape::{Element, Shape};
use super::{Field, Structure, remark};
use std::fmt::Write;

pub(super) fn write(structures: &[Structure], left_out: &[String]) -> String {
    let mut out = format!(
        "/* Written by Lobe {}. Do not edit. */\n#pragma once\n\n#include <assert.h>\n#include <stddef.h>\n\
         #include <stdint.h>\n",
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
    let _ = writeln!(out, "typedef struct {name} {{");
    for field in &structure.fields {
        out.push_str(&comment(&field.docs, "    "));
        let _ = writeln!(out, "    {};", declaration(&field.shape, &field.name));
    }
    let _ = writeln!(out, "}} {name};\n");
    let wrong = "differs from the layout of shaders";
    let _ = writeln!(out, "static_assert(sizeof({name}) == {}, \"{name} {wrong}\");", structure.size);
    for Field { name: field, offset, .. } in &structure.fields {
        let _ = writeln!(
            out,
            "static_assert(offsetof({name}, {field}) == {offset}, \"{name}.{field} {wrong}\");"
        );
    }
    out
}

fn declaration(shape: &Shape, name: &str) -> String {
    let element = match &shape.element {
        Element::Float => "float",
        Element::Signed => "int32_t",
        Element::Unsigned => "uint32_t",
        Element::Structure(name) => name,
    };
    let dims: String = shape.dims.iter().map(|count| format!("[{count}]")).collect();
    format!("{element} {name}{dims}")
}

fn comment(lines: &[String], indent: &str) -> String {
    // A backslash at the end would drag the next line into the comment.
    let line = |text: &String| format!("{indent}/// {text}").trim_end_matches(['\\', ' ']).to_owned() + "\n";
    lines.iter().map(line).collect()
}
