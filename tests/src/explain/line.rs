//! The lines of emitted artifacts that an expression becomes.
//!
//! No writer says which. So the kernel is emitted with and without a change of that one expression, and the lines
//! that differ are its.

use super::value::Place;
use crate::mutation::fault::Edit;
use crate::mutation::operator::mistakes;
use lobe_backends::executor::Program;
use lobe_codegen::ValidModule;
use lobe_codegen::emit::{Content, Options, Target, emit, with_entry};
use lobe_codegen::validate::validate;
use rspirv::binary::Disassemble;

/// Invocations in a workgroup of the entry point, as routes have it.
const WORKGROUP: u32 = 64;

/// The targets that drivers are given.
const TARGETS: [Target; 4] = [Target::Wgsl, Target::Spirv, Target::Hlsl, Target::Glsl];

/// A line of an artifact.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
pub struct Line {
    /// The target.
    pub target: Target,
    /// Its number, from 1; of SPIR-V in its disassembly.
    pub line: usize,
    /// Its text.
    pub text: String,
}

/// The line of the expression in each target, as far as a change of it is known that shows there.
#[must_use]
pub fn lines(program: &Program, (function, at): Place) -> Vec<Line> {
    let module = program.module().module();
    let own = &module.functions[function];
    let changes = mistakes(module, own, &own.expressions[at]);
    let changed: Vec<ValidModule> = changes
        .into_iter()
        .filter_map(|(_, to)| {
            let edit = Edit::Expression { function, at, to };
            let meta = program.module().meta().clone();
            lobe_codegen::quietly(|| validate(edit.apply(module)?, meta).ok()).ok().flatten()
        })
        .collect();
    TARGETS.into_iter().filter_map(|target| line(program, &changed, target)).collect()
}

fn line(program: &Program, changed: &[ValidModule], target: Target) -> Option<Line> {
    let plain = text(program, program.module(), target)?;
    let plain: Vec<&str> = plain.lines().collect();
    let differing = changed.iter().filter_map(|module| {
        let other = text(program, module, target)?;
        difference(&plain, &other.lines().collect::<Vec<_>>())
    });
    // A change may bring helpers or other numbers with it; the one that changes least is the expression's own.
    let (_, last) = differing.min_by_key(|(lines, _)| *lines)?;
    Some(Line { target, line: last + 1, text: plain[last].split_whitespace().collect::<Vec<_>>().join(" ") })
}

/// How many lines differ, and the last of them.
fn difference(plain: &[&str], other: &[&str]) -> Option<(usize, usize)> {
    let first = plain.iter().zip(other).position(|(a, b)| a != b)?;
    let most = plain.len().min(other.len()) - first;
    let same = plain.iter().rev().zip(other.iter().rev()).take(most).take_while(|(a, b)| a == b).count();
    let last = (plain.len() - same).checked_sub(1)?;
    Some((plain.len().max(other.len()) - same - first, last.max(first)))
}

fn text(program: &Program, module: &ValidModule, target: Target) -> Option<String> {
    let (module, _) = with_entry(module, program.handle(), WORKGROUP).ok()?;
    match emit(&module, target, &Options::default()).ok()?.content {
        Content::Text(text) => Some(text),
        Content::Words(words) => Some(rspirv::dr::load_words(&words).ok()?.disassemble()),
    }
}
