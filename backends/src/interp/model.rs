//! What a lane's numbers are.
//!
//! The machine that runs programs (`judge`) is the same for all models; a model says what a
//! float, an integer and a boolean are and what each scalar operation does.
//! [`Strict`](super::strict::Strict) holds plain numbers, [`Shadow`](super::shadow::Shadow) carries the set
//! of values that permitted drivers may have, [`Perturbed`](super::perturbed::Perturbed) is one such driver,
//! drawn by chance.
//!
//! Operations whose accuracy is inherited from a formula have that formula as their default.

use super::formula;
use super::program::Scalar;
use crate::texture::{Format, Known};
use naga::SubgroupOperation;

/// Which of two operands' values and exact values a join takes: `true` for the first one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pick {
    pub(super) value: bool,
    pub(super) exact: bool,
}

macro_rules! operations {
    (required { $($(#[$doc:meta])* $name:ident($($arg:ident)*);)* } formulas { $($derived:ident($($darg:ident)*);)* }) => {
        /// The scalar operations; see the module's documentation.
        ///
        /// Integers are their bits, whether signed or not, as registers of programs hold them; a scalar that a model has
        /// no numbers for is one of them.
        pub(super) trait Model {
            /// Whether decisions can be ambiguous and values unknown.
            const SHADOW: bool;
            /// Whether it has numbers for floats of 16 and 64 bits; else these are words.
            const ALL_WIDTHS: bool;
            /// A float lane.
            type F: Copy;
            /// An integer lane.
            type W: Copy;
            /// A boolean lane.
            type B: Copy;

            /// Whether it has numbers for floats of this type.
            fn has(scalar: Scalar) -> bool {
                scalar == Scalar::F32 || (Self::ALL_WIDTHS && scalar.float())
            }

            /// The same model for floats of 16 bits, if it has numbers for them. The lanes of floats of all widths are
            /// of one type; operations are those of the width that the model is for.
            type Half: Model<F = Self::F, W = Self::W, B = Self::B>;
            /// The same for floats of 64 bits.
            type Double: Model<F = Self::F, W = Self::W, B = Self::B>;
            fn half(&self) -> Self::Half;
            fn double(&self) -> Self::Double;

            /// A float that is `value` in f32 and `exact` in truth.
            fn float(&self, value: f32, exact: f64) -> Self::F;
            /// A float that is `value` in f32, and of which `known` tells what drivers may have.
            fn ranged(&self, value: f32, known: Known) -> Self::F;
            /// What drivers may have of a float.
            fn range(&self, a: Self::F) -> Known {
                Known::point(self.exact(a))
            }
            /// The texel of these numbers, as their bits.
            fn texel(&self, format: Format, numbers: [u64; 4]) -> u128 {
                format.encode(numbers)
            }
            /// A float of another width.
            fn converted(&self, a: Self::F, from: Scalar) -> Self::F;
            /// The same float, of which nothing is promised.
            fn unpromised(&self, a: Self::F) -> Self::F;
            fn value(&self, a: Self::F) -> f32;
            fn exact(&self, a: Self::F) -> f64;
            /// The float `a`, of which the exact value is `truth`.
            fn with_truth(&self, a: Self::F, truth: f64) -> Self::F;
            /// What drivers may make of `all` numbers, in whatever order; `strict` is what the interpreter does.
            fn collected(&self, op: SubgroupOperation, all: &[Self::F], strict: Self::F) -> Self::F {
                let _ = (op, all);
                strict
            }
            fn join_f(&self, a: Self::F, b: Self::F, pick: Pick) -> Self::F;

            fn word(&self, value: u64) -> Self::W;
            fn word_value(&self, a: Self::W) -> u64;
            fn word_exact(&self, a: Self::W) -> u64;
            fn known(&self, a: Self::W) -> bool;
            /// A word that is `value` on the f32 path and `exact` on the exact one; known if these agree.
            fn word_parts(&self, value: u64, exact: u64) -> Self::W;
            /// The same word, but any other value is possible too.
            fn forget(&self, a: Self::W) -> Self::W;
            fn map_w(&self, a: Self::W, f: impl Fn(u64) -> u64) -> Self::W;
            fn zip_w(&self, a: Self::W, b: Self::W, f: impl Fn(u64, u64) -> u64) -> Self::W;
            fn join_w(&self, a: Self::W, b: Self::W, pick: Pick) -> Self::W;

            fn boolean(&self, value: bool) -> Self::B;
            fn decision(&self, a: Self::B) -> bool;
            fn decision_exact(&self, a: Self::B) -> bool;
            fn ambiguous(&self, a: Self::B) -> bool;
            fn join_b(&self, a: Self::B, b: Self::B, pick: Pick) -> Self::B;
            fn not(&self, a: Self::B) -> Self::B;
            fn and(&self, a: Self::B, b: Self::B) -> Self::B;
            fn xor(&self, a: Self::B, b: Self::B) -> Self::B;
            fn or(&self, a: Self::B, b: Self::B) -> Self::B {
                self.not(self.and(self.not(a), self.not(b)))
            }

            fn compare_w(&self, a: Self::W, b: Self::W, f: impl Fn(u64, u64) -> bool) -> Self::B;
            fn less(&self, a: Self::F, b: Self::F) -> Self::B;
            fn less_equal(&self, a: Self::F, b: Self::F) -> Self::B;
            fn equal(&self, a: Self::F, b: Self::F) -> Self::B;
            fn is_nan(&self, a: Self::F) -> Self::B;
            fn is_inf(&self, a: Self::F) -> Self::B;

            /// The integer of this type that is nearest to `a`, towards zero.
            fn to_word(&self, a: Self::F, to: Scalar) -> Self::W;
            /// The number that `a` is as an integer of this type.
            fn to_float(&self, a: Self::W, from: Scalar) -> Self::F;
            fn bits(&self, a: Self::F) -> Self::W;
            fn float_of_bits(&self, a: Self::W) -> Self::F;

            $(
                $(#[$doc])*
                fn $name(&self, $($arg: Self::F),*) -> Self::F;
            )*
            $(
                fn $derived(&self, $($darg: Self::F),*) -> Self::F
                where
                    Self: Sized,
                {
                    formula::$derived(self, $($darg),*)
                }
            )*

            /// The float nearest to a constant of a formula.
            fn constant(&self, exact: f64) -> Self::F {
                self.float(exact as f32, exact)
            }

            /// `a * a`, both factors being the same number.
            fn square(&self, a: Self::F) -> Self::F {
                self.mul(a, a)
            }

            /// `a`, of which a decision has told that it is not negative.
            fn nonnegative(&self, a: Self::F) -> Self::F {
                a
            }

            /// `a`, a result of a function: a model may look once more at what it knows of it.
            fn settled(&self, a: Self::F) -> Self::F {
                a
            }

            /// `accept` if `condition` holds, otherwise `reject`.
            fn select_f(&self, condition: Self::B, accept: Self::F, reject: Self::F) -> Self::F {
                let pick = Pick { value: self.decision(condition), exact: self.decision_exact(condition) };
                if self.ambiguous(condition) {
                    self.join_f(accept, reject, pick)
                } else if pick.value {
                    accept
                } else {
                    reject
                }
            }
        }
    };
}

operations! {
    required {
        add(a b);
        sub(a b);
        mul(a b);
        div(a b);
        /// `a % b`, with the sign of `a`
        rem(a b);
        neg(a);
        abs(a);
        min(a b);
        max(a b);
        sign(a);
        ceil(a);
        floor(a);
        round(a);
        trunc(a);
        fract(a);
        /// 1 if `edge <= x`
        step(edge x);
        sqrt(a);
        inverse_sqrt(a);
        exp(a);
        exp2(a);
        log(a);
        log2(a);
        sin(a);
        cos(a);
        atan(a);
        atan2(y x);
    }
    formulas {
        clamp(x low high);
        saturate(x);
        pow(x y);
        tan(x);
        asin(x);
        acos(x);
        sinh(x);
        cosh(x);
        tanh(x);
        asinh(x);
        acosh(x);
        atanh(x);
        degrees(x);
        radians(x);
        length(x);
        fma(x y z);
        mix(x y t);
        smoothstep(low high x);
    }
}
