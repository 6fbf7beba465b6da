//! What judges want to know beside the operations.

use super::super::program::op::Mark;
use super::super::program::{Op, Scalar, Value};
use super::frame::{Frame, Item};
use super::{Lowerer, Reader, scan};
use lobe_codegen::def::Truth;
use lobe_codegen::module::Scope;
use naga::{Block, Span, Statement};
use std::collections::HashMap;

/// Where the source has statements, by their address in the module.
pub(crate) type Spans = HashMap<*const Statement, Span>;

impl<'m> Lowerer<'m> {
    /// Zeros of a variable without a first value.
    pub(crate) fn unwritten(&mut self, scalars: &[Scalar]) -> Vec<Value> {
        match self.reader {
            Reader::Lanes | Reader::Judge => self.zeros(scalars),
            Reader::Sanitizer => {
                scalars.iter().map(|s| self.b.eval(Op::Mark(*s, Mark::Unwritten), &[])).collect()
            }
        }
    }

    /// A function's results, told to be so, and what exact function they stand for.
    pub(crate) fn marked(&mut self, frame: &Frame<'m>, mut results: Vec<Value>) -> Vec<Value> {
        if self.reader != Reader::Judge {
            return results;
        }
        self.tell_truth(frame, &mut results);
        for value in &mut results {
            if self.b.scalar(*value) == Scalar::F32 {
                *value = self.b.eval(Op::Mark(Scalar::F32, Mark::Settled), &[*value]);
            }
        }
        results
    }

    fn tell_truth(&mut self, frame: &Frame<'m>, results: &mut [Value]) {
        let Scope::Function(function) = frame.scope else {
            return;
        };
        let (Some(truth), Some(first)) = (self.module.meta().truths.get(&function), results.first_mut())
        else {
            return;
        };
        let count = match truth {
            Truth::Unary(_) => 1,
            Truth::Binary(_) => 2,
        };
        let mut operands = vec![*first];
        for argument in &frame.arguments {
            if let Item::Values(values) = argument {
                operands.extend(values.iter().filter(|v| self.b.scalar(**v) == Scalar::F32));
            }
        }
        operands.truncate(1 + count);
        if operands.len() == 1 + count && self.b.scalar(*first) == Scalar::F32 {
            self.b.program.truths.push(*truth);
            let mark = Mark::Truth(self.b.program.truths.len() as u32 - 1);
            *first = self.b.eval(Op::Mark(Scalar::F32, mark), &operands);
        }
    }

    /// Notes where the source has the statements of a function.
    pub(crate) fn note_spans(&mut self, frame: &Frame<'m>) {
        if self.reader == Reader::Sanitizer {
            note(&frame.function.body, &mut self.spans);
        }
    }

    /// From here on `statement` is lowered.
    pub(crate) fn locate(&mut self, statement: &Statement) {
        if let Some(span) = self.spans.get(&std::ptr::from_ref(statement)) {
            self.b.at = *span;
        }
    }
}

fn note(block: &Block, spans: &mut Spans) {
    for (statement, span) in block.span_iter() {
        spans.insert(std::ptr::from_ref(statement), *span);
        scan::inner_blocks(statement).into_iter().for_each(|inner| note(inner, spans));
    }
}
