//! Built-in functions.

use super::super::error::Res;
use super::super::leaf::Leaf;
use super::super::model::Model;
use super::{Frame, InterpError, Machine};
use naga::{Expression, Handle, MathFunction, ScalarKind};

/// A function of one number.
type Unary<'a, M> = &'a dyn Fn(<M as Model>::F) -> <M as Model>::F;

const MISSING: InterpError = InterpError::Malformed("a built-in function lacks an argument");

impl<'m, M: Model> Machine<'m, M> {
    pub(super) fn math(
        &self,
        frame: &Frame<'m, M>,
        fun: MathFunction,
        first: Handle<Expression>,
        rest: [Option<Handle<Expression>>; 3],
    ) -> Res<Vec<Leaf<M>>> {
        let ty = self.type_of(frame, first);
        let mut args = vec![frame.data(first)?];
        for handle in rest.into_iter().flatten() {
            args.push(frame.data(handle)?);
        }
        if fun == MathFunction::Transpose {
            let (_, rows) = super::matrix::dimensions(ty).ok_or(MISSING)?;
            return Ok(Self::transpose(rows as usize, args[0]));
        }
        match ty.scalar().map(|s| s.kind) {
            Some(ScalarKind::Float) => self.float_math(frame, fun, &args),
            Some(ScalarKind::Sint) => self.integer_math(frame, fun, &args, true),
            Some(ScalarKind::Uint) => self.integer_math(frame, fun, &args, false),
            Some(ScalarKind::Bool | ScalarKind::AbstractInt | ScalarKind::AbstractFloat) | None => {
                Err(frame.unsupported(format!("{fun:?} of this type")))
            }
        }
    }

    fn unary_math(&self, args: &[&[Leaf<M>]], f: impl Fn(M::F) -> M::F) -> Res<Vec<Leaf<M>>> {
        args[0].iter().map(|a| self.map_f(a, &f)).collect()
    }

    fn binary_math(&self, args: &[&[Leaf<M>]], f: impl Fn(M::F, M::F) -> M::F) -> Res<Vec<Leaf<M>>> {
        let b = args.get(1).ok_or(MISSING)?;
        self.columns(args[0], b, |a, b| self.zip_f(a, b, &f))
    }

    fn ternary_math(&self, args: &[&[Leaf<M>]], f: impl Fn(M::F, M::F, M::F) -> M::F) -> Res<Vec<Leaf<M>>> {
        let (Some(b), Some(c)) = (args.get(1), args.get(2)) else {
            return Err(MISSING);
        };
        // `mix` takes a scalar third argument beside vectors.
        let rest = b.iter().zip(c.iter().cycle());
        args[0].iter().zip(rest).map(|(a, (b, c))| self.zip3_f([a, b, c], &f)).collect()
    }

    fn float_math(&self, frame: &Frame<'m, M>, fun: MathFunction, args: &[&[Leaf<M>]]) -> Res<Vec<Leaf<M>>> {
        use MathFunction as F;
        let m = &self.model;
        match fun {
            F::Abs => self.unary_math(args, |a| m.abs(a)),
            F::Min => self.binary_math(args, |a, b| m.min(a, b)),
            F::Max => self.binary_math(args, |a, b| m.max(a, b)),
            F::Clamp => self.ternary_math(args, |x, low, high| m.clamp(x, low, high)),
            F::Saturate => self.unary_math(args, |a| m.saturate(a)),
            F::Sign => self.unary_math(args, |a| m.sign(a)),
            F::Ceil => self.unary_math(args, |a| m.ceil(a)),
            F::Floor => self.unary_math(args, |a| m.floor(a)),
            F::Round => self.unary_math(args, |a| m.round(a)),
            F::Trunc => self.unary_math(args, |a| m.trunc(a)),
            F::Fract => self.unary_math(args, |a| m.fract(a)),
            F::Step => self.binary_math(args, |edge, x| m.step(edge, x)),
            F::Sqrt => self.unary_math(args, |a| m.sqrt(a)),
            F::InverseSqrt => self.unary_math(args, |a| m.inverse_sqrt(a)),
            F::Exp => self.unary_math(args, |a| m.exp(a)),
            F::Exp2 => self.unary_math(args, |a| m.exp2(a)),
            F::Log => self.unary_math(args, |a| m.log(a)),
            F::Log2 => self.unary_math(args, |a| m.log2(a)),
            F::Pow => self.binary_math(args, |a, b| m.pow(a, b)),
            F::Degrees => self.unary_math(args, |a| m.degrees(a)),
            F::Radians => self.unary_math(args, |a| m.radians(a)),
            F::Fma => self.ternary_math(args, |x, y, z| m.fma(x, y, z)),
            F::Mix => self.ternary_math(args, |x, y, t| m.mix(x, y, t)),
            F::SmoothStep => self.ternary_math(args, |low, high, x| m.smoothstep(low, high, x)),
            F::Sin
            | F::Cos
            | F::Tan
            | F::Asin
            | F::Acos
            | F::Atan
            | F::Atan2
            | F::Sinh
            | F::Cosh
            | F::Tanh
            | F::Asinh
            | F::Acosh
            | F::Atanh => self.trigonometry(fun, args),
            F::Dot
            | F::Length
            | F::Distance
            | F::Normalize
            | F::Cross
            | F::Reflect
            | F::Refract
            | F::FaceForward => self.vector_math(fun, args),
            F::Modf
            | F::Frexp
            | F::Ldexp
            | F::Outer
            | F::Inverse
            | F::Determinant
            | F::Transpose
            | F::QuantizeToF16
            | F::Dot4I8Packed
            | F::Dot4U8Packed => Err(frame.unsupported(format!("{fun:?}"))),
            F::CountTrailingZeros
            | F::CountLeadingZeros
            | F::CountOneBits
            | F::ReverseBits
            | F::ExtractBits
            | F::InsertBits
            | F::FirstTrailingBit
            | F::FirstLeadingBit => Err(frame.unsupported(format!("{fun:?} of floats"))),
            F::Pack4x8snorm
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
            | F::Unpack4xU8 => Err(frame.unsupported(format!("{fun:?}"))),
        }
    }

    fn trigonometry(&self, fun: MathFunction, args: &[&[Leaf<M>]]) -> Res<Vec<Leaf<M>>> {
        use MathFunction as F;
        let m = &self.model;
        if fun == F::Atan2 {
            return self.binary_math(args, |y, x| m.atan2(y, x));
        }
        let table: [(F, Unary<'_, M>); 12] = [
            (F::Sin, &|a| m.sin(a)),
            (F::Cos, &|a| m.cos(a)),
            (F::Tan, &|a| m.tan(a)),
            (F::Asin, &|a| m.asin(a)),
            (F::Acos, &|a| m.acos(a)),
            (F::Atan, &|a| m.atan(a)),
            (F::Sinh, &|a| m.sinh(a)),
            (F::Cosh, &|a| m.cosh(a)),
            (F::Tanh, &|a| m.tanh(a)),
            (F::Asinh, &|a| m.asinh(a)),
            (F::Acosh, &|a| m.acosh(a)),
            (F::Atanh, &|a| m.atanh(a)),
        ];
        let (_, f) = table.iter().find(|(name, _)| *name == fun).ok_or(MISSING)?;
        self.unary_math(args, f)
    }

    fn vector_math(&self, fun: MathFunction, args: &[&[Leaf<M>]]) -> Res<Vec<Leaf<M>>> {
        use MathFunction as F;
        let none: &[Leaf<M>] = &[];
        let arg = |i: usize| args.get(i).copied().unwrap_or(none);
        let (x, y, z) = (arg(0), arg(1), arg(2));
        let one = |leaf: Res<Leaf<M>>| leaf.map(|leaf| vec![leaf]);
        if fun == F::Dot {
            one(self.dot(x, y))
        } else if fun == F::Length {
            one(self.length(x))
        } else if fun == F::Distance {
            one(self.distance(x, y))
        } else if fun == F::Normalize {
            self.normalize(x)
        } else if fun == F::Cross {
            self.cross(x, y)
        } else if fun == F::Reflect {
            self.reflect(x, y)
        } else if fun == F::Refract {
            self.refract(x, y, z.first().ok_or(MISSING)?)
        } else {
            self.face_forward(x, y, z)
        }
    }
}
