//! The reference: rounds of samples until there are enough.

use super::{Frame, Layer, Picture};
use lobe_backends::executor::ExecError;
use lobe_codegen::glam::Vec3;
use lobe_kernels::reference::pass::{BounceRound, BounceSample};
use lobe_kernels::reference::running_mean::{RunningMean, running_mean_standard_error};

/// Samples of all pixels in a round, at most: their buffers take some 200 bytes each.
const ROUND: u32 = 1 << 18;

/// What is told apart by which shadows are cast, in the order of the kernel's modes.
const MODES: [&str; 4] = ["vis", "novis", "la", "ab"];

impl Frame<'_, '_> {
    /// The light of one bounce, by sampling; adds its layers and returns that with all shadows.
    pub(super) fn bounces(
        &mut self,
        picture: &mut Picture,
        progress: &dyn Fn(f32),
    ) -> Result<Vec<Vec3>, ExecError> {
        let pixels = self.pixels();
        let modes = MODES.len() as u32;
        self.room("means", pixels * modes)?;
        self.room("spreads", pixels * modes * 3)?;
        let samples = self.settings.samples.max(1);
        let mut first = 0;
        while first < samples {
            let round = (ROUND / pixels).clamp(1, samples - first);
            self.round(BounceRound { first, samples: round })?;
            first += round;
            progress(first as f32 / samples as f32);
        }
        self.layers(picture)
    }

    fn round(&mut self, part: BounceRound) -> Result<(), ExecError> {
        let pixels = self.pixels();
        let samples = pixels * part.samples;
        self.memory.put("part", self.pipeline.pack("part", &[part])?);
        self.room("bounces", samples)?;
        self.room("shadow_rays", 2 * samples)?;
        self.room("visible", 2 * samples)?;
        self.dispatch("bounce_sample_pass", samples)?;
        if self.has_details {
            self.reflect_by_skins(samples)?;
        }
        self.dispatch("shadow_pass", 2 * samples)?;
        self.dispatch("bounce_mean_pass", pixels * MODES.len() as u32)
    }

    /// Gives samples what the surfaces that they meet are like there.
    fn reflect_by_skins(&mut self, samples: u32) -> Result<(), ExecError> {
        self.room("met", samples)?;
        self.dispatch("bounce_met_pass", samples)?;
        // The pass of points is told what the samples meet as if pixels saw it.
        let of_pixels = ["seen", "points"].map(|name| (name, self.memory.take(name).unwrap_or_default()));
        self.rename("met", "seen");
        self.room("points", samples)?;
        self.dispatch("textured_point_pass", samples)?;
        self.rename("seen", "met");
        self.rename("points", "met_points");
        of_pixels.into_iter().for_each(|(name, bytes)| self.memory.put(name, bytes));
        self.dispatch("bounce_textured_pass", samples)
    }

    fn rename(&mut self, from: &str, to: &str) {
        let bytes = self.memory.take(from).unwrap_or_default();
        self.memory.put(to, bytes);
    }

    fn layers(&self, picture: &mut Picture) -> Result<Vec<Vec3>, ExecError> {
        let means: Vec<BounceSample> = self.pipeline.unpack("means", self.memory.bytes("means"))?;
        let spreads: Vec<RunningMean> = self.pipeline.unpack("spreads", self.memory.bytes("spreads"))?;
        for (mode, suffix) in MODES.iter().enumerate() {
            let mut add = |name: String, of: &dyn Fn(&BounceSample) -> Vec3| {
                let pixels = means.iter().skip(mode).step_by(MODES.len()).map(of).collect();
                picture.layers.push(Layer { name, pixels });
            };
            add(format!("indirect_total_{suffix}"), &|m| diffuse(m) + glossy(m));
            add(format!("indirect_diffuse_{suffix}"), &diffuse);
            add(format!("indirect_specular_{suffix}"), &glossy);
            if *suffix != "ab" {
                add(format!("indirect_diffuse_fromspec_{suffix}"), &|m| m.diffuse_of_glossy);
                add(format!("indirect_specular_fromspec_{suffix}"), &|m| m.glossy_of_glossy);
            }
            for (part, lobe) in ["total", "diffuse", "specular"].iter().enumerate() {
                let of_mode = spreads.iter().skip(3 * mode + part).step_by(3 * MODES.len());
                let pixels = of_mode.map(|s| Vec3::splat(running_mean_standard_error(*s))).collect();
                picture.layers.push(Layer { name: format!("se_indirect_{lobe}_{suffix}"), pixels });
            }
        }
        Ok(picture.layer("indirect_total_vis").map(<[Vec3]>::to_vec).unwrap_or_default())
    }
}

fn diffuse(mean: &BounceSample) -> Vec3 {
    mean.diffuse_of_diffuse + mean.diffuse_of_glossy
}

fn glossy(mean: &BounceSample) -> Vec3 {
    mean.glossy_of_diffuse + mean.glossy_of_glossy
}
