//! How a picture stands against its golden.

/// Names of the channels, in their order.
pub const CHANNELS: [&str; 3] = ["R", "G", "B"];

/// How a picture stands against its golden.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// Pixels by what was found of them.
    pub pixels: Pixels,
    /// The value that uses the largest share of its permitted error; none where nothing is promised at all.
    pub worst: Option<Worst>,
    /// Shares of the permitted error that so many of the pixels with a bound stay within: half, 99 %, 99.9 %, all.
    pub shares: [f64; 4],
}

/// Pixels by what was found of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Pixels {
    /// All channels are within their permitted error.
    pub inside: usize,
    /// A channel is not.
    pub outside: usize,
    /// None is outside, but of one nothing is promised.
    pub indeterminate: usize,
    /// All channels are the floats nearest to the truth, whatever is promised of them.
    pub equal: usize,
}

/// A value of a picture and how it stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Worst {
    /// Column, from the left.
    pub x: usize,
    /// Row, from the top.
    pub y: usize,
    /// Which of [`CHANNELS`].
    pub channel: usize,
    /// What the picture has.
    pub found: f32,
    /// What is true.
    pub truth: f32,
    /// The permitted distance.
    pub permitted: f32,
    /// The distance over the permitted one; infinite for NaN, or where none is permitted.
    pub share: f64,
}

impl Verdict {
    /// Whether no value is outside its permitted error.
    #[must_use]
    pub fn passes(&self) -> bool {
        self.pixels.outside == 0
    }
}

impl Pixels {
    /// All of them.
    #[must_use]
    pub fn all(&self) -> usize {
        self.inside + self.outside + self.indeterminate
    }
}
