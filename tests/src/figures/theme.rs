//! Colours, for light and dark pages.

/// Which page a figure stands on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Theme {
    /// Dark on light.
    Light,
    /// Light on dark.
    Dark,
}

/// Colours of a theme.
#[derive(Clone, Copy, Debug)]
pub struct Palette {
    /// Behind everything.
    pub page: &'static str,
    /// Titles and labels.
    pub text: &'static str,
    /// Captions and numbers at ticks.
    pub quiet: &'static str,
    /// Frames of panels.
    pub frame: &'static str,
    /// Lines of the grid.
    pub grid: &'static str,
    /// Curves: the first four those of Okabe and Ito, which the colour-blind tell apart too, as light as the page permits.
    pub series: [&'static str; 8],
}

impl Theme {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Light, Self::Dark];

    /// The part of a file's name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Light => "light",
            Self::Dark => "dark",
        }
    }

    /// Its colours.
    #[must_use]
    pub fn palette(self) -> Palette {
        match self {
            Self::Light => Palette {
                page: "#ffffff",
                text: "#1f2328",
                quiet: "#59636e",
                frame: "#8c959f",
                grid: "#e4e8ec",
                series: [
                    "#0072b2", "#d55e00", "#009e73", "#a8538c", "#8a6d00", "#3a9bd0", "#b23a48", "#1f2328",
                ],
            },
            Self::Dark => Palette {
                page: "#0d1117",
                text: "#f0f6fc",
                quiet: "#a5afba",
                frame: "#6e7681",
                grid: "#222932",
                series: [
                    "#56b4e9", "#f0a030", "#2fc497", "#e39cc8", "#f0e442", "#9aa7ff", "#ff7b72", "#f0f6fc",
                ],
            },
        }
    }
}
