//! What is kept of several texels.

use crate::brdf::lobe::sg_ndf_warp;
use crate::brdf::model::{lambert_brdf, microfacet_reflectance};
use crate::constants::PI;
use crate::filter::{Moments, moments_empty, moments_merge, moments_of_lobe};
use crate::reference::running_mean::luminance;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::Tokuyoshi15;
use crate::rsm::point::MapPoint;
use crate::sg::sg_integral;
use lobe_codegen::prelude::*;

/// The mean of the texels of a square.
#[kernel]
pub struct MapMean {
    /// Of the positions, weighted by the power that they reflect.
    pub positions: Moments,
    /// Of the glossy lobes, weighted by theirs.
    pub lobes: Moments,
    /// Of the unit normals times the weight of their positions.
    pub normal: Vec3,
    /// How much of the square is in the map.
    #[domain(0.0..=1.0)]
    pub cover: f32,
    /// Power times the diffuse lobe's BRDF, linear RGB, in W/sr.
    pub diffuse: Vec3,
    /// Power times the integral of the glossy lobe's BRDF, linear RGB, in W.
    pub specular: Vec3,
}

/// The mean of no texel.
#[kernel]
pub fn map_mean_nothing() -> MapMean {
    MapMean {
        positions: moments_empty(),
        lobes: moments_empty(),
        normal: Vec3::ZERO,
        cover: 0.0,
        diffuse: Vec3::ZERO,
        specular: Vec3::ZERO,
    }
}

/// What a map's lights send of: both lobes, or one of them.
#[kernel]
pub const OF_BOTH: u32 = 0;
/// Only the diffuse lobes, each of sharpness 2 about its normal.
#[kernel]
pub const OF_DIFFUSE: u32 = 1;
/// Only the glossy lobes.
#[kernel]
pub const OF_GLOSSY: u32 = 2;

/// The mean of one texel.
///
/// The glossy lobe is [`sg_ndf_warp`] about the mirrored light, its other factors those of the mirror direction. The
/// positions within a texel are spread as in a square of its area: 1/6 of that.
/// Source: [Tokuyoshi15] section 3.2; the spread within a texel is our own.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `vpl` | the texel | | |
/// | `origin` | where positions are counted from | -1e4 ..= 1e4 | m |
/// | `part` | [`OF_BOTH`], [`OF_DIFFUSE`] or [`OF_GLOSSY`] | 0 ..= 2 | 1 |
///
/// Returns the mean. A texel that shows nothing has weight 0.
#[kernel]
pub fn map_mean_of(vpl: MapPoint, origin: Vec3, part: u32) -> MapMean {
    let material = vpl.material;
    let lobe = sg_ndf_warp(vpl.normal, vpl.dir, material.alpha);
    let peak =
        microfacet_reflectance(material.f0, material.f90, material.alpha, vpl.normal, vpl.dir, lobe.axis);
    let diffuse = select(vpl.flux * lambert_brdf(material.diffuse_albedo), Vec3::ZERO, part == OF_GLOSSY);
    let glossy = select(sg_integral(lobe.sharpness) * (vpl.flux * peak), Vec3::ZERO, part == OF_DIFFUSE);
    let of_diffuse = PI * luminance(diffuse);
    let of_glossy = luminance(glossy);
    let weight = of_diffuse + max(dot(vpl.normal, vpl.dir), 0.0) * of_glossy;
    let directions = if part == OF_DIFFUSE {
        moments_of_lobe(vpl.normal, 2.0, of_diffuse, Vec3::ZERO)
    } else {
        moments_of_lobe(lobe.axis, min(lobe.sharpness, 1e6), of_glossy, Vec3::ZERO)
    };
    MapMean {
        positions: Moments { weight, mean: vpl.position - origin, spread: vpl.area / 6.0 },
        lobes: directions,
        normal: weight * vpl.normal,
        cover: 1.0,
        diffuse,
        specular: glossy,
    }
}

/// A mean that counts for less.
#[kernel]
pub fn map_mean_share(mean: MapMean, share: f32) -> MapMean {
    MapMean {
        positions: Moments { weight: share * mean.positions.weight, ..mean.positions },
        lobes: Moments { weight: share * mean.lobes.weight, ..mean.lobes },
        normal: share * mean.normal,
        cover: share * mean.cover,
        diffuse: share * mean.diffuse,
        specular: share * mean.specular,
    }
}

/// Two means together, each as much as it counts: a step of the chain.
///
/// Source: [Tokuyoshi15] section 3.2.
#[kernel]
pub fn map_mean_add(a: MapMean, b: MapMean) -> MapMean {
    MapMean {
        positions: moments_merge(a.positions, b.positions),
        lobes: moments_merge(a.lobes, b.lobes),
        normal: a.normal + b.normal,
        cover: a.cover + b.cover,
        diffuse: a.diffuse + b.diffuse,
        specular: a.specular + b.specular,
    }
}

/// A mean in parts of four numbers.
#[kernel]
pub struct PackedMean {
    /// Four numbers each.
    pub parts: [Vec4; 5],
}

/// A mean, packed.
#[kernel]
pub fn map_mean_pack(mean: MapMean) -> PackedMean {
    let positions = mean.positions;
    let lobes = mean.lobes;
    PackedMean {
        parts: [
            Vec4::new(positions.mean.x, positions.mean.y, positions.mean.z, positions.weight),
            Vec4::new(lobes.mean.x, lobes.mean.y, lobes.mean.z, lobes.weight),
            Vec4::new(mean.normal.x, mean.normal.y, mean.normal.z, positions.spread),
            Vec4::new(mean.diffuse.x, mean.diffuse.y, mean.diffuse.z, lobes.spread),
            Vec4::new(mean.specular.x, mean.specular.y, mean.specular.z, mean.cover),
        ],
    }
}

/// What was packed.
#[kernel]
pub fn map_mean_unpack(bundle: PackedMean) -> MapMean {
    let a = bundle.parts[0];
    let b = bundle.parts[1];
    let c = bundle.parts[2];
    let d = bundle.parts[3];
    let e = bundle.parts[4];
    MapMean {
        positions: Moments { weight: a.w, mean: Vec3::new(a.x, a.y, a.z), spread: c.w },
        lobes: Moments { weight: b.w, mean: Vec3::new(b.x, b.y, b.z), spread: d.w },
        normal: Vec3::new(c.x, c.y, c.z),
        cover: e.w,
        diffuse: Vec3::new(d.x, d.y, d.z),
        specular: Vec3::new(e.x, e.y, e.z),
    }
}
