//! How virtual lights are made and shone.

use crate::render::Method;

/// By what the texels of a light's map are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Density {
    /// By what they give lights with extent out of the camera's map.
    Vsgl,
    /// By what they give single pixels.
    Vpl,
    /// By the power that they reflect.
    Power,
}

impl Density {
    /// All, in the order of the documentation.
    pub const ALL: [Self; 3] = [Self::Vsgl, Self::Vpl, Self::Power];

    /// Its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Vsgl => "vsgl",
            Self::Vpl => "vpl",
            Self::Power => "power",
        }
    }
}

impl std::fmt::Display for Density {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

impl std::str::FromStr for Density {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let found = Self::ALL.into_iter().find(|density| density.name() == text);
        found.ok_or_else(|| {
            format!("`{text}` is no density; there are {}", Self::ALL.map(Self::name).join(", "))
        })
    }
}

/// What hides virtual lights from pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Visibility {
    /// Nothing.
    None,
    /// Whatever a ray meets.
    Exact,
    /// What imperfect shadow maps show.
    Imperfect,
}

impl Visibility {
    /// All, in the order of the documentation.
    pub const ALL: [Self; 3] = [Self::None, Self::Exact, Self::Imperfect];

    /// Its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Exact => "exact",
            Self::Imperfect => "imperfect",
        }
    }
}

impl std::fmt::Display for Visibility {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

impl std::str::FromStr for Visibility {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let found = Self::ALL.into_iter().find(|visibility| visibility.name() == text);
        found.ok_or_else(|| {
            format!("`{text}` is no visibility; there are {}", Self::ALL.map(Self::name).join(", "))
        })
    }
}

/// What a virtual light is read from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reading {
    /// The square of the map around one texel.
    Square,
    /// All texels of its stratum.
    Stratum,
}

impl Reading {
    /// All, in the order of the documentation.
    pub const ALL: [Self; 2] = [Self::Square, Self::Stratum];

    /// Its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Square => "square",
            Self::Stratum => "stratum",
        }
    }
}

impl std::fmt::Display for Reading {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

impl std::str::FromStr for Reading {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let found = Self::ALL.into_iter().find(|reading| reading.name() == text);
        found.ok_or_else(|| {
            format!("`{text}` is no reading; there are {}", Self::ALL.map(Self::name).join(" and "))
        })
    }
}

/// How virtual lights are made and shone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VirtualLights {
    /// How many, of all lights together.
    pub count: u32,
    /// Texels along a side of a light's map.
    pub map: u32,
    /// By what they are drawn.
    pub density: Density,
    /// Lights out of the camera's map by which the density is found, at most.
    pub view_lights: u32,
    /// Share that is drawn by reflected power alone.
    pub floor_share: f32,
    /// What a light is read from; without it the stratum by [`Method::VslWide`] in a single picture, else the square.
    pub reading: Option<Reading>,
    /// How many times its own square a light is read from; 0 for the texel alone.
    pub smoothing: f32,
    /// Whether glossy lobes are filtered, too.
    pub filters_lobes: bool,
    /// Up to which sharpness over its cone a light counts as smooth; 0 for never.
    pub bias: f32,
    /// What hides a light from a pixel.
    pub visibility: Visibility,
    /// Points of an imperfect shadow map, on the average.
    pub shadow_points: u32,
    /// Texels along a side of one; counts as the next power of 2 up to 128.
    pub shadow_map: u32,
    /// Share of the points of which lights have as many each; the rest goes by what they send.
    pub shadow_floor: f32,
    /// Least distance of point lights, in m.
    pub least_distance: f32,
    /// Directions for each spherical light.
    pub directions: u32,
    /// Pictures whose mean it is, each with lights of its own; a single one takes the middles of strata and texels.
    pub frames: u32,
    /// By how much the squares that lights are read from, and so their radii, are smaller in a picture than in the one before.
    pub shrink: f32,
}

impl VirtualLights {
    /// What a light of `method` is read from.
    pub(super) fn reading(&self, method: Method) -> Reading {
        let own =
            if method == Method::VslWide && self.frames <= 1 { Reading::Stratum } else { Reading::Square };
        match method {
            // Their light is one texel's.
            Method::Vpl | Method::Vsl => Reading::Square,
            _ => self.reading.unwrap_or(own),
        }
    }

    /// Share of the lights that is drawn by reflected power alone.
    pub(super) fn floor(&self) -> f32 {
        match self.density {
            Density::Power => 1.0,
            Density::Vsgl | Density::Vpl => self.floor_share,
        }
    }
}

impl Default for VirtualLights {
    fn default() -> Self {
        Self {
            count: 1024,
            map: 256,
            density: Density::Vsgl,
            view_lights: 64,
            floor_share: 0.5,
            reading: None,
            smoothing: 4.0,
            filters_lobes: true,
            bias: 0.001,
            visibility: Visibility::None,
            shadow_points: 1024,
            shadow_map: 64,
            shadow_floor: 0.1,
            least_distance: 0.0,
            directions: 16,
            frames: 1,
            shrink: 1.0,
        }
    }
}
