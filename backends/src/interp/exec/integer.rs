//! Built-in functions of integers; the bit operations are those of the native functions.

use super::super::error::Res;
use super::super::leaf::Leaf;
use super::super::model::Model;
use super::{Frame, InterpError, Machine};
use lobe_codegen::math;
use naga::MathFunction;

/// `f` on words as signed integers.
fn signed<const N: usize>(f: impl Fn([i32; N]) -> i32) -> impl Fn([u32; N]) -> u32 {
    move |words| f(words.map(|w| w as i32)) as u32
}

impl<'m, M: Model> Machine<'m, M> {
    pub(super) fn integer_math(
        &self,
        frame: &Frame<'m, M>,
        fun: MathFunction,
        args: &[&[Leaf<M>]],
        is_signed: bool,
    ) -> Res<Vec<Leaf<M>>> {
        use MathFunction as F;
        match fun {
            F::Abs if is_signed => self.words(args, signed(|[a]| math::abs(a))),
            F::Abs => Ok(args[0].to_vec()),
            F::Sign => self.words(args, signed(|[a]| math::sign(a))),
            F::Min if is_signed => self.words(args, signed(|[a, b]| math::min(a, b))),
            F::Min => self.words(args, |[a, b]| math::min(a, b)),
            F::Max if is_signed => self.words(args, signed(|[a, b]| math::max(a, b))),
            F::Max => self.words(args, |[a, b]| math::max(a, b)),
            F::Clamp if is_signed => self.words(args, signed(|[a, low, high]| math::clamp(a, low, high))),
            F::Clamp => self.words(args, |[a, low, high]| math::clamp(a, low, high)),
            F::CountTrailingZeros => self.words(args, |[a]| math::count_trailing_zeros(a)),
            F::CountLeadingZeros => self.words(args, |[a]| math::count_leading_zeros(a)),
            F::CountOneBits => self.words(args, |[a]| math::count_one_bits(a)),
            F::ReverseBits => self.words(args, |[a]| math::reverse_bits(a)),
            F::FirstTrailingBit => self.words(args, |[a]| math::first_trailing_bit(a)),
            F::FirstLeadingBit if is_signed => self.words(args, signed(|[a]| math::first_leading_bit(a))),
            F::FirstLeadingBit => self.words(args, |[a]| math::first_leading_bit(a)),
            F::ExtractBits if is_signed => {
                self.words(args, |[a, at, n]| math::extract_bits(a as i32, at, n) as u32)
            }
            F::ExtractBits => self.words(args, |[a, at, n]| math::extract_bits(a, at, n)),
            F::InsertBits => self.words(args, |[a, bits, at, n]| math::insert_bits(a, bits, at, n)),
            F::Dot => {
                let y = args.get(1).ok_or(InterpError::Malformed("a dot product of one vector"))?;
                Ok(vec![self.dot_words(args[0], y)?])
            }
            F::Saturate
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
            | F::Unpack4xU8 => Err(frame.unsupported(format!("{fun:?} of integers"))),
        }
    }

    /// `f` of the words of `N` arguments; lone columns go with all columns of the first argument.
    fn words<const N: usize>(&self, args: &[&[Leaf<M>]], f: impl Fn([u32; N]) -> u32) -> Res<Vec<Leaf<M>>> {
        let component = |i: usize| -> Res<Leaf<M>> {
            let pick = |arg: &&[Leaf<M>]| arg.get(if arg.len() == 1 { 0 } else { i }).cloned();
            let leaves: Vec<_> = args.iter().filter_map(pick).collect();
            let words = leaves.iter().map(|l| l.words()).collect::<Res<Vec<_>>>()?;
            let words: [&[M::W]; N] = words
                .try_into()
                .map_err(|_| InterpError::Malformed("a built-in function lacks an argument"))?;
            Ok(Leaf::from_words((0..self.lanes).map(|l| self.word_n(words.map(|w| w[l]), &f)).collect()))
        };
        (0..args[0].len()).map(component).collect()
    }

    /// Applies `f` to what each word is on the f32 path and on the exact path.
    fn word_n<const N: usize>(&self, words: [M::W; N], f: &impl Fn([u32; N]) -> u32) -> M::W {
        let m = &self.model;
        let (value, exact) = (words.map(|w| m.word_value(w)), words.map(|w| m.word_exact(w)));
        let parts = m.word_parts(f(value), f(exact));
        if words.iter().all(|w| m.known(*w)) { parts } else { m.forget(parts) }
    }
}
