//! The mathematics of spherical-Gaussian lighting, each function written once.
//!
//! Every kernel is an ordinary Rust function, and a definition that `lobe-codegen` turns into WGSL,
//! SPIR-V and HLSL.
//! One file a subject; [`registry`] is the only list.
//!
//! Conventions, everywhere: directions are unit vectors that point away from the point they are used
//! at; a spherical Gaussian is `G(w; v, k) = exp(log_amplitude + k (w·v - 1))`, its sharpness `k >= 0`;
//! integrals over directions are in steradian.
//!
//! Numerics, everywhere: the stated budget is what the derived rounding-error bound stays inside, for
//! any driver that keeps the accuracy rules of WGSL and Vulkan, over the stated domain; `lobe check`
//! derives and compares it.
//! Each kernel's documentation ends in that budget and the worst errors that `lobe measure` found, as shares of
//! it: of the derived bound, and of each route's results against the real value of the formula (of the exact
//! function, where the kernel approximates one).
//! Finite arguments inside the domain never give NaN.
//! For NaN or infinite arguments the shading languages promise nothing (a compiler may assume that
//! there are none): the native form then returns what its operations give in IEEE arithmetic, and a
//! driver may return any value, but does return.
//!
//! A form that a paper prints and that loses accuracy is kept beside the default as `.._paper` (or
//! under its author's name), marked as not robust with the reason.
//!
//! Citations, as `[Wang09]`, are listed in [`references`](mod@references).

pub mod asg;
pub mod brdf;
pub mod constants;
pub mod filter;
pub mod hsg;
pub mod rect;
pub mod reference;
pub mod references;
pub mod registry;
pub mod sg;
pub mod special;
pub mod vsgl;
