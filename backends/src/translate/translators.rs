//! All compilers between an emitted text and a driver, each as it was found.

use super::{Dxc, DxcOutput, Glslang, Slang, TranslateError, dxc, glslang, slang, spirv_words};
use crate::route::Road;

/// The compilers of this machine.
#[derive(Debug)]
pub struct Translators {
    dxc: Result<Dxc, TranslateError>,
    slang: Result<Slang, TranslateError>,
    glslang: Result<Glslang, TranslateError>,
}

impl Translators {
    /// Looks for each; what takes long waits for the first shader.
    #[must_use]
    pub fn find() -> Self {
        Self { dxc: Dxc::find(), slang: Slang::find(), glslang: Glslang::find() }
    }

    /// DXC, or why there is none.
    ///
    /// # Errors
    /// When it was not found or does not load.
    pub fn dxc(&self) -> Result<&Dxc, &TranslateError> {
        self.dxc.as_ref()
    }

    /// slang, or why there is none.
    ///
    /// # Errors
    /// When it was not found or does not load.
    pub fn slang(&self) -> Result<&Slang, &TranslateError> {
        self.slang.as_ref()
    }

    /// glslang, or why there is none.
    ///
    /// # Errors
    /// When it was not found.
    pub fn glslang(&self) -> Result<&Glslang, &TranslateError> {
        self.glslang.as_ref()
    }

    /// The words that a driver is given for the compute shader `entry` of a kernel's `text`, which is the road's.
    ///
    /// # Errors
    /// When the road has no translator, or its own is missing or refuses the text.
    pub fn spirv(&self, road: Road, text: &str, entry: &str) -> Result<Vec<u32>, TranslateError> {
        match road {
            Road::Spirv | Road::WgslNaga | Road::WgslTint | Road::Glsl => Err(TranslateError::BadInput {
                tool: "the road",
                reason: format!("{} has no translator", road.name()),
            }),
            Road::HlslDxc => {
                let dxc = self.dxc().map_err(Clone::clone)?;
                spirv_words(&dxc.compile(text, "cs_6_0", Some(entry), DxcOutput::Spirv)?)
            }
            Road::HlslSlang => spirv_words(&self.slang().map_err(Clone::clone)?.compile(text, entry)?),
            Road::GlslGlslang => self.glslang().map_err(Clone::clone)?.compile(text),
        }
    }

    /// What the translator of `road` lacks, and how to get it.
    #[must_use]
    pub fn missing(&self, road: Road) -> Option<(String, &'static str)> {
        let (error, mend) = match road {
            Road::Spirv | Road::WgslNaga | Road::WgslTint | Road::Glsl => return None,
            Road::HlslDxc => (self.dxc().err()?, dxc::MEND),
            Road::HlslSlang => (self.slang().err()?, slang::MEND),
            Road::GlslGlslang => (self.glslang().err()?, glslang::MEND),
        };
        let what = match error {
            TranslateError::NotFound { tool, .. } => format!("{tool} was not found"),
            other => other.to_string(),
        };
        Some((what, mend))
    }
}
