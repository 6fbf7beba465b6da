//! The finished text: header, items with their docs, one blank line between them.

use super::groups::{self, Lead};
use super::mark::{Marks, Role};
use super::readable::Author;
use super::rename::Renamer;
use super::scan::{self, Piece};
use super::words::Words;
use super::wrap::wrap;
use super::{EmitError, Options, Target, docs};
use crate::module::Definitions;
use naga::FastHashSet as HashSet;
use naga::{Function, Module, Statement};

/// A writer's text, in pieces.
pub(super) struct Text<'a> {
    /// The line that some languages want to be the first of all.
    version: &'a str,
    /// The rest.
    pub(super) pieces: Vec<Piece<'a>>,
}

impl<'a> Text<'a> {
    /// Cuts a text.
    pub(super) fn new(raw: &'a str) -> Self {
        let end = raw.find('\n').filter(|_| raw.starts_with("#version ")).map_or(0, |i| i + 1);
        let (version, rest) = raw.split_at(end);
        Self { version, pieces: scan::pieces(rest) }
    }
}

/// Makes a writer's text, full of marks, into the one that a user gets; `definitions` are those of `module`'s functions.
pub(super) fn finish<'a>(
    (module, definitions): (&'a Module, &Definitions),
    marks: &'a Marks,
    mut text: Text<'a>,
    target: Target,
    options: &Options,
) -> Result<String, EmitError> {
    let words = Words::number(&mut text.pieces, marks);
    let author = Author::new(module, &words);
    let mut renamer = Renamer::new(module, marks, target, &words)?;
    let mut out = text.version.to_owned();
    if options.header {
        out.push_str(&header(module, target, options));
    }
    let mut former_is_line = false;
    for pieces in scan::items(&text.pieces) {
        let defines = renamer.defines(pieces);
        let written = renamer.body(defines).map(|(_, function)| author.written(pieces, function));
        let item = renamer.item(written.as_deref().unwrap_or(pieces), defines, options.docs)?;
        let text = item.text.trim();
        let docs =
            item.defines.filter(|_| options.docs).map(|role| docs::item(module, role)).unwrap_or_default();
        let is_line = docs.is_empty() && !text.contains('\n');
        let is_together = former_is_line && is_line;
        if !out.is_empty() && !is_together {
            out.push('\n');
        }
        out.push_str(&docs);
        lay_out(text, &leads(text, item.defines, definitions, options.docs), &mut out);
        former_is_line = is_line;
    }
    Ok(out)
}

/// The groups of the definition that an item comes from.
fn leads(
    text: &str,
    defined: Option<Role>,
    definitions: &Definitions,
    with_comments: bool,
) -> Vec<(usize, Lead)> {
    let Some(Role::Function(function)) = defined else { return Vec::new() };
    let definition = definitions.get(&function);
    definition.map(|definition| groups::leads(text, definition, with_comments)).unwrap_or_default()
}

/// Writes an item's text, with what leads groups of its lines.
fn lay_out(text: &str, leads: &[(usize, Lead)], out: &mut String) {
    let mut lines = Lines { out, is_behind_blank: false, is_behind_brace: false };
    let mut leads = leads.iter().peekable();
    for (i, line) in text.lines().enumerate() {
        if let Some((_, lead)) = leads.next_if(|(led, _)| *led == i) {
            lines.lead(lead, line);
        }
        lines.push(line.trim_end());
    }
}

/// The lines of an item, as they are written.
struct Lines<'o> {
    out: &'o mut String,
    is_behind_blank: bool,
    /// Whether the last line that is not blank opens a block.
    is_behind_brace: bool,
}

impl Lines<'_> {
    fn push(&mut self, line: &str) {
        if line.is_empty() {
            // Writers leave blank lines in bodies; one at a time is kept.
            self.out.push_str(if self.is_behind_blank { "" } else { "\n" });
            self.is_behind_blank = true;
            return;
        }
        (self.is_behind_blank, self.is_behind_brace) = (false, line.ends_with('{'));
        self.out.push_str(&wrap(line));
        self.out.push('\n');
    }

    /// Writes what stands before `line`.
    fn lead(&mut self, lead: &Lead, line: &str) {
        if lead.is_blank && !self.is_behind_brace {
            self.push("");
        }
        let indent = &line[..line.len() - line.trim_start().len()];
        for comment in &lead.comment {
            self.push(format!("{indent}// {comment}").trim_end());
        }
    }
}

fn header(module: &Module, target: Target, options: &Options) -> String {
    let kernels = if options.kernels.is_empty() { roots(module) } else { options.kernels.clone() };
    let command = options.command.clone().unwrap_or_else(|| {
        format!("lobe emit --target {target} {}", kernels.join(" ")).trim_end().to_owned()
    });
    let version = env!("CARGO_PKG_VERSION");
    let lines = [
        format!("Written by Lobe {version} from {}.", list(&kernels)),
        format!("Do not edit; write it again with: {command}"),
    ];
    lines.iter().map(|line| format!("// {}\n", one_line(line))).collect()
}

/// Text that cannot leave a line comment.
pub(super) fn one_line(text: &str) -> String {
    docs::without_breaks(text).trim_end_matches(|c: char| c.is_whitespace() || c == '\\').to_owned()
}

fn list(kernels: &[String]) -> String {
    match kernels {
        [] => "no kernel".to_owned(),
        [one] => format!("the kernel {one}"),
        many => format!("the kernels {}", many.join(", ")),
    }
}

/// The entry points, or else the functions that no other calls.
fn roots(module: &Module) -> Vec<String> {
    if !module.entry_points.is_empty() {
        return module.entry_points.iter().map(|e| e.name.clone()).collect();
    }
    let mut called = HashSet::default();
    for (_, function) in module.functions.iter() {
        collect_calls(&function.body, &mut called);
    }
    let is_root = |(handle, f): (naga::Handle<Function>, &Function)| {
        f.name.clone().filter(|_| !called.contains(&handle))
    };
    module.functions.iter().filter_map(is_root).collect()
}

/// The functions that a block calls.
pub(super) fn collect_calls(block: &naga::Block, called: &mut HashSet<naga::Handle<Function>>) {
    for statement in block.iter() {
        match statement {
            Statement::Call { function, .. } => {
                called.insert(*function);
            }
            Statement::Block(inner) => collect_calls(inner, called),
            Statement::If { accept, reject, .. } => {
                collect_calls(accept, called);
                collect_calls(reject, called);
            }
            Statement::Switch { cases, .. } => cases.iter().for_each(|c| collect_calls(&c.body, called)),
            Statement::Loop { body, continuing, .. } => {
                collect_calls(body, called);
                collect_calls(continuing, called);
            }
            _ => {}
        }
    }
}
