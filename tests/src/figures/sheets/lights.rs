//! Sheets of virtual lights: filtered lobes, bias and its reduction, the whole map as two lights.

use super::{Artist, Row, SAMPLES, SheetError, Tile, Tiles, rows, tile};
use crate::render::{Method, Picture, Settings, VirtualLights};
use lobe_backends::pipeline::Interpreted;
use lobe_codegen::prelude::{Vec3, exp};
use lobe_kernels::constants::PI;
use lobe_kernels::rsm::point::MapPoint;
use lobe_kernels::rsm::two::WholeLight;
use lobe_kernels::sg::sg_integral;
use lobe_kernels::vsgl::vsgl_light;

/// Pixels along a side.
const SIDE: u32 = 96;
/// The most lights of a picture that a test draws again.
const QUICK: u32 = 4096;
/// Lights whose sum stands beside two of the whole map.
const MANY: u32 = 16384;

impl Artist<'_> {
    /// Light by way of mirrors on a floor, rows of 256 and 1024 lights: with Gaussian lobes, of the texel and filtered; with GGX
    /// lobes, the same; the truth.
    pub(super) fn lobes(&self) -> Result<Tiles, SheetError> {
        let row = |count: u32| -> Result<Row, SheetError> {
            let of = |method, filters_lobes| {
                let lights =
                    VirtualLights { count, filters_lobes, smoothing: 0.25, ..VirtualLights::default() };
                self.of_layer("caustic_a002", method, lights, "indirect_diffuse_fromspec_la")
            };
            Ok(vec![
                of(Method::Vsgl, false)?,
                of(Method::Vsgl, true)?,
                of(Method::VslWide, false)?,
                of(Method::VslWide, true)?,
                of(Method::Reference, true)?,
            ])
        };
        let rows = [256, 1024].map(row);
        Ok(Tiles::new("lobes", rows.into_iter().collect::<Result<_, _>>()?))
    }

    /// Rows of 256, 4096 and 65536 lights: the share of lights whose lobes are given up, with Gaussian lobes alone and with that, points
    /// that are held at a distance, points, the truth.
    pub(super) fn bias(&self) -> Result<Tiles, SheetError> {
        let row = |(count, map): (u32, u32)| -> Result<Row, SheetError> {
            let lights = VirtualLights { count, map, smoothing: 1.0, ..VirtualLights::default() };
            let name = "plates_a010";
            let of = |method, lights| self.of_layer(name, method, lights, "indirect_total_la");
            Ok(vec![
                self.of_layer(name, Method::Vsgl, lights, "smooth_lights")?,
                of(Method::Vsgl, VirtualLights { bias: 0.0, ..lights })?,
                of(Method::Vsgl, lights)?,
                of(Method::Vpl, VirtualLights { least_distance: 0.5, ..lights })?,
                of(Method::Vpl, lights)?,
                of(Method::Reference, lights)?,
            ])
        };
        let rows = [(256, 256), (4096, 256), (65536, 1024)].map(row);
        Ok(Tiles::new("bias", rows.into_iter().collect::<Result<_, _>>()?))
    }

    /// Diffuse light of two lights of the whole map: with the cosine drawn out of the integral, as printed, by the hemispherical
    /// integral, and by many points; glossy light of the two, and by many points.
    pub(super) fn two_lights(&self) -> Result<Tiles, SheetError> {
        let row = |name: &str| -> Result<Row, SheetError> {
            let (diffuse, specular) = ("indirect_diffuse_la", "indirect_specular_la");
            let few = VirtualLights::default();
            let many = VirtualLights { count: MANY, ..few };
            Ok(vec![
                Some(self.drawn_out(name)?),
                self.of_layer(name, Method::Vsgl2Paper, few, diffuse)?,
                self.of_layer(name, Method::Vsgl2, few, diffuse)?,
                self.of_layer(name, Method::Vpl, many, diffuse)?,
                self.of_layer(name, Method::Vsgl2, few, specular)?,
                self.of_layer(name, Method::Vpl, many, specular)?,
            ])
        };
        Ok(Tiles::new("two_lights", rows(&["cornell_L0", "plates_a040"], row)?))
    }

    /// A layer by a method; none of one that takes long, where the truth is not asked for.
    fn of_layer(
        &self,
        name: &str,
        method: Method,
        lights: VirtualLights,
        layer: &str,
    ) -> Result<Option<Tile>, SheetError> {
        let is_quick = method != Method::Reference && lights.count <= QUICK;
        match is_quick || self.with_truth {
            true => Ok(Some(tile(&self.picture_of(name, method, lights)?, layer))),
            false => Ok(None),
        }
    }

    fn picture_of(&self, name: &str, method: Method, lights: VirtualLights) -> Result<Picture, SheetError> {
        let (mut scene, proxies) = self.scene(name)?;
        scene.camera.size = [SIDE; 2];
        let settings = Settings { method, samples: SAMPLES, virtual_lights: lights, ..Settings::default() };
        Ok(self.renderer.render(&scene, &proxies, &settings, &mut Interpreted::default(), &|_| {})?)
    }

    /// Diffuse light of the two lights, each with the cosine towards its middle in place of all.
    fn drawn_out(&self, name: &str) -> Result<Tile, SheetError> {
        let (mut scene, proxies) = self.scene(name)?;
        scene.camera.size = [SIDE; 2];
        let survey =
            self.renderer.survey(&scene, &proxies, &Settings::default(), &mut Interpreted::default())?;
        let pixel = |pixel: &MapPoint| {
            let each = survey.whole.iter().map(|whole| drawn_out(whole, pixel));
            each.sum::<Vec3>() * pixel.material.diffuse_albedo
        };
        Ok(survey.pixels.iter().map(pixel).collect())
    }
}

/// Radiance that a white pixel reflects of a light whose middle gives the cosine.
fn drawn_out(whole: &WholeLight, pixel: &MapPoint) -> Vec3 {
    let incoming = vsgl_light(whole.light, pixel.position);
    let sharpness = incoming.sharpness.min(1e7);
    let irradiance = (1.0 + sharpness) * sg_integral(sharpness) * incoming.density * exp(incoming.log_shift);
    let towards = (whole.light.mean - pixel.position).normalize_or_zero();
    whole.colour * (irradiance * towards.dot(pixel.normal).max(0.0) / PI)
}
