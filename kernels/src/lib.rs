//! The mathematics of spherical-Gaussian lighting, each function written once.
//!
//! Every kernel is an ordinary Rust function, and a definition that `lobe-codegen` turns into WGSL,
//! SPIR-V and HLSL.
//! One file a subject; [`registry`] is the only list of what is emitted.
//!
//! ```
//! use lobe_codegen::glam::Vec3;
//! use lobe_kernels::hsg::hsg_cosine_product_integral;
//! use lobe_kernels::sg::{Sg, sg_integral};
//!
//! // A light in the zenith that sends one unit of power per area: its lobe integrates to 1.
//! let log_amplitude = -sg_integral(1000.0).ln();
//! let light = Sg { axis: Vec3::Z, sharpness: 1000.0, log_amplitude };
//! // On a floor nearly all of it counts, on a floor that is tilted by 60 degrees half of it.
//! let tilted = Vec3::new(0.75_f32.sqrt(), 0.0, 0.5);
//! assert!((hsg_cosine_product_integral(light, Vec3::Z) - 1.0).abs() < 2e-3);
//! assert!((hsg_cosine_product_integral(light, tilted) - 0.5).abs() < 2e-3);
//! ```
//!
//! | file | what | sources |
//! |---|---|---|
//! | [`special`], [`constants`] | functions that shading languages lack; multiples of π | [Higham02] |
//! | [`sg`] | spherical Gaussians: value, integral, product | [Wang09], [Tokuyoshi22] |
//! | [`hsg`] | the same over a hemisphere, and against the clamped cosine: diffuse light | [Tokuyoshi22] |
//! | [`asg`] | anisotropic ones | [Xu13] |
//! | [`brdf`] | reflectance, its lobes, its sampling | [Walter07], [Heitz14] |
//! | [`filter`] | averages of lobes and positions | [Toksvig05], [Chan83] |
//! | [`vsgl`] | indirect light by virtual lights | [Tokuyoshi15], [Tokuyoshi15b] |
//! | [`rect`] | indirect light off a glossy rectangle | [RectGlossy], our own |
//! | [`reference`](mod@reference) | the truth by sampling | [Veach97], [Pharr23] |
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
//! Modules called `budget` hold what permitted errors are stated in: no kernel computes with it, and none of
//! it is emitted.
//!
//! Citations, as `[Wang09]`, are listed in [`references`](mod@references).

#[allow(unused_imports, reason = "citations link to them")]
use references::{
    Chan83, Heitz14, Higham02, Pharr23, RectGlossy, Toksvig05, Tokuyoshi15, Tokuyoshi15b, Tokuyoshi22,
    Veach97, Walter07, Wang09, Xu13,
};

pub mod asg;
pub mod brdf;
pub mod constants;
pub mod filter;
pub mod hsg;
pub mod rect;
pub mod reference;
pub mod references;
pub mod registry;
pub mod rsm;
pub mod scene;
pub mod sg;
pub mod special;
pub mod vsgl;
