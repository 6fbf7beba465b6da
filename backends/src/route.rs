//! How a kernel reaches a machine, and the name of that way: `native`, `interp`, `target+translator@driver`.

use crate::gpu::Api;
use lobe_codegen::emit::Target;
use std::fmt;
use std::str::FromStr;

/// A way from a kernel to its results.
///
/// ```
/// use lobe_backends::route::{Road, Route};
///
/// let route: Route = "hlsl+dxc@lavapipe".parse()?;
/// assert_eq!(route, Route::Gpu { road: Road::HlslDxc, driver: "lavapipe".to_owned() });
/// assert_eq!(route.to_string(), "hlsl+dxc@lavapipe");
/// assert!("lavapipe".parse::<Route>().is_err());
/// # Ok::<(), lobe_backends::route::ParseRouteError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Route {
    /// The Rust function itself.
    Native,
    /// The CPU interpreter, on the naga module.
    Interp,
    /// An emitted artifact on a driver.
    Gpu {
        /// What is emitted and what it passes through.
        road: Road,
        /// The driver's short name, as [`crate::gpu::Driver`] states it.
        driver: String,
    },
}

/// What is emitted for a driver, and which translator it passes before the driver sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Road {
    /// SPIR-V words, handed to the driver unchanged.
    Spirv,
    /// WGSL text through wgpu's naga.
    WgslNaga,
    /// HLSL text through Microsoft's DXC.
    HlslDxc,
    /// WGSL text through Dawn's Tint.
    WgslTint,
    /// GLSL text, handed to an OpenGL driver unchanged.
    Glsl,
    /// HLSL text through Khronos' slang.
    HlslSlang,
    /// GLSL text through Khronos' glslang.
    GlslGlslang,
}

impl Road {
    /// Every road.
    pub const ALL: [Self; 7] = [
        Self::Spirv,
        Self::WgslNaga,
        Self::WgslTint,
        Self::HlslDxc,
        Self::HlslSlang,
        Self::GlslGlslang,
        Self::Glsl,
    ];

    /// The part of a route's name before `@`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Spirv => "spirv",
            Self::WgslNaga => "wgsl+naga",
            Self::HlslDxc => "hlsl+dxc",
            Self::WgslTint => "wgsl+tint",
            Self::HlslSlang => "hlsl+slang",
            Self::GlslGlslang => "glsl+glslang",
            Self::Glsl => "glsl",
        }
    }

    /// What is emitted.
    #[must_use]
    pub fn target(self) -> Target {
        match self {
            Self::Spirv => Target::Spirv,
            Self::WgslNaga | Self::WgslTint => Target::Wgsl,
            Self::HlslDxc | Self::HlslSlang => Target::Hlsl,
            Self::GlslGlslang | Self::Glsl => Target::Glsl,
        }
    }

    /// The interface of the drivers that it leads to.
    #[must_use]
    pub fn api(self) -> Api {
        match self {
            Self::Spirv
            | Self::WgslNaga
            | Self::WgslTint
            | Self::HlslDxc
            | Self::HlslSlang
            | Self::GlslGlslang => Api::Vulkan,
            Self::Glsl => Api::OpenGl,
        }
    }

    /// Whether the driver is given SPIR-V, which it must then take unchanged.
    #[must_use]
    pub fn ends_in_spirv(self) -> bool {
        match self {
            Self::Spirv | Self::HlslDxc | Self::HlslSlang | Self::GlslGlslang => true,
            Self::WgslNaga | Self::WgslTint | Self::Glsl => false,
        }
    }
}

impl Route {
    /// The driver, for a route that has one.
    #[must_use]
    pub fn driver(&self) -> Option<&str> {
        match self {
            Self::Native | Self::Interp => None,
            Self::Gpu { driver, .. } => Some(driver),
        }
    }
}

impl fmt::Display for Route {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Native => f.pad("native"),
            Self::Interp => f.pad("interp"),
            Self::Gpu { road, driver } => f.pad(&format!("{}@{driver}", road.name())),
        }
    }
}

/// A text that names no route.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "`{text}` names no route: {reason}. A route is `native`, `interp`, or one of {roads} followed by `@` and a \
     driver, as `spirv@lavapipe` (`lobe doctor` lists those of this machine)",
    roads = Road::ALL.map(Road::name).join(", ")
)]
pub struct ParseRouteError {
    text: String,
    reason: String,
}

impl FromStr for Route {
    type Err = ParseRouteError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let fail = |reason: &str| ParseRouteError { text: text.to_owned(), reason: reason.to_owned() };
        match text.split_once('@') {
            None if text == "native" => Ok(Self::Native),
            None if text == "interp" => Ok(Self::Interp),
            None => Err(fail("it has no `@driver`")),
            Some((_, "")) => Err(fail("no driver stands after `@`")),
            Some((road, driver)) => {
                let known = Road::ALL.into_iter().find(|r| r.name() == road);
                let road = known.ok_or_else(|| fail(&format!("`{road}` is no target and translator")))?;
                Ok(Self::Gpu { road, driver: driver.to_owned() })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_come_back_as_they_went() {
        for name in [
            "native",
            "interp",
            "spirv@lavapipe",
            "wgsl+naga@swiftshader",
            "hlsl+dxc@a-card-2",
            "hlsl+slang@x",
            "wgsl+tint@lavapipe",
            "glsl@llvmpipe",
        ] {
            assert_eq!(name.parse::<Route>().map(|r| r.to_string()), Ok(name.to_owned()));
        }
    }

    #[test]
    fn what_is_no_route_is_refused_with_the_reason() {
        for (text, part) in [
            ("", "no `@driver`"),
            ("lavapipe", "no `@driver`"),
            ("spirv@", "no driver stands after"),
            ("metal@lavapipe", "`metal` is no target"),
            ("wgsl@lavapipe", "wgsl+naga"),
        ] {
            let message = text.parse::<Route>().expect_err(text).to_string();
            assert!(message.contains(part), "{message}");
        }
    }
}
