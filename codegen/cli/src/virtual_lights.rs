//! Options of the methods of virtual lights.

use lobe_tests::render::{Density, Reading, VirtualLights, Visibility};

/// Options of virtual lights.
#[derive(Debug, clap::Args)]
pub(crate) struct VirtualArgs {
    /// Virtual lights, of all lights together
    #[arg(long, value_name = "N", default_value_t = 1024, value_parser = clap::value_parser!(u32).range(1..=65536))]
    lights: u32,
    /// Texels along a side of a light's reflective shadow map
    #[arg(long, value_name = "TEXELS", default_value_t = 256, value_parser = clap::value_parser!(u32).range(1..=1024))]
    map: u32,
    /// By what texels are drawn: vsgl, vpl or power
    #[arg(long, default_value_t = Density::Vsgl)]
    density: Density,
    /// Share of the lights that is drawn by reflected power whatever the density
    #[arg(long, value_name = "SHARE", default_value_t = 0.5, value_parser = |text: &str| within(text, 0.001, 1.0))]
    power_share: f32,
    /// What a virtual light is read from: square, of the map around one texel, or stratum, all texels between it and the next;
    /// of vsl-wide in a single picture the stratum, else the square if not given
    #[arg(long, value_name = "WHAT")]
    reading: Option<Reading>,
    /// How many times its own square of the map a virtual light is read from; 0 for one texel
    #[arg(short, long, value_name = "K", default_value_t = 4.0, value_parser = |text: &str| within(text, 0.0, 100.0))]
    k: f32,
    /// Take glossy lobes from one texel, unfiltered
    #[arg(long)]
    raw_lobes: bool,
    /// Sharpness over its cone up to which a light's reflection is evaluated and not approximated; 0 for never
    #[arg(long, value_name = "ALPHA", default_value_t = 0.001, value_parser = |text: &str| within(text, 0.0, 1.0))]
    bias: f32,
    /// What hides virtual lights from pixels: none, exact or imperfect
    #[arg(long, value_name = "HOW", default_value_t = Visibility::None)]
    visibility: Visibility,
    /// Points of a light's imperfect shadow map, on the average
    #[arg(long, value_name = "N", default_value_t = 1024, value_parser = clap::value_parser!(u32).range(1..=65536))]
    shadow_points: u32,
    /// Texels along a side of one: a power of 2 up to 128
    #[arg(long, value_name = "SIDE", default_value_t = 64, value_parser = power_of_two)]
    shadow_map: u32,
    /// Share of the points of which lights have as many each; the others go by what lights send
    #[arg(long, value_name = "SHARE", default_value_t = 0.1, value_parser = |text: &str| within(text, 0.0, 1.0))]
    shadow_floor: f32,
    /// Least distance of virtual point lights, in m
    #[arg(long, value_name = "M", default_value_t = 0.0, value_parser = |text: &str| within(text, 0.0, 1e4))]
    clamp: f32,
    /// Directions for each virtual spherical light
    #[arg(long, default_value_t = 16, value_parser = clap::value_parser!(u32).range(1..=1024))]
    directions: u32,
    /// Pictures, each with lights of its own, whose mean is taken
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=65536))]
    frames: u32,
    /// By how much radii shrink from one of these to the next
    #[arg(long, default_value_t = 1.0, value_parser = |text: &str| within(text, 0.1, 1.0))]
    shrink: f32,
}

impl VirtualArgs {
    /// Whether something hides virtual lights.
    pub(crate) fn has_visibility(&self) -> bool {
        self.visibility != Visibility::None
    }

    /// What the library takes.
    pub(crate) fn settings(&self) -> VirtualLights {
        VirtualLights {
            count: self.lights,
            map: self.map,
            density: self.density,
            floor_share: self.power_share,
            reading: self.reading,
            smoothing: self.k,
            filters_lobes: !self.raw_lobes,
            bias: self.bias,
            visibility: self.visibility,
            shadow_points: self.shadow_points,
            shadow_map: self.shadow_map,
            shadow_floor: self.shadow_floor,
            least_distance: self.clamp,
            directions: self.directions,
            frames: self.frames,
            shrink: self.shrink,
            ..VirtualLights::default()
        }
    }
}

fn within(text: &str, low: f32, high: f32) -> Result<f32, String> {
    let value = text.parse().ok().filter(|value| (low..=high).contains(value));
    value.ok_or_else(|| format!("`{text}` is no number from {low} to {high}"))
}

fn power_of_two(text: &str) -> Result<u32, String> {
    let value = text.parse().ok().filter(|value: &u32| value.is_power_of_two() && *value <= 128);
    value.ok_or_else(|| format!("`{text}` is no power of 2 from 1 to 128; take 32 or 64"))
}
