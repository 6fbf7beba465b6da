//! Interreflection: the light that a glossy rectangle reflects of a distant source onto a surface.
//!
//! Three methods, and a matt surface's share:
//!
//! - [`laplace`] is our own closed form: the integrand at one spot times an effective area. Against a
//!   numerical integral it is off by a factor of 1.06, where the other method, corrected, is off by 2.1.
//!   Prefer it where reflectances are constant: it is registered kernel by kernel, with a budget.
//! - [`quadrature`] looks at the whole integrand at nine places for each lobe: off by a factor of 1.04 where the closed form
//!   with a spot for each lobe is off by 1.19, and takes 1.2 times its time. Prefer it for pictures.
//! - The method of [RectGlossy] puts a disk about the specular peak in place of the rectangle, and a lobe in
//!   place of the disk. Prefer it where the lobe itself is wanted: it can be stored, and multiplied with any
//!   other lobe; and it costs about half as much.
//! - [`diffuse`] is for matt surfaces and matt rectangles, for which neither has a formula.
//!
//! The method of [RectGlossy], in the order of its steps:
//!
//! | step | file | kernels | differs from the paper in |
//! |---|---|---|---|
//! | radiance at the peak | [`energy`] | `rect_radiance` | the factor `1/(π m²)` that eq. 17 lacks; lights add, where eq. 15 has their mean |
//! | falloff around it, fitted | [`attenuation`] | `rect_attenuation`, `rect_falloff_fit` | nothing: they fit eq. 23 with the angle of eq. 24, which is wrong for slanting light (`rect_psi`, `rect_falloff`) |
//! | both, and the peak's direction | [`reflection`] | `rect_reflection` | nothing else |
//! | place of the peak | [`peak`] | `rect_specular_peak` | nothing |
//! | the disk's radius | [`disk`] | `rect_disk_radius` | a rule of our own: the paper leaves it open |
//! | share that the rectangle covers | [`disk`] | `rect_coverage_bounds` | eq. 36 exceeds 1; `rect_coverage` is exact |
//! | energy of the disk | [`energy`] | `rect_disk_energy` | the radius is taken over the distance; `rect_energy_ggx` needs no fit |
//! | its lobe | [`light`] | `rect_asg_from_disk` | half extents over the distance, at most 4 (eq. 32 turns negative) |
//! | one pixel | [`shade`] | `rect_shade` | half the sharpness in eq. 11, the mirror direction about the normal in eq. 8 |
//! | all of them | [`chain`] | `rect_shade_light` | nothing else |
//!
//! An engine calls `rect_reflection` once for each rectangle and light, `rect_disk_radius` and `rect_shade`
//! for each pixel. What is printed differently stands beside each as `.._paper`; [`angle`] has the angles and
//! logarithms that the languages leave imprecise, [`budget`] what the permitted errors are measured by.
//!
//! Conventions: lengths in m; a rectangle reflects on the side of its normal; directions point away from
//! where they are used, the light's to the light; `σ` is its angle of incidence on the rectangle; `m`,
//! `alpha`, is the width of a GGX distribution. Reflectances leave the distribution out. Nothing is shadowed.

pub mod angle;
pub mod attenuation;
pub mod budget;
pub mod chain;
pub mod diffuse;
pub mod disk;
pub mod energy;
pub mod field;
pub mod field_tree;
pub mod laplace;
pub mod light;
pub mod pass;
pub mod peak;
pub mod pixel;
pub mod quadrature;
pub mod reflection;
pub mod shade;
pub mod shadow;
pub mod soft_shadow;

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::RectGlossy;
use lobe_codegen::prelude::*;

/// A rectangle that reflects on the side that its normal points to.
#[kernel]
pub struct Rectangle {
    /// Of its middle.
    #[domain(-100.0..=100.0)]
    pub position: Vec3,
    /// Unit normal of the reflecting side.
    #[domain(unit)]
    pub normal: Vec3,
    /// Unit vector along the first pair of sides; the second pair is along `cross(normal, tangent)`.
    #[domain(normal_to(normal))]
    pub tangent: Vec3,
    /// Half the extent along the tangent.
    #[domain(1e-3..=100.0)]
    pub half_x: f32,
    /// Half the extent across.
    #[domain(1e-3..=100.0)]
    pub half_y: f32,
}

/// A position on a glossy surface that sees the rectangle, and who looks at it.
#[kernel]
pub struct GlossyReceiver {
    /// The position.
    #[domain(-1e4..=1e4)]
    pub position: Vec3,
    /// Unit normal of the surface.
    #[domain(unit)]
    pub normal: Vec3,
    /// Unit direction to the viewer.
    #[domain(unit)]
    pub view: Vec3,
    /// GGX alpha of the surface.
    #[domain(0.02..=1.0)]
    pub alpha: f32,
    /// Its BRDF without the distribution: Fresnel and shadowing over four cosines.
    #[domain(0.0..=100.0)]
    pub reflectance: f32,
}
