//! The closed form with shadows: one rectangle after the other.

use super::{Frame, Picture};
use lobe_backends::executor::ExecError;
use lobe_codegen::glam::Vec3;
use lobe_kernels::rect::shadow::{SHADOW_RAYS, ShadowTurn};

impl Frame<'_, '_> {
    /// The light of the rectangles that one point of each lets pass; adds its layers and returns their sum.
    pub(super) fn shadowed(
        &mut self,
        slacks: &[f32],
        picture: &mut Picture,
        progress: &dyn Fn(f32),
    ) -> Result<Vec<Vec3>, ExecError> {
        let pixels = self.pixels();
        let rays = SHADOW_RAYS * pixels * self.lights;
        self.room("shadow_rays", rays)?;
        self.room("visible", rays)?;
        self.room("indirect", pixels)?;
        for (at, slack) in slacks.iter().enumerate() {
            let turn = ShadowTurn { index: at as u32, slack: *slack };
            self.memory.put("turn", self.pipeline.pack("turn", &[turn])?);
            self.dispatch("rect_shadow_ray_pass", pixels * self.lights)?;
            self.dispatch("shadow_pass", rays)?;
            self.dispatch("rect_shadowed_pass", pixels)?;
            progress((at + 1) as f32 / slacks.len() as f32);
        }
        self.rectangle_layers("vis", picture)
    }
}
