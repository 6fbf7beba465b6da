//! The methods of rendering, by name.

use super::VirtualLights;
use super::shadowed::Shadows;

/// How the light of one bounce is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Not at all: direct light alone.
    Direct,
    /// Rectangles, by the corrected method of the disk.
    Rect,
    /// Rectangles, by our quadrature with nine places for each lobe.
    RectQuadrature,
    /// Rectangles, by our closed form with a spot for each lobe.
    RectLaplace,
    /// Rectangles, by our closed form with one spot.
    RectLaplaceSingle,
    /// Rectangles, by our closed form with one evaluation.
    RectLaplaceFast,
    /// Rectangles, by the disk's method with isotropic lobes.
    RectSg,
    /// Rectangles, by the disk's method as printed.
    RectPaper,
    /// Virtual point lights.
    Vpl,
    /// Virtual spherical lights, by directions drawn in their cones.
    Vsl,
    /// Virtual spherical lights with GGX lobes widened by their cones: our own.
    VslWide,
    /// Virtual spherical-Gaussian lights.
    Vsgl,
    /// Two of them, of the whole map.
    Vsgl2,
    /// The same, with the clamped cosine as printed.
    Vsgl2Paper,
    /// By sampling: the truth, with its standard error.
    Reference,
}

impl Method {
    /// All, in the order of the documentation.
    pub const ALL: [Self; 15] = [
        Self::Direct,
        Self::Rect,
        Self::RectQuadrature,
        Self::RectLaplace,
        Self::RectLaplaceSingle,
        Self::RectLaplaceFast,
        Self::RectSg,
        Self::RectPaper,
        Self::Vpl,
        Self::Vsl,
        Self::VslWide,
        Self::Vsgl,
        Self::Vsgl2,
        Self::Vsgl2Paper,
        Self::Reference,
    ];

    /// Its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Direct => "direct",
            Self::Rect => "rect",
            Self::RectQuadrature => "rect-quadrature",
            Self::RectLaplace => "rect-laplace",
            Self::RectLaplaceSingle => "rect-laplace-single",
            Self::RectLaplaceFast => "rect-laplace-fast",
            Self::RectSg => "rect-sg",
            Self::RectPaper => "rect-paper",
            Self::Vpl => "vpl",
            Self::Vsl => "vsl",
            Self::VslWide => "vsl-wide",
            Self::Vsgl => "vsgl",
            Self::Vsgl2 => "vsgl2",
            Self::Vsgl2Paper => "vsgl2-paper",
            Self::Reference => "reference",
        }
    }

    /// Whether it can ask for what stands between pixel, rectangle and light.
    #[must_use]
    pub fn has_shadows(self) -> bool {
        Shadows::of(self).is_some()
    }

    /// The pass that shades by a light-field texture, of methods that can.
    #[must_use]
    pub fn field_pass(self) -> Option<&'static str> {
        match self {
            Self::RectLaplace => Some("rect_field_pass"),
            Self::RectQuadrature => Some("rect_field_quadrature_pass"),
            _ => None,
        }
    }

    /// The pass of a method of rectangles.
    #[must_use]
    pub fn rect_pass(self) -> Option<&'static str> {
        match self {
            Self::Rect => Some("rect_pass"),
            Self::RectQuadrature => Some("rect_quadrature_pass"),
            Self::RectLaplace => Some("rect_laplace_pass"),
            Self::RectLaplaceSingle => Some("rect_laplace_single_pass"),
            Self::RectLaplaceFast => Some("rect_laplace_fast_pass"),
            Self::RectSg => Some("rect_sg_pass"),
            Self::RectPaper => Some("rect_paper_pass"),
            Self::Direct | Self::Reference => None,
            Self::Vpl | Self::Vsl | Self::VslWide | Self::Vsgl | Self::Vsgl2 | Self::Vsgl2Paper => None,
        }
    }

    /// The passes whose results pixels are the sum of: direct light, and that of one bounce, if the method finds it in one.
    /// [`Method::Reference`] and shadows take many turns.
    #[must_use]
    pub fn last_passes(self, settings: &VirtualLights) -> Vec<&'static str> {
        let bounce = match self.rect_pass() {
            None if self.has_virtual_lights() => Some(super::virtual_lights::shading(self, settings)),
            pass => pass,
        };
        std::iter::once("direct_pass").chain(bounce).collect()
    }

    /// Whether it takes virtual lights out of reflective shadow maps.
    #[must_use]
    pub fn has_virtual_lights(self) -> bool {
        matches!(self, Self::Vpl | Self::Vsl | Self::VslWide | Self::Vsgl | Self::Vsgl2 | Self::Vsgl2Paper)
    }

    /// Whether its virtual lights can be hidden; two lights of a whole map are nowhere that a ray could lead to.
    #[must_use]
    pub fn has_visibility(self) -> bool {
        matches!(self, Self::Vpl | Self::Vsl | Self::VslWide | Self::Vsgl)
    }
}

impl std::fmt::Display for Method {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

impl std::str::FromStr for Method {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let names = Self::ALL.map(Self::name).join(", ");
        let found = Self::ALL.into_iter().find(|method| method.name() == text);
        found.ok_or_else(|| format!("`{text}` is no method; the methods are {names}"))
    }
}
