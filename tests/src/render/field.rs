//! Pictures by a light-field texture.

use super::{Frame, Picture};
use lobe_backends::executor::ExecError;
use lobe_codegen::glam::Vec3;
use lobe_kernels::rect::field::{FIELD_LIST, FIELD_TEXEL, FieldSettings};

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
    kept: Vec<u8>,
}

impl LightField {
    /// Nothing known yet, and nothing moving.
    #[must_use]
    pub fn new(side: u32, most: u32) -> Self {
        let most = most.clamp(1, FIELD_LIST);
        Self { side: side.max(1), most, moving: 0, moving_surfaces: 0, kept: Vec::new() }
    }

    /// Forgets everything, as after a change of what stands still.
    pub fn forget(&mut self) {
        self.kept.clear();
    }
}

impl Frame<'_, '_> {
    /// The light of the rectangles in the texels; adds its layers and returns their sum.
    pub(super) fn by_field(
        &mut self,
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
        self.list(FieldSettings { texel: if is_known { moved } else { 0 }, ..settings }, texels)?;
        self.list(FieldSettings { list: FIELD_LIST, first: still, count: field.moving, ..settings }, texels)?;
        let indirect = self.rectangles("rect_field_pass", picture)?;
        field.kept = self.memory.take("field").unwrap_or_default();
        Ok(indirect)
    }

    /// Makes a list of all texels from the first on.
    fn list(&mut self, settings: FieldSettings, texels: u32) -> Result<(), ExecError> {
        if settings.texel >= texels {
            return Ok(());
        }
        self.memory.put("field_settings", self.pipeline.pack("field_settings", &[settings])?);
        self.dispatch("field_pass", texels - settings.texel)
    }

    /// Elements of a buffer.
    fn elements(&self, buffer: &str) -> Result<u32, ExecError> {
        Ok((self.memory.bytes(buffer).len() / self.pipeline.layout(buffer)?.stride as usize) as u32)
    }
}
