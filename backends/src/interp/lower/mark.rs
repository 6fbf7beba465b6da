//! What judges want to know beside the operations.

use super::super::program::op::Mark;
use super::super::program::{Atomic, Op, Place, Scalar, Stmt, Update, Value};
use super::frame::{Frame, Item, Pointer};
use super::layout::Shape;
use super::{Lowerer, Reader, scan};
use lobe_codegen::def::Truth;
use lobe_codegen::module::Scope;
use naga::{Block, Span, Statement, TypeInner};
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

    /// Loads a scalar; sanitizers learn what is atomic.
    pub(crate) fn load_place(&mut self, pointer: Pointer, place: Place, scalar: Scalar) -> Value {
        if !self.is_atomic(pointer, scalar) {
            return self.b.load(place, scalar);
        }
        let old = self.b.register(scalar);
        let (fun, value, at) = (Update::Or, self.b.zero(scalar), self.b.at);
        self.b.push(Stmt::Atomic(Atomic { place, fun, value, expected: None, old: Some(old), at }));
        Value::Reg(old)
    }

    /// Stores a scalar; sanitizers learn what is atomic.
    pub(crate) fn store_place(&mut self, pointer: Pointer, place: Place, value: Value) {
        if !self.is_atomic(pointer, self.b.scalar(value)) {
            return self.b.store(place, value);
        }
        let (fun, at) = (Update::Exchange, self.b.at);
        self.b.touch();
        self.b.push(Stmt::Atomic(Atomic { place, fun, value, expected: None, old: None, at }));
    }

    fn is_atomic(&self, pointer: Pointer, scalar: Scalar) -> bool {
        let Shape::Type(ty) = pointer.shape else {
            return false;
        };
        self.reader == Reader::Sanitizer
            && !scalar.float()
            && matches!(self.types().inner(ty), TypeInner::Atomic(_))
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
