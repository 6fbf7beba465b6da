//! Pictures by a light-field texture.

use super::{FieldTree, Frame, Picture};
use lobe_backends::executor::ExecError;
use lobe_codegen::glam::Vec3;
use lobe_kernels::rect::field::{FIELD_LIST, FIELD_TEXEL, FieldSettings};

/// How the rectangles of a texel are found. The lists are the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FieldSearch {
    /// By a tree over those that stand still, and by trying each of those that move.
    Tree,
    /// By trying each rectangle.
    All,
}

/// Which rectangles send most light to each texel of each surface, and how it is made.
///
/// Rectangles and surfaces that move are the last ones of their lists. What was found of the others is kept from frame to
/// frame.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LightField {
    /// Texels along a side of a surface.
    pub side: u32,
    /// Rectangles of each of a texel's two lists, 1 ..= 8.
    pub most: u32,
    /// How many of the rectangles move.
    pub moving: u32,
    /// How many of the surfaces move.
    pub moving_surfaces: u32,
    /// Who makes the lists.
    pub search: FieldSearch,
    kept: Vec<u8>,
}

impl LightField {
    /// Nothing known yet, and nothing moving.
    #[must_use]
    pub fn new(side: u32, most: u32) -> Self {
        let most = most.clamp(1, FIELD_LIST);
        Self {
            side: side.max(1),
            most,
            moving: 0,
            moving_surfaces: 0,
            search: FieldSearch::Tree,
            kept: Vec::new(),
        }
    }

    /// Forgets everything, as after a change of what stands still.
    pub fn forget(&mut self) {
        self.kept.clear();
    }
}

impl Frame<'_, '_> {
    /// The light of the rectangles in the texels, which `pass` finds; adds its layers and returns their sum.
    pub(super) fn by_field(
        &mut self,
        pass: &str,
        field: &mut LightField,
        picture: &mut Picture,
    ) -> Result<Vec<Vec3>, ExecError> {
        let surfaces = self.elements("surfaces")?;
        let texels = surfaces * field.side * field.side;
        let room = self.pipeline.zeros("field", (texels * FIELD_TEXEL) as usize)?;
        let is_known = field.kept.len() == room.len();
        self.memory.put("field", if is_known { std::mem::take(&mut field.kept) } else { room });
        let still = self.elements("proxies")?.saturating_sub(field.moving);
        let settings =
            FieldSettings { side: field.side, most: field.most, list: 0, first: 0, count: still, texel: 0 };
        let moved = surfaces.saturating_sub(field.moving_surfaces) * field.side * field.side;
        let standing = FieldSettings { texel: if is_known { moved } else { 0 }, ..settings };
        match self.plant(&standing, field.search, texels)? {
            true => self.list("field_tree_pass", standing, texels)?,
            false => self.list("field_pass", standing, texels)?,
        }
        let moving = FieldSettings { list: FIELD_LIST, first: still, count: field.moving, ..settings };
        self.list("field_pass", moving, texels)?;
        let indirect = self.rectangles(pass, picture)?;
        field.kept = self.memory.take("field").unwrap_or_default();
        Ok(indirect)
    }

    /// Makes the tree over the rectangles of a list, if one is wanted; whether there is one now.
    fn plant(
        &mut self,
        settings: &FieldSettings,
        search: FieldSearch,
        texels: u32,
    ) -> Result<bool, ExecError> {
        if search == FieldSearch::All || settings.count == 0 || self.lights == 0 || settings.texel >= texels {
            return Ok(false);
        }
        let pipeline = self.pipeline;
        let proxies = pipeline.unpack("proxies", self.memory.bytes("proxies"))?;
        let materials = pipeline.unpack("materials", self.memory.bytes("materials"))?;
        let lights = pipeline.unpack("lights", self.memory.bytes("lights"))?;
        let range = settings.first..settings.first + settings.count;
        let tree = FieldTree::new(&proxies, range, &materials, &lights);
        self.memory.put("field_nodes", pipeline.pack("field_nodes", &tree.nodes)?);
        self.memory.put("field_lobes", pipeline.pack("field_lobes", &tree.lobes)?);
        Ok(true)
    }

    /// Makes a list of all texels from the first on.
    fn list(&mut self, pass: &str, settings: FieldSettings, texels: u32) -> Result<(), ExecError> {
        if settings.texel >= texels {
            return Ok(());
        }
        self.memory.put("field_settings", self.pipeline.pack("field_settings", &[settings])?);
        self.dispatch(pass, texels - settings.texel)
    }

    /// Elements of a buffer.
    fn elements(&self, buffer: &str) -> Result<u32, ExecError> {
        Ok((self.memory.bytes(buffer).len() / self.pipeline.layout(buffer)?.stride as usize) as u32)
    }
}
