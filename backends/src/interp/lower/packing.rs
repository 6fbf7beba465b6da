//! Several numbers in one word, and back.
//!
//! Normalised numbers are rounded as the graphics interfaces do it: their product, to the nearest, ties to even.

use super::super::error::Res;
use super::super::program::op::{FloatOp, IntOp};
use super::super::program::{Scalar, Value};
use super::{Lowerer, malformed};
use naga::MathFunction;
use std::rc::Rc;

/// What the parts of a word are.
#[derive(Debug, Clone, Copy)]
struct Layout {
    /// Bits of a part.
    bits: u32,
    /// What a part is as a number of its own.
    number: Scalar,
    how: How,
}

/// How a part's bits are a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum How {
    /// The integer itself; lower bits, or the nearest that fits.
    Integer { clamped: bool },
    /// A float: the integer by the largest one.
    Normalised,
    /// A float of 16 bits.
    Half,
}

fn layout(bits: u32, number: Scalar, how: How) -> Layout {
    Layout { bits, number, how }
}

/// The layout of what a function packs.
fn packs(fun: MathFunction) -> Option<Layout> {
    use MathFunction as F;
    Some(match fun {
        F::Pack4x8snorm => layout(8, Scalar::I32, How::Normalised),
        F::Pack4x8unorm => layout(8, Scalar::U32, How::Normalised),
        F::Pack2x16snorm => layout(16, Scalar::I32, How::Normalised),
        F::Pack2x16unorm => layout(16, Scalar::U32, How::Normalised),
        F::Pack2x16float => layout(16, Scalar::U32, How::Half),
        F::Pack4xI8 => layout(8, Scalar::I32, How::Integer { clamped: false }),
        F::Pack4xU8 => layout(8, Scalar::U32, How::Integer { clamped: false }),
        F::Pack4xI8Clamp => layout(8, Scalar::I32, How::Integer { clamped: true }),
        F::Pack4xU8Clamp => layout(8, Scalar::U32, How::Integer { clamped: true }),
        _ => return None,
    })
}

/// The layout of what a function unpacks.
fn unpacks(fun: MathFunction) -> Option<Layout> {
    use MathFunction as F;
    Some(match fun {
        F::Unpack4x8snorm => layout(8, Scalar::I32, How::Normalised),
        F::Unpack4x8unorm => layout(8, Scalar::U32, How::Normalised),
        F::Unpack2x16snorm => layout(16, Scalar::I32, How::Normalised),
        F::Unpack2x16unorm => layout(16, Scalar::U32, How::Normalised),
        F::Unpack2x16float => layout(16, Scalar::U32, How::Half),
        F::Unpack4xI8 => layout(8, Scalar::I32, How::Integer { clamped: false }),
        F::Unpack4xU8 => layout(8, Scalar::U32, How::Integer { clamped: false }),
        _ => return None,
    })
}

impl Layout {
    /// The largest and least integer of a part.
    fn range(self) -> (i32, i32) {
        if self.number.signed() {
            ((1 << (self.bits - 1)) - 1, -(1 << (self.bits - 1)))
        } else {
            ((1 << self.bits) - 1, 0)
        }
    }
}

impl Lowerer<'_> {
    /// The result of a function that packs, unpacks, or multiplies what is packed; `None` of others.
    pub(crate) fn packed_math(&mut self, fun: MathFunction, args: &[Rc<[Value]>]) -> Res<Option<Vec<Value>>> {
        let first = |at: usize| -> Res<Value> {
            let arg = args.get(at).and_then(|a| a.first());
            arg.copied().ok_or(malformed("a function of words without words"))
        };
        if let Some(layout) = packs(fun) {
            return Ok(Some(vec![self.pack(layout, &args[0])]));
        }
        if let Some(layout) = unpacks(fun) {
            return Ok(Some(self.unpack(layout, first(0)?)));
        }
        let number = match fun {
            MathFunction::Dot4I8Packed => Scalar::I32,
            MathFunction::Dot4U8Packed => Scalar::U32,
            _ => return Ok(None),
        };
        let bytes = layout(8, number, How::Integer { clamped: false });
        let (x, y) = (self.unpack(bytes, first(0)?), self.unpack(bytes, first(1)?));
        Ok(Some(vec![self.dot_words(&x, &y)?]))
    }

    fn pack(&mut self, layout: Layout, parts: &[Value]) -> Value {
        let mut word = self.b.u32(0);
        for (at, part) in (0..).map(|i| i * layout.bits).zip(parts) {
            let bits = self.part(layout, *part);
            let (at, count) = (self.b.u32(at), self.b.u32(layout.bits));
            word = self.b.int_op(IntOp::InsertBits, &[word, bits, at, count]);
        }
        word
    }

    /// A u32 with the bits of a part, lowest.
    fn part(&mut self, layout: Layout, number: Value) -> Value {
        let (high, low) = layout.range();
        match layout.how {
            How::Half => {
                let half = self.converted(number, Scalar::F16);
                let bits = self.reinterpreted(half, Scalar::U16);
                self.converted(bits, Scalar::U32)
            }
            How::Normalised => {
                let least = if layout.number.signed() { -1.0 } else { 0.0 };
                let ends = [least, 1.0].map(|end| self.b.float(Scalar::F32, end));
                let clamped = self.b.float_op(FloatOp::Clamp, &[number, ends[0], ends[1]]);
                let scale = self.b.float(Scalar::F32, high as f32);
                let scaled = self.mul(clamped, scale);
                let rounded = self.b.float_op(FloatOp::Round, &[scaled]);
                let integer = self.converted(rounded, layout.number);
                self.reinterpreted(integer, Scalar::U32)
            }
            How::Integer { clamped } => {
                let ends = [low, high].map(|end| self.b.bits(layout.number, (end as u32).into(), end.into()));
                let fits = match clamped {
                    true => self.b.int_op(IntOp::Clamp, &[number, ends[0], ends[1]]),
                    false => number,
                };
                self.reinterpreted(fits, Scalar::U32)
            }
        }
    }

    fn unpack(&mut self, layout: Layout, word: Value) -> Vec<Value> {
        let word = self.reinterpreted(word, layout.number);
        (0..32 / layout.bits).map(|i| self.number(layout, word, i * layout.bits)).collect()
    }

    /// The number that lies from bit `at` on.
    fn number(&mut self, layout: Layout, word: Value, at: u32) -> Value {
        let (at, count) = (self.b.u32(at), self.b.u32(layout.bits));
        let integer = self.b.int_op(IntOp::ExtractBits, &[word, at, count]);
        match layout.how {
            How::Integer { .. } => integer,
            How::Half => {
                let bits = self.converted(integer, Scalar::U16);
                let half = self.reinterpreted(bits, Scalar::F16);
                self.converted(half, Scalar::F32)
            }
            How::Normalised => {
                let float = self.converted(integer, Scalar::F32);
                let scale = self.b.float(Scalar::F32, layout.range().0 as f32);
                let number = self.b.float_op(FloatOp::Div, &[float, scale]);
                if !layout.number.signed() {
                    return number;
                }
                let least = self.b.float(Scalar::F32, -1.0);
                self.b.float_op(FloatOp::Max, &[number, least])
            }
        }
    }
}
