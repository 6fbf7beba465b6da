//! Imperfect shadow maps: what hides a virtual light, by points on the surfaces in a small map for each light.
//!
//! | file | what |
//! |---|---|
//! | [`blocker`] | points on the surfaces, drawn by area |
//! | [`share`] | how many of them each light has |
//! | [`splat`] | where they are in the light's map, and the nearest of each texel |
//! | [`fill`] | texels that no point fell in |
//! | [`lookup`] | whether what a pixel's texel has hides it |
//!
//! All points are one set, in an order of which every run covers all surfaces evenly. Each light takes a run of its own,
//! so lights have disjoint points until the set is used up, and then begin again. [Tokuyoshi15] says how many points a
//! light has, and not which.
//!
//! A map is a square of directions about the light's normal, mirrored in a paraboloid ([`splat::parabolic`]), with levels of
//! ever larger squares. A point is in the level whose squares are as large as it is. Buffers have level after level, of
//! each the maps of a turn's lights one after the other.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::Tokuyoshi15;

pub mod blocker;
pub mod fill;
pub mod lookup;
pub mod share;
pub mod splat;
