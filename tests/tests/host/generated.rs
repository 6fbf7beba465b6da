// Written by Lobe 0.1.0. Do not edit.
// Needs the crate `bytemuck` with its feature `derive`.

/// A spherical Gaussian `G(w) = exp(log_amplitude + sharpness (w·axis - 1))`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Sg {
    /// Unit vector to the peak; the zero vector where products of opposite lobes have no axis.
    pub axis: [f32; 3],
    /// Sharpness, at least 0; 0 is the constant lobe.
    pub sharpness: f32,
    /// Natural logarithm of the value at the peak.
    pub log_amplitude: f32,
    #[doc(hidden)]
    pub _pad0: [u32; 3],
}

const _: () = {
    assert!(core::mem::size_of::<Sg>() == 32);
    assert!(core::mem::offset_of!(Sg, axis) == 0);
    assert!(core::mem::offset_of!(Sg, sharpness) == 12);
    assert!(core::mem::offset_of!(Sg, log_amplitude) == 16);
    assert!(core::mem::offset_of!(Sg, _pad0) == 20);
};

/// An anisotropic spherical Gaussian
/// `G(w) = amplitude max(w·z, 0) exp(-lambda (w·x)² - mu (w·y)²)`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Asg {
    /// Unit vector to the peak.
    pub z: [f32; 3],
    #[doc(hidden)]
    pub _pad0: [u32; 1],
    /// Unit tangent, perpendicular to `z`.
    pub x: [f32; 3],
    #[doc(hidden)]
    pub _pad1: [u32; 1],
    /// Unit bitangent, `cross(z, x)`.
    pub y: [f32; 3],
    /// Bandwidth along `x`, at least 0.
    pub lambda: f32,
    /// Bandwidth along `y`, at least 0.
    pub mu: f32,
    /// Value at the peak.
    pub amplitude: f32,
    #[doc(hidden)]
    pub _pad2: [u32; 2],
}

const _: () = {
    assert!(core::mem::size_of::<Asg>() == 64);
    assert!(core::mem::offset_of!(Asg, z) == 0);
    assert!(core::mem::offset_of!(Asg, _pad0) == 12);
    assert!(core::mem::offset_of!(Asg, x) == 16);
    assert!(core::mem::offset_of!(Asg, _pad1) == 28);
    assert!(core::mem::offset_of!(Asg, y) == 32);
    assert!(core::mem::offset_of!(Asg, lambda) == 44);
    assert!(core::mem::offset_of!(Asg, mu) == 48);
    assert!(core::mem::offset_of!(Asg, amplitude) == 52);
    assert!(core::mem::offset_of!(Asg, _pad2) == 56);
};

/// Three unit vectors, perpendicular to each other, right-handed.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Frame {
    /// Tangent.
    pub x: [f32; 3],
    #[doc(hidden)]
    pub _pad0: [u32; 1],
    /// Bitangent, `cross(z, x)`.
    pub y: [f32; 3],
    #[doc(hidden)]
    pub _pad1: [u32; 1],
    /// Normal.
    pub z: [f32; 3],
    #[doc(hidden)]
    pub _pad2: [u32; 1],
}

const _: () = {
    assert!(core::mem::size_of::<Frame>() == 48);
    assert!(core::mem::offset_of!(Frame, x) == 0);
    assert!(core::mem::offset_of!(Frame, _pad0) == 12);
    assert!(core::mem::offset_of!(Frame, y) == 16);
    assert!(core::mem::offset_of!(Frame, _pad1) == 28);
    assert!(core::mem::offset_of!(Frame, z) == 32);
    assert!(core::mem::offset_of!(Frame, _pad2) == 44);
};

/// A diffuse and a glossy lobe over each other, linear RGB.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Material {
    /// Share of the light that the diffuse lobe reflects.
    pub diffuse_albedo: [f32; 3],
    #[doc(hidden)]
    pub _pad0: [u32; 1],
    /// Reflectance of the glossy lobe's facets at normal incidence.
    pub f0: [f32; 3],
    /// Theirs at grazing incidence; 0 where there is no glossy lobe.
    pub f90: f32,
    /// Width of the GGX distribution, `alpha`.
    pub alpha: f32,
    #[doc(hidden)]
    pub _pad1: [u32; 3],
}

const _: () = {
    assert!(core::mem::size_of::<Material>() == 48);
    assert!(core::mem::offset_of!(Material, diffuse_albedo) == 0);
    assert!(core::mem::offset_of!(Material, _pad0) == 12);
    assert!(core::mem::offset_of!(Material, f0) == 16);
    assert!(core::mem::offset_of!(Material, f90) == 28);
    assert!(core::mem::offset_of!(Material, alpha) == 32);
    assert!(core::mem::offset_of!(Material, _pad1) == 36);
};

/// A rectangle that reflects on the side that its normal points to.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Rectangle {
    /// Of its middle.
    pub position: [f32; 3],
    #[doc(hidden)]
    pub _pad0: [u32; 1],
    /// Unit normal of the reflecting side.
    pub normal: [f32; 3],
    #[doc(hidden)]
    pub _pad1: [u32; 1],
    /// Unit vector along the first pair of sides; the second pair is along `cross(normal, tangent)`.
    pub tangent: [f32; 3],
    /// Half the extent along the tangent.
    pub half_x: f32,
    /// Half the extent across.
    pub half_y: f32,
    #[doc(hidden)]
    pub _pad2: [u32; 3],
}

const _: () = {
    assert!(core::mem::size_of::<Rectangle>() == 64);
    assert!(core::mem::offset_of!(Rectangle, position) == 0);
    assert!(core::mem::offset_of!(Rectangle, _pad0) == 12);
    assert!(core::mem::offset_of!(Rectangle, normal) == 16);
    assert!(core::mem::offset_of!(Rectangle, _pad1) == 28);
    assert!(core::mem::offset_of!(Rectangle, tangent) == 32);
    assert!(core::mem::offset_of!(Rectangle, half_x) == 44);
    assert!(core::mem::offset_of!(Rectangle, half_y) == 48);
    assert!(core::mem::offset_of!(Rectangle, _pad2) == 52);
};

/// The place where a rectangle's plane mirrors a distant light to a position.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct SpecularPeak {
    /// The place, which may lie outside the rectangle.
    pub position: [f32; 3],
    #[doc(hidden)]
    pub _pad0: [u32; 1],
    /// Unit direction in which the light leaves it.
    pub reflected: [f32; 3],
    /// Its distance from the position; 0 or negative for one that is not on the reflecting side.
    pub dist: f32,
}

const _: () = {
    assert!(core::mem::size_of::<SpecularPeak>() == 32);
    assert!(core::mem::offset_of!(SpecularPeak, position) == 0);
    assert!(core::mem::offset_of!(SpecularPeak, _pad0) == 12);
    assert!(core::mem::offset_of!(SpecularPeak, reflected) == 16);
    assert!(core::mem::offset_of!(SpecularPeak, dist) == 28);
};

/// An anisotropic lobe that stands for a disk, and the disk's half extents.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct DiskLobe {
    /// Unit vector to the peak.
    pub z: [f32; 3],
    #[doc(hidden)]
    pub _pad0: [u32; 1],
    /// Unit tangent, perpendicular to `z`.
    pub x: [f32; 3],
    #[doc(hidden)]
    pub _pad1: [u32; 1],
    /// Unit bitangent, `cross(z, x)`.
    pub y: [f32; 3],
    /// Half extent of the disk along `x` over its distance.
    pub half_x: f32,
    /// Half extent along `y`.
    pub half_y: f32,
    /// Bandwidth along `x`.
    pub lambda: f32,
    /// Bandwidth along `y`.
    pub mu: f32,
    /// Value at the peak.
    pub amplitude: f32,
}

const _: () = {
    assert!(core::mem::size_of::<DiskLobe>() == 64);
    assert!(core::mem::offset_of!(DiskLobe, z) == 0);
    assert!(core::mem::offset_of!(DiskLobe, _pad0) == 12);
    assert!(core::mem::offset_of!(DiskLobe, x) == 16);
    assert!(core::mem::offset_of!(DiskLobe, _pad1) == 28);
    assert!(core::mem::offset_of!(DiskLobe, y) == 32);
    assert!(core::mem::offset_of!(DiskLobe, half_x) == 44);
    assert!(core::mem::offset_of!(DiskLobe, half_y) == 48);
    assert!(core::mem::offset_of!(DiskLobe, lambda) == 52);
    assert!(core::mem::offset_of!(DiskLobe, mu) == 56);
    assert!(core::mem::offset_of!(DiskLobe, amplitude) == 60);
};

/// Weight, mean and spread of lobes or of positions.
///
/// Of positions the spread is the trace of their covariance; of lobes, one less the square of the length of
/// their mean direction.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Moments {
    /// Sum of the weights, or their average: only ratios matter.
    pub weight: f32,
    #[doc(hidden)]
    pub _pad0: [u32; 3],
    /// Weighted mean, less the origin or the reference direction that the caller has chosen.
    pub mean: [f32; 3],
    /// Weighted mean square of the distances from the mean; for lobes together with their widths.
    pub spread: f32,
}

const _: () = {
    assert!(core::mem::size_of::<Moments>() == 32);
    assert!(core::mem::offset_of!(Moments, weight) == 0);
    assert!(core::mem::offset_of!(Moments, _pad0) == 4);
    assert!(core::mem::offset_of!(Moments, mean) == 16);
    assert!(core::mem::offset_of!(Moments, spread) == 28);
};

/// A glossy rectangle under one directional light.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Reflector {
    /// Roughness `alpha` of its GGX distribution.
    pub alpha: f32,
    /// Value of its reflectance without the distribution.
    pub reflectance: f32,
    #[doc(hidden)]
    pub _pad0: [u32; 2],
    /// Unit direction to the light.
    pub light: [f32; 3],
    /// Irradiance on a plane that faces the light.
    pub irradiance: f32,
}

const _: () = {
    assert!(core::mem::size_of::<Reflector>() == 32);
    assert!(core::mem::offset_of!(Reflector, alpha) == 0);
    assert!(core::mem::offset_of!(Reflector, reflectance) == 4);
    assert!(core::mem::offset_of!(Reflector, _pad0) == 8);
    assert!(core::mem::offset_of!(Reflector, light) == 16);
    assert!(core::mem::offset_of!(Reflector, irradiance) == 28);
};

/// A position on a glossy surface that sees the rectangle, and who looks at it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct GlossyReceiver {
    /// The position.
    pub position: [f32; 3],
    #[doc(hidden)]
    pub _pad0: [u32; 1],
    /// Unit normal of the surface.
    pub normal: [f32; 3],
    #[doc(hidden)]
    pub _pad1: [u32; 1],
    /// Unit direction to the viewer.
    pub view: [f32; 3],
    /// GGX alpha of the surface.
    pub alpha: f32,
    /// Its BRDF without the distribution: Fresnel and shadowing over four cosines.
    pub reflectance: f32,
    #[doc(hidden)]
    pub _pad2: [u32; 3],
}

const _: () = {
    assert!(core::mem::size_of::<GlossyReceiver>() == 64);
    assert!(core::mem::offset_of!(GlossyReceiver, position) == 0);
    assert!(core::mem::offset_of!(GlossyReceiver, _pad0) == 12);
    assert!(core::mem::offset_of!(GlossyReceiver, normal) == 16);
    assert!(core::mem::offset_of!(GlossyReceiver, _pad1) == 28);
    assert!(core::mem::offset_of!(GlossyReceiver, view) == 32);
    assert!(core::mem::offset_of!(GlossyReceiver, alpha) == 44);
    assert!(core::mem::offset_of!(GlossyReceiver, reflectance) == 48);
    assert!(core::mem::offset_of!(GlossyReceiver, _pad2) == 52);
};

/// Constants of a distribution of roughness `alpha`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Gloss {
    /// `alpha²`, with `alpha` clamped to 0.002 ..= 0.98.
    pub square: f32,
    /// `1 - alpha²`.
    pub rest: f32,
}

const _: () = {
    assert!(core::mem::size_of::<Gloss>() == 8);
    assert!(core::mem::offset_of!(Gloss, square) == 0);
    assert!(core::mem::offset_of!(Gloss, rest) == 4);
};

/// A reflector in the frame of its rectangle: computed once for each rectangle and light.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct LaplaceReflector {
    /// Unit direction to the light, in the frame.
    pub light: [f32; 3],
    /// Its distribution.
    pub gloss: Gloss,
    /// Weight of the view's mirror direction where the search begins.
    pub pull: f32,
    /// `4 alpha²/π²` times the light's cosine.
    pub peak: f32,
    #[doc(hidden)]
    pub _pad0: [u32; 1],
}

const _: () = {
    assert!(core::mem::size_of::<LaplaceReflector>() == 32);
    assert!(core::mem::offset_of!(LaplaceReflector, light) == 0);
    assert!(core::mem::offset_of!(LaplaceReflector, gloss) == 12);
    assert!(core::mem::offset_of!(LaplaceReflector, pull) == 20);
    assert!(core::mem::offset_of!(LaplaceReflector, peak) == 24);
    assert!(core::mem::offset_of!(LaplaceReflector, _pad0) == 28);
};

/// A receiver in the frame of a rectangle: computed once for each pixel and rectangle, for any number of
/// lights.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct LaplaceReceiver {
    /// The pixel, from the rectangle's middle.
    pub offset: [f32; 3],
    /// Square of its height above the rectangle's plane.
    pub height2: f32,
    /// Unit normal.
    pub facing: [f32; 3],
    #[doc(hidden)]
    pub _pad0: [u32; 1],
    /// The viewer's direction, mirrored about the normal.
    pub mirror: [f32; 3],
    /// Cosine of the view.
    pub cosine: f32,
    /// The viewer's direction along the pixel's surface, by its two tangents.
    pub view: [f32; 2],
    #[doc(hidden)]
    pub _pad1: [u32; 2],
    /// Two tangents of the pixel's surface, `(xx, xy, facing.x)` and `(xy, yy, facing.y)`: xx, yy, xy.
    pub tangents: [f32; 3],
    /// Weight of the light's mirror direction where the search begins; that of `mirror` is the reflector's.
    pub pull: f32,
    /// Its distribution.
    pub gloss: Gloss,
    /// Half the rectangle's extents.
    pub extent: [f32; 2],
    /// Where the edges of low and high x are, from the foot of the pixel's perpendicular.
    pub edges_x: [f32; 2],
    /// Where the edges of low and high y are.
    pub edges_y: [f32; 2],
    /// The corner of the rectangle that is highest above the pixel's horizon.
    pub corner: [f32; 2],
    /// Height of that corner above the horizon plane.
    pub top: f32,
    #[doc(hidden)]
    pub _pad2: [u32; 1],
}

const _: () = {
    assert!(core::mem::size_of::<LaplaceReceiver>() == 128);
    assert!(core::mem::offset_of!(LaplaceReceiver, offset) == 0);
    assert!(core::mem::offset_of!(LaplaceReceiver, height2) == 12);
    assert!(core::mem::offset_of!(LaplaceReceiver, facing) == 16);
    assert!(core::mem::offset_of!(LaplaceReceiver, _pad0) == 28);
    assert!(core::mem::offset_of!(LaplaceReceiver, mirror) == 32);
    assert!(core::mem::offset_of!(LaplaceReceiver, cosine) == 44);
    assert!(core::mem::offset_of!(LaplaceReceiver, view) == 48);
    assert!(core::mem::offset_of!(LaplaceReceiver, _pad1) == 56);
    assert!(core::mem::offset_of!(LaplaceReceiver, tangents) == 64);
    assert!(core::mem::offset_of!(LaplaceReceiver, pull) == 76);
    assert!(core::mem::offset_of!(LaplaceReceiver, gloss) == 80);
    assert!(core::mem::offset_of!(LaplaceReceiver, extent) == 88);
    assert!(core::mem::offset_of!(LaplaceReceiver, edges_x) == 96);
    assert!(core::mem::offset_of!(LaplaceReceiver, edges_y) == 104);
    assert!(core::mem::offset_of!(LaplaceReceiver, corner) == 112);
    assert!(core::mem::offset_of!(LaplaceReceiver, top) == 120);
    assert!(core::mem::offset_of!(LaplaceReceiver, _pad2) == 124);
};

/// The geometric part of the interreflection, and where it comes from.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct LaplaceIntegral {
    /// `cos ∫ D_r D_x cos cos dA/distance²`, without irradiance and reflectances.
    pub value: f32,
    #[doc(hidden)]
    pub _pad0: [u32; 3],
    /// Unit direction from the pixel to the spot that stands for the rectangle, in the rectangle's frame.
    pub dir: [f32; 3],
    #[doc(hidden)]
    pub _pad1: [u32; 1],
}

const _: () = {
    assert!(core::mem::size_of::<LaplaceIntegral>() == 32);
    assert!(core::mem::offset_of!(LaplaceIntegral, value) == 0);
    assert!(core::mem::offset_of!(LaplaceIntegral, _pad0) == 4);
    assert!(core::mem::offset_of!(LaplaceIntegral, dir) == 16);
    assert!(core::mem::offset_of!(LaplaceIntegral, _pad1) == 28);
};

/// A spot of the rectangle, as the pixel sees it.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct LaplaceSpot {
    /// Where it is on the rectangle, from its middle.
    pub at: [f32; 2],
    /// The same from the foot of the pixel's perpendicular.
    pub offset: [f32; 2],
    /// Distance from the pixel.
    pub reach: f32,
    #[doc(hidden)]
    pub _pad0: [u32; 1],
    /// Part of the direction to it along the rectangle.
    pub along: [f32; 2],
    /// Part of the direction to it against the rectangle's normal: the cosine at the rectangle.
    pub down: f32,
    /// Cosine at the pixel.
    pub cosine: f32,
}

const _: () = {
    assert!(core::mem::size_of::<LaplaceSpot>() == 40);
    assert!(core::mem::offset_of!(LaplaceSpot, at) == 0);
    assert!(core::mem::offset_of!(LaplaceSpot, offset) == 8);
    assert!(core::mem::offset_of!(LaplaceSpot, reach) == 16);
    assert!(core::mem::offset_of!(LaplaceSpot, _pad0) == 20);
    assert!(core::mem::offset_of!(LaplaceSpot, along) == 24);
    assert!(core::mem::offset_of!(LaplaceSpot, down) == 32);
    assert!(core::mem::offset_of!(LaplaceSpot, cosine) == 36);
};

/// Minus the logarithm of the integrand around a spot, to second order.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct LaplaceForm {
    /// Gradient.
    pub gradient: [f32; 2],
    #[doc(hidden)]
    pub _pad0: [u32; 2],
    /// Second derivatives xx, yy, xy.
    pub second: [f32; 3],
    #[doc(hidden)]
    pub _pad1: [u32; 1],
}

const _: () = {
    assert!(core::mem::size_of::<LaplaceForm>() == 32);
    assert!(core::mem::offset_of!(LaplaceForm, gradient) == 0);
    assert!(core::mem::offset_of!(LaplaceForm, _pad0) == 8);
    assert!(core::mem::offset_of!(LaplaceForm, second) == 16);
    assert!(core::mem::offset_of!(LaplaceForm, _pad1) == 28);
};

/// Slope of a half vector from a normal, and its derivatives as the spot moves.
///
/// The spot's movements are measured in the rectangle's plane, over the distance.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct LaplaceSlope {
    /// Squared slope, the squared tangent of the angle between half vector and normal.
    pub square: f32,
    #[doc(hidden)]
    pub _pad0: [u32; 1],
    /// Half the gradient of the squared slope, over `scale`.
    pub gradient: [f32; 2],
    /// Products xx, yy, xy of the slope's derivatives, over `scale²`.
    pub products: [f32; 3],
    /// Inverse of the half vector's component along the normal.
    pub scale: f32,
}

const _: () = {
    assert!(core::mem::size_of::<LaplaceSlope>() == 32);
    assert!(core::mem::offset_of!(LaplaceSlope, square) == 0);
    assert!(core::mem::offset_of!(LaplaceSlope, _pad0) == 4);
    assert!(core::mem::offset_of!(LaplaceSlope, gradient) == 8);
    assert!(core::mem::offset_of!(LaplaceSlope, products) == 16);
    assert!(core::mem::offset_of!(LaplaceSlope, scale) == 28);
};

/// How a distribution falls off at a slope.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct LaplaceFall {
    /// GGX: the root of the distribution over `alpha²/π`, less one; spherical Gaussian: the distribution over
    /// its peak.
    pub value: f32,
    /// Minus the derivative of its logarithm by half the squared slope.
    pub weight: f32,
}

const _: () = {
    assert!(core::mem::size_of::<LaplaceFall>() == 8);
    assert!(core::mem::offset_of!(LaplaceFall, value) == 0);
    assert!(core::mem::offset_of!(LaplaceFall, weight) == 4);
};

/// Both half vectors at a spot.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct LaplacePair {
    /// Slope of the reflector's.
    pub reflector: LaplaceSlope,
    /// How the reflector's distribution falls off there.
    pub reflector_fall: LaplaceFall,
    #[doc(hidden)]
    pub _pad0: [u32; 2],
    /// Slope of the receiver's.
    pub receiver: LaplaceSlope,
}

const _: () = {
    assert!(core::mem::size_of::<LaplacePair>() == 80);
    assert!(core::mem::offset_of!(LaplacePair, reflector) == 0);
    assert!(core::mem::offset_of!(LaplacePair, reflector_fall) == 32);
    assert!(core::mem::offset_of!(LaplacePair, _pad0) == 40);
    assert!(core::mem::offset_of!(LaplacePair, receiver) == 48);
};

/// A spot that is evaluated in full.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct LaplacePoint {
    /// The spot.
    pub spot: LaplaceSpot,
    #[doc(hidden)]
    pub _pad0: [u32; 2],
    /// Minus the logarithm of the integrand around it.
    pub local: LaplaceForm,
    /// Product of both distributions, without the constant factors of the reflector's.
    pub density: f32,
    /// Root of the determinant of the reflector's distribution alone.
    pub own: f32,
    #[doc(hidden)]
    pub _pad1: [u32; 2],
}

const _: () = {
    assert!(core::mem::size_of::<LaplacePoint>() == 96);
    assert!(core::mem::offset_of!(LaplacePoint, spot) == 0);
    assert!(core::mem::offset_of!(LaplacePoint, _pad0) == 40);
    assert!(core::mem::offset_of!(LaplacePoint, local) == 48);
    assert!(core::mem::offset_of!(LaplacePoint, density) == 80);
    assert!(core::mem::offset_of!(LaplacePoint, own) == 84);
    assert!(core::mem::offset_of!(LaplacePoint, _pad1) == 88);
};

/// Extents of the rectangle around a spot, inverse, in half-angle coordinates: `1/(2 tan(angle/2))` of the angle
/// from the spot to an edge.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct LaplaceExtent {
    /// To the edges of low and of high x.
    pub x: [f32; 2],
    /// To the edges of low and of high y.
    pub y: [f32; 2],
    /// `1/cos` of the angles along x and y at which the spot is seen.
    pub secant: [f32; 2],
}

const _: () = {
    assert!(core::mem::size_of::<LaplaceExtent>() == 24);
    assert!(core::mem::offset_of!(LaplaceExtent, x) == 0);
    assert!(core::mem::offset_of!(LaplaceExtent, y) == 8);
    assert!(core::mem::offset_of!(LaplaceExtent, secant) == 16);
};

/// The integrand's logarithm in half-angle coordinates.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct LaplaceAngles {
    /// Gradient.
    pub gradient: [f32; 2],
    /// Second derivatives xx and yy.
    pub second: [f32; 2],
    /// Square of the second derivative xy.
    pub mixed2: f32,
    /// How far the reflector's distribution makes the peak, 0 ..= 1.
    pub share: f32,
}

const _: () = {
    assert!(core::mem::size_of::<LaplaceAngles>() == 24);
    assert!(core::mem::offset_of!(LaplaceAngles, gradient) == 0);
    assert!(core::mem::offset_of!(LaplaceAngles, second) == 8);
    assert!(core::mem::offset_of!(LaplaceAngles, mixed2) == 16);
    assert!(core::mem::offset_of!(LaplaceAngles, share) == 20);
};

/// What is kept of a stream of numbers.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct RunningMean {
    /// How many there were.
    pub count: u32,
    /// Their mean.
    pub mean: f32,
    /// Sum of their squared differences from the mean.
    pub squares: f32,
}

const _: () = {
    assert!(core::mem::size_of::<RunningMean>() == 12);
    assert!(core::mem::offset_of!(RunningMean, count) == 0);
    assert!(core::mem::offset_of!(RunningMean, mean) == 4);
    assert!(core::mem::offset_of!(RunningMean, squares) == 8);
};

/// A viewed point, a rectangle, and a light.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct OneBounce {
    /// The viewed point.
    pub position: [f32; 3],
    #[doc(hidden)]
    pub _pad0: [u32; 1],
    /// Its unit normal.
    pub normal: [f32; 3],
    #[doc(hidden)]
    pub _pad1: [u32; 1],
    /// Unit direction from it to the viewer.
    pub view: [f32; 3],
    #[doc(hidden)]
    pub _pad2: [u32; 1],
    /// Its surface.
    pub material: Material,
    /// What reflects the light onto it.
    pub rectangle: Rectangle,
    /// The rectangle's surface.
    pub rectangle_material: Material,
    /// Unit direction from the rectangle to the light.
    pub light: [f32; 3],
    #[doc(hidden)]
    pub _pad3: [u32; 1],
}

const _: () = {
    assert!(core::mem::size_of::<OneBounce>() == 224);
    assert!(core::mem::offset_of!(OneBounce, position) == 0);
    assert!(core::mem::offset_of!(OneBounce, _pad0) == 12);
    assert!(core::mem::offset_of!(OneBounce, normal) == 16);
    assert!(core::mem::offset_of!(OneBounce, _pad1) == 28);
    assert!(core::mem::offset_of!(OneBounce, view) == 32);
    assert!(core::mem::offset_of!(OneBounce, _pad2) == 44);
    assert!(core::mem::offset_of!(OneBounce, material) == 48);
    assert!(core::mem::offset_of!(OneBounce, rectangle) == 96);
    assert!(core::mem::offset_of!(OneBounce, rectangle_material) == 160);
    assert!(core::mem::offset_of!(OneBounce, light) == 208);
    assert!(core::mem::offset_of!(OneBounce, _pad3) == 220);
};

/// What a rectangle makes of a distant light, wherever it is seen from.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Reflection {
    /// Unit direction from a position to its specular peak.
    pub axis: [f32; 3],
    #[doc(hidden)]
    pub _pad0: [u32; 1],
    /// The rectangle's normal without its part along the axis; as long as the sine of incidence.
    pub slant: [f32; 3],
    /// Cosine of incidence; 0 or negative for a light that does not shine on the reflecting side.
    pub cos_sigma: f32,
    /// Exponent of the falloff's fit.
    pub attenuation: f32,
    /// Radiance at the peak, in W m⁻² sr⁻¹.
    pub radiance: f32,
    #[doc(hidden)]
    pub _pad1: [u32; 2],
}

const _: () = {
    assert!(core::mem::size_of::<Reflection>() == 48);
    assert!(core::mem::offset_of!(Reflection, axis) == 0);
    assert!(core::mem::offset_of!(Reflection, _pad0) == 12);
    assert!(core::mem::offset_of!(Reflection, slant) == 16);
    assert!(core::mem::offset_of!(Reflection, cos_sigma) == 28);
    assert!(core::mem::offset_of!(Reflection, attenuation) == 32);
    assert!(core::mem::offset_of!(Reflection, radiance) == 36);
    assert!(core::mem::offset_of!(Reflection, _pad1) == 40);
};

/// A distant light.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct DistantLight {
    /// Unit direction to the light.
    pub direction: [f32; 3],
    /// Irradiance on a plane that faces the light, in W m⁻².
    pub irradiance: f32,
}

const _: () = {
    assert!(core::mem::size_of::<DistantLight>() == 16);
    assert!(core::mem::offset_of!(DistantLight, direction) == 0);
    assert!(core::mem::offset_of!(DistantLight, irradiance) == 12);
};

/// In what the forms of the shading differ.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct ShadeForm {
    /// The largest half extent of the disk over its distance.
    pub widest: f32,
    /// The largest share of the disk.
    pub fullest: f32,
    /// What the product with the surface's lobe takes of its sharpness.
    pub share: f32,
}

const _: () = {
    assert!(core::mem::size_of::<ShadeForm>() == 12);
    assert!(core::mem::offset_of!(ShadeForm, widest) == 0);
    assert!(core::mem::offset_of!(ShadeForm, fullest) == 4);
    assert!(core::mem::offset_of!(ShadeForm, share) == 8);
};

/// The shading of one position, step by step.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct RectShade {
    /// Height of the position over the rectangle's plane, in m.
    pub height: f32,
    #[doc(hidden)]
    pub _pad0: [u32; 3],
    /// The specular peak.
    pub peak: [f32; 3],
    /// Its distance, in m.
    pub dist: f32,
    /// Square of the sine of the angle under which the disk is seen.
    pub aperture: f32,
    /// Area of the rectangle around what disk and rectangle share, in m².
    pub bounds: f32,
    /// Share of the disk that the rectangle covers.
    pub coverage: f32,
    /// Energy that the disk sends, in W m⁻².
    pub energy: f32,
    /// Bandwidths of its lobe, across the plane of incidence and in it.
    pub lambda: f32,
    /// The other one.
    pub mu: f32,
    /// Value of the lobe at its peak, in W m⁻² sr⁻¹.
    pub amplitude: f32,
    #[doc(hidden)]
    pub _pad1: [u32; 1],
    /// Mirror direction of the viewer.
    pub mirror: [f32; 3],
    /// Sharpness of the surface's lobe about it.
    pub sharpness: f32,
    /// Product integral of both lobes, for amplitudes of 1, in sr.
    pub product: f32,
    /// Reflected radiance, in W m⁻² sr⁻¹.
    pub radiance: f32,
    #[doc(hidden)]
    pub _pad2: [u32; 2],
}

const _: () = {
    assert!(core::mem::size_of::<RectShade>() == 96);
    assert!(core::mem::offset_of!(RectShade, height) == 0);
    assert!(core::mem::offset_of!(RectShade, _pad0) == 4);
    assert!(core::mem::offset_of!(RectShade, peak) == 16);
    assert!(core::mem::offset_of!(RectShade, dist) == 28);
    assert!(core::mem::offset_of!(RectShade, aperture) == 32);
    assert!(core::mem::offset_of!(RectShade, bounds) == 36);
    assert!(core::mem::offset_of!(RectShade, coverage) == 40);
    assert!(core::mem::offset_of!(RectShade, energy) == 44);
    assert!(core::mem::offset_of!(RectShade, lambda) == 48);
    assert!(core::mem::offset_of!(RectShade, mu) == 52);
    assert!(core::mem::offset_of!(RectShade, amplitude) == 56);
    assert!(core::mem::offset_of!(RectShade, _pad1) == 60);
    assert!(core::mem::offset_of!(RectShade, mirror) == 64);
    assert!(core::mem::offset_of!(RectShade, sharpness) == 76);
    assert!(core::mem::offset_of!(RectShade, product) == 80);
    assert!(core::mem::offset_of!(RectShade, radiance) == 84);
    assert!(core::mem::offset_of!(RectShade, _pad2) == 88);
};

/// The cone of directions from a shading point to a spherical light.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Cone {
    /// In sr.
    pub solid_angle: f32,
    /// Of the lobe that stands for it, 4π over the solid angle.
    pub sharpness: f32,
    /// Solid angle over the area `π r²` of the light's disk.
    pub density: f32,
}

const _: () = {
    assert!(core::mem::size_of::<Cone>() == 12);
    assert!(core::mem::offset_of!(Cone, solid_angle) == 0);
    assert!(core::mem::offset_of!(Cone, sharpness) == 4);
    assert!(core::mem::offset_of!(Cone, density) == 8);
};

/// A virtual spherical-Gaussian light: radiant intensity `intensity G(w; axis, sharpness)`, from positions with
/// an isotropic Gaussian distribution.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct Vsgl {
    /// Mean of the positions.
    pub mean: [f32; 3],
    /// Variance of the positions along one axis.
    pub variance: f32,
    /// Unit axis of the emission.
    pub axis: [f32; 3],
    /// Sharpness of the emission.
    pub sharpness: f32,
    /// Radiant intensity along the axis.
    pub intensity: f32,
    #[doc(hidden)]
    pub _pad0: [u32; 3],
}

const _: () = {
    assert!(core::mem::size_of::<Vsgl>() == 48);
    assert!(core::mem::offset_of!(Vsgl, mean) == 0);
    assert!(core::mem::offset_of!(Vsgl, variance) == 12);
    assert!(core::mem::offset_of!(Vsgl, axis) == 16);
    assert!(core::mem::offset_of!(Vsgl, sharpness) == 28);
    assert!(core::mem::offset_of!(Vsgl, intensity) == 32);
    assert!(core::mem::offset_of!(Vsgl, _pad0) == 36);
};

/// Incoming radiance `(1 + sharpness) density e^log_shift G(w; axis, sharpness)`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
pub struct VsglLight {
    /// Unit axis, towards the light; shorter where the light faces away.
    pub axis: [f32; 3],
    /// Sharpness; without limit for a point light.
    pub sharpness: f32,
    /// Of extent against emission, at most 0.
    pub log_shift: f32,
    /// Radiance at the peak over `1 + sharpness`, before the shift.
    pub density: f32,
    #[doc(hidden)]
    pub _pad0: [u32; 2],
}

const _: () = {
    assert!(core::mem::size_of::<VsglLight>() == 32);
    assert!(core::mem::offset_of!(VsglLight, axis) == 0);
    assert!(core::mem::offset_of!(VsglLight, sharpness) == 12);
    assert!(core::mem::offset_of!(VsglLight, log_shift) == 16);
    assert!(core::mem::offset_of!(VsglLight, density) == 20);
    assert!(core::mem::offset_of!(VsglLight, _pad0) == 24);
};
