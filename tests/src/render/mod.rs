//! Renders scenes: passes of kernels over buffers, the same on every route.
//!
//! [`Renderer`] holds the passes, lowered once; [`Renderer::render`] runs those of a [`Method`] by a dispatcher of
//! [`lobe_backends::pipeline`] and gives a [`Picture`] in layers.

mod bounce;
pub mod bvh;
mod field;
mod field_tree;
mod file;
mod judged;
mod method;
mod picture;
mod rectangles;
mod reflectors;
mod shadowed;
mod upload;
mod virtual_lights;

pub use field::{FieldSearch, LightField};
pub use field_tree::FieldTree;
pub(crate) use file::png_of;
pub use file::{FileError, auto_exposure, encoded, exr, png};
pub use judged::{Judged, PassVerdict, summary};
pub use method::Method;
pub use picture::{Layer, Picture};
pub use upload::Uploaded;
pub use virtual_lights::{Density, Reading, Survey, VirtualLights, Visibility};

use crate::proxies::Proxies;
use crate::scene::{Scene, texel_values};
use lobe_backends::executor::ExecError;
use lobe_backends::pipeline::{Dispatcher, Memory, Pipeline};
use lobe_codegen::glam::Vec3;
use lobe_kernels::rect::pass::RectSettings;
use lobe_kernels::registry::PASSES;
use lobe_kernels::scene::direct::DirectPixel;
use shadowed::Shadows;

/// What a picture is made with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Who finds the light of one bounce.
    pub method: Method,
    /// Samples a pixel of [`Method::Reference`].
    pub samples: u32,
    /// The disk's radius over alpha and distance, of the methods of rectangles.
    pub radius_factor: f32,
    /// Whether what stands between is asked for: by [`Method::RectLaplace`] of one point for each rectangle and lobe, by
    /// [`Method::RectQuadrature`] of each place. Other methods of rectangles have no shadows.
    pub shadows: bool,
    /// Virtual lights, of the methods that have them.
    pub virtual_lights: VirtualLights,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            method: Method::RectQuadrature,
            samples: 256,
            radius_factor: 3.0,
            shadows: false,
            virtual_lights: VirtualLights::default(),
        }
    }
}

/// The passes of all methods.
#[derive(Debug)]
pub struct Renderer {
    pipeline: Pipeline,
}

impl Renderer {
    /// Lowers the passes.
    ///
    /// # Errors
    /// Only where a kernel of the library is broken.
    pub fn new() -> Result<Self, ExecError> {
        Ok(Self { pipeline: Pipeline::new(PASSES)? })
    }

    /// The same, with another module in the place of a pass's own, for tests of what notices a change.
    ///
    /// # Errors
    /// When there is no such pass.
    #[doc(hidden)]
    pub fn with_module(self, pass: &str, module: lobe_codegen::ValidModule) -> Result<Self, ExecError> {
        Ok(Self { pipeline: self.pipeline.with_module(pass, module)? })
    }

    /// The passes.
    #[must_use]
    pub fn pipeline(&self) -> &Pipeline {
        &self.pipeline
    }

    /// The picture of `scene`, in whose place the methods of rectangles take `proxies`; `progress` is told which share of the work is done.
    ///
    /// # Errors
    /// When a pass cannot be run by `dispatcher`.
    pub fn render<'p>(
        &'p self,
        scene: &Scene,
        proxies: &Proxies,
        settings: &Settings,
        dispatcher: &mut dyn Dispatcher<'p>,
        progress: &dyn Fn(f32),
    ) -> Result<Picture, ExecError> {
        self.frame(scene, proxies, settings, None, dispatcher, progress)
    }

    /// The same without shadows by the rectangles that `field` lists, if the method can ([`Method::field_pass`]).
    ///
    /// # Errors
    /// As of [`Renderer::render`].
    pub fn render_by_field<'p>(
        &'p self,
        scene: &Scene,
        proxies: &Proxies,
        settings: &Settings,
        field: &mut LightField,
        dispatcher: &mut dyn Dispatcher<'p>,
    ) -> Result<Picture, ExecError> {
        self.frame(scene, proxies, settings, Some(field), dispatcher, &|_| {})
    }

    fn frame<'p>(
        &'p self,
        scene: &Scene,
        proxies: &Proxies,
        settings: &Settings,
        field: Option<&mut LightField>,
        dispatcher: &mut dyn Dispatcher<'p>,
        progress: &dyn Fn(f32),
    ) -> Result<Picture, ExecError> {
        let uploaded = Uploaded::new(scene, proxies);
        let slacks = uploaded.slacks.clone();
        let mapped = virtual_lights::Mapped::new(&uploaded);
        let mut frame = Frame::new(&self.pipeline, uploaded, settings, dispatcher)?;
        frame.see()?;
        let mut picture = frame.direct()?;
        let indirect = match (settings.method, settings.method.rect_pass()) {
            (method, Some(pass)) => {
                let shadows = Shadows::of(method).filter(|_| settings.shadows);
                match (field.zip(method.field_pass()), shadows) {
                    (Some((field, pass)), _) => frame.by_field(pass, field, &mut picture)?,
                    (None, Some(shadows)) => frame.shadowed(shadows, &slacks, &mut picture, progress)?,
                    (None, None) => frame.rectangles(pass, &mut picture)?,
                }
            }
            (Method::Reference, None) => frame.bounces(&mut picture, progress)?,
            (method, None) if method.has_virtual_lights() => {
                frame.virtual_lights(&mapped, &mut picture, progress)?
            }
            (_, None) => return Ok(picture),
        };
        picture.radiance = picture::sum(&picture.radiance, &indirect);
        Ok(picture)
    }
}

/// A picture in the making.
struct Frame<'p, 'd> {
    pipeline: &'p Pipeline,
    dispatcher: &'d mut dyn Dispatcher<'p>,
    memory: Memory,
    settings: Settings,
    size: [u32; 2],
    lights: u32,
    /// Whether surfaces have skins.
    has_details: bool,
}

impl<'p, 'd> Frame<'p, 'd> {
    fn new(
        pipeline: &'p Pipeline,
        uploaded: Uploaded,
        settings: &Settings,
        dispatcher: &'d mut dyn Dispatcher<'p>,
    ) -> Result<Self, ExecError> {
        let mut memory = Memory::default();
        memory.put("camera", pipeline.pack("camera", &[uploaded.camera])?);
        memory.put("nodes", pipeline.pack("nodes", &uploaded.bvh.nodes)?);
        memory.put("triangles", pipeline.pack("triangles", &uploaded.bvh.triangles)?);
        memory.put("surfaces", pipeline.pack("surfaces", &uploaded.surfaces)?);
        memory.put("proxies", pipeline.pack("proxies", &uploaded.proxies)?);
        memory.put("materials", pipeline.pack("materials", &uploaded.materials)?);
        memory.put("lights", pipeline.pack("lights", &uploaded.lights)?);
        memory.put("reflectors", pipeline.pack("reflectors", &uploaded.reflectors)?);
        let has_details = !uploaded.surface_details.is_empty();
        if has_details {
            memory.put("details", pipeline.pack("details", &uploaded.surface_details)?);
            memory.put("corners", pipeline.pack("corners", &uploaded.details.corners)?);
            memory.put("skins", pipeline.pack("skins", &uploaded.details.skins)?);
            memory.put("texels", pipeline.pack("texels", uploaded.details.some_texels())?);
            memory.put("texel_values", pipeline.pack("texel_values", &texel_values())?);
        }
        let settings_of_rect = RectSettings { radius_factor: settings.radius_factor };
        memory.put("settings", pipeline.pack("settings", &[settings_of_rect])?);
        let (lights, size) = (uploaded.lights.len() as u32, [uploaded.camera.width, uploaded.camera.height]);
        Ok(Self { pipeline, dispatcher, memory, settings: *settings, size, lights, has_details })
    }

    fn pixels(&self) -> u32 {
        self.size[0] * self.size[1]
    }

    /// Makes room for `count` elements of a buffer.
    fn room(&mut self, buffer: &str, count: u32) -> Result<(), ExecError> {
        self.memory.put(buffer, self.pipeline.zeros(buffer, count as usize)?);
        Ok(())
    }

    /// Runs a pass that writes `count` elements.
    fn dispatch(&mut self, pass: &str, count: u32) -> Result<(), ExecError> {
        self.dispatcher.dispatch(self.pipeline.pass(pass)?, count, &mut self.memory)
    }

    /// What each pixel sees, and what that is like.
    fn see(&mut self) -> Result<(), ExecError> {
        let pixels = self.pixels();
        for buffer in ["rays", "hits", "seen"] {
            self.room(buffer, pixels)?;
        }
        for pass in ["camera_pass", "nearest_pass", "seen_pass"] {
            self.dispatch(pass, pixels)?;
        }
        if !self.has_details {
            // Nobody asks for a point, but no buffer is empty.
            return self.room("points", 1);
        }
        self.room("points", pixels)?;
        self.dispatch("textured_point_pass", pixels)
    }

    /// Direct light.
    fn direct(&mut self) -> Result<Picture, ExecError> {
        let (pixels, rays) = (self.pixels(), self.pixels() * self.lights);
        self.room("shadow_rays", rays)?;
        self.room("visible", rays)?;
        self.room("direct", pixels)?;
        self.dispatch("light_ray_pass", rays)?;
        self.dispatch("shadow_pass", rays)?;
        self.dispatch("direct_pass", pixels)?;
        let found: Vec<DirectPixel> = self.pipeline.unpack("direct", self.memory.bytes("direct"))?;
        let layer = |name: &str, of: fn(&DirectPixel) -> Vec3| Layer {
            name: name.to_owned(),
            pixels: found.iter().map(of).collect(),
        };
        let layers = vec![
            layer("direct_vis", |p| p.shadowed),
            layer("direct_novis", |p| p.unshadowed),
            layer("direct_specular_novis", |p| p.unshadowed_specular),
        ];
        Ok(Picture { size: self.size, radiance: layers[0].pixels.clone(), layers })
    }
}
