//! Built-in functions of integers.

use super::super::error::Res;
use super::super::program::Value;
use super::super::program::op::IntOp;
use super::Lowerer;
use super::frame::Frame;
use naga::MathFunction;
use std::rc::Rc;

impl<'m> Lowerer<'m> {
    pub(crate) fn integer_math(
        &mut self,
        frame: &Frame<'m>,
        fun: MathFunction,
        args: &[Rc<[Value]>],
    ) -> Res<Vec<Value>> {
        if fun == MathFunction::Dot
            && let [x, y] = args
        {
            return Ok(vec![self.dot_words(x, y)?]);
        }
        let signed = self.b.scalar(args[0][0]).signed();
        if fun == MathFunction::Abs && !signed {
            return Ok(args[0].to_vec());
        }
        let op = componentwise(fun).ok_or_else(|| frame.unsupported(format!("{fun:?} of integers")))?;
        let component = |i: usize| {
            let operands: Vec<Value> = args.iter().map(|a| a[if a.len() == 1 { 0 } else { i }]).collect();
            self.b.int_op(op, &operands)
        };
        Ok((0..args[0].len()).map(component).collect())
    }
}

/// The operation that a function is on each component.
fn componentwise(fun: MathFunction) -> Option<IntOp> {
    use MathFunction as F;
    Some(match fun {
        F::Abs => IntOp::Abs,
        F::Sign => IntOp::Sign,
        F::Min => IntOp::Min,
        F::Max => IntOp::Max,
        F::Clamp => IntOp::Clamp,
        F::CountTrailingZeros => IntOp::CountTrailingZeros,
        F::CountLeadingZeros => IntOp::CountLeadingZeros,
        F::CountOneBits => IntOp::CountOneBits,
        F::ReverseBits => IntOp::ReverseBits,
        F::FirstTrailingBit => IntOp::FirstTrailingBit,
        F::FirstLeadingBit => IntOp::FirstLeadingBit,
        F::ExtractBits => IntOp::ExtractBits,
        F::InsertBits => IntOp::InsertBits,
        F::Dot
        | F::Saturate
        | F::Cos
        | F::Cosh
        | F::Sin
        | F::Sinh
        | F::Tan
        | F::Tanh
        | F::Acos
        | F::Asin
        | F::Atan
        | F::Atan2
        | F::Asinh
        | F::Acosh
        | F::Atanh
        | F::Radians
        | F::Degrees
        | F::Ceil
        | F::Floor
        | F::Round
        | F::Fract
        | F::Trunc
        | F::Modf
        | F::Frexp
        | F::Ldexp
        | F::Exp
        | F::Exp2
        | F::Log
        | F::Log2
        | F::Pow
        | F::Outer
        | F::Cross
        | F::Distance
        | F::Length
        | F::Normalize
        | F::FaceForward
        | F::Reflect
        | F::Refract
        | F::Fma
        | F::Mix
        | F::Step
        | F::SmoothStep
        | F::Sqrt
        | F::InverseSqrt
        | F::Inverse
        | F::Transpose
        | F::Determinant
        | F::QuantizeToF16
        | F::Dot4I8Packed
        | F::Dot4U8Packed
        | F::Pack4x8snorm
        | F::Pack4x8unorm
        | F::Pack2x16snorm
        | F::Pack2x16unorm
        | F::Pack2x16float
        | F::Pack4xI8
        | F::Pack4xU8
        | F::Pack4xI8Clamp
        | F::Pack4xU8Clamp
        | F::Unpack4x8snorm
        | F::Unpack4x8unorm
        | F::Unpack2x16snorm
        | F::Unpack2x16unorm
        | F::Unpack2x16float
        | F::Unpack4xI8
        | F::Unpack4xU8 => return None,
    })
}
