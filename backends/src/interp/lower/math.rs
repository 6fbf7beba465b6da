//! Built-in functions of floats.

use super::super::error::Res;
use super::super::program::Value;
use super::super::program::op::FloatOp;
use super::frame::Frame;
use super::{Lowerer, malformed};
use naga::{Expression, Handle, MathFunction};
use std::rc::Rc;

impl<'m> Lowerer<'m> {
    pub(crate) fn math(
        &mut self,
        frame: &Frame<'m>,
        fun: MathFunction,
        first: Handle<Expression>,
        rest: [Option<Handle<Expression>>; 3],
    ) -> Res<Vec<Value>> {
        let mut args = vec![frame.data(first)?];
        for handle in rest.into_iter().flatten() {
            args.push(frame.data(handle)?);
        }
        if fun == MathFunction::Transpose {
            let shape = self.shape(frame, first)?;
            let (_, rows) = self.types().matrix(shape).ok_or(malformed("what is transposed is a matrix"))?;
            return Ok(Self::transpose(rows, &args[0]));
        }
        let scalar = args[0].first().map(|v| self.b.scalar(*v));
        if scalar.is_some_and(|s| s.float()) {
            self.float_math(frame, fun, &args)
        } else {
            self.integer_math(frame, fun, &args)
        }
    }

    /// `op` of each component; lone scalars go with all components of the others.
    fn each(&mut self, op: FloatOp, args: &[Rc<[Value]>]) -> Vec<Value> {
        let width = args.iter().map(|a| a.len()).max().unwrap_or(0);
        let component = |i: usize| {
            let operands: Vec<Value> = args.iter().map(|a| a[if a.len() == 1 { 0 } else { i }]).collect();
            self.b.float_op(op, &operands)
        };
        (0..width).map(component).collect()
    }

    fn float_math(&mut self, frame: &Frame<'m>, fun: MathFunction, args: &[Rc<[Value]>]) -> Res<Vec<Value>> {
        if let Some(op) = componentwise(fun) {
            return Ok(self.each(op, args));
        }
        self.vector_math(frame, fun, args)
    }

    fn vector_math(&mut self, frame: &Frame<'m>, fun: MathFunction, args: &[Rc<[Value]>]) -> Res<Vec<Value>> {
        use MathFunction as F;
        match (fun, args) {
            (F::Dot, [x, y]) => Ok(vec![self.dot(x, y)?]),
            (F::Length, [x]) => Ok(vec![self.length(x)?]),
            (F::Distance, [x, y]) => Ok(vec![self.distance(x, y)?]),
            (F::Normalize, [x]) => self.normalize(x),
            (F::Cross, [x, y]) => self.cross(x, y),
            (F::Reflect, [x, y]) => self.reflect(x, y),
            (F::Refract, [x, y, eta]) => self.refract(x, y, eta[0]),
            (F::FaceForward, [x, y, z]) => self.face_forward(x, y, z),
            (fun, _) => Err(frame.unsupported(format!("{fun:?} of floats"))),
        }
    }
}

/// The operation that a function is on each component.
fn componentwise(fun: MathFunction) -> Option<FloatOp> {
    use MathFunction as F;
    Some(match fun {
        F::Abs => FloatOp::Abs,
        F::Min => FloatOp::Min,
        F::Max => FloatOp::Max,
        F::Clamp => FloatOp::Clamp,
        F::Saturate => FloatOp::Saturate,
        F::Sign => FloatOp::Sign,
        F::Ceil => FloatOp::Ceil,
        F::Floor => FloatOp::Floor,
        F::Round => FloatOp::Round,
        F::Trunc => FloatOp::Trunc,
        F::Fract => FloatOp::Fract,
        F::Step => FloatOp::Step,
        F::Sqrt => FloatOp::Sqrt,
        F::InverseSqrt => FloatOp::InverseSqrt,
        F::Exp => FloatOp::Exp,
        F::Exp2 => FloatOp::Exp2,
        F::Log => FloatOp::Log,
        F::Log2 => FloatOp::Log2,
        F::Pow => FloatOp::Pow,
        F::Degrees => FloatOp::Degrees,
        F::Radians => FloatOp::Radians,
        F::Fma => FloatOp::Fma,
        F::Mix => FloatOp::Mix,
        F::SmoothStep => FloatOp::SmoothStep,
        F::Sin => FloatOp::Sin,
        F::Cos => FloatOp::Cos,
        F::Tan => FloatOp::Tan,
        F::Asin => FloatOp::Asin,
        F::Acos => FloatOp::Acos,
        F::Atan => FloatOp::Atan,
        F::Atan2 => FloatOp::Atan2,
        F::Sinh => FloatOp::Sinh,
        F::Cosh => FloatOp::Cosh,
        F::Tanh => FloatOp::Tanh,
        F::Asinh => FloatOp::Asinh,
        F::Acosh => FloatOp::Acosh,
        F::Atanh => FloatOp::Atanh,
        F::Dot
        | F::Length
        | F::Distance
        | F::Normalize
        | F::Cross
        | F::Reflect
        | F::Refract
        | F::FaceForward
        | F::Modf
        | F::Frexp
        | F::Ldexp
        | F::Outer
        | F::Inverse
        | F::Determinant
        | F::Transpose
        | F::QuantizeToF16
        | F::Dot4I8Packed
        | F::Dot4U8Packed
        | F::CountTrailingZeros
        | F::CountLeadingZeros
        | F::CountOneBits
        | F::ReverseBits
        | F::ExtractBits
        | F::InsertBits
        | F::FirstTrailingBit
        | F::FirstLeadingBit
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
