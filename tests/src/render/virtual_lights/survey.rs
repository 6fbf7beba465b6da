//! What a method of virtual lights knows of a light's map before it shines.

use super::{Frame, Mapped};
use crate::proxies::Proxies;
use crate::render::{Renderer, Settings, Uploaded};
use crate::scene::Scene;
use lobe_backends::executor::ExecError;
use lobe_backends::pipeline::Dispatcher;
use lobe_codegen::glam::Vec2;
use lobe_kernels::rsm::draw::drawn_share;
use lobe_kernels::rsm::point::MapPoint;
use lobe_kernels::rsm::two::WholeLight;

/// The map of a scene's first light, and what is seen of the scene.
#[derive(Debug, Clone)]
pub struct Survey {
    /// The map's texels, row by row from the top.
    pub texels: Vec<MapPoint>,
    /// Which share of the virtual lights each texel has, 1 together.
    pub shares: Vec<f32>,
    /// The camera's pixels, as points of power 1.
    pub pixels: Vec<MapPoint>,
    /// The whole map as two lights, diffuse and glossy.
    pub whole: Vec<WholeLight>,
}

impl Renderer {
    /// What virtual lights by these settings are drawn from, of the first light of `scene`.
    ///
    /// # Errors
    /// When a pass cannot be run by `dispatcher`.
    pub fn survey<'p>(
        &'p self,
        scene: &Scene,
        proxies: &Proxies,
        settings: &Settings,
        dispatcher: &mut dyn Dispatcher<'p>,
    ) -> Result<Survey, ExecError> {
        let uploaded = Uploaded::new(scene, proxies);
        let mapped = Mapped::new(&uploaded);
        let mut frame = Frame::new(&self.pipeline, uploaded, settings, dispatcher)?;
        frame.see()?;
        frame.survey(&mapped)
    }
}

impl Frame<'_, '_> {
    fn survey(&mut self, mapped: &Mapped) -> Result<Survey, ExecError> {
        self.camera_lights(mapped)?;
        let pixels = self.pipeline.unpack("map_points", self.memory.bytes("map_points"))?;
        let mut survey = Survey { texels: Vec::new(), shares: Vec::new(), pixels, whole: Vec::new() };
        let Some(light) = mapped.lights.first() else { return Ok(survey) };
        let origin = self.light_map(mapped, 0, light, 0)?;
        survey.texels = self.pipeline.unpack("map_points", self.memory.bytes("map_points"))?;
        self.weigh()?;
        survey.shares = self.shares()?;
        self.whole_lights(origin)?;
        survey.whole = self.pipeline.unpack("whole_lights", self.memory.bytes("whole_lights"))?;
        Ok(survey)
    }

    /// What the estimates of texels make of the number of lights.
    fn shares(&self) -> Result<Vec<f32>, ExecError> {
        let estimates: Vec<Vec2> = self.pipeline.unpack("estimates", self.memory.bytes("estimates"))?;
        let total = estimates
            .iter()
            .fold([0.0, 0.0], |[x, y], estimate| [x + f64::from(estimate.x), y + f64::from(estimate.y)]);
        let total = Vec2::from(total.map(|sum| sum as f32));
        let floor = self.settings.virtual_lights.floor();
        Ok(estimates.into_iter().map(|estimate| drawn_share(estimate, total, floor)).collect())
    }
}
