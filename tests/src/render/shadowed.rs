//! Methods of rectangles with shadows: one rectangle after the other, by as many pixels as their rays have room.

use super::{Frame, Method, Picture};
use lobe_backends::executor::ExecError;
use lobe_codegen::glam::Vec3;
use lobe_kernels::rect::shadow::{SHADOW_RAYS, ShadowTurn};
use lobe_kernels::rect::soft_shadow::{SOFT_PARTS, SOFT_RAYS};

/// Rays of a turn, at most, of several pixels: each takes 48 bytes, and drivers bind 128 MiB at least.
const ROUND: u32 = 1 << 20;

/// How a method asks for what is in the way.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shadows {
    /// The pass that makes rays.
    rays: &'static str,
    /// Its invocations for each pixel and light.
    parts: u32,
    /// Rays of each invocation.
    each: u32,
    /// The pass that adds the light.
    adds: &'static str,
}

impl Shadows {
    /// That of a method; none for one that has no shadows to ask for.
    pub(super) fn of(method: Method) -> Option<Self> {
        match method {
            Method::RectLaplace => Some(Self {
                rays: "rect_shadow_ray_pass",
                parts: 1,
                each: SHADOW_RAYS,
                adds: "rect_shadowed_pass",
            }),
            Method::RectQuadrature => Some(Self {
                rays: "rect_soft_ray_pass",
                parts: SOFT_PARTS,
                each: SOFT_RAYS,
                adds: "rect_soft_pass",
            }),
            _ => None,
        }
    }
}

impl Frame<'_, '_> {
    /// The light of the rectangles that nothing keeps off; adds its layers and returns their sum.
    pub(super) fn shadowed(
        &mut self,
        shadows: Shadows,
        slacks: &[f32],
        picture: &mut Picture,
        progress: &dyn Fn(f32),
    ) -> Result<Vec<Vec3>, ExecError> {
        let pixels = self.pixels();
        self.room("indirect", pixels)?;
        let band = (ROUND / (shadows.parts * shadows.each * self.lights.max(1))).clamp(1, pixels);
        for (at, slack) in slacks.iter().enumerate() {
            for first in (0..pixels).step_by(band as usize) {
                let count = band.min(pixels - first);
                self.turn(shadows, ShadowTurn { index: at as u32, slack: *slack, first, count })?;
                let done = at as f32 + (first + count) as f32 / pixels as f32;
                progress(done / slacks.len() as f32);
            }
        }
        self.rectangle_layers("vis", picture)
    }

    /// Adds a rectangle's light to some pixels.
    fn turn(&mut self, shadows: Shadows, turn: ShadowTurn) -> Result<(), ExecError> {
        let invocations = shadows.parts * turn.count * self.lights;
        let rays = shadows.each * invocations;
        self.memory.put("turn", self.pipeline.pack("turn", &[turn])?);
        self.room("shadow_rays", rays)?;
        self.room("visible", rays)?;
        self.dispatch(shadows.rays, invocations)?;
        self.dispatch("shadow_pass", rays)?;
        self.dispatch(shadows.adds, turn.count)
    }
}
