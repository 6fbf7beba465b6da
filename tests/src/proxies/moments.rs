//! Area, middle, spread and mean normal of triangles: sums, so that regions are merged without their triangles.

use super::{Deviation, Limits};
use crate::scene::Triangle;
use lobe_codegen::glam::{DMat3, DVec3};
use std::iter::Sum;
use std::ops::Add;

/// Integrals over triangles.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Moments {
    /// `∫ dA`, m².
    pub(super) area: f64,
    /// `∫ x dA`.
    first: DVec3,
    /// `∫ x xᵀ dA`.
    second: DMat3,
    /// `∫ n dA`.
    normal: DVec3,
}

/// A plane through a point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plane {
    pub(super) point: DVec3,
    /// Of length one.
    pub(super) normal: DVec3,
}

/// Area of a triangle, m².
pub(super) fn area(triangle: &Triangle) -> f64 {
    let [a, b, c] = triangle.vertices.map(|vertex| vertex.as_dvec3());
    0.5 * (b - a).cross(c - a).length()
}

impl Moments {
    pub(super) fn of(triangle: &Triangle) -> Self {
        let corners = triangle.vertices.map(|vertex| vertex.as_dvec3());
        let (area, sum) = (area(triangle), corners.into_iter().sum::<DVec3>());
        let outer = |x: DVec3| DMat3::from_cols(x * x.x, x * x.y, x * x.z);
        // ∫ x xᵀ over a triangle: area / 12 (Σ v vᵀ + (Σ v) (Σ v)ᵀ).
        let second = corners.into_iter().map(outer).fold(outer(sum), |all, one| all + one) * (area / 12.0);
        Self { area, first: sum * (area / 3.0), second, normal: area * triangle.normal.as_dvec3() }
    }

    /// Through the middle, across the mean normal; where normals cancel, across one of the axes.
    pub(super) fn plane(&self) -> Plane {
        Plane { point: self.first / self.area, normal: self.normal.try_normalize().unwrap_or(DVec3::Y) }
    }

    /// Area as it is seen along the mean normal, m².
    pub(super) fn seen(&self) -> f64 {
        self.normal.length()
    }

    /// Area that a plane misrepresents, m²: all of it counts once where it is the permitted distance off, and once where its
    /// normals are the permitted angle off.
    pub(super) fn error(&self, limits: &Limits) -> f64 {
        let Plane { point, normal } = self.plane();
        let square = (normal.dot(self.second * normal) / self.area - normal.dot(point).powi(2)).max(0.0);
        let turned = (1.0 - self.normal.length() / self.area).max(0.0);
        self.area * (square / limits.distance.powi(2) + turned / (1.0 - limits.least_cosine))
    }
}

impl Add for Moments {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            area: self.area + other.area,
            first: self.first + other.first,
            second: self.second + other.second,
            normal: self.normal + other.normal,
        }
    }
}

impl Sum for Moments {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(Self::default(), Self::add)
    }
}

impl Plane {
    /// How far a point is on the side of the normal, m.
    pub(super) fn height(&self, point: DVec3) -> f64 {
        (point - self.point).dot(self.normal)
    }

    /// How far triangles are from it.
    pub(super) fn deviation<'a>(&self, triangles: impl Iterator<Item = &'a Triangle>) -> Deviation {
        let (mut max, mut squares, mut total, mut cosine) = (0f64, 0.0, 0.0, 1f64);
        for triangle in triangles {
            let heights = triangle.vertices.map(|vertex| self.height(vertex.as_dvec3()).abs());
            let weight = area(triangle);
            max = heights.into_iter().fold(max, f64::max);
            squares += weight * heights.into_iter().map(|h| h * h).sum::<f64>() / 3.0;
            total += weight;
            cosine = cosine.min(triangle.normal.as_dvec3().dot(self.normal));
        }
        let rms = (squares / total).sqrt();
        Deviation {
            max: max as f32,
            rms: rms as f32,
            angle_deg: cosine.clamp(-1.0, 1.0).acos().to_degrees() as f32,
        }
    }
}
