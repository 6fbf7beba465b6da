//! Built-in functions.

use super::error::{Fault, Internal, Result};
use super::exec::{Executor, Frame};
use super::expr::{f1, f2, map, zip};
use super::matrix::dot;
use super::model::{Comparison, F1, F2, F3, Model};
use super::value::Column;
use lobe_codegen::math as native;
use naga::{Expression, Handle, MathFunction as M3, TypeInner};

/// How a function treats its arguments.
enum Form {
    /// Each component by itself.
    One(F1),
    Two(F2),
    Three(F3),
    /// Integers, each by itself: `(bits, signed)`.
    Bits(fn(u32, bool) -> u32),
    /// A formula over whole vectors.
    Geometric,
    /// Not here.
    Missing,
}

fn form(fun: M3) -> Form {
    match fun {
        M3::Abs => Form::One(F1::Abs),
        M3::Min => Form::Two(F2::Min),
        M3::Max => Form::Two(F2::Max),
        M3::Clamp => Form::Three(F3::Clamp),
        M3::Saturate => Form::One(F1::Saturate),
        M3::Cos => Form::One(F1::Cos),
        M3::Cosh => Form::One(F1::Cosh),
        M3::Sin => Form::One(F1::Sin),
        M3::Sinh => Form::One(F1::Sinh),
        M3::Tan => Form::One(F1::Tan),
        M3::Tanh => Form::One(F1::Tanh),
        M3::Acos => Form::One(F1::Acos),
        M3::Asin => Form::One(F1::Asin),
        M3::Atan => Form::One(F1::Atan),
        M3::Atan2 => Form::Two(F2::Atan2),
        M3::Asinh => Form::One(F1::Asinh),
        M3::Acosh => Form::One(F1::Acosh),
        M3::Atanh => Form::One(F1::Atanh),
        M3::Radians => Form::One(F1::Radians),
        M3::Degrees => Form::One(F1::Degrees),
        M3::Ceil => Form::One(F1::Ceil),
        M3::Floor => Form::One(F1::Floor),
        M3::Round => Form::One(F1::Round),
        M3::Fract => Form::One(F1::Fract),
        M3::Trunc => Form::One(F1::Trunc),
        M3::Exp => Form::One(F1::Exp),
        M3::Exp2 => Form::One(F1::Exp2),
        M3::Log => Form::One(F1::Log),
        M3::Log2 => Form::One(F1::Log2),
        M3::Pow => Form::Two(F2::Pow),
        M3::Sign => Form::One(F1::Sign),
        M3::Fma => Form::Three(F3::Fma),
        M3::Mix => Form::Three(F3::Mix),
        M3::Step => Form::Two(F2::Step),
        M3::SmoothStep => Form::Three(F3::SmoothStep),
        M3::Sqrt => Form::One(F1::Sqrt),
        M3::InverseSqrt => Form::One(F1::InverseSqrt),
        M3::CountTrailingZeros => Form::Bits(|x, _| native::count_trailing_zeros(x)),
        M3::CountLeadingZeros => Form::Bits(|x, _| native::count_leading_zeros(x)),
        M3::CountOneBits => Form::Bits(|x, _| native::count_one_bits(x)),
        M3::ReverseBits => Form::Bits(|x, _| native::reverse_bits(x)),
        M3::FirstTrailingBit => Form::Bits(|x, _| native::first_trailing_bit(x)),
        M3::FirstLeadingBit => Form::Bits(|x, signed| {
            if signed { native::first_leading_bit(x as i32) as u32 } else { native::first_leading_bit(x) }
        }),
        M3::Dot
        | M3::Cross
        | M3::Distance
        | M3::Length
        | M3::Normalize
        | M3::FaceForward
        | M3::Reflect
        | M3::Refract
        | M3::Transpose
        | M3::ExtractBits
        | M3::InsertBits => Form::Geometric,
        M3::Modf
        | M3::Frexp
        | M3::Ldexp
        | M3::Dot4I8Packed
        | M3::Dot4U8Packed
        | M3::Outer
        | M3::Inverse
        | M3::Determinant
        | M3::QuantizeToF16
        | M3::Pack4x8snorm
        | M3::Pack4x8unorm
        | M3::Pack2x16snorm
        | M3::Pack2x16unorm
        | M3::Pack2x16float
        | M3::Pack4xI8
        | M3::Pack4xU8
        | M3::Pack4xI8Clamp
        | M3::Pack4xU8Clamp
        | M3::Unpack4x8snorm
        | M3::Unpack4x8unorm
        | M3::Unpack2x16snorm
        | M3::Unpack2x16unorm
        | M3::Unpack2x16float
        | M3::Unpack4xI8
        | M3::Unpack4xU8 => Form::Missing,
    }
}

impl<'m, M: Model> Executor<'m, M> {
    pub(super) fn math(
        &mut self,
        frame: &mut Frame<'m, M>,
        fun: M3,
        handles: [Option<Handle<Expression>>; 4],
    ) -> Result<Vec<Column<M>>> {
        let first = handles[0].ok_or(Internal::Kind)?;
        let signed = self.is_signed(frame, first);
        let inner = self.inner(frame, first);
        let mut args = Vec::new();
        for handle in handles.into_iter().flatten() {
            args.push(self.value(frame, handle)?);
        }
        let is_word = matches!(args[0][0], Column::W(_));
        match form(fun) {
            _ if is_word && matches!(fun, M3::Abs | M3::Min | M3::Max | M3::Clamp | M3::Sign) => {
                (0..args[0].len()).map(|i| integer(fun, &column_of(&args, i), signed)).collect()
            }
            Form::One(op) => args[0].iter().map(|c| f1(op, c)).collect(),
            Form::Two(op) => args[0].iter().zip(args[1].iter()).map(|(a, b)| f2(op, a, b)).collect(),
            Form::Three(op) => (0..args[0].len()).map(|i| three(op, &column_of(&args, i))).collect(),
            Form::Bits(f) => args[0]
                .iter()
                .map(|c| Ok(Column::W(map(c.words()?, |x| M::w1(x, |x| f(x, signed))))))
                .collect(),
            Form::Geometric => {
                let args: Vec<&[Column<M>]> = args.iter().map(|a| a.as_slice()).collect();
                geometric(fun, &args, inner, signed)
            }
            Form::Missing => Err(Fault::Unsupported(format!("the function {fun:?}"))),
        }
    }
}

/// Component `i` of each argument; a scalar argument is its only one.
fn column_of<M: Model>(args: &[super::value::Value<M>], i: usize) -> Vec<Column<M>> {
    args.iter().map(|a| a[if a.len() == 1 { 0 } else { i }].clone()).collect()
}

fn three<M: Model>(op: F3, args: &[Column<M>]) -> Result<Column<M>> {
    let f = M::f3(op);
    let (x, y, z) = (args[0].floats()?, args[1].floats()?, args[2].floats()?);
    Ok(Column::F((0..x.len()).map(|i| f(x[i], y[i], z[i])).collect()))
}

fn integer<M: Model>(fun: M3, args: &[Column<M>], signed: bool) -> Result<Column<M>> {
    let x = args[0].words()?;
    let lesser: fn(u32, u32) -> u32 = if signed { |a, b| (a as i32).min(b as i32) as u32 } else { u32::min };
    let greater: fn(u32, u32) -> u32 = if signed { |a, b| (a as i32).max(b as i32) as u32 } else { u32::max };
    let pair = |x: &[M::W], y: &Column<M>, f: fn(u32, u32) -> u32| -> Result<Vec<M::W>> {
        Ok(zip(x, y.words()?, |x, y| M::w2(x, y, f)))
    };
    Ok(Column::W(match fun {
        M3::Abs if signed => map(x, |x| M::w1(x, |x| (x as i32).wrapping_abs() as u32)),
        M3::Sign if signed => map(x, |x| M::w1(x, |x| (x as i32).signum() as u32)),
        M3::Min => pair(x, &args[1], lesser)?,
        M3::Max => pair(x, &args[1], greater)?,
        M3::Clamp => pair(&pair(x, &args[1], greater)?, &args[2], lesser)?,
        _ => x.to_vec(),
    }))
}

fn geometric<M: Model>(
    fun: M3,
    args: &[&[Column<M>]],
    inner: &TypeInner,
    signed: bool,
) -> Result<Vec<Column<M>>> {
    let x = args[0];
    let y = args.get(1).copied().unwrap_or(&[]);
    let z = args.get(2).copied().unwrap_or(&[]);
    match fun {
        M3::Dot => Ok(vec![dot(x, y)?]),
        M3::Length => Ok(vec![length(x)?]),
        M3::Distance => Ok(vec![length(&each(F2::Subtract, x, y)?)?]),
        M3::Normalize => {
            let l = length(x)?;
            x.iter().map(|c| f2(F2::Divide, c, &l)).collect()
        }
        M3::Cross => cross(x, y),
        M3::Reflect => {
            let twice = f2(F2::Multiply, &constant(2.0, x)?, &dot(y, x)?)?;
            each(F2::Subtract, x, &scaled(y, &twice)?)
        }
        M3::Refract => refract(x, y, &z[0]),
        M3::FaceForward => {
            let negative = x.iter().map(|c| f1(F1::Negate, c)).collect::<Result<Vec<_>>>()?;
            let d = dot(z, y)?;
            let zero = constant::<M>(0.0, x)?;
            let faces = zip(d.floats()?, zero.floats()?, |d, zero| M::compare(Comparison::Less, d, zero));
            x.iter().zip(&negative).map(|(x, n)| Column::select(&faces, x, n)).collect()
        }
        M3::Transpose => match *inner {
            TypeInner::Matrix { columns, rows, .. } => {
                let (columns, rows) = (columns as usize, rows as usize);
                Ok((0..rows * columns).map(|i| x[(i % columns) * rows + i / columns].clone()).collect())
            }
            _ => Err(Internal::Kind.into()),
        },
        M3::ExtractBits => bits(x, &[y, z], |x, rest| {
            if signed {
                native::extract_bits(x as i32, rest[0], rest[1]) as u32
            } else {
                native::extract_bits(x, rest[0], rest[1])
            }
        }),
        M3::InsertBits => {
            bits(x, &[y, z, args[3]], |x, rest| native::insert_bits(x, rest[0], rest[1], rest[2]))
        }
        _ => Err(Internal::Kind.into()),
    }
}

/// A function of integers; scalar arguments meet every component.
fn bits<M: Model>(
    x: &[Column<M>],
    rest: &[&[Column<M>]],
    f: impl Fn(u32, &[u32]) -> u32,
) -> Result<Vec<Column<M>>> {
    let component = |i: usize| {
        let lanes = x[i].words()?;
        let others =
            rest.iter().map(|r| r[if r.len() == 1 { 0 } else { i }].words()).collect::<Result<Vec<_>>>()?;
        let lane = |k: usize| {
            let exact: Vec<u32> = others.iter().map(|o| M::word_value(o[k])).collect();
            others.iter().fold(M::w1(lanes[k], |x| f(x, &exact)), |out, o| M::w2(out, o[k], |out, _| out))
        };
        Ok(Column::W((0..lanes.len()).map(lane).collect()))
    };
    (0..x.len()).map(component).collect()
}

fn constant<M: Model>(value: f32, like: &[Column<M>]) -> Result<Column<M>> {
    Ok(Column::F(vec![M::float(value, value.into()); like[0].floats()?.len()]))
}

fn each<M: Model>(op: F2, x: &[Column<M>], y: &[Column<M>]) -> Result<Vec<Column<M>>> {
    x.iter().zip(y).map(|(x, y)| f2(op, x, y)).collect()
}

fn scaled<M: Model>(x: &[Column<M>], by: &Column<M>) -> Result<Vec<Column<M>>> {
    x.iter().map(|x| f2(F2::Multiply, x, by)).collect()
}

fn length<M: Model>(x: &[Column<M>]) -> Result<Column<M>> {
    f1(F1::Sqrt, &dot(x, x)?)
}

fn cross<M: Model>(x: &[Column<M>], y: &[Column<M>]) -> Result<Vec<Column<M>>> {
    [(1, 2), (2, 0), (0, 1)]
        .iter()
        .map(|&(i, j)| {
            let (a, b) = (f2(F2::Multiply, &x[i], &y[j])?, f2(F2::Multiply, &x[j], &y[i])?);
            f2(F2::Subtract, &a, &b)
        })
        .collect()
}

/// `z x - (z dot(y, x) + sqrt(k)) y`, `k = 1 - z z (1 - dot(y, x)²)`; zero where `k < 0`.
fn refract<M: Model>(x: &[Column<M>], y: &[Column<M>], eta: &Column<M>) -> Result<Vec<Column<M>>> {
    let (zero, one) = (constant::<M>(0.0, x)?, constant::<M>(1.0, x)?);
    let d = dot(y, x)?;
    let sine = f2(F2::Subtract, &one, &f2(F2::Multiply, &d, &d)?)?;
    let k = f2(F2::Subtract, &one, &f2(F2::Multiply, &f2(F2::Multiply, eta, eta)?, &sine)?)?;
    let along = f2(F2::Add, &f2(F2::Multiply, eta, &d)?, &f1(F1::Sqrt, &k)?)?;
    let bent = each(F2::Subtract, &scaled(x, eta)?, &scaled(y, &along)?)?;
    let total = zip(k.floats()?, zero.floats()?, |k, zero| M::compare(Comparison::Less, k, zero));
    bent.iter().map(|b| Column::select(&total, &zero, b)).collect()
}
