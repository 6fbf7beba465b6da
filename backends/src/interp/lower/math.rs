//! Built-in functions of floats.

use super::super::error::Res;
use super::super::program::op::FloatOp;
use super::super::program::{Op, Scalar, Value};
use super::Lowerer;
use super::frame::Frame;
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
        let matrix = self.shape(frame, first).ok().and_then(|shape| self.types().matrix(shape));
        if let Some((_, rows)) = matrix {
            return self.matrix_math(frame, fun, rows, &args[0]);
        }
        if let Some(values) = self.packed_math(fun, &args)? {
            return Ok(values);
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

    fn matrix_math(
        &mut self,
        frame: &Frame<'m>,
        fun: MathFunction,
        rows: usize,
        x: &[Value],
    ) -> Res<Vec<Value>> {
        match fun {
            MathFunction::Transpose => Ok(Self::transpose(rows, x)),
            MathFunction::Determinant => Ok(vec![self.determinant(rows, x)?]),
            MathFunction::Inverse => self.inverse(rows, x),
            fun => Err(frame.unsupported(format!("{fun:?} of matrices"))),
        }
    }

    /// Both results of a function on each component: all of the first, then all of the second.
    fn both(&mut self, x: &[Value], f: impl Fn(&mut Self, Value) -> [Value; 2]) -> Vec<Value> {
        let pairs: Vec<_> = x.iter().map(|x| f(self, *x)).collect();
        (0..2).flat_map(|part| pairs.iter().map(move |pair| pair[part])).collect()
    }

    /// What is behind the point, with the sign, and what is before it.
    fn modf(&mut self, x: Value) -> [Value; 2] {
        let whole = self.b.float_op(FloatOp::Trunc, &[x]);
        [self.sub(x, whole), whole]
    }

    /// A number in `[0.5, 1)`, with the sign, and the power of two that it was divided by, as an integer as wide.
    fn frexp(&mut self, x: Value) -> [Value; 2] {
        let scalar = self.b.scalar(x);
        let exponent = self.b.eval(Op::Exponent(scalar), &[x]);
        let whole = match scalar.bytes() {
            2 => Scalar::I16,
            8 => Scalar::I64,
            _ => Scalar::I32,
        };
        [self.b.float_op(FloatOp::Significand, &[x]), self.converted(exponent, whole)]
    }

    fn ldexp(&mut self, x: Value, by: Value) -> Value {
        let (scalar, by) = (self.b.scalar(x), self.converted(by, Scalar::I32));
        self.b.eval(Op::Ldexp(scalar), &[x, by])
    }

    fn quantized(&mut self, x: Value) -> Value {
        let half = self.converted(x, Scalar::F16);
        self.converted(half, Scalar::F32)
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
            (F::Outer, [x, y]) => Ok(self.outer(x, y)),
            (F::Modf, [x]) => Ok(self.both(x, Self::modf)),
            (F::Frexp, [x]) => Ok(self.both(x, Self::frexp)),
            (F::Ldexp, [x, by]) => Ok(self.pairs(x, by, Self::ldexp)),
            (F::QuantizeToF16, [x]) => Ok(x.iter().map(|x| self.quantized(*x)).collect()),
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
