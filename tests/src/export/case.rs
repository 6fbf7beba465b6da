//! A kernel at rows of arguments, with what must come of them.

use super::ExportError;
use crate::question::conformant::sample;
use crate::subject::Subject;
use crate::value::{Floats, args_json, format_hex};
use lobe_backends::executor::{ExecError, Executor};
use lobe_backends::interp::{ShadowColumn, ShadowColumns};
use lobe_backends::route::Route;
use lobe_codegen::accuracy::Model;
use lobe_codegen::data::Columns;
use lobe_codegen::def::Scalar;
use lobe_codegen::emit::{self, Content, EntryLayout, Options, Target};

/// A case.
#[derive(Debug)]
pub struct Case<'a> {
    subject: &'a Subject,
    args: &'a Columns,
    shadow: ShadowColumns,
    accuracy: &'static Model,
    found: Option<(Route, Columns)>,
}

/// A buffer that the entry point reads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Buffer {
    /// Its name in the shader.
    pub name: String,
    /// Its binding, in group 0.
    pub binding: u32,
    /// Whether it is a uniform rather than a storage buffer.
    pub is_uniform: bool,
    /// What it holds.
    pub words: Vec<u32>,
}

/// What must stand at a place of the buffer `results`.
#[derive(Clone, Debug, PartialEq)]
pub struct Expected {
    /// Its row.
    pub row: usize,
    /// Its path in the result; empty for a result of one scalar.
    pub path: String,
    /// Bytes from the start of the buffer.
    pub offset: usize,
    /// What it is.
    pub scalar: Scalar,
    /// What it must be.
    pub wanted: Wanted,
}

/// What is permitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Wanted {
    /// A float at most so far from the exact value.
    Float {
        /// In real numbers.
        exact: f64,
        /// Derived by the accuracy model.
        bound: f64,
    },
    /// These bits.
    Word(u32),
    /// Anything.
    Unknown,
}

impl<'a> Case<'a> {
    /// The case of `subject`, whose bounds are those of `accuracy`, at the rows `args`; what `route` returns there is
    /// told in the file.
    ///
    /// # Errors
    /// When the kernel does not run.
    pub fn new(
        subject: &'a Subject,
        args: &'a Columns,
        accuracy: &'static Model,
        route: Option<&mut dyn Executor>,
    ) -> Result<Self, ExportError> {
        let program = subject.program();
        let shadow = program.shadow(args, None)?;
        let found =
            route.map(|r| Ok::<_, ExportError>((r.route().clone(), r.run(program, args)?))).transpose()?;
        program.entry()?;
        Ok(Self { subject, args, shadow, accuracy, found })
    }

    /// The kernel.
    #[must_use]
    pub fn subject(&self) -> &Subject {
        self.subject
    }

    /// What drivers are permitted.
    #[must_use]
    pub fn accuracy(&self) -> &'static Model {
        self.accuracy
    }

    /// Where the entry point has its buffers.
    ///
    /// # Errors
    /// When there is no entry point.
    pub fn layout(&self) -> Result<&EntryLayout, ExportError> {
        Ok(&self.subject.program().entry()?.1)
    }

    /// Workgroups along x.
    ///
    /// # Errors
    /// As of [`Case::layout`].
    pub fn workgroups(&self) -> Result<usize, ExportError> {
        Ok(self.args.rows.div_ceil(self.layout()?.workgroup_size as usize))
    }

    /// Bytes of the buffer `results`.
    ///
    /// # Errors
    /// As of [`Case::layout`].
    pub fn result_bytes(&self) -> Result<usize, ExportError> {
        Ok(self.layout()?.result.stride as usize * self.args.rows)
    }

    /// What the entry point reads, by binding.
    ///
    /// # Errors
    /// As of [`Case::layout`].
    pub fn buffers(&self) -> Result<Vec<Buffer>, ExportError> {
        let layout = self.layout()?;
        let params = self.subject.def().params.iter();
        let packed = self.subject.program().argument_buffers(self.args)?;
        let arguments = params.zip(&layout.arguments).zip(packed).map(|((param, at), bytes)| Buffer {
            name: format!("{}_values", param.name),
            binding: at.binding,
            is_uniform: false,
            words: bytes.as_chunks::<4>().0.iter().map(|word| u32::from_le_bytes(*word)).collect(),
        });
        let count = Buffer {
            name: "row_count".to_owned(),
            binding: layout.count_binding,
            is_uniform: true,
            words: vec![self.args.rows as u32],
        };
        Ok(arguments.chain([count]).collect())
    }

    /// What must stand in `results`, scalar by scalar.
    ///
    /// # Errors
    /// As of [`Case::layout`].
    pub fn expected(&self) -> Result<Vec<Expected>, ExportError> {
        let layout = &self.layout()?.result;
        let results = self.subject.program().results();
        let of_row = |row: usize| {
            let slots = layout.leaves.iter().zip(results).enumerate();
            slots.map(move |(leaf, (slot, result))| Expected {
                row,
                path: result.path.clone(),
                offset: row * layout.stride as usize + slot.offset as usize,
                scalar: result.scalar,
                wanted: self.wanted(leaf, row),
            })
        };
        Ok((0..self.args.rows).flat_map(of_row).collect())
    }

    fn wanted(&self, leaf: usize, row: usize) -> Wanted {
        let is_unknown = self.shadow.indeterminate.get(row).copied().unwrap_or(false);
        match &self.shadow.columns[leaf] {
            _ if is_unknown => Wanted::Unknown,
            ShadowColumn::Float { exact, bound, .. } => {
                let (exact, bound) = (exact[row], bound[row]);
                let is_known = (exact as f32).is_finite() && bound.is_finite();
                if is_known { Wanted::Float { exact, bound } } else { Wanted::Unknown }
            }
            ShadowColumn::Word { value, known } if known[row] => Wanted::Word(value[row]),
            ShadowColumn::Word { .. } => Wanted::Unknown,
        }
    }

    /// The complete shader, without a header.
    ///
    /// # Errors
    /// When the kernel cannot be emitted.
    pub fn shader(&self, target: Target) -> Result<Content, ExportError> {
        let program = self.subject.program();
        let options = Options { header: false, ..Options::default() };
        let emitted = emit::emit(&program.entry()?.0, target, &options);
        let emitted =
            emitted.map_err(|cause| ExecError::Emit { kernel: program.name(), cause: cause.into() })?;
        Ok(emitted.content)
    }

    /// The case in words, for comments.
    ///
    /// # Errors
    /// As of [`Case::layout`].
    pub fn notes(&self) -> Result<Vec<String>, ExportError> {
        let def = self.subject.def();
        let mut lines = vec![format!("{}, exported by Lobe {}.", def.name, env!("CARGO_PKG_VERSION"))];
        lines.extend((!def.contract.cite.is_empty()).then(|| format!("Source: {}.", def.contract.cite)));
        lines.push(String::new());
        lines.push(match self.args.rows {
            1 => "Arguments, floats in hexadecimal:".to_owned(),
            rows => format!("{rows} rows of arguments, floats in hexadecimal:"),
        });
        lines.extend((0..self.args.rows).map(|row| self.args_line(row)));
        lines.push(format!(
            "Expected, with the error that drivers are permitted ({}):",
            self.accuracy.title.trim_end_matches('.')
        ));
        lines.extend(self.expected()?.iter().map(|expected| self.expected_line(expected)));
        lines.extend(self.found_lines());
        lines.push(String::new());
        Ok(lines)
    }

    fn args_line(&self, row: usize) -> String {
        format!("  {}", args_json(self.subject.def(), &self.args.row(row), Floats::Hex))
    }

    fn expected_line(&self, expected: &Expected) -> String {
        let value = match expected.wanted {
            Wanted::Float { exact, bound } => {
                format!("{exact:?} +- {bound:e}, in f32 {}", format_hex(exact as f32))
            }
            Wanted::Word(word) => number(expected.scalar, word),
            Wanted::Unknown => "anything: no bound is derived here".to_owned(),
        };
        format!("  {} = {value}", self.name(expected.row, &expected.path))
    }

    /// `result.axis.x`; with the row, where there are several.
    fn name(&self, row: usize, path: &str) -> String {
        let row = if self.args.rows > 1 { format!("[{row}]") } else { String::new() };
        let point = if path.is_empty() || path.starts_with('[') { "" } else { "." };
        format!("result{row}{point}{path}")
    }

    fn found_lines(&self) -> Vec<String> {
        let Some((route, found)) = &self.found else { return Vec::new() };
        let results = self.subject.program().results();
        let scalars = (0..self.args.rows).flat_map(|row| (0..results.len()).map(move |leaf| (row, leaf)));
        let line = |(row, leaf): (usize, usize)| {
            let word = found.columns[leaf][row];
            let is_known = self.wanted(leaf, row) != Wanted::Unknown;
            let sample = sample(&self.shadow.columns[leaf], row, word).filter(|_| is_known);
            let share = match sample.map(|s| s.share()) {
                Some(share) if share > 1.0 => format!(", NOT permitted: {share:.3e} of the bound"),
                Some(share) => format!(", {share:.2} of the bound"),
                None => String::new(),
            };
            let value = number(results[leaf].scalar, word);
            format!("  {} = {value}{share}", self.name(row, &results[leaf].path))
        };
        [format!("Found on {route}:")].into_iter().chain(scalars.map(line)).collect()
    }
}

fn number(scalar: Scalar, word: u32) -> String {
    match scalar {
        Scalar::F32 => format!("{:?}, {}", f32::from_bits(word), format_hex(f32::from_bits(word))),
        Scalar::I32 => (word as i32).to_string(),
        Scalar::U32 => word.to_string(),
        Scalar::Bool => (word != 0).to_string(),
    }
}
