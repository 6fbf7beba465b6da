//! Light of one bounce by virtual lights out of reflective shadow maps.

mod imperfect;
mod map;
mod settings;
mod survey;

pub use settings::{Density, Reading, VirtualLights, Visibility};
pub use survey::Survey;

use super::{Frame, Layer, Method, Picture, Uploaded};
use lobe_backends::executor::ExecError;
use lobe_codegen::glam::{Vec2, Vec3};
use lobe_kernels::reference::random::random_pair;
use lobe_kernels::rsm::chain::{ChainStep, MapLevel};
use lobe_kernels::rsm::draw::DrawSettings;
use lobe_kernels::rsm::mean::{OF_BOTH, OF_DIFFUSE, OF_GLOSSY};
use lobe_kernels::rsm::point::SeenMap;
use lobe_kernels::rsm::scan::SCAN_BLOCK;
use lobe_kernels::rsm::shade::{LightTurn, VirtualPixel};
use lobe_kernels::scene::Triangle;
use lobe_kernels::scene::camera::PinholeCamera;
use lobe_kernels::scene::light::SceneLight;

/// Levels that a pass of the chain makes.
const LEVELS: u32 = 4;
/// Shadow rays of a turn, at most: they take 48 bytes each.
const TURN_RAYS: u32 = 1 << 20;
/// Lights of a turn, at most.
const TURN: u32 = 1024;

/// The passes that a method of virtual lights adds to pixels by.
pub(super) fn shading(method: Method, settings: &VirtualLights) -> &'static str {
    match method {
        Method::Vsl => "vsl_pass",
        Method::VslWide => "vsl_wide_pass",
        Method::Vsgl if settings.bias > 0.0 => "vsgl_reduced_pass",
        Method::Vsgl => "vsgl_pass",
        Method::Vsgl2 => "vsgl_two_pass",
        Method::Vsgl2Paper => "vsgl_two_paper_pass",
        _ => "vpl_pass",
    }
}

/// What of a scene the maps are made of.
pub(super) struct Mapped {
    pub(super) camera: PinholeCamera,
    pub(super) lights: Vec<SceneLight>,
    pub(super) triangles: Vec<Triangle>,
}

impl Mapped {
    pub(super) fn new(uploaded: &Uploaded) -> Self {
        Self {
            camera: uploaded.camera,
            lights: uploaded.lights.clone(),
            triangles: uploaded.bvh.triangles.clone(),
        }
    }
}

impl Frame<'_, '_> {
    /// The light of virtual lights; adds its layers and returns their sum.
    pub(super) fn virtual_lights(
        &mut self,
        mapped: &Mapped,
        picture: &mut Picture,
        progress: &dyn Fn(f32),
    ) -> Result<Vec<Vec3>, ExecError> {
        let frames = self.settings.virtual_lights.frames.max(1);
        let pixels = self.pixels();
        self.room("virtual_pixels", pixels)?;
        self.room("visible", 1)?;
        if !matches!(self.settings.method, Method::Vsgl2 | Method::Vsgl2Paper) {
            self.camera_lights(mapped)?;
            if self.settings.virtual_lights.visibility == Visibility::Imperfect {
                self.blockers()?;
            }
        }
        for frame in 0..frames {
            for (at, light) in (0_u32..).zip(&mapped.lights) {
                let origin = self.light_map(mapped, at, light, frame)?;
                match self.settings.method {
                    Method::Vsgl2 | Method::Vsgl2Paper => self.two_lights(origin)?,
                    _ => {
                        let count = self.draw(origin, mapped.lights.len() as u32, frame)?;
                        // Each picture and light begins elsewhere in the set of points.
                        self.shine(count, (random_pair(frame, at, 10).x * 16_777_216.0) as u32)?;
                    }
                }
                progress((frame as f32 + (at + 1) as f32 / mapped.lights.len() as f32) / frames as f32);
            }
        }
        self.virtual_layers(picture)
    }

    /// Texels and the chain of a map of this size, for positions counted from `origin`.
    fn chain(&mut self, levels: &[MapLevel], origin: Vec3, part: u32) -> Result<(), ExecError> {
        self.memory.put("levels", self.pipeline.pack("levels", levels)?);
        self.room("map_means", map::means(levels))?;
        for level in (0..levels.len() as u32 - 1).step_by(LEVELS as usize) {
            let pass = if level == 0 { "chain_first_pass" } else { "chain_pass" };
            let next = levels[level as usize + 1];
            let groups = next.width.div_ceil(8) * next.height.div_ceil(8);
            let step = ChainStep { origin, level, part };
            self.memory.put("chain_step", self.pipeline.pack("chain_step", &[step])?);
            self.dispatch(pass, 64 * groups)?;
        }
        Ok(())
    }

    /// The lights, or points, of the camera's map by which texels are weighed.
    fn camera_lights(&mut self, mapped: &Mapped) -> Result<(), ExecError> {
        let settings = self.settings.virtual_lights;
        let camera = &mapped.camera;
        let origin = camera.position;
        let pixel = 4.0 * camera.right.length() * camera.up.length() / self.pixels() as f32;
        let camera_map = SeenMap { origin, solid_angle: pixel };
        self.memory.put("camera_map", self.pipeline.pack("camera_map", &[camera_map])?);
        self.room("map_points", self.pixels())?;
        self.dispatch("seen_point_pass", self.pixels())?;
        let levels = map::levels(self.size[0], self.size[1]);
        let level = map::level_of(&levels, settings.view_lights);
        let count = levels[level].width * levels[level].height;
        if settings.density == Density::Vpl {
            self.memory.put("levels", self.pipeline.pack("levels", &levels)?);
        } else {
            self.chain(&levels, origin, OF_BOTH)?;
        }
        let step = ChainStep { origin, level: level as u32, part: OF_BOTH };
        self.memory.put("chain_step", self.pipeline.pack("chain_step", &[step])?);
        let (buffer, pass) = match settings.density {
            Density::Vpl => ("view_points", "view_point_pass"),
            Density::Vsgl | Density::Power => ("view_lights", "view_light_pass"),
        };
        self.room(buffer, count)?;
        self.dispatch(pass, count)
    }

    /// The points of a light's map; returns where their positions are counted from.
    fn light_map(
        &mut self,
        mapped: &Mapped,
        at: u32,
        light: &SceneLight,
        frame: u32,
    ) -> Result<Vec3, ExecError> {
        let settings = self.settings.virtual_lights;
        let place = if settings.frames > 1 { random_pair(frame, at, 9) } else { Vec2::splat(0.5) };
        let view = map::view(light, at, settings.map, &mapped.triangles, place);
        self.memory.put("map", self.pipeline.pack("map", &[view])?);
        let texels = settings.map * settings.map;
        // What the light sees, in the buffers of what the camera does.
        let of_pixels = ["seen", "points"].map(|name| (name, self.memory.take(name).unwrap_or_default()));
        for buffer in ["rays", "hits", "seen", "points", "map_points"] {
            self.room(buffer, texels)?;
        }
        for pass in ["map_ray_pass", "nearest_pass", "seen_pass"] {
            self.dispatch(pass, texels)?;
        }
        if self.has_details {
            self.dispatch("textured_point_pass", texels)?;
        }
        self.dispatch("map_point_pass", texels)?;
        of_pixels.into_iter().for_each(|(name, bytes)| self.memory.put(name, bytes));
        Ok(view.origin)
    }

    /// How much each texel of a light's map matters.
    fn weigh(&mut self) -> Result<(), ExecError> {
        let settings = self.settings.virtual_lights;
        let texels = settings.map * settings.map;
        self.room("estimates", texels)?;
        let by_points = settings.density == Density::Vpl;
        self.dispatch(if by_points { "density_point_pass" } else { "density_pass" }, texels)
    }

    /// Sums of the estimates up to each of `count` places, in the order of a pass, and of their blocks.
    fn sums_of_estimates(&mut self, pass: &str, count: u32) -> Result<(), ExecError> {
        let blocks = count.div_ceil(SCAN_BLOCK);
        for (buffer, count) in
            [("sums", count), ("block_totals", blocks), ("block_sums", blocks), ("all_totals", 1)]
        {
            self.room(buffer, count)?;
        }
        self.dispatch(pass, 64 * blocks)?;
        self.dispatch("scan_block_pass", 64)
    }

    /// Lights drawn out of a light's map; returns how many.
    fn draw(&mut self, origin: Vec3, lights: u32, frame: u32) -> Result<u32, ExecError> {
        let settings = self.settings.virtual_lights;
        let levels = map::levels(settings.map, settings.map);
        self.chain(&levels, origin, OF_BOTH)?;
        self.weigh()?;
        // The curve fills a square of a power of two.
        self.sums_of_estimates("scan_curve_pass", settings.map.next_power_of_two().pow(2))?;
        let count = settings.count.div_ceil(lights.max(1)).max(1);
        // A square as much smaller as its radius.
        let smoothing = settings.smoothing * settings.shrink.powi(2 * frame.min(1000) as i32);
        let method = self.settings.method;
        let is_whole = settings.reading(method) == Reading::Stratum;
        let drawing = DrawSettings {
            origin,
            count,
            smoothing: if method == Method::Vpl { 0.0 } else { smoothing },
            floor_share: settings.floor(),
            frame,
            are_lobes_filtered: u32::from(settings.filters_lobes),
            is_random: u32::from(settings.frames > 1),
            is_whole: u32::from(is_whole),
        };
        self.memory.put("drawing", self.pipeline.pack("drawing", &[drawing])?);
        self.room("light_places", count)?;
        self.room("virtual_lights", count)?;
        self.dispatch("light_place_pass", count)?;
        self.dispatch(if is_whole { "light_stratum_pass" } else { "light_draw_pass" }, count)?;
        if method == Method::VslWide {
            self.room("wide_lights", count)?;
            self.dispatch("wide_light_pass", count)?;
        }
        Ok(count)
    }

    /// Adds the lights that were drawn to the pixels; runs of points begin at `shift`.
    fn shine(&mut self, count: u32, shift: u32) -> Result<(), ExecError> {
        let settings = self.settings.virtual_lights;
        let pixels = self.pixels();
        let pass = shading(self.settings.method, &settings);
        let is_shadowed = settings.visibility != Visibility::None;
        let most = match settings.visibility {
            Visibility::None => TURN,
            Visibility::Exact => (TURN_RAYS / pixels).clamp(1, TURN),
            Visibility::Imperfect => {
                self.point_runs(count)?;
                (TURN_RAYS / pixels).clamp(1, TURN).min(imperfect::maps_of_turn(settings.shadow_map))
            }
        };
        for first in (0..count).step_by(most as usize) {
            let turn = LightTurn {
                first,
                count: most.min(count - first),
                is_shadowed: u32::from(is_shadowed),
                directions: settings.directions,
                least: settings.least_distance,
                threshold: settings.bias,
            };
            self.memory.put("lights_turn", self.pipeline.pack("lights_turn", &[turn])?);
            match settings.visibility {
                Visibility::None => {}
                Visibility::Exact => self.exact_shadows(turn)?,
                Visibility::Imperfect => self.imperfect_shadows(turn, count, shift)?,
            }
            self.dispatch(pass, pixels)?;
        }
        Ok(())
    }

    /// What of a turn's lights each pixel sees, by rays.
    fn exact_shadows(&mut self, turn: LightTurn) -> Result<(), ExecError> {
        let rays = self.pixels() * turn.count;
        self.room("shadow_rays", rays)?;
        self.room("visible", rays)?;
        self.dispatch("virtual_ray_pass", rays)?;
        self.dispatch("shadow_pass", rays)
    }

    /// The two lights of a light's map.
    fn whole_lights(&mut self, origin: Vec3) -> Result<(), ExecError> {
        let settings = self.settings.virtual_lights;
        let levels = map::levels(settings.map, settings.map);
        self.room("whole_lights", 2)?;
        for part in [OF_DIFFUSE, OF_GLOSSY] {
            self.chain(&levels, origin, part)?;
            self.dispatch("whole_light_pass", 1)?;
        }
        Ok(())
    }

    /// Adds the two lights of a light's map to the pixels.
    fn two_lights(&mut self, origin: Vec3) -> Result<(), ExecError> {
        self.whole_lights(origin)?;
        let settings = self.settings.virtual_lights;
        self.dispatch(shading(self.settings.method, &settings), self.pixels())
    }

    fn virtual_layers(&self, picture: &mut Picture) -> Result<Vec<Vec3>, ExecError> {
        let settings = &self.settings.virtual_lights;
        let found: Vec<VirtualPixel> =
            self.pipeline.unpack("virtual_pixels", self.memory.bytes("virtual_pixels"))?;
        let is_shadowed = settings.visibility != Visibility::None && self.settings.method.has_visibility();
        let suffix = if is_shadowed { "vis" } else { "la" };
        let share = 1.0 / settings.frames.max(1) as f32;
        let mut add = |name: &str, of: &dyn Fn(&VirtualPixel) -> Vec3| {
            let pixels = found.iter().map(|pixel| share * of(pixel)).collect();
            picture.layers.push(Layer { name: format!("indirect_{name}_{suffix}"), pixels });
        };
        let diffuse = |p: &VirtualPixel| p.parts.diffuse_of_diffuse + p.parts.diffuse_of_glossy;
        let glossy = |p: &VirtualPixel| p.parts.glossy_of_diffuse + p.parts.glossy_of_glossy;
        add("total", &|p| diffuse(p) + glossy(p));
        add("diffuse", &diffuse);
        add("specular", &glossy);
        add("diffuse_fromspec", &|p| p.parts.diffuse_of_glossy);
        add("specular_fromspec", &|p| p.parts.glossy_of_glossy);
        let each = share / settings.count.max(1) as f32;
        let pixels = found.iter().map(|p| Vec3::splat(each * p.smoothed)).collect();
        picture.layers.push(Layer { name: "smooth_lights".to_owned(), pixels });
        Ok(found.iter().map(|p| share * (diffuse(p) + glossy(p))).collect())
    }
}
