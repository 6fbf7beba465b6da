//! Two pictures that may be compared.

use lobe_codegen::glam::Vec3;

/// A picture of one layer: linear RGB, row by row from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct Image {
    /// Columns and rows.
    pub size: [u32; 2],
    /// A colour for each pixel.
    pub pixels: Vec<Vec3>,
}

/// Why two pictures cannot be compared.
#[derive(Debug, thiserror::Error, PartialEq)]
pub enum PairError {
    /// They have other sizes.
    #[error(
        "the picture has {} x {} pixels, the truth {} x {}: render both in one size",
        picture[0], picture[1], truth[0], truth[1]
    )]
    Sizes {
        /// Columns and rows of the picture.
        picture: [u32; 2],
        /// Those of the truth.
        truth: [u32; 2],
    },
    /// There is no pixel, or not as many as the size says.
    #[error("the {which} has {count} pixels for {} x {}: there is nothing to compare", size[0], size[1])]
    Pixels {
        /// `picture` or `truth`.
        which: &'static str,
        /// How many there are.
        count: usize,
        /// Columns and rows that it states.
        size: [u32; 2],
    },
    /// A value is infinite or NaN.
    #[error("the {which} is not finite at column {x}, row {y}: {value}; no metric means anything there")]
    NotFinite {
        /// `picture` or `truth`.
        which: &'static str,
        /// Column, from the left.
        x: u32,
        /// Row, from the top.
        y: u32,
        /// What is there.
        value: Vec3,
    },
}

/// Two pictures of one size, finite in every pixel, at least one of these.
#[derive(Debug, Clone, Copy)]
pub struct Pair<'a> {
    size: [u32; 2],
    picture: &'a [Vec3],
    truth: &'a [Vec3],
}

impl<'a> Pair<'a> {
    /// `picture` beside what it should be.
    ///
    /// # Errors
    /// When their sizes differ, when there is no pixel, or when a value is not finite.
    pub fn new(picture: &'a Image, truth: &'a Image) -> Result<Self, PairError> {
        if picture.size != truth.size {
            return Err(PairError::Sizes { picture: picture.size, truth: truth.size });
        }
        check("picture", picture)?;
        check("truth", truth)?;
        Ok(Self { size: picture.size, picture: &picture.pixels, truth: &truth.pixels })
    }

    /// Columns and rows.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// What is judged.
    #[must_use]
    pub fn picture(&self) -> &'a [Vec3] {
        self.picture
    }

    /// What it should be.
    #[must_use]
    pub fn truth(&self) -> &'a [Vec3] {
        self.truth
    }

    /// Column and row of a pixel.
    pub(super) fn place(&self, index: usize) -> [u32; 2] {
        place(self.size, index)
    }
}

fn place([width, _]: [u32; 2], index: usize) -> [u32; 2] {
    let index = index as u32;
    [index % width, index / width]
}

fn check(which: &'static str, image: &Image) -> Result<(), PairError> {
    let (size, count) = (image.size, image.pixels.len());
    if count == 0 || count as u64 != u64::from(size[0]) * u64::from(size[1]) {
        return Err(PairError::Pixels { which, count, size });
    }
    match image.pixels.iter().position(|pixel| !pixel.is_finite()) {
        Some(at) => {
            let [x, y] = place(size, at);
            Err(PairError::NotFinite { which, x, y, value: image.pixels[at] })
        }
        None => Ok(()),
    }
}
