//! Executors and translators: everything that runs an emitted shader, or turns it into another language first.
//!
//! - [`translate`] holds foreign compilers (DXC) and validators (`spirv-val`).
//!
//! Each takes *artifacts*, the very text or words that a user of the emitted code gets, and know nothing of naga modules:
//! what they prove, they prove about the emission too.

pub mod translate;
