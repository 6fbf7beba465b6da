//! The light of rectangles, and its layers.

use super::{Frame, Layer, Method, Picture};
use lobe_backends::executor::ExecError;
use lobe_codegen::glam::Vec3;
use lobe_kernels::rect::pixel::RectPixel;

impl Frame<'_, '_> {
    /// The light that `pass` finds; adds its layers and returns their sum.
    pub(super) fn rectangles(&mut self, pass: &str, picture: &mut Picture) -> Result<Vec<Vec3>, ExecError> {
        let pixels = self.pixels();
        self.room("indirect", pixels)?;
        self.dispatch(pass, pixels)?;
        self.rectangle_layers("novis", picture)
    }

    /// Adds the layers of what is found, with which surfaces hide others as a suffix, and returns their sum.
    pub(super) fn rectangle_layers(
        &self,
        suffix: &str,
        picture: &mut Picture,
    ) -> Result<Vec<Vec3>, ExecError> {
        let found: Vec<RectPixel> = self.pipeline.unpack("indirect", self.memory.bytes("indirect"))?;
        let mut add = |name: &str, of: fn(&RectPixel) -> Vec3| {
            let name = format!("indirect_{name}_{suffix}");
            picture.layers.push(Layer { name, pixels: found.iter().map(of).collect() });
        };
        add("specular_fromspec", |p| p.specular);
        add("diffuse_fromspec", |p| p.diffuse);
        add("diffuse", diffuse);
        if self.settings.method == Method::RectQuadrature {
            add("specular", specular);
            add("total", total);
        }
        Ok(found.iter().map(total).collect())
    }
}

fn diffuse(pixel: &RectPixel) -> Vec3 {
    pixel.diffuse + pixel.diffuse_of_diffuse
}

fn specular(pixel: &RectPixel) -> Vec3 {
    pixel.specular + pixel.specular_of_diffuse
}

fn total(pixel: &RectPixel) -> Vec3 {
    diffuse(pixel) + specular(pixel)
}
