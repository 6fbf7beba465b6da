//! One-bounce glossy interreflection from a rectangle: a closed form by a Laplace approximation that knows
//! the rectangle's edges.
//!
//! A GGX rectangle reflects a directional light towards a pixel, which reflects it to the viewer:
//!
//! `L = E M_r M_x cos_i ∫ D_r(h_r) D_x(h_x) (n_x·w)+ cos_y / d² dA(y)`
//!
//! over the rectangle; `w` is the direction from the pixel to `y`, `d` the distance, `h_r` the half vector of
//! the light and `-w`, `h_x` that of `w` and the view, `E` the irradiance on a plane that faces the light, `M` the
//! reflectances without their distributions (Fresnel and shadowing over the usual denominators).
//! No lobe is fitted and nothing is replaced by a disk: the integrand itself is evaluated, at one spot, and
//! multiplied by an effective area.
//! All is algebra: no loop, no trigonometric function, one exponential per evaluation for a receiver whose
//! distribution is a spherical Gaussian and none for a GGX receiver.
//! The derivation is our own; no paper has it.
//!
//! # Derivation
//!
//! **Coordinates.** In the rectangle's frame a spot is seen under `w = (u, -v)`, `v` being the cosine at the
//! rectangle. Moving the spot by `δ` in the plane and measuring `δ/d` makes derivatives plain: the reflector's half
//! vector has the slope `s = (i - u)/(i_z + v)` from the rectangle's normal, with derivative
//! `K (a u' - 1)`, `K = 1/(i_z + v)`, `a = i - i_z s`, and determinant `K² v (1 + s²)/(2 K)`; the receiver's half
//! vector likewise, in two tangents of the pixel ([`evaluate`](rect_laplace_receiver_slope)).
//!
//! **Weights.** `-log D` of GGX as a function of the squared slope `q` is concave, so it lies below each of its
//! tangents: with the weight `w = 4 (1 - m²)/((m² + q)(1 + q))` the form `w J'J` is a second derivative that is positive
//! definite everywhere, also far out in the tail, where the true one is not. The sum of both distributions' forms and
//! of the cosine's, `κκ'`, is the form `Λ`; the gradient is exact.
//!
//! **Search.** The start is the weighted sum of the two mirror directions (of the light at the rectangle, of the
//! view at the pixel), met with the plane and clamped to the rectangle. A spot below the pixel's horizon is moved
//! towards the corner that is highest above it. One Gauss-Newton step on `-log (f v⁴)` follows: Newton in x
//! with y eliminated, then y, x and y in turn, each clamped to the edges. The fast kernels leave the step out.
//!
//! **Area.** Along each axis the integrand is taken for `(1 + S (2 b x + a x²))^(-3/2)` in the coordinate
//! `x = 2 tan(angle/2)` from the spot, which makes lobes symmetric and all limits finite; `a` and `b` are a third of
//! the second derivative and of the gradient. The integral to an edge is elementary for any sign of the
//! discriminant, [`rect_laplace_half_width`]. `S` slides from 1 at the peak to a value further out that depends on how far
//! the reflector's distribution makes the peak: a pure Gaussian, a pure GGX and two equal GGX lobes need different
//! ones to keep their energy. Two axes are joined by a Schur complement with the variance that the edges leave; both orders
//! of integration are taken and their geometric mean, or, in the fast kernels, the order in which more of the lobe is
//! seen.
//!
//! # What an engine computes when
//!
//! | once for each | function | scalar operations |
//! |---|---|---|
//! | rectangle | [`rect_laplace_bitangent`] | 9 |
//! | rectangle and light | [`rect_laplace_reflector`] | 21 |
//! | pixel and rectangle | [`rect_laplace_receiver`] | 100 |
//! | pixel, rectangle and light | [`rect_laplace_integral`] | 712 |
//! | | [`rect_laplace_integral_sg`] | 721 |
//! | | [`rect_laplace_fast_integral`] | 421 |
//! | | [`rect_laplace_fast_integral_sg`] | 425 |
//!
//! The integrals return the direction of the spot, too, at which an engine evaluates its `M_r` and `M_x`.
//! [`rect_laplace`] and its variants do everything for one pixel, with constant reflectances.
//! Counted in the lowered module, every component's operation by itself; the tests hold the counts.
//!
//! # Accuracy
//!
//! Against a numerical integral, as the factor `exp(mean |log(result/integral)|)`, on the 197 lit scenes of the oracle's
//! table; the disk method is off by a factor of 2.1 there (2.4 for the spherical Gaussian receiver) in its corrected form,
//! and by 25 (35) as printed:
//!
//! | kernel | factor | median ratio | 5 .. 95 % | least, greatest | within 1.25 |
//! |---|---|---|---|---|---|
//! | `rect_laplace` | 1.056 | 1.018 | 0.89 .. 1.11 | 0.76, 1.36 | 97 % |
//! | `rect_laplace_sg` | 1.058 | 1.009 | 0.87 .. 1.14 | 0.68, 1.38 | 97 % |
//! | `rect_laplace_fast` | 1.100 | 1.008 | 0.73 .. 1.15 | 0.09, 1.51 | 89 % |
//! | `rect_laplace_fast_sg` | 1.110 | 0.999 | 0.75 .. 1.14 | 0.07, 1.49 | 90 % |
//!
//! A test holds the factors.
//!
//! # Limits
//!
//! - A full lobe inside a large rectangle comes out a few per cent too bright, a peak off the rectangle more.
//! - Two narrow lobes far apart (view far off, peak outside) are not one mode: the fast kernels then return a small part of
//!   the integral, and the full ones may, too.
//! - A long diagonal lobe (light far from the normal) that a corner cuts is too bright.
//! - Far in the tail of a spherical Gaussian receiver the relative error has no limit. Prefer the GGX receiver.
//! - The choice of the corner in lifting a spot, and in the fast kernels that of the order, are the only jumps.
//! - No visibility, one directional light.

mod budget;
mod evaluate;
mod frame;
mod integral;
mod radiance;
mod search;
mod split;
mod width;

pub use budget::*;
pub use evaluate::*;
pub use frame::*;
pub use integral::*;
pub use radiance::*;
pub use search::*;
pub use split::*;
pub use width::*;
