//! A figure: panels of curves, a title above and a caption below.

use super::axis::Axis;

/// A figure.
#[derive(Clone, Debug)]
pub struct Figure {
    /// The stem of its files' names.
    pub name: &'static str,
    /// What it shows, in few words.
    pub title: String,
    /// The panels, two in a row.
    pub panels: Vec<Panel>,
    /// What was measured, and how.
    pub caption: String,
}

/// A diagram.
#[derive(Clone, Debug)]
pub struct Panel {
    /// Above it.
    pub title: String,
    /// Below it.
    pub x: Axis,
    /// Beside it.
    pub y: Axis,
    /// What is drawn, the first lowest.
    pub series: Vec<Series>,
    /// Where the legend stands, if there is one.
    pub legend: Option<Corner>,
}

/// A corner of a panel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Corner {
    /// Above, to the left.
    TopLeft,
    /// Above, to the right.
    TopRight,
    /// Below, to the left.
    BottomLeft,
    /// Below, to the right.
    BottomRight,
}

/// Something drawn.
#[derive(Clone, Debug)]
pub struct Series {
    /// Its name in the legend; none for an empty one.
    pub label: String,
    /// Which colour of the palette, from the first again after the last.
    pub colour: usize,
    /// How.
    pub mark: Mark,
}

/// How a series is drawn.
#[derive(Clone, Debug)]
pub enum Mark {
    /// A curve through points.
    Line(Vec<(f64, f64)>),
    /// The same, in dashes.
    Dashes(Vec<(f64, f64)>),
    /// Points.
    Dots(Vec<(f64, f64)>),
    /// An area between two curves: `(x, low, high)`.
    Band(Vec<(f64, f64, f64)>),
}

impl Series {
    /// A series of this name and colour.
    #[must_use]
    pub fn new(label: &str, colour: usize, mark: Mark) -> Self {
        Self { label: label.to_owned(), colour, mark }
    }
}

/// A number for a caption: three digits, powers of ten raised.
#[must_use]
pub fn number(value: f64) -> String {
    let text = format!("{value:.2e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let mantissa = mantissa.replace('-', "−");
    match exponent {
        "0" => mantissa,
        "-1" => format!("{value:.3}").replace('-', "−"),
        _ => format!("{mantissa}·10^{{{}}}", exponent.replace('-', "−")),
    }
}
